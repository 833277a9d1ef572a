#include "jamscape/study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

std::vector<std::string> advice(const Study& study, const std::vector<Task>& tasks) {
  std::vector<std::string> said;
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    std::vector<const Task*> runs;
    for (const Task& t : tasks)
      if (t.system == s) runs.push_back(&t);
    if (runs.empty()) continue;
    tell_start(study.systems[s], runs, said);
  }
  return said;
}

}  // namespace jam
