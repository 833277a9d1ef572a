#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "fixture.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/geometry/segments.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/packing/wall_roles.hpp"
#include "jamscape/protocol/relaxation.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {
namespace {

constexpr int realisations = 3;
constexpr double aspects[] = {1.7, 3, 8.5};

struct Kind {
  const char* name;
  const char* shape;
  int dimension;
  const char* walls;
  double width;  // in L
};
constexpr Kind kinds[] = {{"2d", "cross", 2, "box", 9}, {"3d", "star", 3, "cylinder", 5}};

std::string name_of(const Kind& kind, double aspect) { return fmt::format("{}-{}", kind.name, aspect); }

std::string study_text(std::int64_t grains) {
  std::string text = fmt::format(R"([study]
name = "clusters"
title = "Packings of crosses and stars, synthetic"
realisations = {}

[measure]
force = "total"
clamp = 0

[grains]
count = {}
sizes = "monodisperse"

[domain]
gravity = 0.001

[[stage]]
name = "settle"
kind = "settle"

[[stage]]
name = "press"
kind = "press"
speed = 1e-3
force = 10.0

[[stage]]
name = "relax"
kind = "relax"
)",
                                 realisations, grains);
  for (const Kind& kind : kinds)
    for (const double aspect : aspects)
      text += fmt::format(
          "\n[[system]]\nname = \"{}\"\ngrains.shape = \"{}\"\ngrains.aspect = {}\ndomain.dimension = {}\n"
          "domain.walls = \"{}\"\ndomain.width = {:.1f}\n",
          name_of(kind, aspect), kind.shape, aspect, kind.dimension, kind.walls, kind.width);
  return text;
}

/// Bodies dropped one after another: each takes the lowest of some places where it overlaps none by more than a little.
class Heap {
 public:
  Heap(const Kind& kind, double aspect, std::int64_t grains, Random random) : kind_(kind), random_(random) {
    p_.dimension = kind.dimension;
    p_.shapes = {kind.dimension == 2 ? cross_shape(aspect) : star_shape(aspect)};
    radius_ = kind.width * shape().length / 2;
    const double room = std::pow(shape().length, kind.dimension) * static_cast<double>(grains);
    height_ = 2 * room / (kind.dimension == 2 ? 2 * radius_ : std::numbers::pi * radius_ * radius_) + shape().length;
    for (std::int64_t k = 0; k < grains; ++k) drop();
    double top = 0;
    for (const Vec3& at : p_.grains.position) top = std::max(top, at[1] + 0.8 * shape().circumradius);
    add_walls(top);
    for (std::size_t i = 0; i < p_.grains.size(); ++i) touch(i);
  }

  const Packing& packing() const { return p_; }

 private:
  static constexpr double touching = 0.03, deepest = 0.08;  // gap that counts as a contact, overlap that is allowed

  const ClusterShape& shape() const { return p_.shapes.front(); }

  Segment<double> axis(const Vec3& at, const Quaternion& q, const Arm& arm) const {
    return {at + rotate(q, arm.centre), rotate(q, arm.direction), arm.half_length};
  }
  Segment<double> axis(std::size_t n, std::size_t arm) const {
    return axis(p_.grains.position[n], p_.grains.orientation[n], shape().arms[arm]);
  }

  Quaternion any_turn() {
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    if (kind_.dimension == 2) return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
    Quaternion q;
    for (double* part : {&q.w, &q.x, &q.y, &q.z}) *part = random_.uniform(-1, 1);
    return normalized(q);
  }

  /// The ends of all arms between the walls, and no arm too deep in another.
  bool free(const Vec3& at, const Quaternion& q) const {
    for (const Arm& arm : shape().arms) {
      const Segment<double> own = axis(at, q, arm);
      for (const double end : {-own.half_length, own.half_length}) {
        const Vec3 point = own.centre + end * own.direction;
        const double out = kind_.dimension == 2 ? std::abs(point[0]) : std::hypot(point[0], point[2]);
        if (point[1] < 0.5 - deepest || out > radius_ - 0.5 + deepest) return false;
      }
      for (std::size_t n = 0; n < p_.grains.size(); ++n) {
        if (norm(p_.grains.position[n] - at) > 2 * shape().circumradius) continue;
        for (std::size_t other = 0; other < shape().arms.size(); ++other)
          if (closest_points(own, axis(n, other)).distance2 < (1 - deepest) * (1 - deepest)) return false;
      }
    }
    return true;
  }

  void drop() {
    Vec3 best{0, 2 * height_, 0};
    Quaternion turn;
    for (int found = 0, trial = 0; trial < 4000 && found < 25; ++trial) {
      const double top = std::min(height_, top_ + shape().length);
      const Vec3 at{random_.uniform(-radius_, radius_), random_.uniform(0, top),
                    kind_.dimension == 2 ? 0 : random_.uniform(-radius_, radius_)};
      const Quaternion q = any_turn();
      if (at[1] > best[1] || !free(at, q)) continue;
      ++found;
      best = at;
      turn = q;
    }
    top_ = std::max(top_, best[1]);
    Grains& g = p_.grains;
    g.id.push_back(static_cast<std::int64_t>(g.size()));
    g.species.push_back(0);
    g.radius.push_back(shape().circumradius);
    g.mass.push_back(shape().volume);
    g.position.push_back(best);
    for (auto* list : {&g.velocity, &g.spin, &g.angle}) list->push_back({});
    g.shape.push_back(0);
    g.scale.push_back(1);
    g.orientation.push_back(turn);
  }

  void add_walls(double top) {
    p_.domain.lo = {-radius_, 0, kind_.dimension == 2 ? 0 : -radius_};
    p_.domain.hi = {radius_, top, kind_.dimension == 2 ? 0 : radius_};
    const auto plane = [&](Vec3 at, Vec3 normal) {
      Wall wall;
      wall.position = at;
      wall.normal = normal;
      p_.walls.push_back(wall);
    };
    if (kind_.dimension == 2) {
      plane({-radius_, 0, 0}, {1, 0, 0});
      plane({radius_, 0, 0}, {-1, 0, 0});
    } else {
      Wall wall;
      wall.kind = WallKind::cylinder;
      wall.normal = {0, 1, 0};
      wall.radius = radius_;
      p_.walls.push_back(wall);
    }
    plane({}, {0, 1, 0});
    plane({0, top, 0}, {0, -1, 0});
  }

  void add(std::size_t i, std::int32_t j, std::size_t part_i, std::size_t part_j, double gap, Vec3 normal, Vec3 point) {
    Contacts& c = p_.contacts;
    c.i.push_back(static_cast<std::uint32_t>(i));
    c.j.push_back(j);
    c.part_i.push_back(static_cast<std::uint16_t>(part_i));
    c.part_j.push_back(static_cast<std::uint16_t>(part_j));
    c.image.push_back({});
    c.overlap.push_back(touching - gap);
    c.normal_force.push_back(-std::log(1 - random_.uniform()));
    c.normal.push_back(normal);
    c.tangential_force.push_back({});
    c.point.push_back(point);
    c.sliding.push_back(0);
  }

  void touch(std::size_t i) {
    const std::size_t arms = shape().arms.size();
    for (std::size_t w = p_.walls.size(); w-- > 0;) touch_wall(i, w);
    for (std::size_t j = i + 1; j < p_.grains.size(); ++j)
      for (std::size_t a = 0; a < arms; ++a)
        for (std::size_t b = 0; b < arms; ++b) {
          const Segment<double> own = axis(i, a);
          const auto closest = closest_points(own, axis(j, b));
          const double distance = std::sqrt(closest.distance2);
          if (distance - 1 > touching) continue;
          const Vec3 normal = (1 / distance) * closest.d;
          add(i, static_cast<std::int32_t>(j), a, b, distance - 1, normal,
              own.centre + closest.s * own.direction + 0.5 * closest.d);
        }
  }

  void touch_wall(std::size_t i, std::size_t w) {
    const Wall& wall = p_.walls[w];
    for (std::size_t a = 0; a < shape().arms.size(); ++a) {
      const Segment<double> own = axis(i, a);
      for (const std::size_t end : {0u, 1u}) {
        const Vec3 point = own.centre + (end == 0 ? -own.half_length : own.half_length) * own.direction;
        Vec3 normal = -1.0 * wall.normal;
        double distance = dot(point - wall.position, wall.normal);
        if (wall.kind == WallKind::cylinder) {
          const double out = std::hypot(point[0], point[2]);
          normal = {point[0] / out, 0, point[2] / out};
          distance = wall.radius - out;
        }
        if (distance - 0.5 > touching) continue;
        add(i, -1 - static_cast<std::int32_t>(w), a, end, distance - 0.5, normal, point + distance * normal);
      }
    }
  }

  const Kind& kind_;
  Random random_;
  Packing p_;
  double radius_, height_ = 0, top_ = 0;
};

/// k of the tail as S3 has it, about.
double exponent(const Kind& kind, double psi) {
  return kind.dimension == 2 ? 1.43 - 0.18 * (1 - psi) : 1.36 - 2.03 * std::pow(1 - psi, 2.43);
}

/// A peak at 1 for round grains, none for long arms in three dimensions.
double force_density(const Kind& kind, double psi, double f) {
  const double b = kind.dimension == 2 || psi > 0.7 ? 0.85 : 0.2, k = exponent(kind, psi);
  return k * (1 - b * std::exp(-f * f)) * std::exp(-k * f) * (1.5 + b);
}

double radial(const ClusterShape& shape, double r) {
  const Distances at = contact_distances(shape);
  double g = r < 0.9 * at.d1 ? 0 : 1;
  for (const double peak : {at.d1, at.d2, at.d3}) g += 1.6 * at.d1 / peak * std::exp(-std::pow((r - peak) / 0.06, 2));
  return g;
}

class Tables {
 public:
  void row(std::string& out, const std::string& lead, const std::string& quantity, double mean, double relative) {
    const double se = relative * std::abs(mean) * random_.uniform(0.5, 1);
    out += fmt::format("{},{},{},{},{},{}\n", lead, quantity, realisations, mean + se * random_.uniform(-1, 1),
                       se * std::sqrt(realisations), se);
  }

  void add(const Task& task, const Kind& kind, const ClusterShape& shape) {
    const double psi = sphericity(shape), k = exponent(kind, psi);
    const Distances at = contact_distances(shape);
    const std::string name = name_of(kind, aspect_ratio(shape));
    for (std::size_t f = 0; f < task.plan.frames.size(); ++f) {
      const bool last = f + 1 == task.plan.frames.size();
      relaxed += fmt::format("{},{},{},{},{}\n", name, task.realisation, f, task.plan.frames[f].stage,
                             last ? relaxed_energy : "");
      if (task.realisation != 0) continue;
      if (last) pooled += fmt::format("{},tail_k_pooled,{},{},0.02\n", name, realisations, k);
      const std::string lead = fmt::format("{},{},{}", name, f, 0.4 + 0.05 * static_cast<double>(f));
      const std::pair<const char*, double> quantities[] = {{"tail_k", k},
                                                           {"tail_k_mle", k + 0.1},
                                                           {"tail_k_loglinear", k + 0.05},
                                                           {"type_a", psi > 0.6},
                                                           {"peak_position", 0.9},
                                                           {"solid_fraction", 0.65 * std::pow(psi, 1.5)},
                                                           {"height", 40.0},
                                                           {"weight_over_load", 0.03},
                                                           {"deepest_overlap", 0.02},
                                                           {"z", 5 + 3 * psi},
                                                           {"rattlers", 0.04},
                                                           {"fraction_above_8", 4e-5},
                                                           {"rdf_peak1", at.d1},
                                                           {"rdf_peak1_error", 0.01},
                                                           {"rdf_peak2", at.d2},
                                                           {"rdf_peak2_error", 0.02},
                                                           {"unbalanced_force", 1e-4}};
      for (const auto& [quantity, value] : quantities) row(frames, lead, quantity, value, 0.02);
      for (int b = 0; b < 50; ++b) {
        const double x = 0.1 + 0.2 * b, noise = 0.02 * std::exp(0.35 * x), y = force_density(kind, psi, x);
        row(forces, fmt::format("{},{:.1f}", lead, x), "density", y < 3e-5 ? 0 : y, noise);
        row(stresses, fmt::format("{},{:.1f}", lead, x), "density", y < 3e-4 ? 0 : y, noise);
      }
      for (int b = 0; b < 250; ++b)
        row(pairs, fmt::format("{},{:.2f}", lead, 0.01 + 0.02 * b), "g", radial(shape, 0.01 + 0.02 * b), 0.05);
    }
  }

  void write(const std::filesystem::path& folder) const {
    const auto head = [](const char* abscissa) {
      return fmt::format("system,frame,packing_fraction_target{},quantity,n,mean,sd,se\n", abscissa);
    };
    write_text(folder / "ensemble/frames.csv", head("") + frames);
    write_text(folder / "ensemble/contact_force_distribution.csv", head(",force") + forces);
    write_text(folder / "ensemble/stress_distribution.csv", head(",stress") + stresses);
    write_text(folder / "ensemble/radial_distribution.csv", head(",distance") + pairs);
    write_text(folder / "ensemble/transitions.csv", "system,quantity,n,value,se\n" + pooled);
    write_text(folder / "tables/frames.csv", "system,realisation,frame,stage,relaxation\n" + relaxed);
  }

 private:
  Random random_{1, "clusters", 0, "noise"};
  std::string frames, forces, stresses, pairs, relaxed, pooled;
};

void write_frames(const TaskFolder& folder, const Task& task, const Packing& heap) {
  make_folder(folder.frames());
  std::vector<std::filesystem::path> files;
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k) {
    const PlannedFrame& planned = task.plan.frames[k];
    Packing p = heap;
    p.stage = planned.stage;
    p.step = planned.step < 0 ? static_cast<std::int64_t>(1000000 + k) : planned.step;
    if (planned.relaxed) p.relaxation = relaxed_energy;
    p.packing_fraction = p.packing_fraction_plain = 0.4 + 0.05 * static_cast<double>(k);
    if (k == 0) p.domain.hi[1] = p.walls.back().position[1] = 3 * heap.domain.hi[1];
    files.push_back(folder.frame(k));
    guess_roles(p);
    write_frame(files.back(), p);
  }
  assemble_run(files, folder.run_file(), {});
  folder.discard_partial();
}

}  // namespace

void write_cluster_fixture(const std::filesystem::path& folder, std::int64_t grains) {
  const Study study = read_study_text(study_text(grains), "clusters.toml");
  write_results_study(folder, study);
  for (const char* sub : {"ensemble", "tables"}) make_folder(folder / sub);
  Tables tables;
  for (const Task& task : plan_tasks(study)) {
    const Kind& kind = kinds[task.system / std::size(aspects)];
    const Heap heap(kind, aspects[task.system % std::size(aspects)], task.realisation == 0 ? grains : 0,
                    Random(7, "clusters", task.system, "packing"));
    tables.add(task, kind, heap.packing().shapes.front());
    if (task.realisation == 0) write_frames(TaskFolder(folder, task.hash), task, heap.packing());
  }
  tables.write(folder);
}

}  // namespace jam
