// How a packing becomes a network and numbers: options of the measures. They never influence a simulation.
#pragma once

#include <cstdint>
#include <utility>

#include "jamscape/base/option.hpp"

namespace jam {

/// Which force of a contact is the weight of its edge.
enum class EdgeForce { normal, total };
template <>
struct EnumNames<EdgeForce> {
  static constexpr std::pair<EdgeForce, std::string_view> values[] = {{EdgeForce::normal, "normal"},
                                                                      {EdgeForce::total, "total"}};
};

/// Spacing of the bins of P(F).
enum class ForceScale { log, linear };
template <>
struct EnumNames<ForceScale> {
  static constexpr std::pair<ForceScale, std::string_view> values[] = {{ForceScale::log, "log"},
                                                                       {ForceScale::linear, "linear"}};
};

/// Tetrahedra of four mutually linked grains: filled, or left out of the complex.
enum class Tetrahedra { filled, hollow };
template <>
struct EnumNames<Tetrahedra> {
  static constexpr std::pair<Tetrahedra, std::string_view> values[] = {{Tetrahedra::filled, "filled"},
                                                                       {Tetrahedra::hollow, "hollow"}};
};

struct MeasureOptions {
  EdgeForce force = EdgeForce::normal;
  double clamp = 5;              // in mean forces; 0: none
  bool remove_rattlers = false;  // S2: once, not recursively
  double rows_every = 0.02;      // keeps tables of bins and points to the packing fractions that are shown
  double pair_bin = 0.02;
  double pair_range = 8;
  double pair_margin = 3;  // grains within about two layers of a wall are ordered by it
  double force_min = 0.1;
  double force_max = 6;
  std::int64_t force_bins = 50;
  double betti_max = 5;
  double betti_step = 0.05;
  ForceScale force_scale = ForceScale::log;
  double level_max = 3;
  double level_step = 0.05;
  Tetrahedra tetrahedra = Tetrahedra::filled;
  bool rough_includes_edge = false;
  double force_margin = 0;
  double gravity = 0;
  double contact_force_max = 10;
  std::int64_t contact_force_bins = 50;
  double jamming_z = 4;
  double jamming_pressure = 1e-3;
  double rdf_bin = 0.02;
  double rdf_range = 4;
  double rdf_margin_ends = 10;
  double rdf_margin_sides = 10;
  double rdf_margin_cylinder = 3;

  template <class V>
  void describe(V& v) {
    v.option("force", force, {.text = "weight of an edge: normal force (S1) or total contact force (S2)"});
    v.option(
        "clamp", clamp,
        {.text = "largest weight kept, in mean forces; 0 keeps all", .min = 0, .max = 1e9, .source = "S1 Sec. II.C"});
    v.option("remove_rattlers", remove_rattlers,
             {.text = "remove grains with fewer than two contacts, once", .source = "S2 Sec. 4"});
    v.option(
        "rows_every", rows_every,
        {.text = "measures with several rows a frame are taken at packing fractions that are multiples of this; 0: at "
                 "every frame, as always for clusters",
         .min = 0,
         .max = 1,
         .source = "S1 Figs. 9, 10"});
    v.option(
        "pair_bin", pair_bin,
        {.text = "pair correlation: width of a bin", .unit = "d", .min = 1e-4, .max = 10, .source = "theory sec. 4"});
    v.option("pair_range", pair_range,
             {.text = "pair correlation: largest distance", .unit = "d", .min = 0, .max = 1000, .above_min = true});
    v.option("pair_margin", pair_margin,
             {.text = "pair correlation: grains closer to a wall are no reference grains; at most a sixth of the width",
              .unit = "d",
              .min = 0,
              .max = 1000,
              .source = "theory sec. 4"});
    v.option("force_min", force_min,
             {.text = "force distribution: lowest edge of the bins, in mean forces; above 0 for logarithmic ones",
              .min = 0,
              .max = 1e6,
              .source = "theory sec. 4"});
    v.option("force_max", force_max,
             {.text = "force distribution: highest edge of the bins, in mean forces",
              .min = 0,
              .max = 1e6,
              .above_min = true,
              .source = "theory sec. 4"});
    v.option("force_bins", force_bins, {.text = "force distribution: number of bins", .min = 1, .max = 1e5});
    v.option("force_scale", force_scale,
             {.text = "force distribution: logarithmic or linear bins", .source = "S1 Figs. 9, 10; S2 Fig. 3"});
    v.option("betti_max", betti_max,
             {.text = "Betti numbers: highest threshold, in mean forces", .min = 0, .max = 1e6});
    v.option("betti_step", betti_step,
             {.text = "Betti numbers: distance of the thresholds, in mean forces", .min = 1e-4, .max = 1e6});
    v.option("level_max", level_max,
             {.text = "level sets: highest threshold, in mean forces", .min = 0, .max = 1e6, .source = "S2 Sec. 3"});
    v.option("level_step", level_step,
             {.text = "level sets: distance of the thresholds, in mean forces",
              .min = 1e-4,
              .max = 1e6,
              .source = "theory sec. 4"});
    v.option("tetrahedra", tetrahedra,
             {.text = "level sets: four mutually linked grains are filled and no void, or hollow and one (b2 only)",
              .source = "S2 Sec. 5.1; theory sec. 4"});
    v.option("rough_includes_edge", rough_includes_edge,
             {.text = "persistence bins: a lifetime of exactly 0.1 is rough (S2) or not (S1)",
              .source = "S1 Sec. II.C, S2 Sec. 5.3"});
    v.option("force_margin", force_margin,
             {.text = "force statistics (P(F), P(f), tails, forces of single contacts, distribution of the stresses of grains, wall "
                      "pressure): what is closer to a wall is left out; at most a sixth of the width",
              .unit = "d",
              .min = 0,
              .max = 1000,
              .source = "theory sec. 4"});
    v.option("gravity", gravity,
             {.text = "unbalanced force: acceleration down the second axis, of packings made elsewhere; frames of a "
                      "study take domain.gravity",
              .unit = "d/tau_c^2",
              .min = 0,
              .max = 1e6});
    v.option("contact_force_max", contact_force_max,
             {.text = "distributions of the contacts' forces and of the grains' stresses: end of the bins, in means",
              .min = 0,
              .max = 1e6,
              .above_min = true,
              .source = "S3, Data analysis"});
    v.option("contact_force_bins", contact_force_bins,
             {.text = "distributions of the contacts' forces and of the grains' stresses: number of bins from 0 on",
              .min = 1,
              .max = 1e5,
              .source = "S3, Data analysis"});
    v.option("jamming_z", jamming_z,
             {.text = "contact number whose last upward crossing is the transition rho_z; 4: discs without and spheres "
                      "with friction can just be stable",
              .min = 0,
              .max = 100,
              .above_min = true,
              .source = "theory sec. 4"});
    v.option("jamming_pressure", jamming_pressure,
             {.text = "pressure whose last upward crossing is the transition rho_pressure",
              .unit = "m/tau_c^2, in space m/(d tau_c^2)",
              .min = 0,
              .max = 1e9,
              .above_min = true,
              .source = "theory sec. 4"});
    v.option("rdf_bin", rdf_bin,
             {.text = "radial distribution: width of a bin",
              .unit = "L",
              .min = 1e-4,
              .max = 10,
              .source = "theory sec. 4"});
    v.option("rdf_range", rdf_range,
             {.text = "radial distribution: largest distance", .unit = "L", .min = 0, .max = 1000, .above_min = true});
    v.option("rdf_margin_ends", rdf_margin_ends,
             {.text = "radial distribution: bodies closer than this to lid and floor are no references; a sixth of the "
                      "height where this would leave less than a quarter of it",
              .unit = "L",
              .min = 0,
              .max = 1000,
              .source = "S3, Data analysis; theory sec. 4"});
    v.option("rdf_margin_sides", rdf_margin_sides,
             {.text = "radial distribution: the same from the walls at the sides",
              .unit = "L",
              .min = 0,
              .max = 1000,
              .source = "S3, Data analysis; theory sec. 4"});
    v.option("rdf_margin_cylinder", rdf_margin_cylinder,
             {.text = "radial distribution: the same from a cylinder",
              .unit = "L",
              .min = 0,
              .max = 1000,
              .source = "S3, Data analysis; theory sec. 4"});
  }
};

/// What no single option can say: throws a usage error, placed at the key, where the bins of forces are empty or start
/// at 0 on a logarithmic scale, or a grid of thresholds or distances has more than a million steps.
void check(const MeasureOptions& options);

}  // namespace jam
