// How far a long piece of work has come, as text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jam {

/// "48 s", "12 min", "3 h 05 min", "2 d 4 h"; "?" for a negative or non-finite time.
std::string print_duration(double seconds);

/// "[=====>    ]  52 %" followed by the notes, cut to `width` columns.
std::string print_bar(double fraction, const std::vector<std::string>& notes, std::size_t width);

/// True where a bar can be redrawn in place: standard error is a terminal.
bool progress_terminal();
/// Its width in columns (80 when unknown).
std::size_t terminal_width();

}  // namespace jam
