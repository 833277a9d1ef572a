#include "jamscape/study/verify.hpp"

#include <fmt/format.h>

#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/study/simulate_task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_walls(const std::vector<Wall>& a, const std::vector<Wall>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t w = 0; w < a.size(); ++w)
    if (a[w].kind != b[w].kind || !same_bits(a[w].position, b[w].position) || !same_bits(a[w].normal, b[w].normal) ||
        !same_bits(a[w].velocity, b[w].velocity) || !same_bits(a[w].force, b[w].force) ||
        !same_bits(a[w].bead_radius, b[w].bead_radius) || !same_bits(a[w].beads, b[w].beads) ||
        !same_bits(a[w].radius, b[w].radius))
      return false;
  return true;
}

}  // namespace

std::string first_difference(const Packing& a, const Packing& b) {
  const Grains &g = a.grains, &h = b.grains;
  const Contacts &c = a.contacts, &d = b.contacts;
  const std::pair<bool, const char*> checks[] = {
      {a.dimension == b.dimension && a.step == b.step && same_bits(a.time, b.time), "time"},
      {same_bits(a.packing_fraction, b.packing_fraction), "packing_fraction"},
      {same_bits(a.packing_fraction_plain, b.packing_fraction_plain), "packing_fraction_plain"},
      {a.relaxation == b.relaxation, "relaxation"},
      {same_bits(a.domain.lo, b.domain.lo) && same_bits(a.domain.hi, b.domain.hi) &&
           a.domain.periodic == b.domain.periodic,
       "domain"},
      {same_bits(g.id, h.id), "grains.id"},
      {same_bits(g.species, h.species), "grains.species"},
      {same_bits(g.radius, h.radius), "grains.radius"},
      {same_bits(g.mass, h.mass), "grains.mass"},
      {same_bits(g.position, h.position), "grains.position"},
      {same_bits(g.velocity, h.velocity), "grains.velocity"},
      {same_bits(g.spin, h.spin), "grains.spin"},
      {same_bits(g.angle, h.angle), "grains.angle"},
      {a.shapes == b.shapes, "shapes"},
      {same_bits(g.shape, h.shape), "grains.shape"},
      {same_bits(g.scale, h.scale), "grains.scale"},
      {same_bits(g.orientation, h.orientation), "grains.orientation"},
      {same_bits(c.i, d.i) && same_bits(c.j, d.j), "contacts.pairs"},
      {same_bits(c.part_i, d.part_i) && same_bits(c.part_j, d.part_j), "contacts.parts"},
      {same_bits(c.image, d.image), "contacts.image"},
      {same_bits(c.overlap, d.overlap), "contacts.overlap"},
      {same_bits(c.normal, d.normal), "contacts.normal"},
      {same_bits(c.point, d.point), "contacts.point"},
      {same_bits(c.sliding, d.sliding), "contacts.sliding"},
      {same_bits(c.normal_force, d.normal_force), "contacts.normal_force"},
      {same_bits(c.tangential_force, d.tangential_force), "contacts.tangential_force"},
      {same_walls(a.walls, b.walls), "walls"},
      {same_bits(a.energy.kinetic, b.energy.kinetic) && same_bits(a.energy.elastic, b.energy.elastic) &&
           same_bits(a.energy.damped, b.energy.damped) && same_bits(a.energy.rubbed, b.energy.rubbed) &&
           same_bits(a.energy.wall_work, b.energy.wall_work) && same_bits(a.energy.gravity_work, b.energy.gravity_work),
       "energy"}};
  for (const auto& [same, name] : checks)
    if (!same) return name;
  return {};
}

std::optional<std::string> verify_task(const Study& study, const Task& task, const fs::path& results,
                                       const std::function<void(const Progress&)>& progress,
                                       const std::function<bool()>& stop) {
  const TaskFolder stored(results, task.hash);
  if (!has_all_frames(stored, task.plan))
    throw data_error("the task is not done, so there is nothing to compare with", stored.path().string(),
                     "jamscape run");
  const RunFile before(stored.run_file());
  const ScratchFolder scratch("verify");
  const TaskFolder again(scratch.path(), task.hash);
  if (simulate_task(study, task, again, {progress, stop, {}, 1e9}) == Outcome::stopped) return std::nullopt;
  const RunFile after(again.run_file());
  const std::vector<std::size_t> at_before = stored_frames(before, task.plan).value(),
                                 at_after = stored_frames(after, task.plan).value();
  for (std::size_t f = 0; f < at_before.size(); ++f) {
    const std::string difference = first_difference(before.frame(at_before[f]), after.frame(at_after[f]));
    if (!difference.empty()) return fmt::format("frame {} differs in {}", f, difference);
  }
  return std::string();
}

}  // namespace jam
