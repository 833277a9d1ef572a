#include "jamscape/protocol/stages/steps.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/protocol/box_timetable.hpp"

namespace jam {

void Steps::write(const StageOptions& stage, BoxTimetable& table) {
  table.refuse_below(stage.to, true);
  const auto rungs = static_cast<std::int64_t>(std::floor((stage.to - table.reached()) / stage.increment - 1e-6));
  for (std::int64_t rung = std::max<std::int64_t>(rungs, 0); rung >= 0; --rung) {
    const double from = table.reached(), to = stage.to - static_cast<double>(rung) * stage.increment;
    std::vector<double> inside;
    for (std::int64_t f = 1; f <= stage.frames_inside; ++f)
      inside.push_back(from + (to - from) * static_cast<double>(f) / static_cast<double>(stage.frames_inside));
    table.close_to(to, stage.speed, inside);
    table.rest(stage.relax);
  }
}

}  // namespace jam
