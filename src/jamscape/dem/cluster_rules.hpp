// Choices in the contact of two clusters that the papers leave open (theory sec. 3).
#pragma once

#include <string_view>
#include <utility>

#include "jamscape/base/option.hpp"

namespace jam {

/// Where two nearly parallel arms (angle below a bound, 2 degrees in S3) touch. Overlap and normal are always those of
/// the closest points.
enum class ParallelRule {
  middle,  ///< in the middle of the stretch along which they lie side by side: jumps at the bound [S3]
  blend    ///< moves from the closest points (at the bound) to that middle (parallel) without a jump
};
template <>
struct EnumNames<ParallelRule> {
  static constexpr std::pair<ParallelRule, std::string_view> values[] = {{ParallelRule::middle, "middle"},
                                                                         {ParallelRule::blend, "blend"}};
};

/// What becomes of contacts of one pair of bodies that lie closer together than an arm radius, as near the hub of
/// short arms: literally each counts, or only the deepest of each such group.
enum class DuplicateRule { literal, merge };
template <>
struct EnumNames<DuplicateRule> {
  static constexpr std::pair<DuplicateRule, std::string_view> values[] = {{DuplicateRule::literal, "literal"},
                                                                          {DuplicateRule::merge, "merge"}};
};

}  // namespace jam
