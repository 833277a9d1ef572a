#include "jamscape/base/thread_team.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "jamscape/base/flush_to_zero.hpp"

namespace jam {
namespace {

TEST(ThreadTeam, every_item_is_done_once_whatever_the_number_of_threads) {
  for (const int threads : {1, 2, 3, 7}) {
    ThreadTeam team(threads);
    EXPECT_EQ(team.size(), threads);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 64u, 1000u}) {
      std::vector<int> done(count, 0);
      team.run(count, [&](std::size_t k) { ++done[k]; });
      EXPECT_EQ(done, std::vector<int>(count, 1)) << threads;
    }
  }
}

TEST(ThreadTeam, a_piece_sees_all_that_the_piece_before_wrote) {
  ThreadTeam team(3);
  std::vector<long> a(50, 0), b(50, 0);
  for (int pass = 0; pass < 20000; ++pass) {
    team.run(a.size(), [&](std::size_t k) { a[k] = b[(k + 1) % b.size()] + 1; });
    team.run(b.size(), [&](std::size_t k) { b[k] = a[(k + 1) % a.size()] + 1; });
  }
  EXPECT_EQ(b, std::vector<long>(50, 40000));
}

TEST(ThreadTeam, members_that_fell_asleep_wake_up) {
  ThreadTeam team(2);
  for (int pass = 0; pass < 5; ++pass) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // The first item ends only when the last one has begun: two threads have to be at work.
    std::atomic<bool> last{false};
    team.run(2, [&](std::size_t k) {
      if (k == 1) last = true;
      while (!last) std::this_thread::yield();
    });
    EXPECT_TRUE(last);
  }
}

TEST(ThreadTeam, an_exception_comes_back_and_the_team_goes_on) {
  ThreadTeam team(3);
  std::atomic<int> done{0};
  const auto job = [&](std::size_t k) {
    ++done;
    if (k == 17) throw std::runtime_error("seventeen");
  };
  try {
    team.run(100, job);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "seventeen");
  }
  EXPECT_EQ(done, 100);
  team.run(17, job);
  EXPECT_EQ(done, 117);
}

TEST(ThreadTeam, members_treat_denormals_as_the_caller_does) {
  ThreadTeam team(3);
  volatile double tiny = 1e-308;
  const auto count_zeros = [&] {
    std::vector<int> zero(300, 0);
    team.run(zero.size(), [&](std::size_t k) { zero[k] = tiny / 16 == 0; });
    return std::accumulate(zero.begin(), zero.end(), 0);
  };
  EXPECT_EQ(count_zeros(), 0);
#if defined(__SSE2__)
  {
    const FlushToZero guard;
    EXPECT_EQ(count_zeros(), 300);
  }
#endif
  EXPECT_EQ(count_zeros(), 0);
}

}  // namespace
}  // namespace jam
