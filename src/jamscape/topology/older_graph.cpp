#include "jamscape/topology/older_graph.hpp"

#include <algorithm>

namespace jam {

void OlderGraph::reset(std::uint32_t vertices, std::span<const Ends> edges) {
  added_ = 0;
  end_.assign(vertices, 0);
  for (const auto [a, b] : edges) {
    ++end_[a];
    ++end_[b];
  }
  begin_.resize(vertices);
  max_degree_ = 0;
  std::uint32_t sum = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto degree = end_[v];
    max_degree_ = std::max(max_degree_, degree);
    begin_[v] = end_[v] = sum;
    sum += degree;
  }
  around_.resize(sum);
  hub_begin_.clear();
  if (max_degree_ > kHub) index_hubs(vertices, edges);
}

void OlderGraph::index_hubs(std::uint32_t vertices, std::span<const Ends> edges) {
  const auto room = [&](std::uint32_t v) {
    return (v + 1 < vertices ? begin_[v + 1] : static_cast<std::uint32_t>(around_.size())) - begin_[v];
  };
  hub_begin_.assign(std::size_t{vertices} + 1, 0);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    hub_begin_[v + 1] = hub_begin_[v] + (room(v) > kHub ? room(v) : 0);
  }
  hub_around_.resize(hub_begin_.back());
  std::vector<std::uint32_t> next(hub_begin_.begin(), hub_begin_.end() - 1);
  for (std::uint32_t r = 0; r < edges.size(); ++r) {
    const auto [a, b] = edges[r];
    if (next[a] < hub_begin_[a + 1]) hub_around_[next[a]++] = {b, r};
    if (next[b] < hub_begin_[b + 1]) hub_around_[next[b]++] = {a, r};
  }
  for (std::uint32_t v = 0; v < vertices; ++v) {
    std::sort(hub_around_.begin() + hub_begin_[v], hub_around_.begin() + hub_begin_[v + 1],
              [](Neighbour x, Neighbour y) { return x.age < y.age || (x.age == y.age && x.rank < y.rank); });
  }
}

std::uint32_t OlderGraph::linked_to_hub(std::uint32_t hub, std::uint32_t other) const {
  const auto last = hub_around_.begin() + hub_begin_[hub + 1];
  const auto at = std::lower_bound(hub_around_.begin() + hub_begin_[hub], last, other,
                                   [](Neighbour x, std::uint32_t age) { return x.age < age; });
  return at != last && at->age == other && at->rank < added_ ? at->rank : kNone;
}

std::uint32_t OlderGraph::linked(std::uint32_t x, std::uint32_t y) const {
  if (end_[x] - begin_[x] > end_[y] - begin_[y]) std::swap(x, y);
  const auto list = around(x);
  if (list.size() > kHub) return linked_to_hub(x, y);
  for (const auto n : list) {
    if (n.age == y) return n.rank;
  }
  return kNone;
}

bool OlderGraph::common(Ends e, std::vector<CommonNeighbour>& found) const {
  found.clear();
  const bool swapped = around(e.a).size() > around(e.b).size();
  const auto few = around(swapped ? e.b : e.a), many = around(swapped ? e.a : e.b);
  const auto far = swapped ? e.a : e.b;
  for (const auto n : few) {
    if (n.age == far) return false;
    auto other = kNone;
    if (many.size() > kHub) {
      other = linked_to_hub(far, n.age);
    } else {
      for (const auto m : many) {
        if (m.age == n.age) other = m.rank;
      }
    }
    if (other == kNone) continue;
    found.push_back(swapped ? CommonNeighbour{n.age, other, n.rank} : CommonNeighbour{n.age, n.rank, other});
  }
  if (found.size() > 1) {
    std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.age < y.age; });
  }
  return true;
}

}  // namespace jam
