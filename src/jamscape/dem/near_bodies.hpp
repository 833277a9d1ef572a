// The bodies near a body: what the search for pairs asks of a kernel.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jam {

/// Candidates side by side in memory that are tried in one image of the box (a row of image_shifts()).
struct CandidateRange {
  std::uint32_t from, to, shift;
};

/// The body at `row`, of index `a`, and what may be near it. Arrays of candidates can be read for a vector more.
struct NearQuery {
  const double* row;
  std::uint32_t a;
  double skin;
  const double* x[3];  ///< positions of the candidates
  const double* radius;
  const std::uint32_t* body;  ///< their indices
  const CandidateRange* ranges;
  std::size_t range_count;
  const double* shifts;
};

/// Room for as many as there are candidates, and a vector more.
struct NearBodies {
  static constexpr std::uint32_t touching = 1u << 31;
  std::uint32_t* body;   ///< the index; and `touching`, where they touch
  std::uint32_t* shift;  ///< the image
};

}  // namespace jam
