#include "jamscape/study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jamscape/contact/time_scale.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

/// The lattice of the widest realisation, where some are wider than asked for.
void tell_start(const System& system, const std::vector<const Task*>& runs, std::vector<std::string>& said) {
  const double wanted = system.options.start.packing_fraction;
  double widest = wanted;
  for (const Task* t : runs)
    if (t->plan.start > 0) widest = std::min(widest, t->plan.start);
  if (widest > wanted - 1e-9) return;
  said.push_back(fmt::format(
      "system '{}': the largest grains do not fit on a lattice of packing fraction {}; it begins at {:.3f} and is "
      "closed to {} by itself, at the speed of the first stage; frames count from there (an [[stage]] of its own, to = "
      "{}, sets another speed)",
      system.name, wanted, widest, wanted, wanted));
}

/// The duration of the shortest collision: of two of the smallest grains, or of one and a wall.
void tell_step(const System& system, const std::vector<const Task*>& runs, std::vector<std::string>& said) {
  const SystemOptions& o = system.options;
  if (engine_of(o) == EngineKind::clusters) return;
  const int D = static_cast<int>(o.domain.dimension);
  const double smallest = std::ranges::min(draw_diameters(o.grains, runs.front()->key));
  const double mass = std::pow(smallest, D) / mean_power(o.grains, D);
  double speed = o.start.speed;
  for (const StageOptions& stage : o.stages) speed = std::max(speed, stage.speed);
  const double beta = hardening_exponent(o.contact.law),
               stiffest = o.contact.stiffness * std::max(1.0, o.contact.wall_stiffness);
  const double shortest = collision_time(mass / 2, stiffest, speed, beta);
  constexpr double fewest = 10, usual = 50;  // steps a collision; explicit schemes are unstable below some 2
  if (o.integrator.step * fewest <= shortest) return;
  said.push_back(fmt::format(
      "system '{}': a collision of the smallest grains takes {:.2g} tau_c, {:.1f} steps of integrator.step = {}, which "
      "cannot carry contact.stiffness = {:.3g}; integrator.step = {:.1g} would",
      system.name, shortest, shortest / o.integrator.step, o.integrator.step, o.contact.stiffness, shortest / usual));
}

void tell_area(const System& system, std::vector<std::string>& said) {
  const SystemOptions& o = system.options;
  if (!plans_packing_fraction(o) || o.domain.area == AreaConvention::actual) return;
  const double larger = mean_power(o.grains, static_cast<int>(o.domain.dimension));
  if (std::abs(larger - 1) <= 0.05) return;
  double to = 0;
  for (const StageOptions& stage : o.stages)
    if (stage.traits().to_packing_fraction) to = std::max(to, stage.to);
  said.push_back(fmt::format(
      "system '{}': with domain.area = \"nominal\" packing fractions count grains of the mean diameter, and these fill "
      "{:.3g} times as much: {} is truly {:.3g}; domain.area = \"actual\" counts what is there",
      system.name, larger, to, to * larger));
}

void tell_frames(const System& system, std::vector<std::string>& said) {
  for (const StageOptions& stage : system.options.stages)
    if (!stage.traits().on_user_frames || stage.frames > 0 || !stage.frames_at.empty()) return;
  said.push_back(fmt::format("system '{}': no stage has frames; one is taken at the end (stage.NAME.frames = 61, say)",
                             system.name));
}

}  // namespace

std::vector<std::string> advice(const Study& study, const std::vector<Task>& tasks) {
  std::vector<std::string> said;
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    std::vector<const Task*> runs;
    for (const Task& t : tasks)
      if (t.system == s) runs.push_back(&t);
    if (runs.empty()) continue;
    tell_start(study.systems[s], runs, said);
    tell_step(study.systems[s], runs, said);
    tell_area(study.systems[s], said);
    tell_frames(study.systems[s], said);
  }
  return said;
}

}  // namespace jam
