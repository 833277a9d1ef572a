#include "jamscape/topology/clique_builder.hpp"

#include <algorithm>
#include <string>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

void check_room(const Cliques& cells) {
  if (cells.count() < kAtOnce - (1u << 20)) return;
  throw data_error("the network has too many cliques: 2^31 of dimension " + std::to_string(cells.dimension), {},
                   "ask for a lower dimension of homology, or raise the threshold below which contacts are left out");
}

}  // namespace

CliqueBuilder::CliqueBuilder(const OlderGraph& graph, std::span<const Ends> ends, std::uint32_t dimension,
                             std::vector<Cliques>& into)
    : graph_(graph), ends_(ends), dimension_(dimension), cliques_(into) {
  cliques_.resize(dimension >= 2 ? dimension - 1 : 0);
  for (std::uint32_t k = 2; k <= dimension; ++k) {
    cliques_[k - 2].dimension = k;
    cliques_[k - 2].clear();
    if (k < dimension) cliques_[k - 2].group.resize(ends.size());
  }
}

void CliqueBuilder::add(std::uint32_t rank, std::span<const CommonNeighbour> common) {
  rank_ = rank;
  common_ = common;
  for (std::uint32_t k = 2; k < dimension_; ++k) cliques_[k - 2].group[rank] = cliques_[k - 2].count();
  auto& triangles = cliques_[0];
  check_room(triangles);
  for (const auto& c : common) {
    triangles.facets.insert(triangles.facets.end(), {rank_, c.link_a, c.link_b});
    triangles.others.push_back(c.vertex);
    triangles.partner.push_back(kUnpaired);
  }
  const std::size_t n = common.size();
  if (n < 2) return;
  links_.assign(n * n, OlderGraph::kNone);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      links_[i * n + j] = links_[j * n + i] = graph_.linked(common[i].vertex, common[j].vertex, rank);
    }
  }
  if (dimension_ == 2) {
    for (std::size_t i = 1; i < n; ++i) {
      chosen_.assign(1, i);
      if (begins_class()) triangles.partner[triangles.count() - n + i] = kCleared;
    }
    return;
  }
  for (std::uint32_t k = 3; k <= dimension_; ++k) {  // facets must be there before the cliques they bound
    const auto before = cliques_[k - 2].count();
    chosen_.clear();
    choose(k, 0);
    if (cliques_[k - 2].count() == before) break;
  }
}

void CliqueBuilder::choose(std::uint32_t dimension, std::size_t next) {
  if (chosen_.size() + 1 == dimension) return add_larger(dimension);
  for (std::size_t i = next; i < common_.size(); ++i) {
    const auto linked_to_i = [&](std::size_t c) { return link(c, i) != OlderGraph::kNone; };
    if (!std::all_of(chosen_.begin(), chosen_.end(), linked_to_i)) continue;
    chosen_.push_back(i);
    choose(dimension, i + 1);
    chosen_.pop_back();
  }
}

bool CliqueBuilder::begins_class() const {
  for (std::size_t i = 0; i < chosen_.front(); ++i) {
    const auto linked_to_i = [&](std::size_t c) { return link(c, i) != OlderGraph::kNone; };
    if (std::all_of(chosen_.begin(), chosen_.end(), linked_to_i)) return true;
  }
  return false;
}

void CliqueBuilder::add_larger(std::uint32_t dimension) {
  auto& cells = cliques_[dimension - 2];
  check_room(cells);
  for (std::size_t i = 0; i < chosen_.size(); ++i) cells.facets.push_back(facet_of_group(dimension - 1, i));
  cells.facets.push_back(facet_without_end(dimension - 1, true));
  cells.facets.push_back(facet_without_end(dimension - 1, false));
  for (const auto c : chosen_) cells.others.push_back(common_[c].vertex);
  cells.partner.push_back(dimension == dimension_ && begins_class() ? kCleared : kUnpaired);
}

std::uint32_t CliqueBuilder::facet_of_group(std::uint32_t dimension, std::size_t left_out) {
  others_.clear();
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    if (i != left_out) others_.push_back(common_[chosen_[i]].vertex);
  }
  return find(dimension, rank_, others_);
}

std::uint32_t CliqueBuilder::facet_without_end(std::uint32_t dimension, bool without_a) {
  std::uint32_t youngest = 0;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const auto& c = common_[chosen_[i]];
    youngest = std::max(youngest, without_a ? c.link_b : c.link_a);
    for (std::size_t j = 0; j < i; ++j) youngest = std::max(youngest, link(chosen_[i], chosen_[j]));
  }
  const auto [a, b] = ends_[youngest];
  others_.clear();
  const auto keep = [&, p = a, q = b](std::uint32_t vertex) {
    if (vertex != p && vertex != q) others_.push_back(vertex);
  };
  keep(without_a ? ends_[rank_].b : ends_[rank_].a);
  for (const auto c : chosen_) keep(common_[c].vertex);
  std::sort(others_.begin(), others_.end());
  return find(dimension, youngest, others_);
}

std::uint32_t CliqueBuilder::find(std::uint32_t dimension, std::uint32_t rank,
                                  std::span<const std::uint32_t> others) const {
  const auto& cells = cliques_[dimension - 2];
  auto cell = cells.group[rank];
  while (!std::equal(others.begin(), others.end(), cells.others_of(cell))) ++cell;
  return cell;
}

}  // namespace jam
