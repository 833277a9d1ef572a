#include "jamscape/base/cores.hpp"

#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace jam {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

bool lists(const std::string& names, const std::string& name) {
  const std::vector<std::string> parts = split(names, ',');
  return std::find(parts.begin(), parts.end(), name) != parts.end();
}

/// In mountinfo a blank of a path is \040, and so on.
std::string unescaped(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool octal = text[k] == '\\' && k + 3 < text.size() &&
                       text.substr(k + 1, 3).find_first_not_of("01234567") == std::string::npos;
    if (!octal) {
      out += text[k];
      continue;
    }
    out += static_cast<char>(std::stoi(text.substr(k + 1, 3), nullptr, 8));
    k += 3;
  }
  return out;
}

/// Where a hierarchy of control groups is mounted, and which of its groups is seen there.
struct Mount {
  std::string group, at;
};

std::vector<Mount> mounts(const fs::path& root, bool second_version) {
  std::vector<Mount> found;
  std::ifstream file(root / "proc/self/mountinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t dash = line.find(" - ");
    if (dash == std::string::npos) continue;
    const std::vector<std::string> left = split(line.substr(0, dash), ' '), right = split(line.substr(dash + 3), ' ');
    if (left.size() < 5 || right.size() < 3) continue;
    if (second_version ? right[0] == "cgroup2" : right[0] == "cgroup" && lists(right[2], "cpu"))
      found.push_back({unescaped(left[3]), unescaped(left[4])});
  }
  return found;
}

std::optional<double> quota_2(const fs::path& group) {
  std::ifstream file(group / "cpu.max");
  std::string quota;
  double period = 100000;
  if (!(file >> quota) || quota == "max") return {};
  file >> period;
  char* end = nullptr;
  const double value = std::strtod(quota.c_str(), &end);
  return *end == '\0' && value > 0 && period > 0 ? std::optional(value / period) : std::nullopt;
}

std::optional<double> quota_1(const fs::path& group) {
  double quota = -1, period = 0;
  std::ifstream(group / "cpu.cfs_quota_us") >> quota;
  std::ifstream(group / "cpu.cfs_period_us") >> period;
  return quota > 0 && period > 0 ? std::optional(quota / period) : std::nullopt;
}

/// The group below the mount point, which may show a part of the hierarchy only.
std::string below(const std::string& group, const std::string& shown) {
  if (group.find("/..") != std::string::npos) return {};  // outside of what this process can see
  if (shown == "/") return group;
  if (group == shown) return {};
  return group.starts_with(shown + "/") ? group.substr(shown.size()) : std::string();
}

void take_least(std::optional<double>& least, const fs::path& root, const std::string& group, bool second_version) {
  for (const Mount& mount : mounts(root, second_version)) {
    std::string path = below(group, mount.group);
    while (true) {
      const fs::path place = root / fs::path(mount.at + path).relative_path();
      const std::optional<double> quota = second_version ? quota_2(place) : quota_1(place);
      if (quota && (!least || *quota < *least)) least = quota;
      if (path.empty() || path == "/") break;
      path.resize(path.rfind('/'));
    }
  }
}

/// 0 when the system does not say.
int cores_of_affinity() {
  for (int most = 1024; most <= 1 << 20; most *= 4) {
    cpu_set_t* set = CPU_ALLOC(static_cast<std::size_t>(most));
    if (!set) return 0;
    const std::size_t size = CPU_ALLOC_SIZE(static_cast<std::size_t>(most));
    CPU_ZERO_S(size, set);
    const bool known = sched_getaffinity(0, size, set) == 0;
    const bool too_small = !known && errno == EINVAL;
    const int count = known ? CPU_COUNT_S(size, set) : 0;
    CPU_FREE(set);
    if (!too_small) return count;
  }
  return 0;
}

}  // namespace

std::optional<double> core_quota(const fs::path& root) {
  std::optional<double> least;
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {  // number:controllers:group
    const std::size_t first = line.find(':'), second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty())
      take_least(least, root, group, true);
    else if (lists(controllers, "cpu"))
      take_least(least, root, group, false);
  }
  return least;
}

int usable_cores() {
  int cores = cores_of_affinity();
  if (cores <= 0) cores = static_cast<int>(std::thread::hardware_concurrency());
  if (const auto quota = core_quota(); quota && *quota < cores) cores = static_cast<int>(std::ceil(*quota - 1e-3));
  return std::max(1, cores);
}

}  // namespace jam
