#include "jamscape/base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "jamscape/base/error.hpp"

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
  Descriptor(const Descriptor&) = delete;
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
    const Descriptor file(aside, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.get() < 0) throw system_error("write", path, errno);
    failure = write_all(file.get(), text);
    if (failure == 0 && ::fsync(file.get()) != 0 && errno != EINVAL) failure = errno;
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

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path, LockMode mode) {
  Descriptor file(path, O_RDWR | O_CREAT);
  if (file.get() < 0) throw system_error("lock", path, errno);
  if (::flock(file.get(), (mode == LockMode::shared ? LOCK_SH : LOCK_EX) | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return std::nullopt;
    throw system_error("lock", path, errno);
  }
  if (::ftruncate(file.get(), 0) == 0 && mode == LockMode::exclusive)
    static_cast<void>(write_all(file.get(), fmt::format("{}\n", ::getpid())));
  return FileLock(file.release());
}

FileLock FileLock::lock(const std::filesystem::path& path) {
  Descriptor file(path, O_RDWR | O_CREAT);
  if (file.get() < 0) throw system_error("lock", path, errno);
  while (::flock(file.get(), LOCK_EX) != 0)
    if (errno != EINTR) throw system_error("lock", path, errno);
  return FileLock(file.release());
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace jam
