#include "jamscape/topology/persistence.hpp"

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/topology/filtration.hpp"
#include "jamscape/topology/reduction.hpp"

namespace jam {
namespace {

/// Turns the partners of a filtration into pairs.
class Writer {
 public:
  Writer(const WeightedGraph& graph, const Filtration& cells, const PersistenceOptions& options)
      : graph_(graph), cells_(cells), options_(options) {}

  Diagram write() {
    components();
    for (int k = 1; k <= options_.max_dimension; ++k) {
      if (const auto* partner = partners(k)) classes(k, *partner);
    }
    number_cliques();
    return std::move(diagram_);
  }

 private:
  double weight(std::uint32_t rank) const { return graph_.weight[cells_.edge(rank)]; }

  const std::vector<std::uint32_t>* partners(int dimension) const {
    if (dimension == 1) return &cells_.edge_partner;
    const auto i = static_cast<std::size_t>(dimension - 2);
    return i < cells_.cliques.size() ? &cells_.cliques[i].partner : nullptr;
  }

  void components() {
    const auto& partner = cells_.vertex_partner;
    const auto kept = [&](std::uint32_t age) { return options_.keep_zero_length || partner[age] != cells_.entry(age); };
    std::size_t count = graph_.vertices - cells_.vertices();
    for (std::uint32_t age = 0; age < cells_.vertices(); ++age) count += kept(age);
    diagram_.pairs.reserve(count);

    for (std::uint32_t age = 0; age < cells_.vertices(); ++age) {
      if (!kept(age)) continue;
      const double birth = weight(cells_.entry(age));
      if (partner[age] == kUnpaired) {
        diagram_.pairs.push_back({0, birth, 0, true, cells_.vertex(age), -1});
      } else if (const double death = weight(partner[age]); death < birth || options_.keep_zero_length) {
        diagram_.pairs.push_back({0, birth, death, false, cells_.vertex(age), cells_.edge(partner[age])});
      }
    }
    for (std::uint32_t v = 0; v < graph_.vertices; ++v) {
      if (cells_.isolated(v)) diagram_.pairs.push_back({0, 0, 0, true, v, -1});
    }
    const auto zero = std::partition_point(diagram_.pairs.begin(), diagram_.pairs.end(),
                                           [](const PersistencePair& p) { return p.birth > 0; });
    std::sort(zero, diagram_.pairs.end(), [](const auto& p, const auto& q) { return p.birth_cell < q.birth_cell; });
  }

  void classes(int k, const std::vector<std::uint32_t>& partner) {
    const auto dimension = static_cast<std::uint32_t>(k);
    const auto cell_id = [&](std::uint32_t d, std::uint32_t c) { return CellId{d == 1 ? cells_.edge(c) : c}; };
    const auto visit = [&](auto&& take) {
      for (std::uint32_t c = 0; c < partner.size(); ++c) {
        if (partner[c] == kNegative) continue;
        const auto from = cells_.youngest_edge(dimension, c);
        if (partner[c] == kUnpaired) {
          take(PersistencePair{k, weight(from), 0, true, cell_id(dimension, c), -1});
          continue;
        }
        const auto to = cells_.youngest_edge(dimension + 1, partner[c]);
        if (options_.keep_zero_length || (from != to && weight(to) < weight(from))) {
          take(PersistencePair{k, weight(from), weight(to), false, cell_id(dimension, c), partner[c]});
        }
      }
    };
    std::size_t count = 0;
    visit([&](const PersistencePair&) { ++count; });
    diagram_.pairs.reserve(diagram_.pairs.size() + count);
    visit([&](const PersistencePair& p) { diagram_.pairs.push_back(p); });
  }

  /// Keeps the cliques that occur in pairs, in order, and renames the pairs' cells accordingly.
  void number_cliques() {
    for (std::size_t i = 0; i < cells_.cliques.size(); ++i) {
      const auto& cliques = cells_.cliques[i];
      const auto k = static_cast<int>(cliques.dimension);
      const auto cell_of = [&](PersistencePair& p) {
        return p.dimension == k ? &p.birth_cell : p.dimension + 1 == k && !p.essential ? &p.death_cell : nullptr;
      };
      std::vector<CellId> used;
      for (auto& p : diagram_.pairs) {
        if (const auto* id = cell_of(p)) used.push_back(*id);
      }
      std::sort(used.begin(), used.end());
      for (auto& p : diagram_.pairs) {
        if (auto* id = cell_of(p)) *id = std::lower_bound(used.begin(), used.end(), *id) - used.begin();
      }
      auto& out = diagram_.cliques.emplace_back();
      out.reserve(used.size() * (cliques.dimension + 1));
      for (const auto id : used) {
        const auto c = static_cast<std::uint32_t>(id);
        const auto [a, b] = cells_.ends(cells_.youngest_edge(cliques.dimension, c));
        const auto first = out.size();
        out.insert(out.end(), {cells_.vertex(a), cells_.vertex(b)});
        const auto* others = cliques.others_of(c);
        for (std::uint32_t j = 0; j + 1 < cliques.dimension; ++j) out.push_back(cells_.vertex(others[j]));
        std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
      }
    }
  }

  const WeightedGraph& graph_;
  const Filtration& cells_;
  const PersistenceOptions& options_;
  Diagram diagram_;
};

}  // namespace

struct PersistenceWorkspace::Parts {
  Filtration cells;
  Reduction reduction;
};

PersistenceWorkspace::PersistenceWorkspace() : parts_(std::make_unique<Parts>()) {}
PersistenceWorkspace::~PersistenceWorkspace() = default;

Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options, PersistenceWorkspace& workspace) {
  if (options.max_dimension < 0) throw usage_error("the highest dimension of homology must not be negative");
  auto& [cells, reduction] = *workspace.parts_;
  const bool filled = options.triangles == Triangles::fill && options.max_dimension > 0;
  cells.build(graph, filled ? options.max_dimension + 1 : 1);
  for (auto i = cells.cliques.size(); i-- > 0;) {
    reduction.pair(cells.cliques[i], i > 0 ? cells.cliques[i - 1].partner : cells.edge_partner);
  }
  return Writer(graph, cells, options).write();
}

Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options) {
  PersistenceWorkspace workspace;
  return persistence(graph, options, workspace);
}

}  // namespace jam
