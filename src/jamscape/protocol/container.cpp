#include "jamscape/protocol/container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/cluster_shape.hpp"

namespace jam {
namespace {

std::vector<Arm> read_arms(const std::vector<double>& numbers) {
  constexpr std::size_t per_arm = 8;
  if (numbers.empty() || numbers.size() % per_arm != 0)
    throw usage_error(fmt::format("grains.arms has {} numbers; an arm has {}", numbers.size(), per_arm), {},
                      "for each arm: centre x, y, z, direction x, y, z, length tip to tip, diameter");
  std::vector<Arm> arms;
  for (std::size_t a = 0; a < numbers.size(); a += per_arm) {
    const double* n = numbers.data() + a;
    Arm arm{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, (n[6] - n[7]) / 2, n[7] / 2};
    const std::string name = fmt::format("grains.arms: arm {}", a / per_arm + 1);
    if (!(n[7] > 0)) throw usage_error(name + fmt::format(" has the diameter {}", n[7]), {}, "a diameter above 0");
    if (!(n[6] >= n[7]))
      throw usage_error(name + fmt::format(" is shorter ({}) than thick ({})", n[6], n[7]), {},
                        "the length counts from tip to tip: at least the diameter");
    const double size = norm(arm.direction);
    if (!(size > 0)) throw usage_error(name + " has no direction", {}, "for example 1, 0, 0");
    arm.direction = (1 / size) * arm.direction;
    arms.push_back(arm);
  }
  return arms;
}

}  // namespace

void refuse_balls() {
  throw usage_error("domain.walls: a container holds clusters, and grains.shape = \"ball\" is none", {},
                    "grains.shape = \"sphere\", \"cross\" or \"star\", or domain.walls = \"flat\"");
}

double Container::base() const {
  if (dimension == 2) return width;
  return walls == WallModel::cylinder ? std::numbers::pi / 4 * width * width : width * thickness;
}

ClusterShape grain_shape(const SystemOptions& system) {
  switch (system.grains.shape) {
    case BodyShape::ball:
      refuse_balls();
    case BodyShape::sphere:
      return sphere_shape();
    case BodyShape::rod:
      return rod_shape(system.grains.aspect);
    case BodyShape::cross:
      return cross_shape(system.grains.aspect);
    case BodyShape::star:
      if (system.domain.dimension == 2)
        throw usage_error("grains.shape: a star does not lie in a plane", {}, "\"cross\", or domain.dimension = 3");
      return star_shape(system.grains.aspect);
    case BodyShape::custom:
      break;
  }
  try {
    return custom_shape(read_arms(system.grains.arms), static_cast<int>(system.domain.dimension));
  } catch (const Error& e) {
    if (e.problem().starts_with("grains.arms")) throw;
    throw usage_error("grains.arms: " + e.problem(), {}, e.suggestion());
  }
}

Container container(const SystemOptions& system, const ClusterShape& shape, const std::vector<double>& scales) {
  Container c{static_cast<int>(system.domain.dimension), system.domain.walls, system.domain.width * shape.length, 0, 0};
  double largest = 0;
  for (const double s : scales) {
    c.bodies += c.dimension == 2 ? shape.area * s * s : shape.volume * s * s * s;
    largest = std::max(largest, 2 * s * shape.circumradius);
  }
  if (c.walls == WallModel::cylinder && c.dimension == 2)
    throw usage_error("domain.walls: a cylinder is for three dimensions", {}, "domain.walls = \"box\"");
  if (c.walls == WallModel::box && c.dimension == 3)
    c.thickness = std::max(system.domain.thickness * shape.length, largest);
  if (largest > c.width)
    throw usage_error(
        fmt::format("domain.width: the largest body is {:.4g} d across, the container {:.4g} d", largest, c.width), {},
        fmt::format("at least {:.3g}", largest / shape.length));
  return c;
}

}  // namespace jam
