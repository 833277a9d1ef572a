#include "jamscape/topology/older_graph.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jam {

void OlderGraph::reset(std::span<const std::uint32_t> degree, std::span<const Ends> edges) {
  max_degree_ = 0;
  vertices_.resize(degree.size());
  std::uint32_t sum = 0;
  for (std::size_t v = 0; v < degree.size(); ++v) {
    vertices_[v] = {sum, sum, 0};
    sum += degree[v];
    max_degree_ = std::max(max_degree_, degree[v]);
  }
  neighbours_.resize(sum);
  if (max_degree_ > kHub) index_hubs(degree, edges);
}

void OlderGraph::index_hubs(std::span<const std::uint32_t> degree, std::span<const Ends> edges) {
  hub_begin_.assign(1, 0);
  for (const auto d : degree) hub_begin_.push_back(hub_begin_.back() + (d > kHub ? d : 0));
  hub_neighbours_.resize(hub_begin_.back());
  std::vector<std::uint32_t> next(hub_begin_.begin(), hub_begin_.end() - 1);
  for (std::uint32_t r = 0; r < edges.size(); ++r) {
    const auto [a, b] = edges[r];
    if (degree[a] > kHub) hub_neighbours_[next[a]++] = {b, r};
    if (degree[b] > kHub) hub_neighbours_[next[b]++] = {a, r};
  }
  for (std::size_t v = 0; v < degree.size(); ++v) {
    std::sort(
        hub_neighbours_.begin() + hub_begin_[v], hub_neighbours_.begin() + hub_begin_[v + 1],
        [](Neighbour x, Neighbour y) { return x.vertex < y.vertex || (x.vertex == y.vertex && x.rank < y.rank); });
  }
}

std::uint32_t OlderGraph::linked_to_hub(std::uint32_t hub, std::uint32_t other, std::uint32_t before) const {
  const auto last = hub_neighbours_.begin() + hub_begin_[hub + 1];
  const auto at = std::lower_bound(hub_neighbours_.begin() + hub_begin_[hub], last, other,
                                   [](Neighbour x, std::uint32_t vertex) { return x.vertex < vertex; });
  return at != last && at->vertex == other && at->rank < before ? at->rank : kNone;
}

std::uint32_t OlderGraph::linked(std::uint32_t x, std::uint32_t y, std::uint32_t before) const {
  if ((vertices_[x].hashes & hash(y)) == 0) return kNone;
  if (around(x).size() > around(y).size()) std::swap(x, y);
  if (around(x).size() > kHub) return linked_to_hub(x, y, before);
  for (const auto n : around(x)) {
    if (n.vertex == y) return n.rank < before ? n.rank : kNone;
  }
  return kNone;
}

bool OlderGraph::answer(const Question& q, std::vector<CommonNeighbour>& found) const {
  found.clear();
  if (q.hashes == 0) return true;
  const auto around_a = around(q.e.a, q.end_a), around_b = around(q.e.b, q.end_b);
  const bool swapped = around_a.size() > around_b.size();
  const auto few = swapped ? around_b : around_a, many = swapped ? around_a : around_b;
  const auto far = swapped ? q.e.a : q.e.b;
  const auto add = [&](Neighbour n, std::uint32_t other) {
    found.push_back(swapped ? CommonNeighbour{n.vertex, other, n.rank} : CommonNeighbour{n.vertex, n.rank, other});
  };
  if (many.size() > kHub) {
    for (const auto n : few) {
      if (n.vertex == far) return false;
      const auto other = (q.hashes & hash(n.vertex)) != 0 ? linked_to_hub(far, n.vertex, q.rank) : kNone;
      if (other != kNone) add(n, other);
    }
  } else {
    // Few of a list qualify, and no processor could guess which: they are put aside first, without a branch.
    std::array<Neighbour, kHub + 1> likely;
    std::size_t count = 0;
    bool linked = false;
    for (const auto n : few) {
      likely[count] = n;
      count += (q.hashes & hash(n.vertex)) != 0;
      linked |= n.vertex == far;
    }
    if (linked) return false;
    for (std::size_t k = 0; k < count; ++k) {
      auto other = kNone;
      for (const auto m : many) other = m.vertex == likely[k].vertex ? m.rank : other;
      if (other != kNone) add(likely[k], other);
    }
  }
  const auto before = [](const CommonNeighbour& x, const CommonNeighbour& y) { return x.vertex < y.vertex; };
  if (found.size() == 2 && before(found[1], found[0])) std::swap(found[0], found[1]);
  if (found.size() > 2) std::sort(found.begin(), found.end(), before);
  return true;
}

}  // namespace jam
