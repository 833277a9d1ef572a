#include "jamscape/base/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace jam {

std::string print_duration(double seconds) {
  if (!(seconds >= 0) || !std::isfinite(seconds)) return "?";
  const auto s = static_cast<long long>(std::llround(seconds));
  if (s < 100) return fmt::format("{} s", s);
  if (s < 100 * 60) return fmt::format("{} min", (s + 30) / 60);
  if (s < 48 * 3600) return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
  return fmt::format("{} d {} h", s / 86400, s % 86400 / 3600);
}

std::string print_bar(double fraction, const std::vector<std::string>& notes, std::size_t width) {
  constexpr int cells = 10;
  fraction = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(fraction * cells);
  std::string bar(cells, ' ');
  for (int k = 0; k < cells; ++k)
    if (k <= full) bar[static_cast<std::size_t>(k)] = k < full ? '=' : '>';
  std::string line = fmt::format("[{}] {:3d} %", bar, static_cast<int>(fraction * 100));
  for (const std::string& note : notes)
    if (!note.empty()) line += "  " + note;
  return line.substr(0, width);
}

bool progress_terminal() { return ::isatty(STDERR_FILENO) != 0; }

std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace jam
