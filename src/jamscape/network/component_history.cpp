#include "jamscape/network/component_history.hpp"

#include <algorithm>

#include "jamscape/network/validate.hpp"

namespace jam {

void ComponentHistory::build(const WeightedGraph& graph) {
  validate_edges(graph);
  graph_ = &graph;
  rank_edges();
  order_vertices();
  join_components();
}

void ComponentHistory::rank_edges() {
  const WeightedGraph& graph = *graph_;
  order_.sort(graph.weight);
  degree_.assign(graph.vertices, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    ++degree_[graph.from[e]];
    ++degree_[graph.to[e]];
  }
  ends_.resize(edges());
  const auto early = ahead();
  for (std::uint32_t r = 0; r < edges(); ++r) {
    if (r + early < edges()) {
      __builtin_prefetch(&graph.from[edge(r + early)]);
      __builtin_prefetch(&graph.to[edge(r + early)]);
    }
    ends_[r] = {graph.from[edge(r)], graph.to[edge(r)]};
  }
}

// Whether an edge finds new vertices, or joins components, no processor could guess: what follows does not ask.
void ComponentHistory::order_vertices() {
  constexpr std::uint32_t nowhere = 0xFFFFFFFFu;
  const auto n = edges();
  place_.assign(degree_.size(), nowhere);
  vertices_.name.resize(degree_.size() + 1);
  vertices_.entry.resize(degree_.size() + 1);
  std::uint32_t first = 0;             // of the edges that weigh as much as the present one
  std::uint32_t known = 0, count = 0;  // vertices that entered before those edges, and so far
  const auto order_newcomers = [&](std::uint32_t end) {
    if (end - first > 1) {  // those of a single edge are in order
      std::sort(vertices_.name.begin() + known, vertices_.name.begin() + count);
      for (auto k = known; k < count; ++k) place_[vertices_.name[k]] = k;
    }
    known = count;
    first = end;
  };
  const auto early = ahead();
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + early < n) {
      __builtin_prefetch(&place_[ends_[r + early].a], 1);
      __builtin_prefetch(&place_[ends_[r + early].b], 1);
    }
    if (weight(r) != weight(first)) order_newcomers(r);
    const auto [a, b] = ends_[r];
    for (const auto v : {std::min(a, b), std::max(a, b)}) {
      auto& place = place_[v];
      vertices_.name[count] = v;
      vertices_.entry[count] = first;
      const bool fresh = place == nowhere;
      place = std::min(place, count);
      count += fresh;
    }
  }
  order_newcomers(n);
  vertices_.name.resize(count);
  vertices_.entry.resize(count);
  isolated_.clear();
  for (std::uint32_t v = 0; count + isolated_.size() < place_.size(); ++v)
    if (place_[v] == nowhere) isolated_.push_back(v);
}

void ComponentHistory::join_components() {
  const auto n = edges();
  sets_.reset(static_cast<std::uint32_t>(vertices_.size()));
  merges_.resize(n);
  const auto early = ahead();
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + early < n) {
      __builtin_prefetch(&place_[ends_[r + early].a]);
      __builtin_prefetch(&place_[ends_[r + early].b]);
      sets_.prefetch(place_[ends_[r + early / 2].a]);
      sets_.prefetch(place_[ends_[r + early / 2].b]);
    }
    merges_[r] = sets_.unite(place_[ends_[r].a], place_[ends_[r].b]);
  }
}

void ComponentHistory::forget_merges() {
  merges_ = std::vector<UnionFind::Merge>();  // `= {}` would keep the memory
  sets_ = UnionFind();
  place_ = std::vector<std::uint32_t>();
}

}  // namespace jam
