#include "jamscape/study/identity.hpp"

#include <fmt/format.h>

#include "jamscape/base/hash.hpp"
#include "jamscape/base/schema.hpp"

namespace jam {
namespace {

/// Appends the options in which `s` differs from `standard`.
template <class S>
void append_differing(S s, S standard, const std::string& prefix, std::string& text) {
  const std::vector<Option> set = options_of(s, prefix), defaults = options_of(standard, prefix);
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const std::string value = print_value(set[k]); value != print_value(defaults[k]))
      text += set[k].key + " = " + value + "\n";
}

}  // namespace

std::string physics_text(const SystemOptions& system) {
  std::string text;
  SystemOptions named = system, standard;
  // By its value, whether a study gave it or not; 1/2 was the default before there was one for each dimension.
  standard.grains.inertia_factor = 0.5;
  named.grains.inertia_factor = system.grains.shape == BodyShape::ball ? inertia_factor(system) : 0.5;
  append_differing(std::move(named), standard, "", text);
  for (std::size_t k = 0; k < system.stages.size(); ++k) {
    StageOptions stage = system.stages[k];
    stage.name.clear();
    stage.forget_frames();
    text += fmt::format("stage {}\n", k + 1);
    append_differing(std::move(stage), StageOptions{}, "stage.", text);
  }
  return text;
}

std::string physics_key(const SystemOptions& system) { return short_hash("jamscape physics\n" + physics_text(system)); }

TaskKey task_key(const SystemOptions& system, std::uint64_t seed, std::uint64_t realisation) {
  return {seed, physics_key(system), realisation};
}

std::string task_hash(const SystemOptions& system, std::uint64_t seed, std::uint64_t realisation) {
  return short_hash(fmt::format("jamscape task\nphysics_revision = {}\nseed = {}\nrealisation = {}\n{}",
                                physics_revision(system), seed, realisation, physics_text(system)));
}

}  // namespace jam
