#include "jamscape/network/edge_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace jam {
namespace {

constexpr int kBits = 11, kBuckets = 1 << kBits, kPasses = 3;
constexpr std::size_t kSmall = 256;  // below it comparison sort is faster than clearing the buckets

using Histogram = std::array<std::uint32_t, kBuckets>;

std::size_t digit(std::uint64_t item, int pass) { return (item >> (32 + kBits * pass)) & (kBuckets - 1); }

}  // namespace

void EdgeOrder::sort(std::span<const double> weight) {
  const std::size_t n = weight.size();
  items_.resize(n);
  if (n == 0) return;
  const auto heavier = [&](std::uint64_t a, std::uint64_t b) {
    const auto i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b);
    return weight[i] > weight[j] || (weight[i] == weight[j] && i < j);
  };

  double low = weight[0], high = weight[0];
  for (const double w : weight) {
    low = std::min(low, w);
    high = std::max(high, w);
  }
  // Difference, product and truncation are monotonic, so unequal leading bits order two weights correctly.
  double scale = 4294967295.0 / (high - low);
  if (!std::isfinite(scale) || !std::isfinite((high - low) * scale)) scale = 0;
  const auto item = [&](std::size_t e) {
    const auto leading = scale > 0 ? static_cast<std::uint64_t>((weight[e] - low) * scale) : 0;
    return (0xFFFFFFFFu - std::min<std::uint64_t>(leading, 0xFFFFFFFFu)) << 32 | e;
  };

  if (n <= kSmall) {
    for (std::size_t e = 0; e < n; ++e) items_[e] = item(e);
    std::sort(items_.begin(), items_.end(), heavier);
    return;
  }

  spare_.resize(n);
  std::array<Histogram, kPasses> count{};
  for (std::size_t e = 0; e < n; ++e) {
    const auto it = item(e);
    spare_[e] = it;
    for (int pass = 0; pass < kPasses; ++pass) ++count[static_cast<std::size_t>(pass)][digit(it, pass)];
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    auto& place = count[static_cast<std::size_t>(pass)];
    std::uint32_t sum = 0;
    for (auto& c : place) sum += std::exchange(c, sum);
    for (const auto it : spare_) items_[place[digit(it, pass)]++] = it;
    items_.swap(spare_);
  }
  items_.swap(spare_);

  for (std::size_t first = 0; first + 1 < n;) {
    std::size_t last = first + 1;
    while (last < n && items_[last] >> 32 == items_[first] >> 32) ++last;
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = items_.begin() + static_cast<std::ptrdiff_t>(last);
    if (last > first + 1 && !std::is_sorted(begin, end, heavier)) std::sort(begin, end, heavier);
    first = last;
  }
}

std::vector<std::uint32_t> edges_by_decreasing_weight(std::span<const double> weight) {
  EdgeOrder order;
  order.sort(weight);
  std::vector<std::uint32_t> edges(weight.size());
  for (std::size_t r = 0; r < edges.size(); ++r) edges[r] = order.edge(r);
  return edges;
}

}  // namespace jam
