// A graph that grows edge by edge, oldest first, and answers which vertices its edges so far link to both of two
// others. It may be asked at one time and answer later, when more edges have come: whether an edge has any such vertex
// no processor could guess, so it is cheaper to put aside the questions worth an answer than to go into each at once.
//
// Neighbours lie in one array with room for all, appended as edges come. Each vertex has 64 bits, one set for each
// neighbour by a hash: two vertices without a bit in common have no neighbour in common, which settles most questions.
// The rest compare two short lists; vertices with more than kHub edges also have a sorted list, so that a search costs
// the smaller neighbourhood times the logarithm of the larger, on any graph.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/network/component_history.hpp"

namespace jam {

/// A vertex linked to both ends of an edge, and the ranks of the two links.
struct CommonNeighbour {
  std::uint32_t vertex, link_a, link_b;
};

class OlderGraph {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  static constexpr std::uint32_t kHub = 32;  ///< smaller: more graphs pay for sorting; larger: long lists are compared

  /// Room for edges with these ends, by rank; none is added yet. `degree` has one entry a vertex.
  void reset(std::span<const std::uint32_t> degree, std::span<const Ends> edges);

  /// Edges must be added rank by rank.
  void add(Ends e, std::uint32_t rank) {
    append(vertices_[e.a], {e.b, rank});
    append(vertices_[e.b], {e.a, rank});
  }

  /// Which vertices are linked to both ends by the edges added so far, those of ranks below `rank`?
  struct Question {
    Ends e;
    std::uint32_t rank, end_a, end_b;
    std::uint64_t hashes;  ///< 0 where there are certainly none, and the two ends are not linked
  };
  Question ask(Ends e, std::uint32_t rank) const {
    const Vertex &a = vertices_[e.a], &b = vertices_[e.b];
    return {e, rank, a.end, b.end, a.hashes & (b.hashes | hash(e.b))};
  }
  /// They, by increasing number. False if the two ends are linked.
  bool answer(const Question& q, std::vector<CommonNeighbour>& found) const;

  /// Rank of the edge between two vertices, if it has been added and is below `before`; else kNone.
  std::uint32_t linked(std::uint32_t x, std::uint32_t y, std::uint32_t before) const;

  std::uint32_t max_degree() const { return max_degree_; }

  /// Ask the cache for what an edge will need soon: first its vertices, some time later their neighbours.
  void prefetch(Ends e) const {
    __builtin_prefetch(&vertices_[e.a], 1);
    __builtin_prefetch(&vertices_[e.b], 1);
  }
  void prefetch_neighbours(Ends e) const {
    __builtin_prefetch(&neighbours_[vertices_[e.a].begin], 1);
    __builtin_prefetch(&neighbours_[vertices_[e.b].begin], 1);
  }

 private:
  struct Neighbour {
    std::uint32_t vertex, rank;
  };
  struct Vertex {  // what a question needs first, in one cache line
    std::uint32_t begin, end;
    std::uint64_t hashes;
  };

  static std::uint64_t hash(std::uint32_t vertex) { return std::uint64_t{1} << (vertex * 0x9E3779B1u >> 26); }
  void append(Vertex& v, Neighbour n) {
    neighbours_[v.end++] = n;
    v.hashes |= hash(n.vertex);
  }
  std::span<const Neighbour> around(std::uint32_t v, std::uint32_t end) const {
    return {neighbours_.data() + vertices_[v].begin, end - vertices_[v].begin};
  }
  std::span<const Neighbour> around(std::uint32_t v) const { return around(v, vertices_[v].end); }
  void index_hubs(std::span<const std::uint32_t> degree, std::span<const Ends> edges);
  std::uint32_t linked_to_hub(std::uint32_t hub, std::uint32_t other, std::uint32_t before) const;

  std::vector<Vertex> vertices_;
  std::vector<Neighbour> neighbours_;
  std::uint32_t max_degree_ = 0;
  std::vector<std::uint32_t> hub_begin_;   // one a vertex and one more, into hub_neighbours_; unused without hubs
  std::vector<Neighbour> hub_neighbours_;  // all edges of the hubs, also those not added yet
};

}  // namespace jam
