#include "jamscape/base/file_lacks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <utility>

namespace jam {
namespace {

/// ENOTSUPP of the Linux kernel, which some network file systems let through; it has no name outside the kernel.
constexpr int not_supported_by_kernel = 524;

std::mutex mutex;             // process-wide: so is what a file system lacks
std::array<bool, 2> noted{};  // by Lack
std::vector<std::string> not_taken;

std::string reason(int code) {
  return code == not_supported_by_kernel ? "Operation not supported" : std::strerror(code);
}

}  // namespace

bool is_lack(int code) {
  return code == ENOLCK || code == ENOSYS || code == EOPNOTSUPP || code == ENOTSUP || code == EINVAL ||
         code == not_supported_by_kernel;
}

void note_lack(Lack lack, const std::filesystem::path& path, int code) {
  const std::lock_guard guard(mutex);
  bool& known = noted[static_cast<std::size_t>(lack)];
  if (known) return;
  known = true;
  const std::string folder = path.parent_path().empty() ? "." : path.parent_path().string();
  not_taken.push_back(
      lack == Lack::locks
          ? fmt::format("{}: this file system has no locks ({}): nothing keeps a second jamscape out of the folder",
                        folder, reason(code))
          : fmt::format(
                "{}: this file system cannot force files to its disk ({}): a power cut may cost the last of them, "
                "which the same command makes again",
                folder, reason(code)));
}

std::vector<std::string> take_lacks() {
  const std::lock_guard guard(mutex);
  return std::exchange(not_taken, {});
}

int force_to_disk(int descriptor, const std::filesystem::path& path) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    if (!is_lack(errno)) return errno;
    note_lack(Lack::sync, path, errno);
    return 0;
  }
  return 0;
}

}  // namespace jam
