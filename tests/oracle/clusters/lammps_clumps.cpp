#include "lammps_clumps.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "lammps_program.hpp"

namespace jam::clusters {
namespace {

namespace fs = std::filesystem;

/// Inertia about the centre of mass in the world's frame: xx, yy, zz, xy, xz, yz.
std::array<double, 6> inertia_of(const ClusterShape& shape, const Quaternion& q) {
  const Vec3 axes[3] = {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})};
  std::array<double, 6> sum{};
  for (int k = 0; k < 3; ++k) {
    const Vec3& e = axes[k];
    const double moment = shape.inertia[k];
    const double parts[6] = {e[0] * e[0], e[1] * e[1], e[2] * e[2], e[0] * e[1], e[0] * e[2], e[1] * e[2]};
    for (std::size_t c = 0; c < 6; ++c) sum[c] += moment * parts[c];
  }
  return sum;
}

Vec3 angular_momentum(const ClusterShape& shape, const Quaternion& q, const Vec3& spin) {
  Vec3 l{};
  for (int k = 0; k < 3; ++k) {
    const Vec3 e = rotate(q, {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0});
    l += shape.inertia[k] * dot(spin, e) * e;
  }
  return l;
}

/// impact.data: the spheres, with their body as molecule. impact.bodies: what fix rigid/small needs of each body.
void write_inputs(const fs::path& folder, const Impacts& impacts, int spheres) {
  const ClusterBodies& b = impacts.bodies;
  const ClusterShape& shape = impacts.shape;
  std::string atoms, molecules, bodies = fmt::format("{}\n", b.size());
  std::size_t atom = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Vec3 &x = b.position[k], &v = b.velocity[k];
    for (const Arm& arm : shape.arms)
      for (int s = 0; s < spheres; ++s) {
        const double at = arm.half_length * (2.0 * s / (spheres - 1) - 1);
        const Vec3 p = x + rotate(b.orientation[k], arm.centre + at * arm.direction);
        ++atom;
        atoms += fmt::format("{} 1 {} 1 {} {} {}\n", atom, 2 * arm.radius, p[0], p[1], p[2]);
        molecules += fmt::format("{} {}\n", atom, k + 1);
      }
    const std::array<double, 6> i = inertia_of(shape, b.orientation[k]);
    const Vec3 l = angular_momentum(shape, b.orientation[k], b.spin[k]);
    bodies += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} 0 0 0\n", k + 1, shape.volume, x[0], x[1],
                          x[2], i[0], i[1], i[2], i[3], i[4], i[5], v[0], v[1], v[2], l[0], l[1], l[2]);
  }
  const double margin = 2 * shape.length, far = 3 * shape.length * static_cast<double>(impacts.pairs()) + margin;
  std::ofstream(folder / "impact.data") << fmt::format(
      "impacts\n\n{} atoms\n1 atom types\n{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n\nAtoms # sphere\n\n{}\n"
      "Molecules\n\n{}",
      atom, -margin, far, -margin, margin, -margin, margin, atoms, molecules);
  std::ofstream(folder / "impact.bodies") << bodies;
}

}  // namespace

Motion collide_clumps(const std::string& name, const Impacts& impacts, const Law& law, int spheres, double dt,
                      int steps) {
  const fs::path folder = fs::path(JAM_CLUMP_RUNS) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::copy_file(fs::path(JAM_CLUMP_INPUTS) / "impact.in", folder / "impact.in");
  write_inputs(folder, impacts, spheres);
  lammps::run(folder, "impact",
              fmt::format("-var k_n {} -var k_t {} -var gamma_n {} -var gamma_t {} -var mu {} -var dt {} -var steps {}",
                          law.k_n, law.k_t, law.gamma_n, law.gamma_t, law.mu, dt, steps));
  Motion after;
  after.velocity.resize(impacts.bodies.size());
  after.spin.resize(impacts.bodies.size());
  for (const std::vector<double>& row : lammps::rows_of(folder / "bodies")) {
    const auto k = static_cast<std::size_t>(row.at(0)) - 1;
    after.velocity.at(k) = {row.at(1), row.at(2), row.at(3)};
    after.spin.at(k) = {row.at(4), row.at(5), row.at(6)};
  }
  return after;
}

}  // namespace jam::clusters
