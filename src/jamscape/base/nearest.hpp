// "Did you mean": the known name closest to what was typed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jam {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name at the smallest distance (the first of equals), or "" when none is close enough to be meant. A dotted
/// name also matches by its last part: "frction" finds "contact.friction".
std::string nearest(std::string_view typed, const std::vector<std::string>& known);

}  // namespace jam
