// Text of others made fit to show: what a file or a name holds must not steer a terminal.
#pragma once

#include <string>
#include <string_view>

namespace jam {

enum class LineEnds { keep, escape };

/// The text with control bytes (also those of UTF-8 beyond ASCII, and marks that turn the direction of writing) and
/// bytes that are no UTF-8 written as \x1b; letters of any script stay.
std::string printable(std::string_view text, LineEnds line_ends = LineEnds::keep);

}  // namespace jam
