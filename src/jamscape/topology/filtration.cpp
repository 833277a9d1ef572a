#include "jamscape/topology/filtration.hpp"

#include <algorithm>

#include "jamscape/network/validate.hpp"
#include "jamscape/topology/clique_builder.hpp"

namespace jam {
namespace {

constexpr std::uint32_t kAhead = 16;  // edges between asking the cache and using it: enough to hide main memory

}  // namespace

void Filtration::build(const WeightedGraph& graph, int dimension) {
  validate_edges(graph);
  rank_edges(graph);
  if (dimension < 2) {
    validate(graph);
    cliques.clear();
    sweep([](std::uint32_t, Ends, bool) {});
    return;
  }
  older_.reset(degree_, ends_);
  const auto largest = std::max(2u, older_.max_degree());  // a clique of dimension k needs k edges at each vertex
  CliqueBuilder builder(older_, ends_, std::min(static_cast<std::uint32_t>(dimension), largest), cliques);
  sweep([&](std::uint32_t rank, Ends e, bool joins) {
    if (rank + kAhead < edges()) older_.prefetch(ends_[rank + kAhead]);
    if (rank + kAhead / 2 < edges()) older_.prefetch_neighbours(ends_[rank + kAhead / 2]);
    builder.begin_edge(rank);
    if (!joins) {
      if (!older_.common(e, common_)) validate(graph);  // a repeated edge: throws, naming it
      if (!common_.empty()) builder.add(common_);
    }
    older_.add(e, rank);
  });
}

void Filtration::release_search() {
  older_ = {};
  sets_ = {};
  degree_ = {};
}

void Filtration::rank_edges(const WeightedGraph& graph) {
  order_.sort(graph.weight);
  degree_.assign(graph.vertices, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    ++degree_[graph.from[e]];
    ++degree_[graph.to[e]];
  }
  ends_.resize(edges());
  for (std::uint32_t r = 0; r < edges(); ++r) {
    if (r + kAhead < edges()) {
      __builtin_prefetch(&graph.from[edge(r + kAhead)]);
      __builtin_prefetch(&graph.to[edge(r + kAhead)]);
    }
    ends_[r] = {graph.from[edge(r)], graph.to[edge(r)]};
  }
}

template <class Close>
void Filtration::sweep(const Close& close) {
  const auto n = edges();
  vertices_.assign(degree_.size(), {kIsolated, kUnpaired});
  entering_.clear();
  edge_partner.resize(n);
  sets_.reset(static_cast<std::uint32_t>(degree_.size()));
  const auto older = [&](std::uint32_t a, std::uint32_t b) {
    return vertices_[a].entry < vertices_[b].entry || (vertices_[a].entry == vertices_[b].entry && a < b);
  };

  std::uint32_t first = 0;  // of the edges that weigh as much as the present one
  std::size_t known = 0;    // vertices that entered before them
  const auto order_newcomers = [&] {
    if (entering_.size() > known + 1)
      std::sort(entering_.begin() + static_cast<std::ptrdiff_t>(known), entering_.end());
    known = entering_.size();
  };
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + kAhead < n) {
      for (const auto v : {ends_[r + kAhead].a, ends_[r + kAhead].b}) {
        __builtin_prefetch(&vertices_[v], 1);
        sets_.prefetch(v);
      }
    }
    if (weight(r) != weight(first)) {
      order_newcomers();
      first = r;
    }
    const auto e = ends_[r];
    for (const auto v : {e.a, e.b}) {
      if (vertices_[v].entry != kIsolated) continue;
      vertices_[v].entry = first;
      entering_.push_back(v);
    }
    const auto merge = sets_.unite(e.a, e.b, older);
    if (merge.joined()) vertices_[merge.lost].partner = vertices_[merge.lost].entry == first ? r | kAtOnce : r;
    edge_partner[r] = merge.joined() ? kNegative : kUnpaired;
    close(r, e, merge.joined());
  }
  order_newcomers();
}

std::uint32_t Filtration::youngest_edge(std::uint32_t dimension, std::uint32_t cell) const {
  for (; dimension > 1; --dimension) cell = cliques[dimension - 2].facets_of(cell)[0];
  return cell;
}

}  // namespace jam
