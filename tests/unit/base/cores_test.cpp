#include "jamscape/base/cores.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <fstream>

namespace jam {
namespace {

namespace fs = std::filesystem;

/// A tree of files as the kernel shows them.
class Quota : public testing::Test {
 protected:
  ~Quota() override { fs::remove_all(root_); }
  void put(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  std::optional<double> quota() const { return core_quota(root_); }

  fs::path root_ = fs::temp_directory_path() / ("jamscape-cores-" + std::to_string(::getpid()));
  const std::string second_ = "30 24 0:26 / /sys/fs/cgroup rw,nosuid shared:9 - cgroup2 cgroup2 rw,nsdelegate\n";
  const std::string first_ = "31 24 0:27 / /sys/fs/cgroup/cpu,cpuacct rw shared:10 - cgroup cgroup rw,cpu,cpuacct\n";
};

TEST_F(Quota, NoneWhereThereAreNoGroups) {
  EXPECT_FALSE(quota());
  put("proc/self/cgroup", "0::/\n");
  put("proc/self/mountinfo", "22 1 8:1 / / rw - ext4 /dev/sda rw\n");
  EXPECT_FALSE(quota());
}

TEST_F(Quota, Version2TakesTheLeastOfTheGroupsAbove) {
  put("proc/self/cgroup", "0::/user.slice/job.scope\n");
  put("proc/self/mountinfo", second_);
  put("sys/fs/cgroup/user.slice/job.scope/cpu.max", "max 100000\n");
  EXPECT_FALSE(quota());
  put("sys/fs/cgroup/user.slice/cpu.max", "150000 100000\n");
  EXPECT_EQ(quota(), 1.5);
  put("sys/fs/cgroup/user.slice/job.scope/cpu.max", "50000 50000\n");
  EXPECT_EQ(quota(), 1);
}

TEST_F(Quota, Version2InAContainer) {
  put("proc/self/cgroup", "0::/\n");
  put("proc/self/mountinfo", second_);
  put("sys/fs/cgroup/cpu.max", "200000 100000\n");
  EXPECT_EQ(quota(), 2);
  put("proc/self/cgroup", "0::/../other\n");  // entered from outside of the name space
  EXPECT_EQ(quota(), 2);
}

TEST_F(Quota, Version1) {
  put("proc/self/cgroup", "12:memory:/job\n4:cpu,cpuacct:/job/step\n1:name=systemd:/\n0::/\n");
  put("proc/self/mountinfo", first_ + second_);
  put("sys/fs/cgroup/cpu,cpuacct/job/step/cpu.cfs_quota_us", "-1\n");
  put("sys/fs/cgroup/cpu,cpuacct/job/step/cpu.cfs_period_us", "100000\n");
  EXPECT_FALSE(quota());
  put("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "100000\n");
  put("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(quota(), 1);
}

TEST_F(Quota, Version1InAContainerThatSeesItsOwnGroupOnly) {
  put("proc/self/cgroup", "4:cpuacct,cpu:/docker/abc\n");
  put("proc/self/mountinfo", "31 24 0:27 /docker/abc /sys/fs/cgroup/cpu\\040here ro - cgroup cgroup rw,cpuacct,cpu\n");
  put("sys/fs/cgroup/cpu here/cpu.cfs_quota_us", "250000\n");
  put("sys/fs/cgroup/cpu here/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(quota(), 2.5);
}

TEST_F(Quota, NonsenseIsNoLimit) {
  put("proc/self/cgroup", "0::/\nnonsense\n::\n");
  put("proc/self/mountinfo", second_ + "short - cgroup2\n - \n");
  for (const char* text : {"", "many", "-5 100000", "100000 0", "12cats 100000"}) {
    put("sys/fs/cgroup/cpu.max", text);
    EXPECT_FALSE(quota()) << text;
  }
}

TEST(UsableCores, AreThoseOfTheAffinityMask) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  const int all = usable_cores();
  EXPECT_GE(all, 1);
  EXPECT_LE(all, CPU_COUNT(&before));
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_cores(), 1);
  sched_setaffinity(0, sizeof before, &before);
}

}  // namespace
}  // namespace jam
