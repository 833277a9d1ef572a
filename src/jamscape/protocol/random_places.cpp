#include "jamscape/protocol/random_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam {
namespace {

/// After so many places in vain a body is given up.
constexpr int most_trials = 20000;

/// A point of the disc of radius 1 and its squared distance from the middle.
struct DiscPoint {
  double x, y, square;
};
DiscPoint random_in_disc(Random& random) {
  while (true) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), square = x * x + y * y;
    if (square > 0 && square < 1) return {x, y, square};
  }
}

/// A body where it is tried or placed.
struct Placed {
  Vec3 position;
  std::vector<Arm> arms;
};

Placed placed(const ClusterShape& shape, double scale, const Vec3& position, const Quaternion& q) {
  Placed body{position, shape.arms};
  for (Arm& a : body.arms) {
    a.centre = position + rotate(q, scale * a.centre);
    a.direction = rotate(q, a.direction);
    a.half_length *= scale, a.radius *= scale;
  }
  return body;
}

bool inside(const Placed& body, const ClusterRoom& room) {
  const Container& c = room.container;
  for (const Arm& a : body.arms)
    for (const double end : {-a.half_length, a.half_length}) {
      const Vec3 tip = a.centre + end * a.direction;
      if (tip[1] < a.radius || tip[1] > room.height - a.radius) return false;
      if (c.walls == WallModel::cylinder) {
        if (std::hypot(tip[0], tip[2]) > c.width / 2 - a.radius) return false;
        continue;
      }
      if (std::abs(tip[0]) > c.width / 2 - a.radius) return false;
      if (c.dimension == 3 && std::abs(tip[2]) > c.thickness / 2 - a.radius) return false;
    }
  return true;
}

bool touch(const Placed& a, const Placed& b) {
  for (const Arm& p : a.arms)
    for (const Arm& q : b.arms) {
      const double reach = p.radius + q.radius;
      if (axis_distance(p, q) < reach) return true;
    }
  return false;
}

/// Bodies by cubic cells as wide as the largest body.
class Cells {
 public:
  Cells(const ClusterRoom& room, double width) : width_(width) {
    const double deep = std::max(room.container.thickness, room.container.width);
    const double lengths[3] = {room.container.width, room.height, room.container.dimension == 2 ? 0 : deep};
    for (int c = 0; c < 3; ++c) {
      lo_[c] = c == 1 ? 0 : -lengths[c] / 2;
      count_[c] = static_cast<std::int64_t>(lengths[c] / width) + 1;
    }
    cells_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
  }

  void add(const Vec3& x, std::size_t body) {
    const auto at = cell(x);
    cells_[index(at[0], at[1], at[2])].push_back(body);
  }

  template <class F>
  bool any_near(const Vec3& x, F&& f) const {
    const auto at = cell(x);
    for (std::int64_t a = std::max<std::int64_t>(at[0] - 1, 0); a <= std::min(at[0] + 1, count_[0] - 1); ++a)
      for (std::int64_t b = std::max<std::int64_t>(at[1] - 1, 0); b <= std::min(at[1] + 1, count_[1] - 1); ++b)
        for (std::int64_t c = std::max<std::int64_t>(at[2] - 1, 0); c <= std::min(at[2] + 1, count_[2] - 1); ++c)
          for (const std::size_t body : cells_[index(a, b, c)])
            if (f(body)) return true;
    return false;
  }

 private:
  std::array<std::int64_t, 3> cell(const Vec3& x) const {
    std::array<std::int64_t, 3> at{};
    for (int c = 0; c < 3; ++c)
      at[static_cast<std::size_t>(c)] =
          std::clamp<std::int64_t>(static_cast<std::int64_t>((x[c] - lo_[c]) / width_), 0, count_[c] - 1);
    return at;
  }
  std::size_t index(std::int64_t a, std::int64_t b, std::int64_t c) const {
    return static_cast<std::size_t>((a * count_[1] + b) * count_[2] + c);
  }

  double width_;
  Vec3 lo_{};
  std::int64_t count_[3] = {};
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

Quaternion random_orientation(Random& random, int dimension) {
  const DiscPoint a = random_in_disc(random);
  if (dimension == 2) return {a.x / std::sqrt(a.square), 0, 0, a.y / std::sqrt(a.square)};
  const DiscPoint b = random_in_disc(random);
  const double s = std::sqrt((1 - a.square) / b.square);
  return {a.x, a.y, s * b.x, s * b.y};
}

void place_at_random(const ClusterRoom& room, Random& random, ClusterBodies& bodies) {
  const Container& c = room.container;
  const std::size_t n = bodies.scale.size();
  bodies.position.resize(n), bodies.orientation.resize(n);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bodies.scale[a] > bodies.scale[b]; });
  std::vector<Placed> done(n);
  Cells cells(room, 2 * room.shape.circumradius * bodies.scale[order[0]]);
  for (const std::size_t k : order) {
    int trial = 0;
    while (true) {
      const double deep = c.dimension == 2 ? 0 : c.walls == WallModel::cylinder ? c.width : c.thickness;
      const Vec3 x{c.width * (random.uniform() - 0.5), room.height * random.uniform(), deep * (random.uniform() - 0.5)};
      const Quaternion q = random_orientation(random, c.dimension);
      Placed body = placed(room.shape, bodies.scale[k], x, q);
      if (inside(body, room) && !cells.any_near(x, [&](std::size_t other) { return touch(body, done[other]); })) {
        bodies.position[k] = x, bodies.orientation[k] = q;
        done[k] = std::move(body);
        cells.add(x, k);
        break;
      }
      if (++trial == most_trials)
        throw usage_error(fmt::format("start.packing_fraction: at {} no free place was found for a body in {} trials",
                                      c.packing_fraction(room.height), most_trials),
                          {}, "a smaller one, or start.layout = \"lattice\"");
    }
  }
}

}  // namespace jam
