// A graph that grows edge by edge, oldest first, and answers which vertices its edges so far link to both of two
// others.
//
// Neighbours lie in one array with room for all, appended as edges come: contact networks have few neighbours, and
// comparing them pair by pair beats any index. Vertices with more than kHub edges also get a list sorted by age, so
// that a search costs the smaller neighbourhood times the logarithm of the larger, on any graph.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

/// The two ends of an edge by age, the older first.
struct Ends {
  std::uint32_t a, b;
};

/// A vertex linked to both ends of an edge, and the ranks of the two links.
struct CommonNeighbour {
  std::uint32_t age, link_a, link_b;
};

class OlderGraph {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  static constexpr std::uint32_t kHub =
      32;  ///< fewer: more graphs pay for sorting; more: long lists compared pair by pair

  /// No edges yet, room for these.
  void reset(std::uint32_t vertices, std::span<const Ends> edges);

  void add(Ends e, std::uint32_t rank) {
    around_[end_[e.a]++] = {e.b, rank};
    around_[end_[e.b]++] = {e.a, rank};
    added_ = rank + 1;
  }

  /// Vertices linked to both ends by edges added so far, by increasing age. False if the two ends are linked
  /// themselves.
  bool common(Ends e, std::vector<CommonNeighbour>& found) const;

  /// Rank of the edge added between two vertices, kNone if there is none.
  std::uint32_t linked(std::uint32_t x, std::uint32_t y) const;

  std::uint32_t max_degree() const { return max_degree_; }

 private:
  struct Neighbour {
    std::uint32_t age, rank;
  };

  std::span<const Neighbour> around(std::uint32_t v) const { return {around_.data() + begin_[v], end_[v] - begin_[v]}; }
  void index_hubs(std::uint32_t vertices, std::span<const Ends> edges);
  std::uint32_t linked_to_hub(std::uint32_t hub, std::uint32_t other) const;

  std::vector<std::uint32_t> begin_, end_;  // one a vertex, into around_
  std::vector<Neighbour> around_;
  std::uint32_t max_degree_ = 0;
  std::uint32_t added_ = 0;               // edges of smaller rank have been added
  std::vector<std::uint32_t> hub_begin_;  // one a vertex and one more, into hub_around_; empty without hubs
  std::vector<Neighbour> hub_around_;     // all edges of the hubs, also those not added yet
};

}  // namespace jam
