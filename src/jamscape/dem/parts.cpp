#include "jamscape/dem/parts.hpp"

#include <numeric>
#include <tuple>

namespace jam {

namespace {

std::size_t divide_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

Parts::Parts(int dimension, std::size_t grains, std::size_t beads) : grains_(grains), beads_(beads) {
  length_ = stretch_ = std::max(grains, std::size_t{1});
  if (grains < least_grains) return;
  const std::size_t wanted = divide_up(grains, even * most_grains(dimension)) * even;
  length_ = divide_up(grains, wanted * stretch_length) * stretch_length;
  with_grains_ = divide_up(grains, length_);
  stretch_ = stretch_length;
  stretches_ = divide_up(grains, stretch_);
  size_ = with_grains_ + divide_up(beads, beads_of_part);
}

std::vector<std::uint32_t> deal_rounds(std::span<const Neighbours> neighbours, std::size_t parts) {
  std::vector<std::size_t> order(neighbours.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
    const Neighbours &x = neighbours[p], &y = neighbours[q];
    return std::tuple(y.pairs, x.a, x.b) < std::tuple(x.pairs, y.a, y.b);
  });
  std::vector<std::vector<bool>> taken(parts);  // by part: the rounds it is in
  std::vector<std::uint32_t> rounds(neighbours.size());
  for (const std::size_t n : order) {
    auto &a = taken[neighbours[n].a], &b = taken[neighbours[n].b];
    std::size_t round = 0;
    while ((round < a.size() && a[round]) || (round < b.size() && b[round])) ++round;
    for (auto* rounds_of : {&a, &b}) {
      rounds_of->resize(std::max(rounds_of->size(), round + 1));
      (*rounds_of)[round] = true;
    }
    rounds[n] = static_cast<std::uint32_t>(round);
  }
  return rounds;
}

}  // namespace jam
