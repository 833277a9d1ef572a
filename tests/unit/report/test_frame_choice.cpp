#include <gtest/gtest.h>

#include "jamscape/report/frame_choice.hpp"

namespace jam {
namespace {

using Frames = std::vector<std::int64_t>;

TEST(FrameChoice, TakesMultiplesOfTwoPercent) {
  EXPECT_EQ(even_frames({{0, 0.7}, {1, 0.713}, {2, 0.72}, {3, 0.73}, {4, 0.74}}, 8), (Frames{0, 2, 4}));
}

TEST(FrameChoice, KeepsTheDensestOfTooMany) {
  EXPECT_EQ(even_frames({{0, 0.7}, {1, 0.72}, {2, 0.74}, {3, 0.76}}, 3), (Frames{1, 2, 3}));
}

TEST(FrameChoice, SpreadsEvenlyWithoutMultiples) {
  std::map<std::int64_t, double> rho;
  for (int k = 0; k < 11; ++k) rho[k] = 0.6031 + 0.0071 * k;
  EXPECT_EQ(even_frames(rho, 3), (Frames{0, 5, 10}));
  EXPECT_EQ(even_frames({{4, 0.611}, {5, 0.617}}, 3), (Frames{4, 5}));
}

TEST(FrameChoice, NothingFromNothing) {
  EXPECT_TRUE(even_frames({}, 5).empty());
  EXPECT_TRUE(last_frame({}).empty());
  EXPECT_TRUE(nearest_frames({}, {0.8}).empty());
}

TEST(FrameChoice, LastIsTheDensestNotTheLatest) { EXPECT_EQ(last_frame({{0, 0.7}, {1, 0.9}, {2, 0.8}}), Frames{1}); }

TEST(FrameChoice, NearestOnce) {
  EXPECT_EQ(nearest_frames({{0, 0.7}, {1, 0.8}, {2, 0.9}}, {0.79, 0.81, 0.99}), (Frames{1, 2}));
}

}  // namespace
}  // namespace jam
