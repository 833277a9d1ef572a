#include "impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/random.hpp"
#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam::clusters {
namespace {

Vec3 vector_in(Random& random, double most) {
  Vec3 v;
  do {
    for (int k = 0; k < 3; ++k) v[k] = random.uniform(-most, most);
  } while (norm(v) > most || norm(v) < 1e-3 * most);
  return v;
}
Vec3 direction(Random& random) {
  const Vec3 v = vector_in(random, 1);
  return (1 / norm(v)) * v;
}

/// Whether a contact with this normal at the end of an arm touches its cap, well away from the cylinder.
bool on_the_cap(const Arm& arm, double side, const Vec3& n) { return side * dot(arm.direction, n) > 0.3; }

struct Body {
  Quaternion orientation;
  Vec3 position{}, velocity, spin;
  std::vector<Arm> arms;

  Body(const ClusterShape& shape, Random& random) {
    const double angle = random.uniform(0, std::numbers::pi);
    const Vec3 axis = std::sin(angle) * direction(random);
    orientation = {std::cos(angle), axis[0], axis[1], axis[2]};
    velocity = vector_in(random, 1.5);
    spin = vector_in(random, 1);
    for (const Arm& arm : shape.arms)
      arms.push_back(
          {rotate(orientation, arm.centre), rotate(orientation, arm.direction), arm.half_length, arm.radius});
  }
  void move_to(const Vec3& x) {
    for (Arm& arm : arms) arm.centre += x - position;
    position = x;
  }
  Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, x - position); }
};

/// Where on an arm's axis it shall be touched; the ends of arms are left to Place::side and Place::ends.
double along(const Arm& arm, bool end, Random& random) {
  if (end) return random.uniform() < 0.5 ? -arm.half_length : arm.half_length;
  return arm.half_length * random.uniform(-0.8, 0.8);
}

/// Draws until the pair collides as asked for and no other arms come near.
std::pair<Body, Body> draw_pair(const ClusterShape& shape, Place place, double gap, Random& random) {
  while (true) {
    Body one(shape, random), two(shape, random);
    const std::size_t a = random.below(one.arms.size()), b = random.below(two.arms.size());
    const Arm &first = one.arms[a], &second = two.arms[b];
    const double s = along(first, place != Place::sides, random), t = along(second, place == Place::ends, random);
    Vec3 n = direction(random);
    if (place == Place::sides) {
      n = cross(first.direction, second.direction);
      if (norm(n) < 0.6) continue;
    }
    if (place == Place::side) n = n - dot(n, second.direction) * second.direction;
    n = (1 / norm(n)) * n;
    if (place != Place::sides && !on_the_cap(first, s > 0 ? 1 : -1, n)) continue;
    if (place == Place::ends && !on_the_cap(second, t > 0 ? -1 : 1, n)) continue;

    const double r = first.radius;
    const Vec3 touch = first.centre + s * first.direction + (r + gap / 2) * n;
    two.move_to(touch + (r + gap / 2) * n - t * second.direction);
    const Vec3 v = one.velocity_at(touch) - two.velocity_at(touch);
    const double approach = dot(v, n), slip = norm(v - approach * n);
    if (approach < 0.3 || approach > 0.7 || slip < 1.2 || slip > 2.5) continue;

    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < one.arms.size(); ++i)
      for (std::size_t j = 0; j < two.arms.size(); ++j)
        if (i != a || j != b) nearest = std::min(nearest, axis_distance(one.arms[i], two.arms[j]) - 2 * r);
    if (nearest > 0.05) return {one, two};
  }
}

}  // namespace

Impacts draw(const ClusterShape& shape, Place place, std::size_t pairs, double gap, std::uint64_t seed) {
  Random random(seed, shape.name, static_cast<std::uint64_t>(place), "impacts");
  Impacts out{shape, {}};
  for (std::size_t k = 0; k < pairs; ++k) {
    auto [one, two] = draw_pair(shape, place, gap, random);
    two.move_to(two.position + Vec3{3 * shape.length * static_cast<double>(k), 0, 0});
    one.move_to({3 * shape.length * static_cast<double>(k), 0, 0});
    for (const Body& body : {one, two}) {
      out.bodies.shape.push_back(0);
      out.bodies.scale.push_back(1);
      out.bodies.position.push_back(body.position);
      out.bodies.velocity.push_back(body.velocity);
      out.bodies.spin.push_back(body.spin);
      out.bodies.orientation.push_back(body.orientation);
    }
  }
  return out;
}

Motion collide(const Impacts& impacts, const Law& law, double dt, int steps) {
  constexpr double unclipped = -std::numeric_limits<double>::infinity();
  ClusterSetup setup;
  setup.shapes = {impacts.shape};
  setup.bodies = impacts.bodies;
  setup.kind = NormalLaw::linear;
  setup.grain_law = {law.k_n, law.gamma_n, law.k_t,   law.gamma_t, law.k_t > 0 ? 1 / law.k_t : 0,
                     law.mu,  0,           unclipped, false};
  setup.dt = dt;
  ClusterEngine engine(setup);
  engine.run(steps);
  engine.compute_forces();
  const Packing now = engine.record();
  return {now.grains.velocity, now.grains.spin};
}

double difference(const Motion& a, const Motion& b, double half_length) {
  double sum = 0;
  for (std::size_t k = 0; k < a.velocity.size(); ++k) {
    const Vec3 v = a.velocity[k] - b.velocity[k], w = half_length * (a.spin[k] - b.spin[k]);
    sum += dot(v, v) + dot(w, w);
  }
  return std::sqrt(sum / static_cast<double>(a.velocity.size()));
}

}  // namespace jam::clusters
