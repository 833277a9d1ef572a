#include "fixture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <vector>

#include "jamscape/base/files.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/packing/wall_roles.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {
namespace {

constexpr int realisations = 3;
constexpr std::int64_t side = 20;  // grains in a row

std::string study_text(const std::string& title) {
  return fmt::format(R"([study]
name = "fixture"
title = {}
realisations = {}

[grains]
count = {}

[[stage]]
name = "compress"
to = 0.9
speed = 2.5e-5
frames = 31
frames_at = [0.62, 0.64, 0.66, 0.68, 0.7, 0.72, 0.74, 0.76, 0.78, 0.8, 0.82, 0.84, 0.86, 0.88, 0.9]

[[system]]
name = "equal"
grains.width = 0.0
contact.friction = 0.0

[[system]]
name = "wide"
grains.width = 0.4
contact.friction = 0.0

[[system]]
name = "wide-rough"
grains.width = 0.4
contact.friction = 0.5
)",
                     print_text(title), realisations, side * side);
}

double rho_c(std::size_t system) { return std::vector{0.861, 0.814, 0.788}[system]; }

double step_up(double rho, std::size_t system) { return 1 / (1 + std::exp(-(rho - rho_c(system)) / 0.006)); }

struct Curve {
  std::string name;
  std::function<double(double, std::size_t)> value;
};

std::vector<Curve> frame_curves() {
  const auto up = step_up;
  const auto peak = [](double rho, std::size_t s) { return std::exp(-std::pow((rho - rho_c(s) + 0.015) / 0.02, 2)); };
  std::vector<Curve> curves = {
      {"z", [=](double r, std::size_t s) { return 0.6 + 3.2 * up(r, s) + 2 * (r - 0.6); }},
      {"rattlers", [=](double r, std::size_t s) { return 0.05 + 0.8 * (1 - up(r, s)); }},
      {"psi6", [=](double r, std::size_t s) { return (0.9 - 0.3 * double(s)) * up(r, s); }},
      {"psi6_local", [=](double r, std::size_t s) { return 0.2 + (0.7 - 0.2 * double(s)) * up(r, s); }},
      {"psi6_global", [=](double r, std::size_t s) { return 0.02 + (0.8 - 0.35 * double(s)) * up(r, s); }},
      {"pressure", [=](double r, std::size_t s) { return std::max(0.0, r - rho_c(s)) + 1e-5; }},
      {"unbalanced_force", [=](double r, std::size_t s) { return 1e-3 + 0.8 * (1 - up(r, s)); }},
      {"kinetic", [=](double r, std::size_t s) { return 1e-6 + 1e-3 * (1 - up(r, s)); }},
      // spans more decades than an axis can show
      {"elastic", [=](double r, std::size_t s) { return std::pow(up(r, s), 3); }},
      {"tp0", [=](double r, std::size_t s) { return 300 * up(r, s); }},
      {"tp1", [=](double r, std::size_t s) { return 120 * up(r, s); }},
      {"contacts", [=](double r, std::size_t s) { return 200 * (0.6 + 3.2 * up(r, s)); }},
  };
  for (const std::string dimension : {"b0_", "b1_"}) {
    curves.push_back({dimension + "rough", [=](double r, std::size_t s) { return 380 * (1 - up(r, s)) + 12; }});
    curves.push_back({dimension + "strong", [=](double r, std::size_t s) { return 22 * up(r, s) * (1.3 - r); }});
    curves.push_back({dimension + "medium", [=](double r, std::size_t s) { return 55 * up(r, s); }});
    curves.push_back({dimension + "weak", [=](double r, std::size_t s) { return 8 + 60 * peak(r, s); }});
  }
  return curves;
}

void write_ensemble(const std::filesystem::path& folder, const std::vector<Task>& tasks) {
  std::string frames = "system,grains.width,contact.friction,frame,packing_fraction_target,quantity,n,mean,sd,se\n";
  std::string forces =
      "system,grains.width,contact.friction,frame,packing_fraction_target,force,quantity,n,mean,sd,se\n";
  std::string pairs =
      "system,grains.width,contact.friction,frame,packing_fraction_target,distance,quantity,n,mean,sd,se\n";
  std::string betti =
      "system,grains.width,contact.friction,frame,packing_fraction_target,threshold,quantity,n,mean,sd,se\n";
  const char* names[] = {"equal,0.0,0.0", "wide,0.4,0.0", "wide-rough,0.4,0.5"};
  Random random(1, "fixture", 0, "noise");
  const auto row = [&](std::string& out, const std::string& lead, const std::string& quantity, double mean) {
    const double se = 0.03 * std::abs(mean) * random.uniform(0.5, 1);
    out += fmt::format("{},{},{},{},{},{}\n", lead, quantity, realisations, mean + se * random.uniform(-1, 1),
                       se * std::sqrt(realisations), se);
  };
  for (const Task& task : tasks) {
    if (task.realisation != tasks.front().realisation) continue;
    for (std::size_t f = 0; f < task.plan.frames.size(); ++f) {
      const double rho = task.plan.frames[f].packing_fraction;
      const std::string lead = fmt::format("{},{},{}", names[task.system], f, rho);
      for (const Curve& curve : frame_curves()) row(frames, lead, curve.name, curve.value(rho, task.system));
      for (double force = 0.1; force < 6; force *= 1.12) {
        const std::string at = fmt::format("{},{}", lead, force);
        row(forces, at, "density", std::exp(-force * (0.8 + rho)));
      }
      for (double theta = 0; theta < 5.01; theta += 0.05) {
        const std::string at = fmt::format("{},{}", lead, theta);
        row(betti, at, "b0", 60 * theta * std::exp(-theta) * rho);
        row(betti, at, "b1", 90 * std::exp(-2 * theta) * rho);
      }
      for (double d = 0.5; d < 6; d += 0.02)
        row(pairs, fmt::format("{},{}", lead, d), "g",
            d < 0.95 ? 0 : 1 + std::cos(6.28 * d) * std::exp(-(d - 1) * 0.8));
    }
  }
  write_text(folder / "ensemble/frames.csv", frames);
  write_text(folder / "ensemble/force_distribution.csv", forces);
  write_text(folder / "ensemble/pair_correlation.csv", pairs);
  write_text(folder / "ensemble/betti.csv", betti);
}

void write_transitions(const std::filesystem::path& folder) {
  std::string text = "system,grains.width,contact.friction,quantity,n,value,se\n";
  const char* names[] = {"equal,0.0,0.0", "wide,0.4,0.0", "wide-rough,0.4,0.5"};
  for (std::size_t s = 0; s < 3; ++s)
    for (const char* quantity : {"rho_c", "rho_c_walls", "rho_inflection"})
      text += fmt::format("{},{},{},{},{}\n", names[s], quantity, realisations, rho_c(s), 0.0011);
  write_text(folder / "ensemble/transitions.csv", text);
}

/// Rows of grains between walls of beads, each pushed a little from its place; neighbours that are near enough touch.
Packing made_up_packing(const Task& task, const PlannedFrame& frame) {
  Random random(7, "fixture", task.system, "packing");
  Packing p;
  p.step = frame.step;
  p.stage = frame.stage;
  p.packing_fraction = p.packing_fraction_plain = frame.packing_fraction;
  const double spacing = std::sqrt(0.7854 / frame.packing_fraction);
  const double length = spacing * static_cast<double>(side + 1);
  p.domain.hi = {length, length, 0};
  for (std::int64_t k = 0; k < side * side; ++k) {
    p.grains.id.push_back(k);
    p.grains.species.push_back(0);
    p.grains.radius.push_back(task.system == 0 ? 0.5 : random.uniform(0.42, 0.58));
    p.grains.mass.push_back(1);
    p.grains.position.push_back({spacing * (1 + double(k % side) + random.uniform(-0.1, 0.1)),
                                 spacing * (1 + double(k / side) + random.uniform(-0.1, 0.1)), 0});
    for (auto* list : {&p.grains.velocity, &p.grains.spin, &p.grains.angle}) list->push_back({});
  }
  for (int w = 0; w < 4; ++w) {
    Wall wall;
    wall.kind = WallKind::beads;
    wall.bead_radius = 0.5;
    const int axis = w / 2;
    wall.normal[axis] = w % 2 ? -1 : 1;
    for (int b = -2; b < int(length) + 4; ++b) {
      Vec3 at{};
      at[axis] = w % 2 ? length : 0;
      at[1 - axis] = b;
      wall.beads.push_back(at);
    }
    p.walls.push_back(wall);
  }
  const auto touch = [&](std::size_t i, std::int32_t j, std::uint16_t part, Vec3 other, double radius) {
    const Vec3 apart = other - p.grains.position[i];
    const double distance = norm(apart), overlap = p.grains.radius[i] + radius - distance;
    if (overlap <= 0) return;
    p.contacts.i.push_back(static_cast<std::uint32_t>(i));
    p.contacts.j.push_back(j);
    p.contacts.part_i.push_back(0);
    p.contacts.part_j.push_back(part);
    p.contacts.image.push_back({});
    p.contacts.overlap.push_back(overlap);
    p.contacts.normal_force.push_back(-std::log(1 - random.uniform()));
    p.contacts.normal.push_back((1 / distance) * apart);
    p.contacts.tangential_force.push_back({});
    p.contacts.point.push_back(p.grains.position[i] + (p.grains.radius[i] / distance) * apart);
    p.contacts.sliding.push_back(0);
  };
  for (std::size_t i = 0; i < p.grains.size(); ++i) {
    for (std::size_t w = p.walls.size(); w-- > 0;)
      for (std::size_t b = 0; b < p.walls[w].beads.size(); ++b)
        touch(i, -1 - static_cast<std::int32_t>(w), static_cast<std::uint16_t>(b), p.walls[w].beads[b], 0.5);
    for (std::size_t j = i + 1; j < p.grains.size(); ++j)
      touch(i, static_cast<std::int32_t>(j), 0, p.grains.position[j], p.grains.radius[j]);
  }
  guess_roles(p);
  return p;
}

void write_task(const TaskFolder& folder, const Task& task) {
  make_folder(folder.frames());
  std::vector<std::filesystem::path> files;
  std::string diagram = "frame,dimension,birth,death,essential\n";
  Random random(3, "fixture", task.system, "diagram");
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k) {
    files.push_back(folder.frame(k));
    write_frame(files.back(), made_up_packing(task, task.plan.frames[k]));
    for (int point = 0; point < 300; ++point) {
      const double birth = std::min(5.0, -1.2 * std::log(1 - random.uniform()));
      const bool loop = point % 3 == 0, essential = loop && point % 2 == 0;
      const double death = essential ? 0 : birth * random.uniform();
      diagram += fmt::format("{},{},{},{},{}\n", k, loop ? 1 : 0, birth, death, essential ? 1 : 0);
    }
  }
  assemble_run(files, folder.run_file(), {});
  folder.discard_partial();
  write_text(folder.tables() / "diagram.csv", diagram);
}

}  // namespace

void write_fixture(const std::filesystem::path& folder, const FixtureParts& parts) {
  const Study study = read_study_text(study_text(parts.title), "fixture.toml");
  write_results_study(folder, study);
  const std::vector<Task> tasks = plan_tasks(study);
  for (const char* sub : {"ensemble", "tables"}) make_folder(folder / sub);
  if (parts.ensemble) write_ensemble(folder, tasks);
  if (parts.transitions) write_transitions(folder);
  if (!parts.tasks) return;
  for (const Task& task : tasks) {
    if (task.realisation != tasks.front().realisation) continue;
    const TaskFolder task_folder(folder, task.hash);
    make_folder(task_folder.tables());
    write_task(task_folder, task);
  }
}

}  // namespace jam
