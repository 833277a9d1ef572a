#include "jamscape/io/aside.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/base/file_lacks.hpp"

namespace jam {
namespace {

Error cannot_write(const std::filesystem::path& path, int code) {
  return data_error(fmt::format("cannot write: {}", std::strerror(code)), path.string(),
                    code == ENOSPC || code == EDQUOT || code == EFBIG
                        ? "make room on the disk, or write elsewhere"
                        : "check that its folder exists and may be written");
}

}  // namespace

Aside::Aside(std::filesystem::path target) : target_(std::move(target)), path_(target_.string() + ".part") {
  if (std::filesystem::is_directory(target_)) throw cannot_write(target_, EISDIR);
  const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw cannot_write(target_, errno);
  ::close(file);
}

Aside::~Aside() {
  if (!committed_) ::unlink(path_.c_str());
}

void Aside::commit() {
  const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  int failure = file < 0 ? errno : force_to_disk(file, target_);
  if (file >= 0 && ::close(file) != 0 && errno != EINTR && failure == 0) failure = errno;
  if (failure == 0 && ::rename(path_.c_str(), target_.c_str()) != 0) failure = errno;
  if (failure != 0) throw cannot_write(target_, failure);
  committed_ = true;
}

}  // namespace jam
