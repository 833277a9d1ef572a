#include "jamscape/protocol/stages/compress.hpp"

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/box_timetable.hpp"

namespace jam {
namespace {

/// The packing fractions of the frames, in order.
std::vector<double> frames_of_compression(const StageOptions& stage, const BoxTimetable& table) {
  std::vector<double> at;
  const double from = std::min(table.reached(), stage.to), to = stage.to;
  const double lowest = std::min(from, table.packing_fraction());
  for (std::int64_t f = 0; f < stage.frames; ++f)
    at.push_back(
        stage.frames == 1 ? to : from + (to - from) * static_cast<double>(f) / static_cast<double>(stage.frames - 1));
  for (const double rho : stage.frames_at) {
    if (rho < lowest - 1e-9 || rho > to + 1e-9)
      throw usage_error("stage." + table.stage() + ".frames_at: " + short_number(rho) +
                            " lies outside the stage, which goes from " + short_number(lowest) + " to " +
                            short_number(to),
                        {}, "only packing fractions between the two");
    at.push_back(rho);
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-9; }), at.end());
  return at;
}

}  // namespace

void Compress::write(const StageOptions& stage, BoxTimetable& table) {
  table.refuse_below(stage.to, stage.frames > 1);
  table.close_to(stage.to, stage.speed, frames_of_compression(stage, table));
}

}  // namespace jam
