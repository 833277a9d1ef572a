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
#include "jamscape/dem/scheme.hpp"

namespace jam {

enum class SizeLaw { monodisperse, uniform, bidisperse };
template <>
struct EnumNames<SizeLaw> {
  static constexpr std::pair<SizeLaw, std::string_view> values[] = {
      {SizeLaw::monodisperse, "monodisperse"}, {SizeLaw::uniform, "uniform"}, {SizeLaw::bidisperse, "bidisperse"}};
};

struct GrainOptions {
  std::int64_t count = 2025;
  SizeLaw sizes = SizeLaw::uniform;
  double width = 0.4;       // r_p
  double size_ratio = 1.4;  // bidisperse
  double small_fraction = 2.0 / 3.0;
  double inertia_factor = 0.5;  // I = factor m R^2

  template <class V>
  void describe(V& v) {
    v.option("count", count, {.text = "number of grains", .min = 1, .max = 1e8});
    v.option("sizes", sizes, {.text = "distribution of the diameters, mean 1 d", .source = "S1 Sec. II.A"});
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
             {.text = "moment of inertia over m R^2: 1/2 for a disc, 2/5 for a sphere", .min = 0.01, .max = 1});
  }
};

enum class WallModel { beads, flat, periodic };
template <>
struct EnumNames<WallModel> {
  static constexpr std::pair<WallModel, std::string_view> values[] = {
      {WallModel::beads, "beads"}, {WallModel::flat, "flat"}, {WallModel::periodic, "periodic"}};
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
/// beads close up with the box.
enum class BeadRows { rigid, closing };
template <>
struct EnumNames<BeadRows> {
  static constexpr std::pair<BeadRows, std::string_view> values[] = {{BeadRows::rigid, "rigid"},
                                                                     {BeadRows::closing, "closing"}};
};

struct DomainOptions {
  std::int64_t dimension = 2;
  WallModel walls = WallModel::beads;
  double bead_phase = 0;
  BeadRows bead_rows = BeadRows::rigid;
  BoxConvention box = BoxConvention::half_beads;
  AreaConvention area = AreaConvention::nominal;

  template <class V>
  void describe(V& v) {
    v.option("dimension", dimension, {.text = "number of space dimensions", .min = 2, .max = 3});
    v.option("walls", walls,
             {.text = "what confines the grains: rows of touching beads, flat walls, or a periodic box"});
    v.option("bead_phase", bead_phase,
             {.text = "shift of the rows of beads along themselves", .unit = "d", .min = 0, .max = 1});
    v.option("bead_rows", bead_rows, {.text = "rows of beads keep their spacing, or close up with the box"});
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

struct StartOptions {
  double packing_fraction = 0.6;
  double gap = 0.01;
  double speed = 0.05;

  template <class V>
  void describe(V& v) {
    v.option("packing_fraction", packing_fraction,
             {.text = "packing fraction of the start lattice; less where the largest grains need more room",
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

enum class StageKind {
  compress,  ///< all walls move inward at constant speed
  relax,     ///< the walls stand still until the grains have come to rest; one frame at the end
  steps      ///< compress by `increment`, relax, and so on; one frame after each relaxation
};
template <>
struct EnumNames<StageKind> {
  static constexpr std::pair<StageKind, std::string_view> values[] = {
      {StageKind::compress, "compress"}, {StageKind::relax, "relax"}, {StageKind::steps, "steps"}};
};

/// When a relaxation ends: the first of three (theory sec. 1, note g).
struct RelaxOptions {
  std::int64_t window = 150000;
  double fluctuation = 0.1;
  double energy = 1e-10;
  double windows = 10;

  template <class V>
  void describe(V& v) {
    v.option("relax_window", window,
             {.text = "relax: time steps over which the kinetic energy is looked at",
              .min = 100,
              .max = 1e9,
              .source = "S2 Sec. 3"});
    v.option("relax_fluctuation", fluctuation,
             {.text = "relax: ends where the kinetic energy's standard deviation over a window is at most this part of "
                      "its mean",
              .min = 0,
              .max = 1,
              .source = "S2 Sec. 3"});
    v.option("relax_energy", energy,
             {.text = "relax: ends where the kinetic energy is below this part of the elastic energy (of its value at "
                      "the start, where nothing touches)",
              .min = 0,
              .max = 1,
              .source = "theory 1, note g"});
    v.option("relax_windows", windows,
             {.text = "relax: ends after so many windows at the latest; such a frame is marked as not relaxed",
              .min = 0,
              .max = 1e6,
              .above_min = true,
              .source = "theory 1, note g"});
  }
};

/// One stage of the protocol ([[stage]] in the study file), done in order.
struct StageOptions {
  std::string name;
  StageKind kind = StageKind::compress;
  double to = 0.9;
  double speed = 2.5e-5;
  std::int64_t frames = 0;
  std::vector<double> frames_at;
  double increment = 0.02;
  std::int64_t frames_inside = 0;
  RelaxOptions relax{};

  template <class V>
  void describe(V& v) {
    v.option("name", name, {.text = "name of the stage in the tables; its kind and number when empty"});
    v.option("kind", kind,
             {.text = "what is done: compress moves all walls inward at constant speed; relax stops them until the "
                      "grains rest; steps does both in turn, by an increment of packing fraction each"});
    v.option("to", to, {.text = "packing fraction at which the stage ends", .min = 0, .max = 2, .above_min = true});
    v.option("speed", speed,
             {.text = "speed of each wall",
              .unit = "d/tau_c",
              .min = 0,
              .max = 1,
              .above_min = true,
              .source = "S1 App. A"});
    v.option("frames", frames,
             {.text = "number of frames, evenly spaced in packing fraction, both ends included", .min = 0, .max = 1e6});
    v.option("frames_at", frames_at, {.text = "packing fractions of further frames", .min = 0, .max = 2});
    v.option("increment", increment,
             {.text = "steps: packing fraction from one relaxation to the next, on a grid that ends at `to`",
              .min = 1e-6,
              .max = 1,
              .source = "S2 Sec. 3"});
    v.option(
        "frames_inside", frames_inside,
        {.text = "steps: frames inside each increment, the last one just before its relaxation", .min = 0, .max = 1e6});
    relax.describe(v);
  }
};

/// All that determines one simulation, given the seed, the system's name and the realisation.
struct SystemOptions {
  GrainOptions grains;
  DomainOptions domain;
  ContactOptions contact;
  IntegratorOptions integrator;
  StartOptions start;
  std::vector<StageOptions> stages;  // [[stage]] tables; parsed apart from the groups

  template <class V>
  void describe(V& v) {
    v.group("grains", grains);
    v.group("domain", domain);
    v.group("contact", contact);
    v.group("integrator", integrator);
    v.group("start", start);
  }
};

/// The name of stage `index` in keys and tables: its own, or its kind and number.
inline std::string stage_name(const SystemOptions& system, std::size_t index) {
  const StageOptions& stage = system.stages[index];
  if (!stage.name.empty()) return stage.name;
  std::string kind = "stage";
  for (const auto& [value, name] : EnumNames<StageKind>::values)
    if (value == stage.kind) kind = name;
  return kind + "-" + std::to_string(index + 1);
}

}  // namespace jam
