// How many cores this process was given.
#pragma once

#include <filesystem>
#include <optional>

namespace jam {

/// The smaller of the affinity mask and the quota of its control groups (rounded up to whole cores), at least 1.
int usable_cores();

/// The least quota, in cores, of the control group of this process and of those above it: `cpu.max` of version 2,
/// `cpu.cfs_quota_us` of version 1, in the order of /proc/self/cgroup and /proc/self/mountinfo. Nothing where there is
/// no limit. `root` stands before every path, for tests.
std::optional<double> core_quota(const std::filesystem::path& root = "/");

}  // namespace jam
