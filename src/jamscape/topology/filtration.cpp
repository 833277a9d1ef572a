#include "jamscape/topology/filtration.hpp"

#include <algorithm>

#include "jamscape/network/validate.hpp"
#include "jamscape/topology/clique_builder.hpp"

namespace jam {

void Filtration::build(const WeightedGraph& graph, int dimension) {
  validate_edges(graph);
  order_.sort(graph.weight);
  age_vertices(graph);
  sets_.reset(vertices());
  vertex_partner.assign(vertices(), kUnpaired);
  edge_partner.assign(edges(), kUnpaired);
  cliques.clear();
  if (dimension < 2) {
    validate(graph);
    for (std::uint32_t r = 0; r < edges(); ++r) {
      const auto merge = sets_.unite(ends_[r].a, ends_[r].b);
      if (!merge.joined()) continue;
      edge_partner[r] = kNegative;
      vertex_partner[merge.lost] = r;
    }
  } else {
    sweep(graph, static_cast<std::uint32_t>(dimension));
  }
}

void Filtration::age_vertices(const WeightedGraph& graph) {
  const auto n = static_cast<std::uint32_t>(graph.edges());
  age_of_.assign(graph.vertices, kNoAge);
  vertex_.clear();
  entry_.clear();
  ends_.resize(n);
  for (std::uint32_t first = 0; first < n;) {
    const double weight = graph.weight[edge(first)];
    std::uint32_t last = first + 1;
    while (last < n && order_.may_tie_with_previous(last) && graph.weight[edge(last)] == weight) ++last;

    const auto known = vertices();
    for (auto r = first; r < last; ++r) {
      for (const auto v : {graph.from[edge(r)], graph.to[edge(r)]}) {
        if (age_of_[v] != kNoAge) continue;
        age_of_[v] = 0;
        vertex_.push_back(v);
      }
    }
    std::sort(vertex_.begin() + known, vertex_.end());
    entry_.resize(vertices(), first);
    for (auto age = known; age < vertices(); ++age) age_of_[vertex_[age]] = age;
    for (auto r = first; r < last; ++r) {
      const auto a = age_of_[graph.from[edge(r)]], b = age_of_[graph.to[edge(r)]];
      ends_[r] = {std::min(a, b), std::max(a, b)};
    }
    first = last;
  }
}

void Filtration::sweep(const WeightedGraph& graph, std::uint32_t dimension) {
  older_.reset(vertices(), ends_);
  CliqueBuilder builder(older_, ends_, std::min(dimension, std::max(2u, older_.max_degree())), cliques);
  for (std::uint32_t r = 0; r < edges(); ++r) {
    const auto e = ends_[r];
    builder.begin_edge(r);
    const auto merge = sets_.unite(e.a, e.b);
    if (merge.joined()) {
      edge_partner[r] = kNegative;
      vertex_partner[merge.lost] = r;
    } else {
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
