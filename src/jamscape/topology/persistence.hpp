// Persistent homology of a weighted graph's clique complex, by superlevel sets, over Z/2.
//
// A vertex enters at the largest weight of its edges (0 if it has none), an edge at its weight, a clique at the
// smallest weight of its edges. The level set at theta holds every cell with value >= theta; lowering theta, a class is
// born at `birth` and dies at `death` <= birth. A class that never dies has death 0 and essential = true. Pairs of zero
// length are dropped unless asked for; essential classes are always kept, also the pairs (0, 0) of isolated vertices.
// Cells of equal value enter by increasing index, so the pairs of cells are the same on every run. Source: S1 App. B;
// conventions theory sec. 4.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jamscape/network/component_history.hpp"
#include "jamscape/network/graph.hpp"

namespace jam {

/// What becomes of cycles of three mutually linked vertices: filled by a triangle (S1), or kept as loops.
enum class Triangles { fill, keep };

struct PersistenceOptions {
  int max_dimension = 1;  ///< highest homology dimension wanted: 0, 1, 2, ...
  Triangles triangles = Triangles::fill;
  bool keep_zero_length = false;  ///< keep pairs with birth == death of cells that are not isolated vertices
};

/// Index of a cell: a vertex in dimension 0, an edge in dimension 1, a clique in dimension k >= 2 among all of them as they
/// enter, the same whatever else is asked for. -1 where there is none (the death of an essential class).
using CellId = std::int64_t;

struct PersistencePair {
  int dimension = 0;
  double birth = 0;
  double death = 0;
  bool essential = false;
  CellId birth_cell = -1;  ///< a cell of dimension `dimension`
  CellId death_cell = -1;  ///< a cell of dimension `dimension` + 1
};

/// All pairs, by dimension, then decreasing birth, then increasing birth cell: the same for any order of threads.
struct Diagram {
  std::vector<PersistencePair> pairs;
  /// vertices of the cliques that occur in pairs, by dimension (index 0 = triangles) and number; flat, k + 1 increasing
  /// ones each
  std::vector<std::vector<std::uint32_t>> cliques;
};

/// The pairs of one dimension.
inline std::span<const PersistencePair> pairs_of(const Diagram& diagram, int dimension) {
  const auto begin = std::partition_point(diagram.pairs.begin(), diagram.pairs.end(),
                                          [&](const PersistencePair& p) { return p.dimension < dimension; });
  const auto end = std::partition_point(begin, diagram.pairs.end(),
                                        [&](const PersistencePair& p) { return p.dimension == dimension; });
  return {begin, end};
}

/// Memory that calls may share to be faster; one for each thread. Its contents never influence a result.
class PersistenceWorkspace {
 public:
  PersistenceWorkspace();
  ~PersistenceWorkspace();
  PersistenceWorkspace(const PersistenceWorkspace&) = delete;
  PersistenceWorkspace& operator=(const PersistenceWorkspace&) = delete;

 private:
  friend Diagram persistence(const WeightedGraph&, const PersistenceOptions&, PersistenceWorkspace&);
  friend Diagram persistence(const ComponentHistory&, const PersistenceOptions&, PersistenceWorkspace&);
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Throws a data error for a negative or non-finite weight, an edge out of range, a loop or a repeated edge.
/// Safe to call from several threads.
Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options = {});
Diagram persistence(const WeightedGraph& graph, const PersistenceOptions& options, PersistenceWorkspace& workspace);
/// The same for a graph whose components are known already.
Diagram persistence(const ComponentHistory& history, const PersistenceOptions& options,
                    PersistenceWorkspace& workspace);

}  // namespace jam
