#include "jamscape/topology/filtration.hpp"

#include <algorithm>

#include "jamscape/network/validate.hpp"
#include "jamscape/topology/clique_builder.hpp"

namespace jam {
namespace {

static_assert(kAtOnce == 1u << 31 && kUnpaired == ~0u && kUnpaired == (kNegative | 1u));

/// Edges between asking the cache and using it: enough to hide main memory. Small networks are in the cache: never.
std::uint32_t ahead_of(std::uint32_t edges) { return edges < 1u << 15 ? edges : 16; }

}  // namespace

void Filtration::build(const WeightedGraph& graph, int dimension, Memory memory) {
  validate_edges(graph);
  rank_edges(graph);
  if (dimension < 2) {
    validate(graph);
    cliques.clear();
    order_vertices();
    find_components();
    return;
  }
  order_vertices();
  find_components();
  if (memory == Memory::release) {
    sets_ = {};
    place_ = {};
  }
  find_cliques(graph, static_cast<std::uint32_t>(dimension));
  if (memory == Memory::release) {
    older_ = {};
    degree_ = {};
  }
}

void Filtration::rank_edges(const WeightedGraph& graph) {
  order_.sort(graph.weight);
  degree_.assign(graph.vertices, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    ++degree_[graph.from[e]];
    ++degree_[graph.to[e]];
  }
  ends_.resize(edges());
  const auto ahead = ahead_of(edges());
  for (std::uint32_t r = 0; r < edges(); ++r) {
    if (r + ahead < edges()) {
      __builtin_prefetch(&graph.from[edge(r + ahead)]);
      __builtin_prefetch(&graph.to[edge(r + ahead)]);
    }
    ends_[r] = {graph.from[edge(r)], graph.to[edge(r)]};
  }
}

// Whether an edge finds new vertices, or joins components, no processor could guess: what follows does not ask.
void Filtration::order_vertices() {
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
  const auto ahead = ahead_of(n);
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + ahead < n) {
      __builtin_prefetch(&place_[ends_[r + ahead].a], 1);
      __builtin_prefetch(&place_[ends_[r + ahead].b], 1);
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
  vertices_.partner.assign(count, kUnpaired);
  isolated_.clear();
  for (std::uint32_t v = 0; count + isolated_.size() < place_.size(); ++v)
    if (place_[v] == nowhere) isolated_.push_back(v);
}

void Filtration::find_components() {
  const auto n = edges();
  edge_partner.resize(n);
  sets_.reset(static_cast<std::uint32_t>(vertices_.size()));
  std::uint32_t first = 0;  // of the edges that weigh as much as the present one
  const auto ahead = ahead_of(n);
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + ahead < n) {
      __builtin_prefetch(&place_[ends_[r + ahead].a]);
      __builtin_prefetch(&place_[ends_[r + ahead].b]);
      sets_.prefetch(place_[ends_[r + ahead / 2].a]);
      sets_.prefetch(place_[ends_[r + ahead / 2].b]);
    }
    first = weight(r) == weight(first) ? first : r;
    const auto merge = sets_.unite(place_[ends_[r].a], place_[ends_[r].b]);
    const std::uint32_t closes = !merge.joined(), at_once = vertices_.entry[merge.lost] == first;
    vertices_.partner[merge.lost] = r | at_once << 31 | (0 - closes);
    edge_partner[r] = kNegative | closes;
  }
}

void Filtration::find_cliques(const WeightedGraph& graph, std::uint32_t dimension) {
  older_.reset(degree_, ends_);
  const auto largest = std::max(2u, older_.max_degree());  // a clique of dimension k needs k edges at each vertex
  CliqueBuilder builder(older_, ends_, std::min(dimension, largest), cliques);
  const auto n = edges();
  const auto ahead = ahead_of(n);
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + ahead < n) {
      older_.prefetch(ends_[r + ahead]);
      older_.prefetch_neighbours(ends_[r + ahead / 2]);
    }
    const auto e = ends_[r];
    builder.begin_edge(r);
    if ((edge_partner[r] != kNegative) & older_.may_share(e)) {
      if (!older_.common(e, common_)) validate(graph);  // a repeated edge: throws, naming it
      if (!common_.empty()) builder.add(common_);
    }
    older_.add(e, r);
  }
}

std::uint32_t Filtration::youngest_edge(std::uint32_t dimension, std::uint32_t cell) const {
  for (; dimension > 1; --dimension) cell = cliques[dimension - 2].facets_of(cell)[0];
  return cell;
}

}  // namespace jam
