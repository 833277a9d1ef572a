// A thin layer over the HDF5 C library: handles that close themselves, typed arrays and attributes, and errors as
// data errors that name the file, what was wanted and why it failed.
//
// Every call holds one lock for the whole process, since the library may have been built without thread safety; take a
// Lock around a group of calls to keep other threads from slipping in between. The library's own printing is silenced.
//
// Files are made without time stamps, so equal content gives equal bytes. Numbers are stored little-endian; arrays of
// some size are chunked, shuffled, deflated and carry a Fletcher-32 checksum per chunk.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/io/hdf5_storage.hpp"

namespace jam::hdf5 {

/// Holds the process-wide lock; may be nested.
class Lock {
 public:
  Lock();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Handle() { reset(); }

  hid_t id() const { return id_; }
  /// Closes now; false when the library refused.
  bool reset();

 private:
  void swap(Handle& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }
  hid_t id_ = -1;
  Close close_ = nullptr;
};

using Shape = std::vector<hsize_t>;
inline constexpr hsize_t unlimited = H5S_UNLIMITED;

/// The number types of arrays and attributes: (u)int8, 16, 32, 64 and double.
template <class T>
hid_t stored_type();
template <class T>
hid_t memory_type();

/// What an array's elements are in the file; byte is uint8.
enum class Kind { real, integer, byte, other };

/// An array in a file, which may grow along its first axis (and others).
class Dataset {
 public:
  Shape shape() const;
  Kind kind() const;

  /// Makes room: the new shape, not smaller than the old one in any direction. New elements are 0.
  void resize(const Shape& shape);
  /// Writes a block that starts at `start`.
  template <class T>
  void write(const Shape& start, const Shape& count, std::span<const T> values);
  /// Reads a block; the file must really hold that much.
  template <class T>
  std::vector<T> read(const Shape& start, const Shape& count) const;
  template <class T>
  std::vector<T> read() const {
    const Shape all = shape();
    return read<T>(Shape(all.size(), 0), all);
  }

 private:
  friend class Group;
  Dataset(Handle handle, std::string file, std::string path)
      : handle_(std::move(handle)), file_(std::move(file)), path_(std::move(path)) {}
  Handle handle_;
  std::string file_, path_;
};

class Group {
 public:
  Group() = default;
  Group create_group(std::string_view name);
  Group group(std::string_view name) const;
  bool has(std::string_view name) const;
  bool is_group(std::string_view name) const;
  /// Names of the members, sorted.
  std::vector<std::string> names() const;
  /// A second name for a member of any group of the same file.
  void link(std::string_view name, const Group& from, std::string_view member);

  /// An array that can grow up to `most` (unlimited for any number; one unlimited axis keeps the index of the chunks
  /// small); `chunk` has no zero.
  template <class T>
  Dataset create(std::string_view name, const Shape& shape, const Shape& most, const Shape& chunk);
  Dataset dataset(std::string_view name) const;

  /// A whole array at once; one-dimensional unless a shape is given.
  template <class T>
  void write(std::string_view name, std::span<const T> values, Shape shape = {});
  template <class T>
  void write(std::string_view name, const std::vector<T>& values, Shape shape = {}) {
    write(name, std::span<const T>(values), std::move(shape));
  }
  template <class T>
  std::vector<T> read(std::string_view name) const {
    return dataset(name).read<T>();
  }
  /// UTF-8 text without NUL, an array or a single one, of fixed length: text of variable length stands in the one part
  /// of a file that carries no checksum, where damage crashes the library. So we never read such text.
  void write_strings(std::string_view name, const std::vector<std::string>& values);
  void write_string(std::string_view name, const std::string& value);
  std::vector<std::string> read_strings(std::string_view name) const;

  template <class T>
  void attribute(std::string_view name, const std::vector<T>& values);
  /// Text of fixed length.
  void attribute(std::string_view name, const std::string& value);
  /// Text of variable length, which other programs like best; it cannot be read back here.
  void attribute_for_others(std::string_view name, const std::vector<std::string>& values);
  bool has_attribute(std::string_view name) const;
  template <class T>
  std::vector<T> read_attribute(std::string_view name) const;
  /// No value when it is anything but a single text of fixed length.
  std::optional<std::string> read_text_attribute(std::string_view name) const;
  /// Names of the attributes, sorted.
  std::vector<std::string> attribute_names() const;

  const std::string& file() const { return file_; }

 private:
  friend class File;
  Group(Handle handle, std::string file, std::string path)
      : handle_(std::move(handle)), file_(std::move(file)), path_(std::move(path)) {}
  std::string full(std::string_view name) const;
  void write_text(std::string_view name, const std::vector<std::string>& values, const Shape& shape);
  void write_attribute(std::string_view name, const Handle& type, const Shape& shape, const void* values);
  Handle handle_;
  std::string file_, path_;
};

class File {
 public:
  /// A new file on disk; anything of that name is overwritten.
  static File create(const std::filesystem::path& path);
  /// A new file in memory; `name` is what errors call it.
  static File create_image(const std::string& name);
  /// Existing files, to read only.
  static File open(const std::filesystem::path& path);
  static File open_image(std::string image, const std::string& name);

  Group root() const;
  /// Throws the first failure to write to the disk, if there was any.
  void check() const;
  /// Closes a file on disk; throws when anything of it did not reach the disk. No group or array of it may be open any
  /// more: closing those later confuses the library's end.
  void close();
  /// Closes a file in memory, likewise, and hands over its bytes.
  std::string close_image();

 private:
  File(Handle handle, std::string name, std::unique_ptr<MemoryStorage> memory, std::unique_ptr<DiskStorage> disk)
      : memory_(std::move(memory)), disk_(std::move(disk)), handle_(std::move(handle)), name_(std::move(name)) {}
  void must_be_alone() const;
  std::unique_ptr<MemoryStorage> memory_;
  std::unique_ptr<DiskStorage> disk_;
  Handle handle_;  ///< after the storages, so that it closes before they go
  std::string name_;
};

}  // namespace jam::hdf5
