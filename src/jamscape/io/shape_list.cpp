#include "jamscape/io/shape_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

/// How far unit vectors and quaternions may be off 1: an engine that turns bodies leaves 1e-15, other tools round.
constexpr double unit_tolerance = 1e-6;

constexpr std::pair<const char*, double ClusterShape::*> numbers[] = {{"volume", &ClusterShape::volume},
                                                                      {"surface", &ClusterShape::surface},
                                                                      {"area", &ClusterShape::area},
                                                                      {"length", &ClusterShape::length},
                                                                      {"circumradius", &ClusterShape::circumradius}};

bool finite(const Vec3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }
bool is_unit(double square) { return std::abs(std::sqrt(square) - 1) <= unit_tolerance; }

std::string arm_problem(const Arm& arm, int dimension) {
  if (!finite(arm.centre) || !finite(arm.direction) || !std::isfinite(arm.half_length) || !std::isfinite(arm.radius))
    return "is not finite";
  if (arm.half_length < 0 || arm.radius <= 0) return "has no size";
  if (!is_unit(dot(arm.direction, arm.direction))) return "has a direction that is no unit vector";
  if (dimension == 2 && (arm.centre[2] != 0 || arm.direction[2] != 0))
    return "leaves the plane of a two-dimensional packing";
  return {};
}

std::string shape_problem(const ClusterShape& shape, int dimension) {
  if (shape.arms.empty()) return "has no arms";
  for (std::size_t a = 0; a < shape.arms.size(); ++a)
    if (const std::string problem = arm_problem(shape.arms[a], dimension); !problem.empty())
      return fmt::format("has an arm {} that {}", a, problem);
  for (const auto& [name, member] : numbers)
    if (!std::isfinite(shape.*member)) return fmt::format("has a {} that is not finite", name);
  if (!finite(shape.inertia)) return "has an inertia that is not finite";
  return {};
}

std::string body_problem(const Packing& p, std::size_t n) {
  const Grains& g = p.grains;
  const Quaternion& q = g.orientation[n];
  if (g.shape[n] < 0 || static_cast<std::size_t>(g.shape[n]) >= p.shapes.size())
    return fmt::format("is of shape {}, but there are {} shapes", g.shape[n], p.shapes.size());
  if (!std::isfinite(g.scale[n]) || g.scale[n] <= 0) return fmt::format("has size factor {}", g.scale[n]);
  if (!is_unit(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z))
    return fmt::format("has an orientation ({}, {}, {}, {}) that is no unit quaternion", q.w, q.x, q.y, q.z);
  if (p.dimension == 2 && (q.x != 0 || q.y != 0)) return "is turned out of the plane of a two-dimensional packing";
  return {};
}

/// Walls see the two ends of an arm.
std::string contact_problem(const Packing& p, std::size_t m) {
  const Contacts& c = p.contacts;
  const auto arms = [&](std::size_t n) {
    return n < p.grains.size() ? p.shapes[static_cast<std::size_t>(p.grains.shape[n])].arms.size() : 0;
  };
  const std::size_t most_i = arms(c.i[m]), most_j = c.j[m] < 0 ? 2 : arms(static_cast<std::size_t>(c.j[m]));
  if (c.part_i[m] < most_i && c.part_j[m] < most_j) return {};
  return fmt::format("joins parts {} and {} where there are {} and {}", c.part_i[m], c.part_j[m], most_i, most_j);
}

template <class T>
void expect_entries(const hdf5::Group& group, const char* name, const std::vector<T>& values, std::size_t wanted) {
  if (values.size() != wanted)
    throw data_error(fmt::format("the file is damaged: '{}' has {} entries for {}", name, values.size(), wanted),
                     group.file());
}

std::vector<double> read_numbers(const hdf5::Group& group, const char* name, std::size_t wanted) {
  auto values = group.read<double>(name);
  expect_entries(group, name, values, wanted);
  return values;
}

Vec3 vector_at(const std::vector<double>& flat, std::size_t n) {
  return {flat[3 * n], flat[3 * n + 1], flat[3 * n + 2]};
}

}  // namespace

void write_shapes(hdf5::Group& group, const std::vector<ClusterShape>& shapes) {
  std::vector<std::string> names;
  std::vector<std::uint64_t> offset{0};
  std::vector<double> inertia, centre, direction, half_length, radius;
  for (const ClusterShape& shape : shapes) {
    names.push_back(shape.name);
    offset.push_back(offset.back() + shape.arms.size());
    for (int k = 0; k < 3; ++k) inertia.push_back(shape.inertia[k]);
    for (const Arm& arm : shape.arms) {
      for (int k = 0; k < 3; ++k) centre.push_back(arm.centre[k]);
      for (int k = 0; k < 3; ++k) direction.push_back(arm.direction[k]);
      half_length.push_back(arm.half_length);
      radius.push_back(arm.radius);
    }
  }
  group.write_strings("name", names);
  for (const auto& [name, member] : numbers) {
    std::vector<double> values;
    for (const ClusterShape& shape : shapes) values.push_back(shape.*member);
    group.write(name, values);
  }
  group.write("inertia", inertia, {shapes.size(), 3});
  group.write("arm_offset", offset);
  group.write("arm_centre", centre, {half_length.size(), 3});
  group.write("arm_direction", direction, {half_length.size(), 3});
  group.write("arm_half_length", half_length);
  group.write("arm_radius", radius);
}

std::vector<ClusterShape> read_shapes(const hdf5::Group& group) {
  const auto names = group.read_strings("name");
  const auto offset = group.read<std::uint64_t>("arm_offset");
  expect_entries(group, "arm_offset", offset, names.size() + 1);
  const auto half_length = group.read<double>("arm_half_length");
  const std::size_t arms = half_length.size();
  if (offset.front() != 0 || offset.back() != arms || !std::is_sorted(offset.begin(), offset.end()))
    throw data_error(
        fmt::format("the file is damaged: 'arm_offset' does not cut {} arms into {} shapes", arms, names.size()),
        group.file());
  const auto radius = read_numbers(group, "arm_radius", arms);
  const auto centre = read_numbers(group, "arm_centre", 3 * arms);
  const auto direction = read_numbers(group, "arm_direction", 3 * arms);
  const auto inertia = read_numbers(group, "inertia", 3 * names.size());
  std::vector<ClusterShape> shapes(names.size());
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    shapes[s].name = names[s];
    shapes[s].inertia = vector_at(inertia, s);
    for (std::size_t a = offset[s]; a < offset[s + 1]; ++a)
      shapes[s].arms.push_back({vector_at(centre, a), vector_at(direction, a), half_length[a], radius[a]});
  }
  for (const auto& [name, member] : numbers) {
    const auto values = read_numbers(group, name, shapes.size());
    for (std::size_t s = 0; s < shapes.size(); ++s) shapes[s].*member = values[s];
  }
  return shapes;
}

std::string cluster_problem(const Packing& p) {
  for (const Wall& wall : p.walls)
    if (wall.kind == WallKind::cylinder && !(wall.radius > 0))
      return fmt::format("a cylinder has the radius {}", wall.radius);
  const Grains& g = p.grains;
  const std::size_t bodies = p.shapes.empty() ? 0 : g.size();
  if (g.shape.size() != bodies || g.scale.size() != bodies || g.orientation.size() != bodies)
    return fmt::format("{} grains have {} shapes, {} size factors and {} orientations where {} of each are expected",
                       g.size(), g.shape.size(), g.scale.size(), g.orientation.size(), bodies);
  if (p.shapes.empty()) return {};
  for (std::size_t s = 0; s < p.shapes.size(); ++s)
    if (const std::string problem = shape_problem(p.shapes[s], p.dimension); !problem.empty())
      return fmt::format("shape {} {}", s, problem);
  for (std::size_t n = 0; n < g.size(); ++n)
    if (const std::string problem = body_problem(p, n); !problem.empty()) return fmt::format("grain {} {}", n, problem);
  for (std::size_t m = 0; m < p.contacts.size(); ++m)
    if (const std::string problem = contact_problem(p, m); !problem.empty())
      return fmt::format("contact {} {}", m, problem);
  return {};
}

}  // namespace jam
