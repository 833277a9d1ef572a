#include "jamscape/observe/options.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr double kMostRows = 1e6;

void check_grid(const char* max_key, double max, double step) {
  if (max / step < kMostRows) return;
  throw usage_error(fmt::format("{} steps of {} up to {} are too many", max / step, step, max), max_key,
                    "take a larger step or a lower highest value");
}

}  // namespace

void check(const MeasureOptions& o) {
  if (o.force_scale == ForceScale::log && !(o.force_min > 0))
    throw usage_error("logarithmic bins cannot start at zero", "measure.force_min",
                      "give a positive lower edge, or measure.force_scale = \"linear\"");
  if (!(o.force_min < o.force_max))
    throw usage_error(fmt::format("the force bins end at {}, not above their start {}", o.force_max, o.force_min),
                      "measure.force_max", "give force_max above force_min");
  check_grid("measure.betti_max", o.betti_max, o.betti_step);
  check_grid("measure.level_max", o.level_max, o.level_step);
  check_grid("measure.rdf_range", o.rdf_range, o.rdf_bin);
}

}  // namespace jam
