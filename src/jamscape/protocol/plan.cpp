#include "jamscape/protocol/plan.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

std::string number(double a) {
  std::string s = std::to_string(a);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s + "0" : s;
}

/// Steps until walls that close in with `rate` per step have taken `travel`; rounding never adds a step.
std::int64_t steps_for(double travel, double rate) {
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(travel / rate - 1e-6)));
}

}  // namespace

Timetable timetable(const SystemOptions& system, const TaskKey& key) {
  if (system.stages.empty())
    throw usage_error("the study has no stage", {}, "add a [[stage]] table, e.g. kind = \"compress\", to = 0.9");
  const StartBox box = start_box(system, draw_diameters(system.grains, key));
  Timetable table;
  table.box = box.measure;
  table.plan.bodies = system.grains.count;
  double length = box.length, reached = box.measure.packing_fraction(box.length);
  std::size_t number_of_stage = 0;
  for (const StageOptions& stage : system.stages) {
    ++number_of_stage;
    const std::string name = stage.name.empty() ? "compress-" + std::to_string(number_of_stage) : stage.name;
    if (reached > stage.to + 1e-9)
      throw usage_error("stage." + name + ".to = " + number(stage.to) + " is below the packing fraction " +
                            number(reached) + " the stage starts from",
                        {}, "a larger `to`, or a smaller start.packing_fraction");
    const double closing = 2 * stage.speed * system.integrator.step;
    const std::int64_t first = table.plan.steps, steps = steps_for(length - box.measure.length(stage.to), closing);
    std::vector<double> at;
    const double from = std::min(reached, stage.to);
    for (std::int64_t f = 0; f < stage.frames; ++f)
      at.push_back(stage.frames == 1
                       ? stage.to
                       : from + (stage.to - from) * static_cast<double>(f) / static_cast<double>(stage.frames - 1));
    for (const double rho : stage.frames_at) {
      if (rho < from - 1e-9 || rho > stage.to + 1e-9)
        throw usage_error("stage." + name + ".frames_at: " + number(rho) + " lies outside the stage, which goes from " +
                              number(from) + " to " + number(stage.to),
                          {}, "only packing fractions between the two");
      at.push_back(rho);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-9; }), at.end());
    for (const double rho : at)
      table.plan.frames.push_back(
          {name, rho, first + std::min(steps, steps_for(length - box.measure.length(rho), closing))});
    table.stages.push_back({name, first, steps, stage.speed});
    table.plan.steps += steps;
    length -= closing * static_cast<double>(steps);
    reached = stage.to;
  }
  return table;
}

Plan plan(const SystemOptions& system, const TaskKey& key) { return timetable(system, key).plan; }

}  // namespace jam
