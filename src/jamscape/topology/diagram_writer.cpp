#include "jamscape/topology/diagram_writer.hpp"

#include <algorithm>

namespace jam {
namespace {

/// Writes one diagram.
class Writer {
 public:
  Writer(const Filtration& cells, const PersistenceOptions& options, std::vector<std::uint32_t>& chosen)
      : cells_(cells), options_(options), chosen_(chosen) {}

  Diagram write() {
    diagram_.pairs.reserve(count_pairs());  // once: pairs are most of what is in memory by now
    components();
    if (options_.max_dimension > 0) classes(1, cells_.edge_partner);
    for (const auto& cliques : cells_.cliques) {
      const auto k = static_cast<int>(cliques.dimension);
      if (k <= options_.max_dimension) classes(k, cliques.partner);
    }
    for (const auto& cliques : cells_.cliques) name_cliques(cliques);
    return std::move(diagram_);
  }

 private:
  /// Whether a cell begins a class that may have a length (or is wanted without).
  bool begins(std::uint32_t partner) const {
    const auto limit = options_.keep_zero_length ? static_cast<std::uint32_t>(kCleared) : kAtOnce;
    return partner < limit || partner == kUnpaired;
  }

  /// At most so many pairs are written.
  std::size_t count_pairs() const {
    auto count = static_cast<std::uint32_t>(cells_.isolated().size());
    for (const auto p : cells_.vertex_partner) count += begins(p);
    const auto add_cells = [&](const std::vector<std::uint32_t>& partner) {
      for (const auto p : partner) count += begins(p);
    };
    if (options_.max_dimension > 0) add_cells(cells_.edge_partner);
    for (const auto& cliques : cells_.cliques)
      if (static_cast<int>(cliques.dimension) <= options_.max_dimension) add_cells(cliques.partner);
    return count;
  }

  /// The cells that begin a class, without a branch: no processor could guess it.
  template <class PartnerOf>
  void choose(std::size_t cells, const PartnerOf& partner_of) {
    chosen_.resize(cells + 1);
    std::size_t count = 0;
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
      chosen_[count] = cell;
      count += begins(partner_of(cell));
    }
    chosen_.resize(count);
  }

  void add(int dimension, std::uint32_t from, CellId cell, std::uint32_t partner) {
    const double birth = cells_.weight(from);
    if (partner == kUnpaired) {
      diagram_.pairs.push_back({dimension, birth, 0, true, cell, -1});
      return;
    }
    partner &= ~kAtOnce;
    const auto to = cells_.youngest_edge(static_cast<std::uint32_t>(dimension) + 1, partner);
    const double death = cells_.weight(to);
    if (death == birth && !options_.keep_zero_length) return;
    diagram_.pairs.push_back({dimension, birth, death, false, cell, dimension == 0 ? cells_.edge(partner) : partner});
  }

  void components() {
    const auto& vertices = cells_.vertices();
    const auto& isolated = cells_.isolated();
    choose(vertices.size(), [&](std::uint32_t i) { return cells_.vertex_partner[i]; });
    for (const auto i : chosen_) add(0, vertices.entry[i], vertices.name[i], cells_.vertex_partner[i]);
    if (isolated.empty()) return;
    for (const auto v : isolated) diagram_.pairs.push_back({0, 0, 0, true, v, -1});
    const auto zero = std::partition_point(diagram_.pairs.begin(), diagram_.pairs.end(),
                                           [](const PersistencePair& p) { return p.birth > 0; });
    std::sort(zero, diagram_.pairs.end(), [](const auto& p, const auto& q) { return p.birth_cell < q.birth_cell; });
  }

  void classes(int dimension, const std::vector<std::uint32_t>& partner) {
    choose(partner.size(), [&](std::uint32_t c) { return partner[c]; });
    for (const auto c : chosen_) {
      const auto from = cells_.youngest_edge(static_cast<std::uint32_t>(dimension), c);
      add(dimension, from, dimension == 1 ? cells_.edge(c) : c, partner[c]);
    }
  }

  /// Every clique of dimension k that occurs in a pair, each once.
  template <class Visit>
  void visit_cliques(int k, const Visit& visit) {
    for (const auto& p : diagram_.pairs) {
      if (p.dimension == k) visit(p.birth_cell);
      if (p.dimension + 1 == k && !p.essential) visit(p.death_cell);
    }
  }

  /// Keeps the vertices of the cliques that occur in pairs, in order; the pairs keep their numbers.
  void name_cliques(const Cliques& cliques) {
    const auto k = static_cast<int>(cliques.dimension);
    chosen_.assign(cliques.count(), 0);
    visit_cliques(k, [&](CellId clique) { chosen_[static_cast<std::size_t>(clique)] = 1; });
    std::uint32_t count = 0;
    for (std::uint32_t clique = 0; clique < cliques.count(); ++clique) {  // the place of those that occur
      count += chosen_[clique];
      chosen_[clique] = count - 1;
    }
    const std::size_t size = cliques.dimension + 1;
    auto& out = diagram_.cliques.emplace_back(count * size);
    visit_cliques(k, [&](CellId cell) {
      const auto clique = static_cast<std::uint32_t>(cell);
      write_vertices(cliques, clique, out.data() + chosen_[clique] * size);
    });
  }

  /// In increasing order: each goes to the place that the number of smaller ones gives, without a branch.
  void write_vertices(const Cliques& cliques, std::uint32_t clique, std::uint32_t* out) const {
    const auto [a, b] = cells_.ends(cells_.youngest_edge(cliques.dimension, clique));
    const std::size_t others = cliques.dimension - 1;
    const auto* other = cliques.others_of(clique);  // increasing
    std::size_t before_a = b < a, before_b = a < b;
    for (std::size_t i = 0; i < others; ++i) {
      before_a += other[i] < a;
      before_b += other[i] < b;
      out[i + (a < other[i]) + (b < other[i])] = other[i];
    }
    out[before_a] = a;
    out[before_b] = b;
  }

  const Filtration& cells_;
  const PersistenceOptions& options_;
  std::vector<std::uint32_t>& chosen_;
  Diagram diagram_;
};

}  // namespace

Diagram write_diagram(const Filtration& cells, const PersistenceOptions& options, std::vector<std::uint32_t>& memory) {
  return Writer(cells, options, memory).write();
}

}  // namespace jam
