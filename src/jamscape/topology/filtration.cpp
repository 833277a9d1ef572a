#include "jamscape/topology/filtration.hpp"

#include <algorithm>
#include <array>

#include "jamscape/network/validate.hpp"
#include "jamscape/topology/clique_builder.hpp"

namespace jam {
namespace {

constexpr std::uint32_t kTogether = 64;  // edges; more: what is asked of them has left the cache when it is answered

static_assert(kAtOnce == 1u << 31 && kUnpaired == ~0u && kUnpaired == (kNegative | 1u));

}  // namespace

// Whether an edge joins components no processor could guess: it is not asked.
void Filtration::pair_components(const ComponentHistory& history) {
  history_ = &history;
  const auto merges = history.merges();
  const auto& entry = vertices().entry;
  vertex_partner.assign(vertices().size(), kUnpaired);
  edge_partner.resize(merges.size());
  std::uint32_t first = 0;  // of the edges that weigh as much as the present one
  double last = merges.empty() ? 0 : weight(0);
  for (std::uint32_t r = 0; r < merges.size(); ++r) {
    first = weight(r) == last ? first : r;
    last = weight(r);
    const auto [kept, lost] = merges[r];
    const std::uint32_t closes = kept == lost, at_once = entry[lost] == first;
    vertex_partner[lost] = r | at_once << 31 | (0 - closes);
    edge_partner[r] = kNegative | closes;
  }
}

void Filtration::find_cliques(std::uint32_t dimension) {
  if (dimension < 2) {
    cliques.clear();
    return validate(history_->graph());  // no repeated edges: nothing else would notice
  }
  const auto ends = history_->ends();
  older_.reset(history_->degree(), ends);
  const auto largest = std::max(2u, older_.max_degree());  // a clique of dimension k needs k edges at each vertex
  CliqueBuilder builder(older_, ends, std::min(dimension, largest), cliques);
  const auto n = edges();
  const auto early = history_->ahead();
  std::array<OlderGraph::Question, kTogether + 1> asked;
  for (std::uint32_t r = 0; r < n;) {
    std::size_t count = 0;
    for (const auto end = std::min(n, r + kTogether); r < end; ++r) {
      if (r + early < n) {
        older_.prefetch(ends[r + early]);
        older_.prefetch_neighbours(ends[r + early / 2]);
      }
      asked[count] = older_.ask(ends[r], r);
      const bool closes = edge_partner[r] != kNegative, may_share = asked[count].hashes != 0;
      count += closes & may_share;
      older_.add(ends[r], r);
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (!older_.answer(asked[k], common_)) validate(history_->graph());  // a repeated edge: throws, naming it
      if (!common_.empty()) builder.add(asked[k].rank, common_);
    }
  }
}

void Filtration::forget_neighbours() { older_ = {}; }

std::uint32_t Filtration::youngest_edge(std::uint32_t dimension, std::uint32_t cell) const {
  for (; dimension > 1; --dimension) cell = cliques[dimension - 2].facets_of(cell)[0];
  return cell;
}

}  // namespace jam
