#include "lammps_run.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "lammps_program.hpp"

namespace jam::lammps {
namespace {

namespace fs = std::filesystem;

constexpr double side = 8;
constexpr int grains = 620;  // packing fraction .634
// law.in says the same
constexpr Law between_grains{1e4, 4e3, 100, 30, 0.4}, at_walls{6e3, 5e3, 150, 40, 0.3};

Vec3 three(const std::vector<double>& row, std::size_t first) {
  return {row.at(first), row.at(first + 1), row.at(first + 2)};
}

}  // namespace

Packed::Packed(const std::string& name) : folder_((fs::path(JAM_LAMMPS_RUNS) / name).string()) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  for (const auto* script : {"make.in", "law.in", "follow.in"})
    fs::copy_file(fs::path(JAM_LAMMPS_INPUTS) / script, fs::path(folder_) / script);
  run(folder_, "make", "-var side " + std::to_string(side) + " -var grains " + std::to_string(grains));
}

Followed Packed::follow(double dt, int steps) const {
  std::ostringstream variables;
  variables.precision(17);
  variables << "-var side " << side << " -var dt " << dt << " -var steps " << steps;
  run(folder_, "follow", variables.str());

  Followed out;
  State<3>& s = out.start;
  s.box.length = {side, side, 0};
  s.walls.resize(2);
  s.walls[0].axis = s.walls[1].axis = 2;
  s.walls[1].high = true, s.walls[1].position = side;
  s.kind = NormalLaw::hertz;
  s.law = pair_law(between_grains, std::sqrt(0.25));
  s.wall_law = pair_law(at_walls, std::sqrt(0.5));
  s.dt = dt;
  const fs::path folder = folder_;
  for (const auto& row : rows_of(folder / "grains.0")) {
    s.position.push_back(three(row, 1)), s.velocity.push_back(three(row, 4));
    s.radius.push_back(row.at(7)), s.mass.push_back(row.at(8));
    s.spin.push_back(three(row, 9)), s.force.push_back(three(row, 12)), s.torque.push_back(three(row, 15));
  }
  for (const auto& row : rows_of(folder / ("grains." + std::to_string(steps)))) {
    out.position.push_back(three(row, 1)), out.velocity.push_back(three(row, 4)), out.spin.push_back(three(row, 9));
    out.force.push_back(three(row, 12)), out.torque.push_back(three(row, 15));
  }
  for (const auto& row : rows_of(folder / "contacts")) {
    const int i = static_cast<int>(row.at(0)) - 1, j = static_cast<int>(row.at(1)) - 1;
    const double sign = i < j ? 1 : -1;
    out.contacts[{std::min(i, j), std::max(i, j)}] = {row.at(2), sign * three(row, 3)};
  }
  for (const auto& row : rows_of(folder / "walls")) {
    if (row.at(1) == 0) continue;
    const int i = static_cast<int>(row.at(0)) - 1,
              wall = out.position[static_cast<std::size_t>(i)][2] < side / 2 ? 0 : 1;
    out.contacts[{i, -1 - wall}] = {wall == 0 ? row.at(4) : -row.at(4), {row.at(2), row.at(3), 0}};
  }
  return out;
}

}  // namespace jam::lammps
