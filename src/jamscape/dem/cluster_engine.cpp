#include "jamscape/dem/cluster_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "jamscape/dem/cell_grid.hpp"
#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_merge.hpp"
#include "jamscape/dem/slots.hpp"

namespace jam {
namespace {

using R = ClusterRow;

/// A body's skin is what it moves, at its present speed or a little more, until the next list, which is due after
///   sqrt(list_cost thickness / closing) steps,   closing = how much nearer two bodies of mean speed come in a step:
/// the costs of making lists and of testing listed pairs that do not touch are then lowest together. list_cost: of a
/// list, over that of testing the pairs that one more arm diameter of skin would list (from a profile). A few fast
/// bodies among many at rest get wide skins of their own, and make nobody else's wide. Bounds in arm diameters.
constexpr double list_cost = 15, thinnest_skin = 0.005, widest_skin = 1.0;
/// Over the present speed, and over the speed that a fifth of the bodies do not reach: bodies at rest are hit, slow
/// ones speed up.
constexpr double speed_margin = 1.2, slow_margin = 3;
std::string beyond_wall(const ClusterWall& wall, double beyond) {
  return wall.kind == WallKind::plane ? beyond_plane(beyond, wall.high, wall.axis, wall.position)
                                      : fmt::format("{:.3g} beyond the cylinder", beyond);
}

/// Where more than this part of the listed pairs touched at the last step, they are not collected first.
constexpr double most_touch = 0.45;

}  // namespace

ClusterEngine::ClusterEngine(const ClusterSetup& setup, const ClusterKernels& kernels)
    : kernels_(&kernels),
      kind_(setup.kind),
      grain_law_(setup.grain_law),
      wall_law_(setup.wall_law),
      dt_(setup.dt),
      density_(setup.density),
      planar_(setup.planar),
      parallel_(setup.parallel),
      parallel_sine2_(std::sin(setup.parallel_angle) * std::sin(setup.parallel_angle)),
      duplicates_(setup.duplicates),
      shapes_(setup.shapes),
      gravity_(setup.gravity),
      walls_(setup.walls) {
  wall_force_.assign(walls_.size(), Vec3{});
  append_bodies(bodies_, setup.bodies, shapes_, density_, planar_);
  start_in_step(0);
}

void ClusterEngine::add(const ClusterBodies& bodies) {
  const auto first_new = static_cast<std::uint32_t>(bodies_.count());
  const bool summed = summed_;
  forget_forces();
  append_bodies(bodies_, bodies, shapes_, density_, planar_);
  start_in_step(first_new);
  if (!summed) return;
  sum_without_clock();  // those that were there have had this step's springs and ledger
  summed_ = stale_ = true;
}

void ClusterEngine::forget_forces() {
  std::fill(bodies_.forces.begin(), bodies_.forces.end(), 0.0);
  std::fill(wall_force_.begin(), wall_force_.end(), Vec3{});
  summed_ = false;
}

/// Forces at this instant; springs do not grow, and no work is booked.
void ClusterEngine::sum_without_clock() {
  const double dt = dt_;
  dt_ = 0;
  sum_forces();
  dt_ = dt;
}

/// The given velocities belong to this instant: those of bodies from `first_new` on are put back by half a step.
void ClusterEngine::start_in_step(std::uint32_t first_new) {
  stale_ = true;
  sum_without_clock();
  for (std::size_t k = 0; k < bodies_.count(); ++k) {
    if (bodies_.id[k] < first_new) continue;
    const double *torque = bodies_.force(k) + 4, *inverse = bodies_.inverse.data() + k * R::force_stride;
    const Vec3 force = force_on(k);
    for (std::size_t c = 0; c < 3; ++c) {
      bodies_.row(k)[R::velocity + c] -= force[static_cast<int>(c)] * inverse[c] * (dt_ / 2);
      bodies_.momentum[4 * k + c] -= torque[c] * (dt_ / 2);
    }
  }
  forget_forces();
  refresh(bodies_);
  stale_ = true;  // skins were chosen for no time
}

void ClusterEngine::choose_skins() {
  const std::size_t n = bodies_.count();
  double mean = 0, thickness = 0, fastest_wall = 0;
  std::vector<double> speed(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double* row = bodies_.row(k);
    speed[k] = norm(vec3(row + R::velocity)) + norm(vec3(row + R::spin)) * row[R::reach];
    mean += speed[k] / static_cast<double>(n);
  }
  for (std::size_t a = 0; a < bodies_.arm_count(); ++a)
    thickness += 2 * bodies_.arm(a)[3] / static_cast<double>(bodies_.arm_count());
  for (const ClusterWall& wall : walls_) fastest_wall = std::max(fastest_wall, std::abs(wall.velocity));
  std::vector<double> sorted = speed;
  const auto slow = sorted.begin() + static_cast<std::ptrdiff_t>(n / 5);
  std::nth_element(sorted.begin(), slow, sorted.end());
  const double closing = 2 * mean * dt_,
               until_next = closing > 0 ? std::sqrt(list_cost * thickness / closing) * dt_ : 0;
  const auto skin = [&](double v) {
    return std::clamp(until_next * v, thinnest_skin * thickness, widest_skin * thickness);
  };
  for (std::size_t k = 0; k < n; ++k) {
    bodies_.skin[k] = skin(std::max(speed_margin * speed[k], slow_margin * *slow));
    bodies_.moved[k] = 0;
  }
  wall_skin_ = skin(speed_margin * fastest_wall);
  walls_moved_ = 0;
}

void ClusterEngine::relist() {
  check();
  const std::vector<std::uint32_t> old_arm_id = bodies_.arm_id;
  if (lists_++ % lists_per_order == 0) reorder(bodies_, spatial_order(bodies_), shapes_);
  if (bodies_.count() > 0) choose_skins();
  pairs_ = list_arm_pairs(bodies_, pairs_, old_arm_id, *kernels_);
  ends_ = list_wall_ends(bodies_, walls_, wall_skin_, ends_, old_arm_id);
  contacts_.resize(pairs_.size());
  stale_ = false;
}

void ClusterEngine::compute_forces() {
  if (summed_) return;
  sum_forces();
  summed_ = true;
}

void ClusterEngine::sum_forces() {
  if (stale_) relist();
  ClusterTally tally{};
  const PressRule rule{grain_law_, kind_, parallel_, parallel_sine2_, dt_};
  std::fill(std::begin(tally.excess), std::end(tally.excess), -1.0);
  const bool dense = static_cast<double>(contacts_.count) > most_touch * static_cast<double>(pairs_.size());
  if (dense && duplicates_ == DuplicateRule::literal) {
    contacts_.count = kernels_->press_listed(press_arrays(bodies_, pairs_, contacts_, rule, tally));
  } else {
    contacts_.count = kernels_->collect(collect_arrays(bodies_, pairs_, contacts_));
    if (duplicates_ == DuplicateRule::merge)
      hand_over_springs(merge_duplicates(bodies_, pairs_, rule, contacts_), pairs_);
    kernels_->press(press_arrays(bodies_, pairs_, contacts_, rule, tally));
  }
  forget_parted();
  booked_.damped += sum_of(tally.damped) * dt_;
  booked_.rubbed += sum_of(tally.rubbed);
  for (const double e : tally.excess)
    if (!(e <= 0)) fail_deep();
  touch_walls();
  for (std::size_t w = 0; w < walls_.size(); ++w)
    booked_.wall_work -= wall_force_[w][walls_[w].axis] * walls_[w].velocity * dt_;
  booked_.gravity_work += weight_power() * dt_;
}

/// Of gravity, at the velocities that the forces see.
double ClusterEngine::weight_power() const {
  double power = 0;
  if (dot(gravity_, gravity_) == 0) return power;
  for (std::size_t k = 0; k < bodies_.count(); ++k)
    power += dot(bodies_.row(k)[R::mass] * gravity_, vec3(bodies_.row(k) + R::velocity));
  return power;
}

/// Springs of pairs that touched at the last step and do not now.
void ClusterEngine::forget_parted() {
  for (std::size_t q = 0; q < pairs_.held.size(); ++q) {
    for (unsigned lost = pairs_.held[q] & ~static_cast<unsigned>(contacts_.touching[q]); lost; lost &= lost - 1) {
      double* spring = pairs_.springs.data() + 4 * (q * block + static_cast<std::size_t>(std::countr_zero(lost)));
      if (!hertzian(kind_)) booked_.rubbed += spring_energy(grain_law_.k_t, vec3(spring));
      std::fill_n(spring, 3, 0.0);
    }
    pairs_.held[q] = contacts_.touching[q];
  }
}

template <NormalLaw law, bool friction>
void ClusterEngine::touch_walls() {
  for (std::size_t q = 0; q < ends_.size(); ++q) {
    const ClusterWall& wall = walls_[ends_.wall[q]];
    const double* arm = bodies_.arm(ends_.arm[q]);
    Vec3& spring = ends_.spring[q];
    if (!(wall_overlap(wall, arm, ends_.end[q]) > 0)) {
      if (!ends_.held[q]) continue;
      if (!hertzian(law)) booked_.rubbed += spring_energy(wall_law_.k_t, spring);
      spring = Vec3{};
      ends_.held[q] = 0;
      continue;
    }
    ends_.held[q] = 1;
    const WallTouch t = touch_wall(wall, arm, ends_.end[q]);
    const std::size_t k = bodies_.arm_body[ends_.arm[q]];
    if (t.overlap > 2 * arm[3])
      fail(k, "has an arm outside its box, " + beyond_wall(wall, t.overlap - arm[3]));
    const double* row = bodies_.row(k);
    const Vec3 lever = t.point - vec3(row);
    Vec3 v = vec3(row + R::velocity) + cross(vec3(row + R::spin), lever);
    v[wall.axis] -= wall.velocity;
    const auto f = touch<3, law, friction>(wall_law_, t.normal, t.overlap, row[R::mass], v, Vec3{}, spring, dt_);
    const Vec3 force = (-f.normal) * t.normal + f.tangential, torque = cross(lever, force);
    double* sum = bodies_.force(k);
    for (int c = 0; c < 3; ++c) sum[c] += force[c], sum[4 + c] += torque[c];
    wall_force_[ends_.wall[q]] -= force;
    booked_.damped += f.damped * dt_;
    booked_.rubbed += f.rubbed;
  }
}

void ClusterEngine::touch_walls() {
  with_law(kind_, [&]<NormalLaw law>() { wall_law_.mu > 0 ? touch_walls<law, true>() : touch_walls<law, false>(); });
}

void ClusterEngine::run(std::int64_t n) {
  for (; n > 0; --n) make_step();
}

void ClusterEngine::make_step() {
  compute_forces();
  MotionArrays motion = motion_arrays(bodies_, dt_, gravity_);
  kernels_->integrate(motion);
  double fastest_wall = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].position += walls_[w].velocity * dt_;
    fastest_wall = std::max(fastest_wall, std::abs(walls_[w].velocity));
    wall_force_[w] = Vec3{};
  }
  walls_moved_ += fastest_wall * dt_;
  stale_ = stale_ || motion.outrun || !(walls_moved_ < wall_skin_);
  summed_ = false;
  ++step_;
  if (step_ % 1024 == 0) check();
}

double ClusterEngine::kinetic_energy() const {
  double sum = 0;
  for (std::size_t k = 0; k < bodies_.count(); ++k) {
    const double* row = bodies_.row(k);
    const Vec3 v = vec3(row + R::velocity), w = vec3(row + R::spin), l = vec3(bodies_.momentum.data() + 4 * k);
    sum += 0.5 * (row[R::mass] * dot(v, v) + dot(w, l));
  }
  return sum;
}

void ClusterEngine::check() const {
  const std::size_t odd = find_not_finite(bodies_.rows.data(), bodies_.count(), R::stride);
  if (odd < bodies_.count()) fail(odd, not_a_number);
}

void ClusterEngine::fail_deep() const {
  check();
  for (std::size_t k = 0; k < pairs_.count; ++k) {
    const double *one = bodies_.arm(pairs_.arm_i[k]), *two = bodies_.arm(pairs_.arm_j[k]);
    const Segment<double> a = axis_of(one), b = axis_of(two);
    const double overlap = one[3] + two[3] - std::sqrt(closest_points(a, b).distance2);
    if (!(overlap <= smaller(one[3], two[3])))
      fail(pairs_.i[k], "overlaps body " + std::to_string(bodies_.id[pairs_.j[k]]) + " by " + std::to_string(overlap) +
                            ", more than the radius of an arm: their axes are about to cross");
  }
  fail(0, "or another overlaps its neighbour by more than the radius of an arm");
}

void ClusterEngine::fail(std::size_t body, const std::string& problem) const {
  double lightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies_.count(); ++k) lightest = std::min(lightest, bodies_.row(k)[R::mass]);
  const std::string too_long = step_too_long(dt_, lightest, std::max(grain_law_.k_n, wall_law_.k_n), "bodies");
  throw diverged_at(step_, "body " + std::to_string(bodies_.id[body]), {bodies_.row(body), 3}, problem,
                    too_long.empty() ? "bodies or the lid hit too hard for the stiffness" : too_long);
}

}  // namespace jam
