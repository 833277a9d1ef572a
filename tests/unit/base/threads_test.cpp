#include "jamscape/base/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace jam {
namespace {

TEST(RunJobs, DoesEachOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(50);
    run_jobs(done.size(), threads, [&](std::size_t k) { ++done[k]; });
    for (const auto& d : done) EXPECT_EQ(d, 1);
  }
}

TEST(RunJobs, OneThreadKeepsTheOrder) {
  std::vector<std::size_t> order;
  run_jobs(5, 1, [&](std::size_t k) { order.push_back(k); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(RunJobs, CallsIdleAtLeastOnce) {
  int idle = 0;
  run_jobs(
      3, 2, [](std::size_t) {}, [&] { ++idle; });
  EXPECT_GE(idle, 1);
}

TEST(RunJobs, PassesOnAnExceptionAfterTheOthersEnded) {
  std::atomic<int> ended = 0;
  EXPECT_THROW(run_jobs(4, 1,
                        [&](std::size_t k) {
                          if (k == 2) throw std::runtime_error("third");
                          ++ended;
                        }),
               std::runtime_error);
  EXPECT_EQ(ended, 2) << "jobs not yet begun are left out";
}

TEST(RunJobs, NothingToDo) {
  EXPECT_NO_THROW(run_jobs(0, 4, [](std::size_t) { FAIL(); }));
}

}  // namespace
}  // namespace jam
