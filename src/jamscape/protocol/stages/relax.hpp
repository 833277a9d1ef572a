// relax: the walls stand still until the grains have come to rest; one frame at the end.
#pragma once

#include "jamscape/protocol/stages/stage.hpp"

namespace jam {

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

/// How many steps a relaxation may take, for the timetable.
std::int64_t guess_relaxation(const RelaxOptions& options);

struct Relax {
  static constexpr StageTraits traits = {.text = "stops the walls until the grains rest", .relaxes = true};

  struct Options {
    RelaxOptions relax{};

    template <class V>
    void describe(V& v) {
      relax.describe(v);
    }
  };

  static void write(const StageOptions& stage, BoxTimetable& table);
  static void write(const StageOptions& stage, ContainerTimetable& table);
};

}  // namespace jam
