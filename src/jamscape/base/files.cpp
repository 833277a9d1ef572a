#include "jamscape/base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/base/file_lacks.hpp"

namespace jam {
namespace {

Error system_error(std::string_view verb, const std::filesystem::path& path, int code) {
  std::string hint;
  if (code == ENOSPC || code == EDQUOT) hint = "make room on the disk and run the same command again";
  if (code == EACCES || code == EPERM || code == EROFS) hint = "check the permissions, or choose another folder";
  return data_error(fmt::format("cannot {}: {}", verb, std::strerror(code)), path.string(), hint);
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags) : value_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }
  int release() {
    const int value = value_;
    value_ = -1;
    return value;
  }

 private:
  int value_;
};

/// 0, or the error.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno != EINTR) return errno;
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.get() < 0) throw system_error("read", path, errno);
  std::string text;
  char buffer[1 << 16];
  while (true) {
    const ssize_t n = ::read(file.get(), buffer, sizeof buffer);
    if (n == 0) return text;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw system_error("read", path, errno);
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored) && std::filesystem::file_size(path, ignored) == text.size() &&
      read_text(path) == text)
    return;
  const std::filesystem::path aside = path.string() + ".part";
  int failure = 0;
  {
    Descriptor file(aside, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.get() < 0) throw system_error("write", path, errno);
    failure = write_all(file.get(), text);
    if (failure == 0) failure = force_to_disk(file.get(), path);
    if (::close(file.release()) != 0 && errno != EINTR && failure == 0) failure = errno;  // where a quota says so late
  }
  if (failure == 0 && ::rename(aside.c_str(), path.c_str()) != 0) failure = errno;
  if (failure == 0) return;
  ::unlink(aside.c_str());
  throw system_error("write", path, failure);
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw system_error("create the folder", path, error.value());
}

ScratchFolder::ScratchFolder(std::string_view purpose) {
  std::error_code error;
  const std::filesystem::path below = std::filesystem::temp_directory_path(error);
  std::string name = (below / fmt::format("jamscape-{}-XXXXXX", purpose)).string();
  if (error || !::mkdtemp(name.data()))
    throw system_error("make a temporary folder", name, error ? error.value() : errno);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

bool may_write(const std::filesystem::path& folder) {
  return ::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) == 0;
}

namespace {

/// A lock file of somebody else, or on an archive, can still be locked; it only cannot be written.
Descriptor open_lock(const std::filesystem::path& path, bool& writable) {
  Descriptor file(path, O_RDWR | O_CREAT);
  writable = file.get() >= 0;
  if (writable) return file;
  const int failure = errno;
  if (failure == EACCES || failure == EPERM || failure == EROFS) {
    Descriptor read_only(path, O_RDONLY);
    if (read_only.get() >= 0) return read_only;
  }
  throw system_error("lock", path, failure);
}

/// 0, EWOULDBLOCK, or the error. Where there are no locks all goes on without.
int lock_it(int descriptor, int operation, bool writable, const std::filesystem::path& path) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EINTR) continue;
    // NFS makes an exclusive lock of one that wants the file open for writing
    if (!is_lack(errno) && !(errno == EBADF && !writable)) return errno;
    note_lack(Lack::locks, path, errno);
    return 0;
  }
  return 0;
}

}  // namespace

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path, LockMode mode) {
  bool writable = false;
  Descriptor file = open_lock(path, writable);
  const int operation = (mode == LockMode::shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  if (const int failure = lock_it(file.get(), operation, writable, path); failure != 0) {
    if (failure == EWOULDBLOCK) return std::nullopt;
    throw system_error("lock", path, failure);
  }
  if (writable && mode == LockMode::exclusive && ::ftruncate(file.get(), 0) == 0)
    static_cast<void>(write_all(file.get(), fmt::format("{}\n", ::getpid())));
  return FileLock(file.release());
}

FileLock FileLock::lock(const std::filesystem::path& path) {
  bool writable = false;
  Descriptor file = open_lock(path, writable);
  if (const int failure = lock_it(file.get(), LOCK_EX, writable, path); failure != 0)
    throw system_error("lock", path, failure);
  return FileLock(file.release());
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace jam
