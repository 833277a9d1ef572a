#include "jamscape/protocol/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/box_timetable.hpp"
#include "jamscape/protocol/cluster_start.hpp"
#include "jamscape/protocol/container_timetable.hpp"

namespace jam {
namespace {

/// How a kind of stage is written into a timetable. Throws a usage error where there is no such stage.
auto writer_of(const StageInfo& info, const BoxTimetable& table) {
  if (!info.in_box)
    throw usage_error(
        fmt::format("stage.{}.kind: there is no stage \"{}\" in a box that shrinks", table.stage(), info.name), {},
        "domain.walls = \"box\" or \"cylinder\" is a container");
  return info.in_box;
}

/// "settle, press and relax"
std::string kinds_of_container() {
  std::vector<std::string_view> names;
  for (const StageInfo& s : stage_kinds())
    if (s.in_container) names.push_back(s.name);
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

auto writer_of(const StageInfo& info, const ContainerTimetable& table) {
  if (!info.in_container)
    throw usage_error(fmt::format("stage.{}.kind: there is no stage \"{}\" in a container", table.stage(), info.name),
                      {}, kinds_of_container());
  return info.in_container;
}

void refuse_frames(const StageOptions& stage, const std::string& name) {
  if (stage.traits().on_user_frames || (stage.frames == 0 && stage.frames_at.empty())) return;
  std::string kinds;
  for (const StageInfo& s : stage_kinds())
    if (s.traits.on_user_frames) kinds += fmt::format("{}\"{}\"", kinds.empty() ? "" : " or ", s.name);
  throw usage_error(fmt::format("stage.{}.{}: only stages of kind = {} have it", name,
                                stage.frames > 0 ? "frames" : "frames_at", kinds),
                    {}, std::string(stage.traits().instead_of_frames));
}

/// Neighbours are looked for in cells a little wider than the largest grain; across a periodic box there are three.
void check_width(const SystemOptions& system, const BoxMeasure& box, double largest) {
  constexpr double thin = 0.01, thick = 0.3;  // what a cell is wider, by the speed of the grains
  double to = 0;
  for (const StageOptions& stage : system.stages)
    if (stage.traits().to_packing_fraction) to = std::max(to, stage.to);
  if (to == 0 || box.length(to) >= 3 * (largest + thin)) return;
  const double count = static_cast<double>(system.grains.count) *
                       std::pow(3 * (largest + thick) / box.length(to), static_cast<double>(system.domain.dimension));
  throw usage_error(
      fmt::format("grains.count = {}: the periodic box is {:.3g} d wide at packing fraction {}, less than "
                  "three of the largest grains ({:.3g} d), so that one could touch another on both sides",
                  system.grains.count, box.length(to), to, largest),
      {}, fmt::format("grains.count = {:.0f}, or walls", std::ceil(count)));
}

template <class Table>
Timetable write_all(Table table, const SystemOptions& system) {
  for (std::size_t s = 0; s < system.stages.size(); ++s) {
    const StageOptions& stage = system.stages[s];
    table.begin_stage(stage_name(system, s));
    const auto write = writer_of(stage_info(stage.kind), table);
    refuse_frames(stage, table.stage());
    write(stage, table);
  }
  Timetable written = table.finish();
  written.plan.bodies = system.grains.count;
  return written;
}

}  // namespace

std::int64_t steps_for(double travel, double rate) {
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(travel / rate - 1e-6)));
}

Timetable timetable(const SystemOptions& system, const TaskKey& key) {
  if (system.stages.empty())
    throw usage_error("the study has no stage", {}, "add a [[stage]] table, e.g. kind = \"compress\", to = 0.9");
  if (has_lid(system.domain.walls))
    return write_all(ContainerTimetable(system, cluster_room(system, key).height), system);
  const std::vector<double> diameters = draw_diameters(system.grains, key);
  const StartBox box = start_box(system, diameters);
  if (system.domain.walls == WallModel::periodic)
    check_width(system, box.measure, *std::max_element(diameters.begin(), diameters.end()));
  return write_all(BoxTimetable(box, system), system);
}

Plan plan(const SystemOptions& system, const TaskKey& key) { return timetable(system, key).plan; }

bool PlannedFrame::matches(std::int64_t at, const std::string& of, double found, const std::string& relaxation) const {
  if (step >= 0) return at == step;
  if (of != stage || relaxed != !relaxation.empty()) return false;
  return std::isnan(packing_fraction) || std::abs(found - packing_fraction) < 1e-3;  // fast walls overshoot
}

}  // namespace jam
