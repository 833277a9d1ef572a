// Small files written so that a kill at any moment leaves the old or the new content, and locks that die with their
// process.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace jam {

/// Throws a data error naming the file and the system's reason.
std::string read_text(const std::filesystem::path& path);

/// Writes aside, flushes to the disk, renames. Does nothing when the file already holds exactly `text`.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Creates a folder and its parents; throws a data error with the system's reason.
void make_folder(const std::filesystem::path& path);

/// Could files be made in this folder? False on a read-only file system, and in a folder of somebody else.
bool may_write(const std::filesystem::path& folder);

/// A folder of one's own for temporary files, gone with its content when the work is.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::string_view purpose);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

enum class LockMode { exclusive, shared };

/// An advisory lock on a file (created if missing), released by the destructor or by the end of the process however
/// it comes. The file holds the process id of the last exclusive holder, for messages only. Where the file system has
/// no locks every lock is given, and that is noted (file_lacks.hpp).
class FileLock {
 public:
  /// No value when another process (or another FileLock of this one) holds it. Throws a data error when there is no
  /// such file and none can be made.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path, LockMode mode = LockMode::exclusive);
  /// Waits for it.
  static FileLock lock(const std::filesystem::path& path);

  FileLock(FileLock&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace jam
