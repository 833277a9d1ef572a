// Where the bytes of an HDF5 file go: a driver for the library that never tells it of a full disk. HDF5 1.10 leaves a
// file it could not write half closed, and crashes at the end of the process; so a failure is kept here, the library
// goes on writing into memory, and whoever owns the storage asks for the failure and throws it.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace jam::hdf5 {

/// Bytes with addresses; reading beyond the end gives zeros. Nothing throws but for want of memory.
class Storage {
 public:
  virtual ~Storage() = default;
  virtual std::uint64_t size() const = 0;
  virtual void resize(std::uint64_t size) = 0;
  virtual void read(std::uint64_t address, std::size_t size, char* out) const = 0;
  virtual void write(std::uint64_t address, std::size_t size, const char* bytes) = 0;
};

class MemoryStorage final : public Storage {
 public:
  explicit MemoryStorage(std::string bytes = {}) : bytes_(std::move(bytes)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  void resize(std::uint64_t size) override { bytes_.resize(size); }
  void read(std::uint64_t address, std::size_t size, char* out) const override;
  void write(std::uint64_t address, std::size_t size, const char* bytes) override;
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// A new file on disk, emptied if it was there.
class DiskStorage final : public Storage {
 public:
  explicit DiskStorage(const std::filesystem::path& path);
  ~DiskStorage() override;
  DiskStorage(const DiskStorage&) = delete;
  DiskStorage& operator=(const DiskStorage&) = delete;

  std::uint64_t size() const override { return size_; }
  void resize(std::uint64_t size) override;
  void read(std::uint64_t address, std::size_t size, char* out) const override;
  void write(std::uint64_t address, std::size_t size, const char* bytes) override;
  /// The system's number of the first failure, 0 if all went well.
  int failure() const { return failure_; }

 private:
  bool try_write(std::uint64_t address, std::size_t size, const char* bytes);

  int descriptor_;
  int failure_ = 0;
  std::uint64_t size_ = 0;
  std::vector<std::pair<std::uint64_t, std::string>> unwritten_;  ///< what came after the failure, in its order
};

/// Makes files opened with this access list live in `storage`, which must outlive them.
void use_storage(hid_t access_list, Storage& storage);

}  // namespace jam::hdf5
