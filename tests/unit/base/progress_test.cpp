#include "jamscape/base/progress.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace jam {
namespace {

TEST(Progress, Durations) {
  EXPECT_EQ(print_duration(0), "0 s");
  EXPECT_EQ(print_duration(99.4), "99 s");
  EXPECT_EQ(print_duration(125), "2 min");
  EXPECT_EQ(print_duration(3 * 3600 + 5 * 60), "3 h 05 min");
  EXPECT_EQ(print_duration(52 * 3600), "2 d 4 h");
  EXPECT_EQ(print_duration(-1), "?");
  EXPECT_EQ(print_duration(std::numeric_limits<double>::infinity()), "?");
}

TEST(Progress, BarGrowsAndKeepsItsWidth) {
  EXPECT_EQ(print_bar(0, {}, 80), "[>         ]   0 %");
  EXPECT_EQ(print_bar(0.5, {"3/6 runs", ""}, 80), "[=====>    ]  50 %  3/6 runs");
  EXPECT_EQ(print_bar(1, {}, 80), "[==========] 100 %");
  EXPECT_EQ(print_bar(7, {}, 80), print_bar(1, {}, 80));
  EXPECT_EQ(print_bar(0.5, {"a long note"}, 10).size(), 10u);
}

}  // namespace
}  // namespace jam
