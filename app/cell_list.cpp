#include "cell_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace jam::app {
namespace {

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The weights of edges by their ends.
class Weights {
 public:
  explicit Weights(const WeightedGraph& graph) {
    weight_.reserve(graph.edges());
    for (std::size_t e = 0; e < graph.edges(); ++e)
      weight_.emplace(pair_key(graph.from[e], graph.to[e]), graph.weight[e]);
  }
  /// The smallest within a clique.
  double of(const std::vector<std::uint32_t>& vertices) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < vertices.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) least = std::min(least, weight_.at(pair_key(vertices[a], vertices[b])));
    return least;
  }

 private:
  std::unordered_map<std::uint64_t, double> weight_;
};

}  // namespace

Table diagram_table(const NamedGraph& network, const Diagram& diagram) {
  std::vector<std::int64_t> dimension, essential, birth_cell, death_cell, i, j;
  std::vector<double> birth, death;
  const WeightedGraph& g = network.graph;
  for (const PersistencePair& p : diagram.pairs) {
    dimension.push_back(p.dimension);
    birth.push_back(p.birth);
    death.push_back(p.death);
    essential.push_back(p.essential ? 1 : 0);
    birth_cell.push_back(p.birth_cell);
    death_cell.push_back(p.death_cell);
    const CellId edge = p.dimension == 0 ? p.death_cell : p.dimension == 1 ? p.birth_cell : -1;
    const auto e = static_cast<std::size_t>(edge);
    const bool vertex = p.dimension == 0 && edge < 0;
    i.push_back(edge >= 0 ? network.ids[g.from[e]] : vertex ? network.ids[static_cast<std::size_t>(p.birth_cell)] : -1);
    j.push_back(edge >= 0 ? network.ids[g.to[e]] : -1);
  }
  Table table;
  table.add("dimension", std::move(dimension));
  table.add("birth", std::move(birth));
  table.add("death", std::move(death));
  table.add("essential", std::move(essential));
  table.add("birth_cell", std::move(birth_cell));
  table.add("death_cell", std::move(death_cell));
  table.add("i", std::move(i));
  table.add("j", std::move(j));
  return table;
}

Table cell_table(const NamedGraph& network, const Diagram& diagram) {
  const WeightedGraph& g = network.graph;
  std::set<std::pair<int, CellId>> cells;  // by dimension, as the pairs name them
  for (const PersistencePair& p : diagram.pairs) {
    cells.emplace(p.dimension, p.birth_cell);
    if (!p.essential) cells.emplace(p.dimension + 1, p.death_cell);
  }
  std::vector<double> enters(g.vertices, 0);
  for (std::size_t e = 0; e < g.edges(); ++e)
    for (const std::uint32_t v : {g.from[e], g.to[e]}) enters[v] = std::max(enters[v], g.weight[e]);
  const Weights weights(g);
  std::vector<std::int64_t> dimension, number;
  std::vector<double> value;
  std::vector<std::string> names;
  std::size_t place = 0;  // in the list of cliques of one dimension, which are those of the pairs by number
  int before = 0;
  for (const auto& [k, cell] : cells) {
    const auto c = static_cast<std::size_t>(cell);
    place = k == before ? place + 1 : 0;
    before = k;
    std::vector<std::uint32_t> vertices;
    if (k == 0) {
      vertices = {static_cast<std::uint32_t>(c)};
    } else if (k == 1) {
      vertices = {g.from[c], g.to[c]};
    } else {
      const auto size = static_cast<std::size_t>(k) + 1;
      const auto& flat = diagram.cliques[static_cast<std::size_t>(k) - 2];
      const auto first = flat.begin() + static_cast<std::ptrdiff_t>(place * size);
      vertices.assign(first, first + static_cast<std::ptrdiff_t>(size));
    }
    std::vector<std::int64_t> ids;
    for (const std::uint32_t v : vertices) ids.push_back(network.ids[v]);
    dimension.push_back(k);
    number.push_back(cell);
    value.push_back(k == 0 ? enters[c] : weights.of(vertices));
    names.push_back(fmt::format("{}", fmt::join(ids, " ")));
  }
  Table table;
  table.add("dimension", std::move(dimension));
  table.add("cell", std::move(number));
  table.add("force", std::move(value));
  table.add("vertices", std::move(names));
  return table;
}

}  // namespace jam::app
