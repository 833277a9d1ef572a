// Counts of a diagram's points in the four regions of S1 Fig. 3: rough, strong, medium, weak (theory sec. 4).
//
//   rough   birth - death < rough           (short-lived: geometric noise)
//   strong  otherwise, strong <= birth
//   medium  otherwise, medium <= birth < strong
//   weak    otherwise, birth < medium
//
// An essential class dies at 0. Pairs of zero length do not count, except the isolated vertices (0, 0) of dimension 0,
// which are rough. Every other point of a diagram with deaths >= 0 falls in exactly one bin. What lies on a border to
// within round-off of the birth is on it (base/border.hpp): 1.1 - 1 is a lifetime of exactly .1, and a birth of 2.5 is
// strong, whatever the last digits of a quotient say.
#pragma once

#include <cstddef>

#include "jamscape/topology/persistence.hpp"

namespace jam {

/// Which bin a lifetime of exactly `rough` falls in.
enum class RoughEdge {
  open,    ///< not rough: b - d < rough is (S1)
  closed,  ///< rough: b - d <= rough is (S2)
};

/// Borders in the unit of the weights; S1 and S2 use mean forces.
struct BinOptions {
  double rough = .1;
  double medium = 1;
  double strong = 2.5;
  RoughEdge edge = RoughEdge::open;
};

struct BinCounts {
  std::size_t rough = 0, strong = 0, medium = 0, weak = 0;

  std::size_t total() const { return rough + strong + medium + weak; }
  friend bool operator==(const BinCounts&, const BinCounts&) = default;
};

BinCounts persistence_bins(const Diagram& diagram, int dimension, const BinOptions& options = {});

}  // namespace jam
