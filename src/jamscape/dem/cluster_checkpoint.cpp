// The state of an engine of clusters as named arrays, and back.

#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/dem/stored_arrays.hpp"

namespace jam {
namespace {

constexpr std::int64_t layout_version = 1;

}  // namespace

void ClusterEngine::save(Archive& out) const {
  std::vector<double> wall_position, wall_velocity;
  for (const ClusterWall& wall : walls_) {
    wall_position.push_back(wall.position);
    wall_velocity.push_back(wall.velocity);
  }
  out["clusters/counters"] = std::vector<std::int64_t>{layout_version,
                                                       planar_,
                                                       step_,
                                                       lists_,
                                                       stale_,
                                                       static_cast<std::int64_t>(shapes_.size()),
                                                       static_cast<std::int64_t>(bodies_.count()),
                                                       static_cast<std::int64_t>(pairs_.count),
                                                       static_cast<std::int64_t>(pairs_.size()),
                                                       static_cast<std::int64_t>(ends_.size())};
  out["clusters/scalars"] = std::vector<double>{
      dt_, wall_skin_, walls_moved_, booked_.damped, booked_.rubbed, booked_.wall_work, booked_.gravity_work};
  out["clusters/rows"] = reals(bodies_.rows);
  out["clusters/momentum"] = reals(bodies_.momentum);
  out["clusters/inverse"] = reals(bodies_.inverse);
  out["clusters/moved"] = reals(bodies_.moved);
  out["clusters/skin"] = reals(bodies_.skin);
  out["clusters/top"] = integers(bodies_.top);
  out["clusters/id"] = integers(bodies_.id);
  out["clusters/shape"] = integers(bodies_.shape);
  out["clusters/scale"] = reals(bodies_.scale);
  out["clusters/radius"] = reals(bodies_.radius);
  out["clusters/pair_i"] = integers(pairs_.i);
  out["clusters/pair_j"] = integers(pairs_.j);
  out["clusters/pair_arm_i"] = integers(pairs_.arm_i);
  out["clusters/pair_arm_j"] = integers(pairs_.arm_j);
  out["clusters/pair_mbar"] = reals(pairs_.mbar);
  out["clusters/pair_spring"] = reals(pairs_.springs);
  out["clusters/pair_held"] = integers(pairs_.held);
  out["clusters/end_wall"] = integers(ends_.wall);
  out["clusters/end_arm"] = integers(ends_.arm);
  out["clusters/end_end"] = integers(ends_.end);
  out["clusters/end_held"] = integers(ends_.held);
  out["clusters/end_spring"] = components(ends_.spring);
  out["clusters/wall_position"] = wall_position;
  out["clusters/wall_velocity"] = wall_velocity;
  if (!summed_) return;  // otherwise springs and ledger have had this step
  out["clusters/forces"] = reals(bodies_.forces);
  out["clusters/wall_force"] = components(wall_force_);
}

void ClusterEngine::load(const Archive& in) {
  std::vector<std::int64_t> counters;
  std::vector<double> scalars, position, velocity;
  take(in, "clusters/counters", counters, 10);
  if (counters[0] != layout_version || counters[1] != planar_ ||
      counters[5] != static_cast<std::int64_t>(shapes_.size()))
    refuse_checkpoint(" is of another version or another kind of system");
  const auto size = [&](std::size_t k) { return static_cast<std::size_t>(counters[k]); };
  const std::size_t n = size(6), pairs = size(8), ends = size(9);
  take(in, "clusters/scalars", scalars, 7);
  take(in, "clusters/rows", bodies_.rows, n * ClusterRow::stride);
  take(in, "clusters/momentum", bodies_.momentum, n * 4);
  take(in, "clusters/inverse", bodies_.inverse, n * ClusterRow::force_stride);
  take(in, "clusters/moved", bodies_.moved, n);
  take(in, "clusters/skin", bodies_.skin, n);
  take(in, "clusters/top", bodies_.top, n);
  take(in, "clusters/id", bodies_.id, n);
  take(in, "clusters/shape", bodies_.shape, n);
  take(in, "clusters/scale", bodies_.scale, n);
  take(in, "clusters/radius", bodies_.radius, n);
  for (std::size_t k = 0; k < n; ++k)
    if (bodies_.id[k] >= n || bodies_.shape[k] < 0 || static_cast<std::size_t>(bodies_.shape[k]) >= shapes_.size())
      refuse_checkpoint("'s bodies are inconsistent");
  rebuild_arms(bodies_, shapes_);

  pairs_.count = size(7);
  take(in, "clusters/pair_i", pairs_.i, pairs);
  take(in, "clusters/pair_j", pairs_.j, pairs);
  take(in, "clusters/pair_arm_i", pairs_.arm_i, pairs);
  take(in, "clusters/pair_arm_j", pairs_.arm_j, pairs);
  take(in, "clusters/pair_mbar", pairs_.mbar, pairs);
  take(in, "clusters/pair_spring", pairs_.springs, pairs * 4);
  take(in, "clusters/pair_held", pairs_.held, pairs / block);
  take(in, "clusters/end_wall", ends_.wall, ends);
  take(in, "clusters/end_arm", ends_.arm, ends);
  take(in, "clusters/end_end", ends_.end, ends);
  take(in, "clusters/end_held", ends_.held, ends);
  take(in, "clusters/end_spring", ends_.spring, ends);
  take(in, "clusters/wall_position", position, walls_.size());
  take(in, "clusters/wall_velocity", velocity, walls_.size());
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].position = position[w];
    walls_[w].velocity = velocity[w];
  }
  const auto arms = static_cast<std::uint32_t>(bodies_.arm_count());
  bool sound = pairs % block == 0 && pairs_.count <= pairs;
  for (std::size_t k = 0; k < pairs; ++k)
    sound = sound && pairs_.i[k] < n && pairs_.j[k] < n && pairs_.arm_i[k] < arms + 2 && pairs_.arm_j[k] < arms + 2;
  for (std::size_t q = 0; q < ends; ++q) sound = sound && ends_.wall[q] < walls_.size() && ends_.arm[q] < arms;
  if (!sound) refuse_checkpoint("'s lists are inconsistent");
  contacts_.resize(pairs);
  forget_forces();
  summed_ = in.contains("clusters/forces");
  if (summed_) {
    take(in, "clusters/forces", bodies_.forces, n * ClusterRow::force_stride);
    take(in, "clusters/wall_force", wall_force_, walls_.size());
  }
  step_ = counters[2], lists_ = counters[3], stale_ = counters[4] != 0;
  wall_skin_ = scalars[1], walls_moved_ = scalars[2];
  booked_.damped = scalars[3], booked_.rubbed = scalars[4], booked_.wall_work = scalars[5],
  booked_.gravity_work = scalars[6];
}

}  // namespace jam
