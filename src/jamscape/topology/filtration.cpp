#include "jamscape/topology/filtration.hpp"

#include <algorithm>

#include "jamscape/network/validate.hpp"
#include "jamscape/topology/clique_builder.hpp"

namespace jam {
namespace {

static_assert(kAtOnce == 1u << 31 && kUnpaired == ~0u && kUnpaired == (kNegative | 1u));

constexpr std::uint32_t kAhead = 16;  // edges between asking the cache and using it: enough to hide main memory

}  // namespace

void Filtration::build(const WeightedGraph& graph, int dimension) {
  validate_edges(graph);
  rank_edges(graph);
  if (dimension < 2) {
    validate(graph);
    cliques.clear();
    find_components();
    return;
  }
  find_components();
  find_cliques(graph, static_cast<std::uint32_t>(dimension));
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

// Whether an edge finds new vertices, or joins components, no processor could guess: what follows does not ask.
void Filtration::find_components() {
  const auto n = edges();
  const auto vertices = static_cast<std::uint32_t>(degree_.size());
  vertices_.assign(vertices, {kIsolated, kUnpaired});
  entering_.resize(std::size_t{vertices} + 1);
  edge_partner.resize(n);
  sets_.reset(vertices);
  const auto age = [&](std::uint32_t v) { return std::uint64_t{vertices_[v].entry} << 32 | v; };
  const auto older = [&](std::uint32_t a, std::uint32_t b) { return age(a) < age(b); };

  std::uint32_t first = 0;                               // of the edges that weigh as much as the present one
  std::size_t known = 0, count = 0;                      // vertices that entered before those edges, and so far
  const auto order_newcomers = [&](std::uint32_t end) {  // those of one edge are in order
    if (end - first > 1)
      std::sort(entering_.begin() + static_cast<std::ptrdiff_t>(known),
                entering_.begin() + static_cast<std::ptrdiff_t>(count));
    known = count;
  };
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + kAhead < n) {
      for (const auto v : {ends_[r + kAhead].a, ends_[r + kAhead].b}) {
        __builtin_prefetch(&vertices_[v], 1);
        sets_.prefetch(v);
      }
    }
    if (weight(r) != weight(first)) {
      order_newcomers(r);
      first = r;
    }
    const auto [a, b] = ends_[r];
    for (const auto v : {std::min(a, b), std::max(a, b)}) {
      entering_[count] = v;
      count += vertices_[v].entry == kIsolated;
      vertices_[v].entry = std::min(vertices_[v].entry, first);
    }
    const auto merge = sets_.unite(a, b, older);
    auto& lost = vertices_[merge.lost];
    const std::uint32_t closes = !merge.joined();
    lost.partner = r | static_cast<std::uint32_t>(lost.entry == first) << 31 | (0 - closes);
    edge_partner[r] = kNegative | closes;
  }
  order_newcomers(n);
  entering_.resize(count);
}

void Filtration::find_cliques(const WeightedGraph& graph, std::uint32_t dimension) {
  older_.reset(degree_, ends_);
  const auto largest = std::max(2u, older_.max_degree());  // a clique of dimension k needs k edges at each vertex
  CliqueBuilder builder(older_, ends_, std::min(dimension, largest), cliques);
  const auto n = edges();
  for (std::uint32_t r = 0; r < n; ++r) {
    if (r + kAhead < n) older_.prefetch(ends_[r + kAhead]);
    if (r + kAhead / 2 < n) older_.prefetch_neighbours(ends_[r + kAhead / 2]);
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
