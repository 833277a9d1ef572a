#include "jamscape/topology/persistence.hpp"

#include "jamscape/base/error.hpp"
#include "jamscape/topology/diagram_writer.hpp"
#include "jamscape/topology/filtration.hpp"
#include "jamscape/topology/reduction.hpp"

namespace jam {
namespace {

/// Above dimension 0, how far cliques are needed.
std::uint32_t clique_dimension(const PersistenceOptions& options) {
  if (options.max_dimension < 0) throw usage_error("the highest dimension of homology must not be negative");
  const bool filled = options.triangles == Triangles::fill && options.max_dimension > 0;
  return filled ? static_cast<std::uint32_t>(options.max_dimension) + 1 : 1;
}

void pair_cliques(Filtration& cells, Reduction& reduction) {
  for (auto i = cells.cliques.size(); i-- > 0;)
    reduction.pair(cells.cliques[i], i > 0 ? cells.cliques[i - 1].partner : cells.edge_partner);
}

}  // namespace

struct PersistenceWorkspace::Parts {
  ComponentHistory history;  // where the caller has none
  Filtration cells;
  Reduction reduction;
  std::vector<std::uint32_t> chosen;
};

PersistenceWorkspace::PersistenceWorkspace() : parts_(std::make_unique<Parts>()) {}
PersistenceWorkspace::~PersistenceWorkspace() = default;

Diagram persistence(const ComponentHistory& history, const PersistenceOptions& options,
                    PersistenceWorkspace& workspace) {
  const std::uint32_t dimension = clique_dimension(options);
  auto& parts = *workspace.parts_;
  parts.cells.pair_components(history);
  parts.cells.find_cliques(dimension);
  pair_cliques(parts.cells, parts.reduction);
  return write_diagram(parts.cells, options, parts.chosen);
}

Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options, PersistenceWorkspace& workspace) {
  workspace.parts_->history.build(graph);
  return persistence(workspace.parts_->history, options, workspace);
}

// The same, but what a step has used is given back as soon as nothing later needs it.
Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options) {
  const std::uint32_t dimension = clique_dimension(options);
  ComponentHistory history;
  Filtration cells;
  Reduction reduction;
  std::vector<std::uint32_t> chosen;
  history.build(graph);
  cells.pair_components(history);
  history.forget_merges();
  cells.find_cliques(dimension);
  cells.forget_neighbours();
  pair_cliques(cells, reduction);
  return write_diagram(cells, options, chosen);
}

}  // namespace jam
