// What determines a simulation: every member is an option of the study file, declared here once.
// Nothing in these structs says how many realisations, frames' measures or figures are wanted.
#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/base/option.hpp"
#include "jamscape/contact/options.hpp"
#include "jamscape/dem/cluster_rules.hpp"
#include "jamscape/dem/scheme.hpp"
#include "jamscape/protocol/stage_options.hpp"

namespace jam {

enum class SizeLaw { monodisperse, uniform, bidisperse };
template <>
struct EnumNames<SizeLaw> {
  static constexpr std::pair<SizeLaw, std::string_view> values[] = {
      {SizeLaw::monodisperse, "monodisperse"}, {SizeLaw::uniform, "uniform"}, {SizeLaw::bidisperse, "bidisperse"}};
};

/// What a grain is: a disc or sphere, or a rigid cluster of spherocylinders (theory sec. 2.6).
enum class BodyShape { ball, sphere, rod, cross, star, custom };
template <>
struct EnumNames<BodyShape> {
  static constexpr std::pair<BodyShape, std::string_view> values[] = {
      {BodyShape::ball, "ball"},   {BodyShape::sphere, "sphere"}, {BodyShape::rod, "rod"},
      {BodyShape::cross, "cross"}, {BodyShape::star, "star"},     {BodyShape::custom, "custom"}};
};

struct GrainOptions {
  std::int64_t count = 2025;
  BodyShape shape = BodyShape::ball;
  double aspect = 3;
  std::vector<double> arms;
  double density = 1;
  SizeLaw sizes = SizeLaw::uniform;
  double width = 0.4;       // r_p
  double size_ratio = 1.4;  // bidisperse
  double small_fraction = 2.0 / 3.0;
  double inertia_factor = 0;

  template <class V>
  void describe(V& v) {
    v.option("count", count, {.text = "number of grains", .min = 1, .max = 5e7});
    v.option("shape", shape,
             {.text = "ball: discs or spheres in a box that shrinks; the others are rigid clusters of spherocylinders "
                      "in a container: sphere, rod, cross (2 arms at right angles), star (3), custom (`arms`)",
              .source = "S3 Methods"});
    v.option("aspect", aspect,
             {.text = "rod, cross, star: length over diameter of an arm, L/d", .min = 1, .max = 1000, .source = "S3"});
    v.option(
        "arms", arms,
        {.text = "custom: eight numbers an arm: its centre (3), direction (3), length tip to tip and diameter, in d"});
    v.option("density", density,
             {.text = "clusters: mass over the volume of the union",
              .unit = "m/d^3",
              .min = 0,
              .above_min = true,
              .source = "S3 Table 1"});
    v.option("sizes", sizes,
             {.text = "distribution of the diameters (clusters: size factors of the whole body), mean 1 d",
              .source = "S1 Sec. II.A"});
    v.option("width", width,
             {.text = "uniform sizes: full width r_p, diameters in (1 - r_p/2, 1 + r_p/2) d",
              .unit = "d",
              .min = 0,
              .max = 1.5,
              .source = "S1 App. A"});
    v.option("size_ratio", size_ratio, {.text = "bidisperse sizes: large over small diameter", .min = 1, .max = 10});
    v.option("small_fraction", small_fraction,
             {.text = "bidisperse sizes: fraction of grains that are small", .min = 0, .max = 1});
    v.option("inertia_factor", inertia_factor,
             {.text = "balls: moment of inertia over m R^2; 0: 1/2 for discs, 2/5 for spheres", .min = 0, .max = 1});
  }
};

/// beads, flat and periodic boxes shrink on all sides; box and cylinder are containers with a floor, fixed sides and a
/// lid.
enum class WallModel { beads, flat, periodic, box, cylinder };
/// A floor, fixed sides, and a lid that comes down; otherwise the box closes in on the grains from all sides.
constexpr bool has_lid(WallModel walls) { return walls == WallModel::box || walls == WallModel::cylinder; }
constexpr bool closes_from_all_sides(WallModel walls) { return !has_lid(walls); }
template <>
struct EnumNames<WallModel> {
  static constexpr std::pair<WallModel, std::string_view> values[] = {{WallModel::beads, "beads"},
                                                                      {WallModel::flat, "flat"},
                                                                      {WallModel::periodic, "periodic"},
                                                                      {WallModel::box, "box"},
                                                                      {WallModel::cylinder, "cylinder"}};
};

/// Where a box of bead walls ends (theory sec. 6a); L is the side between the lines of bead centres, d the bead
/// diameter: bead_centre L^2; inner_tangent (L - d)^2; half_beads L^2 - 4 L pi d / 8.
enum class BoxConvention { half_beads, bead_centre, inner_tangent };
template <>
struct EnumNames<BoxConvention> {
  static constexpr std::pair<BoxConvention, std::string_view> values[] = {
      {BoxConvention::half_beads, "half_beads"},
      {BoxConvention::bead_centre, "bead_centre"},
      {BoxConvention::inner_tangent, "inner_tangent"}};
};

/// Which grain area enters the packing fraction: that of N grains of mean diameter, or the true sum.
enum class AreaConvention { nominal, actual };
template <>
struct EnumNames<AreaConvention> {
  static constexpr std::pair<AreaConvention, std::string_view> values[] = {{AreaConvention::nominal, "nominal"},
                                                                           {AreaConvention::actual, "actual"}};
};

/// Whether a row of beads keeps its spacing while the box shrinks, its ends sticking out beyond the corners, or its
/// beads close up with the box; `framed` rows also end in the corners, with a bead of each there, so that a corner is
/// the same at all times and on all sides, and no grain is caught between two rows (theory sec. 1).
enum class BeadRows { rigid, closing, framed };
template <>
struct EnumNames<BeadRows> {
  static constexpr std::pair<BeadRows, std::string_view> values[] = {
      {BeadRows::rigid, "rigid"}, {BeadRows::closing, "closing"}, {BeadRows::framed, "framed"}};
};

struct DomainOptions {
  std::int64_t dimension = 2;
  WallModel walls = WallModel::beads;
  double bead_phase = 0;
  BeadRows bead_rows = BeadRows::rigid;
  BoxConvention box = BoxConvention::half_beads;
  AreaConvention area = AreaConvention::nominal;
  double width = 30;
  double thickness = 1;
  double gravity = 0;

  template <class V>
  void describe(V& v) {
    v.option("dimension", dimension, {.text = "number of space dimensions", .min = 2, .max = 3});
    v.option("walls", walls,
             {.text = "what confines the grains: rows of touching beads, flat walls, or a periodic box, which shrink; "
                      "or a container with fixed sides and a lid: box, or an upright cylinder",
              .source = "S1 App. A; S3 Methods"});
    v.option(
        "width", width,
        {.text = "container: width of the box or diameter of the cylinder, in lengths L of a body of size factor 1",
         .min = 1,
         .max = 1e6,
         .source = "S3 Methods"});
    v.option("thickness", thickness,
             {.text = "box in three dimensions: its thickness in lengths L; at least the largest body",
              .min = 1,
              .max = 1e6,
              .source = "S3 Methods"});
    v.option("gravity", gravity,
             {.text = "acceleration down the second axis", .unit = "d/tau_c^2", .min = 0, .max = 1e6});
    v.option("bead_phase", bead_phase,
             {.text = "shift of the rows of beads along themselves", .unit = "d", .min = 0, .max = 1});
    v.option(
        "bead_rows", bead_rows,
        {.text = "rows of beads keep their spacing, close up with the box, or close up as a frame with a bead in each "
                 "corner, where no grain is caught between two rows",
         .source = "theory 1"});
    v.option("box", box, {.text = "where a box of bead walls ends, for the packing fraction", .source = "theory 6a"});
    v.option("area", area,
             {.text = "grain area in the packing fraction: N pi d^2/4, or the true sum", .source = "theory 6a"});
  }
};

template <>
struct EnumNames<Scheme> {
  static constexpr std::pair<Scheme, std::string_view> values[] = {{Scheme::verlet, "verlet"},
                                                                   {Scheme::gear5, "gear5"}};
};

struct IntegratorOptions {
  Scheme scheme = Scheme::verlet;
  double step = 0.02;

  template <class V>
  void describe(V& v) {
    v.option("scheme", scheme,
             {.text = "velocity Verlet, or the 5-value Gear predictor-corrector", .source = "S1 App. A"});
    v.option("step", step, {.text = "time step", .unit = "tau_c", .min = 0, .max = 0.2, .above_min = true});
  }
};

/// A regular lattice, or places at random where no two bodies touch (clusters): denser, so that the fall is shorter.
enum class StartLayout { lattice, random };
template <>
struct EnumNames<StartLayout> {
  static constexpr std::pair<StartLayout, std::string_view> values[] = {{StartLayout::lattice, "lattice"},
                                                                        {StartLayout::random, "random"}};
};

struct StartOptions {
  StartLayout layout = StartLayout::lattice;
  double packing_fraction = 0.6;
  double gap = 0.01;
  double speed = 0.05;

  template <class V>
  void describe(V& v) {
    v.option("layout", layout,
             {.text = "container: bodies on a lattice of pitch L_max + gap, or at random places at packing_fraction",
              .source = "S3 Methods"});
    v.option("packing_fraction", packing_fraction,
             {.text = "packing fraction of the start; less where the largest grains of a lattice need more room",
              .min = 0,
              .max = 1,
              .above_min = true});
    v.option("gap", gap,
             {.text = "free distance between the largest neighbours on the start lattice",
              .unit = "d",
              .min = 0,
              .max = 10});
    v.option("speed", speed,
             {.text = "velocity components are uniform in (-speed, speed)", .unit = "d/tau_c", .min = 0, .max = 10});
  }
};

/// How arms of clusters touch where the geometry leaves a choice (theory sec. 3).
struct ClusterOptions {
  ParallelRule parallel = ParallelRule::middle;
  double parallel_angle = 2;
  DuplicateRule duplicates = DuplicateRule::literal;

  template <class V>
  void describe(V& v) {
    v.option("parallel", parallel,
             {.text = "contact point of nearly parallel arms: the middle of their overlap, or a continuous blend",
              .source = "S3 Fig. 2; theory 3"});
    v.option("parallel_angle", parallel_angle,
             {.text = "arms at a smaller angle, in degrees, count as parallel", .min = 0, .max = 45, .source = "S3"});
    v.option("duplicates", duplicates,
             {.text = "contacts of two bodies closer than an arm's radius: all of them, or the deepest of each group",
              .source = "theory 3"});
  }
};

/// All that determines one simulation, given the seed, the system's name and the realisation.
struct SystemOptions {
  GrainOptions grains;
  DomainOptions domain;
  ContactOptions contact;
  IntegratorOptions integrator;
  StartOptions start;
  ClusterOptions clusters;
  std::vector<StageOptions> stages;  // [[stage]] tables; parsed apart from the groups

  template <class V>
  void describe(V& v) {
    v.group("grains", grains);
    v.group("domain", domain);
    v.group("contact", contact);
    v.group("integrator", integrator);
    v.group("start", start);
    v.group("clusters", clusters);
  }
};

/// What moves the grains: the shape of the grains decides, not the walls around them.
enum class EngineKind { discs, spheres, clusters };
inline EngineKind engine_of(const SystemOptions& system) {
  if (system.grains.shape != BodyShape::ball) return EngineKind::clusters;
  return system.domain.dimension == 2 ? EngineKind::discs : EngineKind::spheres;
}

/// Frames are asked for at packing fractions. Otherwise they are taken where stages end, and the packing fraction is
/// what comes out.
inline bool plans_packing_fraction(const SystemOptions& system) { return closes_from_all_sides(system.domain.walls); }

/// I/(m R^2) of the balls of this system.
inline double inertia_factor(const SystemOptions& system) {
  if (system.grains.inertia_factor > 0) return system.grains.inertia_factor;
  return system.domain.dimension == 2 ? 0.5 : 0.4;
}

/// The name of stage `index` in keys and tables: its own, or its kind and number.
inline std::string stage_name(const SystemOptions& system, std::size_t index) {
  const StageOptions& stage = system.stages[index];
  if (!stage.name.empty()) return stage.name;
  return std::string(stage_info(stage.kind).name) + "-" + std::to_string(index + 1);
}

}  // namespace jam
