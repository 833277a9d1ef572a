#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "jamscape/geometry/cluster_shape.hpp"

namespace jam::app {
namespace {

/// Sphericities as S3 prints them (Table S1).
struct Printed {
  double aspect, cross, star;
};
constexpr Printed table_s1[] = {{1.1, .995, .995}, {1.7, .933, .933}, {2.25, .842, .809}, {3, .754, .702},
                                {4, .677, .619},   {6, .585, .526},   {8.5, .518, .462},  {11, .473, .419}};

std::optional<double> printed_sphericity(const ClusterShape& shape) {
  for (const Printed& row : table_s1)
    if (std::abs(row.aspect - aspect_ratio(shape)) < 1e-9) return shape.name == "cross" ? row.cross : row.star;
  return std::nullopt;
}

void print_json(const ClusterShape& shape) {
  const Distances at = contact_distances(shape);
  const double psi = sphericity(shape), m = shape.volume;
  nlohmann::json line{{"shape", shape.name},
                      {"aspect", aspect_ratio(shape)},
                      {"volume", m},
                      {"surface", shape.surface},
                      {"area", shape.area},
                      {"sphericity", psi},
                      {"inertia_per_mass", {shape.inertia[0] / m, shape.inertia[1] / m, shape.inertia[2] / m}},
                      {"d1", at.d1},
                      {"d2", at.d2},
                      {"d3", at.d3},
                      {"j1", at.j1}};
  if (const std::optional<double> paper = printed_sphericity(shape)) {
    line["sphericity_paper"] = *paper;
    line["sphericity_deviation"] = psi - *paper;
  }
  fmt::print("{}\n", line.dump());
}

void print_row(const ClusterShape& shape) {
  const Distances at = contact_distances(shape);
  const double psi = sphericity(shape);
  const std::optional<double> paper = printed_sphericity(shape);
  fmt::print("{:6} {:6} {:9.5f} {:9.4f} {:8.4f} {:6} {:>9}  {:9.5f} {:7.3f} {:6.3f} {:6.3f} {:6.3f}\n", shape.name,
             aspect_ratio(shape), shape.volume, shape.surface, psi, paper ? fmt::format("{:.3f}", *paper) : "-",
             paper ? fmt::format("{:+.4f}", psi - *paper) : "-", shape.inertia[2] / shape.volume, at.d1, at.d2, at.d3,
             at.j1);
}

void print_table(const std::vector<double>& aspects) {
  fmt::print("{:6} {:>6} {:>9} {:>9} {:>8} {:6} {:>9}  {:>9} {:>7} {:>6} {:>6} {:>6}\n", "shape", "L/d", "V/d^3",
             "A/d^2", "psi", "paper", "deviation", "I/(m d^2)", "D1/L", "D2/L", "D3/L", "J1/L");
  for (ClusterShape (*const make)(double) : {cross_shape, star_shape})
    for (const double aspect : aspects) print_row(make(aspect));
  fmt::print(
      "\nV, A: volume and surface, overlap of the arms counted once; psi = pi^(1/3) (6 V)^(2/3) / A; I: about the "
      "normal\n"
      "of a cross, about any axis of a star. paper: S3, Table S1. D1..D3, J1: S3, Eq. 11 and 12 as printed, which "
      "touch\n"
      "from L/d = 3 on.\n");
  for (const double aspect : aspects) {
    if (std::abs(aspect - 1.1) > 1e-9) continue;
    fmt::print(
        "\nL/d = 1.1: the printed .995 is not the sphericity of these bodies. It belongs to a cross of L/d = 1.17 "
        "({:.4f})\n"
        "and a star of 1.19 ({:.4f}). Nor does the paper's D1/L = .98 follow from Eq. 11 ({:.3f}): hubs of short arms "
        "lie\n"
        "side by side, two crosses on a diagonal d + (L - d)/sqrt(2) = {:.3f} L apart. Name shapes by L/d, not by "
        "psi.\n",
        sphericity(cross_shape(1.17)), sphericity(star_shape(1.19)), contact_distances(cross_shape(1.1)).d1,
        (1 + .1 / std::sqrt(2.0)) / 1.1);
    break;
  }
}

ExitCode list_shapes(std::vector<double> aspects, bool as_json) {
  if (aspects.empty())
    for (const Printed& row : table_s1) aspects.push_back(row.aspect);
  if (!as_json) {
    print_table(aspects);
    return ExitCode::done;
  }
  for (ClusterShape (*const make)(double) : {cross_shape, star_shape})
    for (const double aspect : aspects) print_json(make(aspect));
  return ExitCode::done;
}

}  // namespace

void add_shapes(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand("shapes", "Volume, sphericity and inertia of crosses and stars, beside S3's");
  auto aspects = std::make_shared<std::vector<double>>();
  auto json = std::make_shared<bool>(false);
  sub->add_option("aspect", *aspects, "aspect ratios L/d of the arms (default: the eight of S3)");
  sub->add_flag("--json", *json, "one JSON object per shape");
  sub->callback([aspects, json, &action] { action = [aspects, json] { return list_shapes(*aspects, *json); }; });
}

}  // namespace jam::app
