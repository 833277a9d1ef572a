// What a protocol does, stage after stage ([[stage]] in the study file).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/base/option.hpp"

namespace jam {

enum class StageKind {
  compress,  ///< all walls move inward at constant speed
  relax,     ///< the walls stand still until the grains have come to rest; one frame at the end
  steps,     ///< compress by `increment`, relax, and so on; one frame after each relaxation
  settle,    ///< grains fall and come to rest on the floor of a container; one frame at the end
  press      ///< the lid of a container comes down until it carries `force`; one frame at that instant
};
template <>
struct EnumNames<StageKind> {
  static constexpr std::pair<StageKind, std::string_view> values[] = {{StageKind::compress, "compress"},
                                                                      {StageKind::relax, "relax"},
                                                                      {StageKind::steps, "steps"},
                                                                      {StageKind::settle, "settle"},
                                                                      {StageKind::press, "press"}};
};

/// When a relaxation ends: the first of three (theory sec. 1, note g).
struct RelaxOptions {
  std::int64_t window = 150000;
  double fluctuation = 0.1;
  double energy = 1e-10;
  double windows = 10;
  double energy_average = 0;
  double unbalanced = -1;

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
    v.option(
        "relax_energy_average", energy_average,
        {.text = "relax: part of a window over which the kinetic energy is averaged for relax_energy; 0: one sample, "
                 "which a packing that swings as a whole passes at every turning point",
         .min = 0,
         .max = 1});
    v.option(
        "relax_unbalanced", unbalanced,
        {.text = "relax: rest by the kinetic energy counts only where the mean net force on a grain is at most this "
                 "part of the mean contact force; 0: not looked at (S2's rule); -1: .01 in a periodic box, 0 "
                 "elsewhere",
         .min = -1,
         .max = 1e6,
         .source = "theory 1, note g"});
    v.option("relax_windows", windows,
             {.text = "relax: ends after so many windows at the latest; such a frame is marked as not relaxed",
              .min = 0,
              .max = 1e6,
              .above_min = true,
              .source = "theory 1, note g"});
  }
};

/// When grains that fall have settled: after a time given by the height h they start from, or when they rest.
enum class SettleUntil { time, rest };
template <>
struct EnumNames<SettleUntil> {
  static constexpr std::pair<SettleUntil, std::string_view> values[] = {{SettleUntil::time, "time"},
                                                                        {SettleUntil::rest, "rest"}};
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
  SettleUntil settle_until = SettleUntil::time;
  double settle_times = 3;
  double force = 0;

  template <class V>
  void describe(V& v) {
    v.option("name", name, {.text = "name of the stage in the tables; its kind and number when empty"});
    v.option("kind", kind,
             {.text = "what is done: compress moves all walls inward at constant speed; relax stops them until the "
                      "grains rest; steps does both in turn, by an increment of packing fraction each; in a container, "
                      "settle lets the grains fall and press brings the lid down until it carries `force`"});
    v.option("to", to, {.text = "packing fraction at which the stage ends", .min = 0, .max = 2, .above_min = true});
    v.option("speed", speed,
             {.text = "speed of each wall, or of the lid",
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
    v.option(
        "settle_until", settle_until,
        {.text = "settle: ends after settle_times sqrt(2 h/g), h being the height of the start, or when the grains "
                 "rest (relax_energy; after that time at the latest)",
         .source = "S3 Methods"});
    v.option("settle_times", settle_times,
             {.text = "settle: longest duration over the time sqrt(2 h/g) of the deepest fall",
              .min = 0.1,
              .max = 1000,
              .source = "S3 Methods"});
    v.option("force", force,
             {.text = "press: what the lid carries in the end",
              .unit = "m d/tau_c^2",
              .min = 0,
              .max = 1e12,
              .source = "S3 Methods"});
  }
};

}  // namespace jam
