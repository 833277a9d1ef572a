#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "fixture.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {
namespace {

constexpr int realisations = 4;

struct Kind {
  const char* name;
  int dimension;
  std::int64_t side;  // grains along an edge
  double last, jams;
  double width;  // of the distribution of forces
};
constexpr Kind kinds[] = {{"2d-linear", 2, 19, 0.89, 0.834, 1.0},
                          {"2d-hertz", 2, 19, 0.906, 0.842, 1.3},
                          {"3d-hertz", 3, 7, 0.71, 0.57, 1.6}};

std::string study_text() {
  std::string text = fmt::format(R"([study]
name = "networks"
title = "Interaction networks, synthetic"
realisations = {}

[measure]
force = "total"
clamp = 0
remove_rattlers = true

[domain]
walls = "flat"

[[stage]]
name = "compress"
speed = 1e-3
)",
                                 realisations);
  for (const Kind& kind : kinds) {
    const double grains = std::pow(static_cast<double>(kind.side), kind.dimension);
    text += fmt::format("\n[[system]]\nname = \"{}\"\ngrains.count = {}\ndomain.dimension = {}\n", kind.name, grains,
                        kind.dimension);
    if (kind.dimension == 3) text += "grains.inertia_factor = 0.4\nstart.packing_fraction = 0.3\n";
    text += fmt::format("stage.compress.to = {}\nstage.compress.frames_at = [", kind.last);
    for (int k = 13; k >= 0; --k) text += fmt::format("{:.3f}{}", kind.last - 0.02 * k, k ? ", " : "]\n");
  }
  return text;
}

double up(double rho, const Kind& kind) { return 1 / (1 + std::exp(-(rho - kind.jams) / 0.008)); }

void write_tables(const std::filesystem::path& folder, const std::vector<Task>& tasks) {
  std::string frames = "system,frame,packing_fraction_target,quantity,n,mean,sd,se\n";
  std::string levels = "system,frame,packing_fraction_target,threshold,quantity,n,mean,sd,se\n";
  std::string forces = "system,frame,packing_fraction_target,force,quantity,n,mean,sd,se\n";
  std::string relaxed = "system,realisation,frame,stage,relaxation\n";
  Random random(1, "networks", 0, "noise");
  const auto row = [&](std::string& out, const std::string& lead, const std::string& quantity, double mean) {
    const double se = 0.03 * std::abs(mean) * random.uniform(0.5, 1);
    out += fmt::format("{},{},{},{},{},{}\n", lead, quantity, realisations, mean + se * random.uniform(-1, 1),
                       se * std::sqrt(realisations), se);
  };
  for (const Task& task : tasks) {
    const Kind& kind = kinds[task.system];
    const double grains = std::pow(static_cast<double>(kind.side), kind.dimension);
    for (std::size_t f = 0; f < task.plan.frames.size(); ++f) {
      const double rho = task.plan.frames[f].packing_fraction, jammed = up(rho, kind);
      const bool slow = f % 5 == 3 && task.realisation == 1;
      relaxed += fmt::format("{},{},{},compress,{}\n", kind.name, task.realisation, f,
                             slow           ? "budget"
                             : jammed < 0.5 ? "fluctuation"
                                            : "energy");
      if (task.realisation != tasks.front().realisation) continue;
      const std::string lead = fmt::format("{},{},{}", kind.name, f, rho);
      row(frames, lead, "z", (kind.dimension + 1) * jammed + 0.3);
      row(frames, lead, "z_backbone", (kind.dimension + 1.4) * jammed + 0.5);
      row(frames, lead, "rattlers", 0.05 + 0.8 * (1 - jammed));
      row(frames, lead, "psi6", kind.dimension == 2 ? 0.3 * jammed : 0);
      row(frames, lead, "pressure", std::max(0.0, rho - kind.jams) + 1e-5);
      for (const char* bin : {"b0_rough", "b0_strong", "b0_medium", "b0_weak"})
        row(frames, lead, bin, 0.1 * grains * jammed);
      row(frames, lead, "tp0", 0.3 * grains * jammed);
      row(frames, lead, "tp1", 0.5 * grains * jammed);
      row(frames, lead, "tp2", kind.dimension == 3 ? 0.02 * grains * jammed : 0);
      for (double theta = 0; theta < 3.01; theta += 0.05) {
        const std::string at = fmt::format("{},{:.2f}", lead, theta);
        row(levels, at, "mean_cluster_pooled",
            0.002 + 0.05 * jammed * std::exp(-std::pow((theta - kind.width - 0.2) / 0.35, 2)));
        row(levels, at, "percolating_grains",
            theta < 1.2 * jammed ? 0.95 * jammed * (1 - theta / 3) : std::nan(""));  // missing: too few percolate
        row(levels, at, "b0", grains * jammed * 0.15 * theta * std::exp(-std::pow(theta / kind.width / 1.4, 2)));
        row(levels, at, "b1", grains * jammed * 0.4 * (kind.dimension - 1) * std::exp(-2 * theta));
        row(levels, at, "b2", kind.dimension == 3 ? grains * jammed * 0.05 * std::exp(-4 * theta) : 0);
        row(levels, at, "shape", jammed < 0.02 ? 0 : 1 + 0.8 * jammed * std::exp(-theta));
      }
      for (double force = 0.06; force < 6; force += 0.12)
        row(forces, fmt::format("{},{}", lead, force), "density",
            std::exp(-std::pow((force - 0.4 * jammed) / kind.width, 2)));
    }
  }
  std::string jamming = "system,quantity,n,value,se\n";
  for (const Kind& kind : kinds) {
    jamming += fmt::format("{},rho_c,{},{},0.001\n", kind.name, realisations, kind.jams - 0.03);
    jamming += fmt::format("{},rho_j,{},{},0.002\n", kind.name, realisations, kind.jams);
    jamming += fmt::format("{},z_at_rho_j,{},{},0.05\n", kind.name, realisations, kind.dimension + 0.2);
  }
  write_text(folder / "ensemble/frames.csv", frames);
  write_text(folder / "ensemble/level_sets.csv", levels);
  write_text(folder / "ensemble/force_distribution.csv", forces);
  write_text(folder / "ensemble/transitions.csv", jamming);
  write_text(folder / "tables/frames.csv", relaxed);
}

/// A cubic or square lattice, each grain pushed a little from its place, between flat walls; the spheres in a periodic
/// box.
Packing made_up_packing(const Task& task, const PlannedFrame& frame) {
  const Kind& kind = kinds[task.system];
  Random random(7, "networks", task.system, "packing");
  Packing p;
  p.dimension = kind.dimension;
  p.step = frame.step;
  p.stage = frame.stage;
  p.packing_fraction = p.packing_fraction_plain = frame.packing_fraction;
  const double length = 0.96 * static_cast<double>(kind.side);
  for (int a = 0; a < kind.dimension; ++a) {
    p.domain.hi[a] = length;
    p.domain.periodic[static_cast<std::size_t>(a)] = kind.dimension == 3;
  }
  const auto grains = static_cast<std::int64_t>(std::pow(kind.side, kind.dimension) + 0.5);
  for (std::int64_t k = 0; k < grains; ++k) {
    p.grains.id.push_back(k);
    p.grains.species.push_back(0);
    p.grains.radius.push_back(random.uniform() < 0.667 ? 0.44 : 0.56);
    p.grains.mass.push_back(1);
    Vec3 at{};
    for (std::int64_t a = 0, left = k; a < kind.dimension; ++a, left /= kind.side)
      at[static_cast<int>(a)] = 0.96 * (0.5 + double(left % kind.side) + random.uniform(-0.08, 0.08));
    p.grains.position.push_back(at);
    for (auto* list : {&p.grains.velocity, &p.grains.spin, &p.grains.angle}) list->push_back({});
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (std::size_t j = i + 1; j < p.grains.size(); ++j) {
      Vec3 apart = p.grains.position[j] - p.grains.position[i];
      std::array<std::int8_t, 3> image{};
      for (std::size_t a = 0; a < 3; ++a) {
        if (!p.domain.periodic[a]) continue;
        image[a] = static_cast<std::int8_t>(-std::lround(apart[static_cast<int>(a)] / length));
        apart[static_cast<int>(a)] += image[a] * length;
      }
      const double distance = norm(apart), overlap = p.grains.radius[i] + p.grains.radius[j] - distance;
      if (overlap <= 0) continue;
      p.contacts.i.push_back(static_cast<std::uint32_t>(i));
      p.contacts.j.push_back(static_cast<std::int32_t>(j));
      p.contacts.part_i.push_back(0);
      p.contacts.part_j.push_back(0);
      p.contacts.image.push_back(image);
      p.contacts.overlap.push_back(overlap);
      p.contacts.normal_force.push_back(-kind.width * std::log(1 - random.uniform()));
      p.contacts.normal.push_back((1 / distance) * apart);
      p.contacts.tangential_force.push_back({});
      p.contacts.point.push_back(p.grains.position[i] + (p.grains.radius[i] / distance) * apart);
      p.contacts.sliding.push_back(0);
    }
  return p;
}

}  // namespace

void write_network_fixture(const std::filesystem::path& folder) {
  const Study study = read_study_text(study_text(), "networks.toml");
  write_results_study(folder, study);
  const std::vector<Task> tasks = plan_tasks(study);
  for (const char* sub : {"ensemble", "tables"}) make_folder(folder / sub);
  write_tables(folder, tasks);
  for (const Task& task : tasks) {
    if (task.realisation != tasks.front().realisation) continue;
    const TaskFolder task_folder(folder, task.hash);
    make_folder(task_folder.frames());
    std::vector<std::filesystem::path> files;
    for (std::size_t k = 0; k < task.plan.frames.size(); ++k) {
      files.push_back(task_folder.frame(k));
      write_frame(files.back(), made_up_packing(task, task.plan.frames[k]));
    }
    assemble_run(files, task_folder.run_file(), {});
    task_folder.discard_partial();
  }
}

}  // namespace jam
