#include "jamscape/network/edge_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace jam {
namespace {

constexpr unsigned kBits = 11, kBuckets = 1u << kBits;
constexpr std::size_t kSmall = 256;       // below it comparison sort is faster than clearing the buckets
constexpr std::size_t kLarge = 1u << 18;  // above it too many weights agree in 22 leading bits, and a third pass pays
constexpr std::size_t kAhead = 16;        // weights asked for before they are needed; enough to hide main memory

std::size_t digit(std::uint64_t item, unsigned pass) { return (item >> (32 + kBits * pass)) & (kBuckets - 1); }

struct Range {
  double low, high;
};

/// Four at a time, so that none waits for the one before.
Range range(std::span<const double> weight) {
  std::array<double, 4> low, high;
  low.fill(weight[0]);
  high.fill(weight[0]);
  std::size_t e = 0;
  for (; e + 4 <= weight.size(); e += 4)
    for (std::size_t k = 0; k < 4; ++k) {
      low[k] = std::min(low[k], weight[e + k]);
      high[k] = std::max(high[k], weight[e + k]);
    }
  for (; e < weight.size(); ++e) {
    low[0] = std::min(low[0], weight[e]);
    high[0] = std::max(high[0], weight[e]);
  }
  return {std::min({low[0], low[1], low[2], low[3]}), std::max({high[0], high[1], high[2], high[3]})};
}

}  // namespace

void EdgeOrder::sort(std::span<const double> weight) {
  const std::size_t n = weight.size();
  items_.resize(n);
  spare_.resize(n);
  if (n == 0) return;
  const auto heavier = [&](std::uint64_t a, std::uint64_t b) {
    const auto i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b);
    return weight[i] > weight[j] || (weight[i] == weight[j] && i < j);
  };

  if (n < kSmall) {
    for (std::size_t e = 0; e < n; ++e) items_[e] = e;
    std::sort(items_.begin(), items_.end(), heavier);
  } else {
    n < kLarge ? sort_leading_bits<2>(weight) : sort_leading_bits<3>(weight);
  }
  for (std::size_t r = 0; r < n; ++r) {
    if (r + kAhead < n) __builtin_prefetch(&weight[edge(r + kAhead)]);
    spare_[r] = std::bit_cast<std::uint64_t>(weight[edge(r)]);
  }

  for (std::size_t r = 1; r < n; ++r) {
    if (this->weight(r) <= this->weight(r - 1)) continue;
    // Only weights that agree in their leading bits can be out of order: sort all that do.
    std::size_t first = r - 1, last = r + 1;
    while (first > 0 && items_[first - 1] >> 32 == items_[r] >> 32) --first;
    while (last < n && items_[last] >> 32 == items_[r] >> 32) ++last;
    std::sort(items_.begin() + static_cast<std::ptrdiff_t>(first), items_.begin() + static_cast<std::ptrdiff_t>(last),
              heavier);
    for (auto k = first; k < last; ++k) spare_[k] = std::bit_cast<std::uint64_t>(weight[edge(k)]);
    r = last - 1;
  }
}

template <unsigned passes>
void EdgeOrder::sort_leading_bits(std::span<const double> weight) {
  const std::uint64_t most = (std::uint64_t{1} << std::min(32u, kBits * passes)) - 1;
  const auto [low, high] = range(weight);
  // Difference, product and truncation are monotonic, so unequal leading bits order two weights correctly.
  double scale = static_cast<double>(most) / (high - low);
  if (!std::isfinite(scale) || !std::isfinite(high - low)) scale = 0;

  std::array<std::array<std::uint32_t, kBuckets>, passes> places{};
  for (std::size_t e = 0; e < weight.size(); ++e) {
    const auto leading = static_cast<std::uint64_t>(static_cast<std::int64_t>((weight[e] - low) * scale));
    const auto item = (most - std::min(leading, most)) << 32 | e;
    items_[e] = item;
    for (unsigned pass = 0; pass < passes; ++pass) ++places[pass][digit(item, pass)];
  }
  for (unsigned pass = 0; pass < passes; ++pass) {
    auto& place = places[pass];
    std::uint32_t sum = 0;
    for (auto& count : place) sum += std::exchange(count, sum);
    for (const auto item : items_) spare_[place[digit(item, pass)]++] = item;
    items_.swap(spare_);
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
