// What S3 prints (Conzelmann et al., "The link between packing morphology and the distribution of contact forces and
// stresses in packings of highly non-convex particles"), for figures that show it beside our results. Sphericities are
// the paper's; at .995 they belong to another aspect ratio than printed (theory sec. 2.6).
#pragma once

#include <cmath>
#include <limits>

namespace jam::conzelmann {

/// Exponent of the tail of P(f) (text and Fig. 6a). The error is the spread the text gives; none where it gives none.
struct TailExponent {
  const char* domain;  ///< "2D", "slab and 3D"
  double sphericity, exponent, error;
};
inline constexpr TailExponent tail_exponents[] = {{"2D", 0.995, 1.42, 0},
                                                  {"2D", 0.473, 1.32, 0},
                                                  {"slab and 3D", 0.85, 1.38, 0.14},
                                                  {"slab and 3D", 0.419, 0.87, 0.13}};
/// The range of psi that 1.38 +- .14 stands for.
inline constexpr double plateau_from = 0.7, plateau_to = 1;

/// Fits of Fig. 6a. The printed linear one rises with 1 - psi, against figure and text: its sign is turned (theory
/// sec. 5). The other is called exponential there and is a power law.
inline double exponent_2d(double sphericity) { return 1.43 - 0.18 * (1 - sphericity); }
inline double exponent_slab(double sphericity) { return 1.29 - 2.03 * std::pow(1 - sphericity, 2.43); }
inline constexpr double fit_from_2d = 0.473, fit_from_slab = 0.419;

/// Peaks of the radial distribution function of crosses in two dimensions, in units of L (Table 2), and of stars in a
/// cylinder (text). Zero: none.
struct Peaks {
  int dimension;
  double sphericity;
  double peak[3];
};
inline constexpr Peaks peaks[] = {{2, 0.473, {0.55, 1.12, 1.66}}, {2, 0.518, {0.58, 1.14, 1.73}},
                                  {2, 0.585, {0.62, 1.25, 1.82}}, {2, 0.754, {0.76, 1.50, 2.23}},
                                  {2, 0.995, {1.00, 1.91, 0}},    {3, 0.702, {0.70, 1.37, 0}},
                                  {3, 0.995, {1.00, 1.90, 0}}};

/// Below it two flat parts of arms can touch: an arm stands out by exactly twice its radius.
inline constexpr double critical_crosses = 0.754, critical_stars = 0.702;

}  // namespace jam::conzelmann
