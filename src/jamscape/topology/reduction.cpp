#include "jamscape/topology/reduction.hpp"

#include <algorithm>

namespace jam {

void Reduction::add_boundary(const Cliques& columns, std::uint32_t column, const std::vector<std::uint32_t>& rows) {
  const auto* facet = columns.facets_of(column);
  for (std::uint32_t i = 0; i <= columns.dimension; ++i) {
    if (rows[facet[i]] != kNegative) work_.toggle(facet[i]);
  }
}

void Reduction::add_column(const Cliques& columns, std::uint32_t partner, const std::vector<std::uint32_t>& rows) {
  if ((partner & kAtOnce) != 0) return add_boundary(columns, partner & ~kAtOnce, rows);
  const auto at = std::lower_bound(reduced_.begin(), reduced_.end(), partner);
  const auto i = static_cast<std::size_t>(at - reduced_.begin());
  for (auto k = begin_[i]; k < begin_[i + 1]; ++k) work_.toggle(entries_[k]);
}

void Reduction::pair(Cliques& columns, std::vector<std::uint32_t>& rows) {
  work_.reset(rows.size());
  reduced_.clear();
  entries_.clear();
  begin_.assign(1, 0);
  for (std::uint32_t c = 0; c < columns.count(); ++c) {
    if (columns.partner[c] != kUnpaired) continue;
    const auto youngest = columns.facets_of(c)[0];
    if (rows[youngest] == kUnpaired) {
      rows[youngest] = c | kAtOnce;
      columns.partner[c] = kNegative;
      continue;
    }
    add_boundary(columns, c, rows);
    while (!work_.empty()) {
      const auto row = work_.largest();
      if (rows[row] != kUnpaired) {
        add_column(columns, rows[row], rows);
        continue;
      }
      rows[row] = c;
      columns.partner[c] = kNegative;
      reduced_.push_back(c);
      while (!work_.empty()) {
        const auto next = work_.largest();
        entries_.push_back(static_cast<std::uint32_t>(next));
        work_.toggle(next);
      }
      begin_.push_back(entries_.size());
    }
  }
}

}  // namespace jam
