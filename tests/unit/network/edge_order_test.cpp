#include "jamscape/network/edge_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "networks.hpp"

namespace jam {
namespace {

std::vector<std::uint32_t> stable_order(const std::vector<double>& weight) {
  std::vector<std::uint32_t> order(weight.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return weight[a] > weight[b]; });
  return order;
}

class Orders : public testing::TestWithParam<std::size_t> {
 protected:
  void check(const std::function<double(Random&)>& draw) {
    auto random = examples::stream(GetParam());
    std::vector<double> weight(GetParam());
    for (auto& w : weight) w = draw(random);
    EXPECT_EQ(edges_by_decreasing_weight(weight), stable_order(weight));
    EdgeOrder order;
    order.sort(weight);
    for (std::size_t r = 0; r < weight.size(); ++r) EXPECT_EQ(order.weight(r), weight[order.edge(r)]);
  }
};

TEST_P(Orders, continuous) { check(examples::forces()); }
TEST_P(Orders, few_levels) { check(examples::levels(7)); }
TEST_P(Orders, all_equal) {
  check([](Random&) { return .25; });
}
TEST_P(Orders, clamped) {
  check([](Random& random) { return std::min(random.uniform(0, 2), 1.0); });
}
TEST_P(Orders, over_many_decades) {
  check([](Random& random) { return std::pow(10., random.uniform(-300, 300)); });
}
TEST_P(Orders, differing_in_the_last_bits) {
  check([](Random& random) { return 1 + static_cast<double>(random.below(50)) * 0x1p-52; });
}
TEST_P(Orders, close_values_and_one_far_away) {
  check([](Random& random) { return random.below(100) == 0 ? 1e9 : random.uniform(); });
}
TEST_P(Orders, smallest_numbers) {
  check(
      [](Random& random) { return static_cast<double>(random.below(90)) * std::numeric_limits<double>::denorm_min(); });
}
INSTANTIATE_TEST_SUITE_P(sizes, Orders, testing::Values(0, 1, 2, 17, 255, 256, 257, 1000, 20011));

}  // namespace
}  // namespace jam
