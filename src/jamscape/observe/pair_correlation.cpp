#include "jamscape/observe/pair_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/border.hpp"
#include "jamscape/base/mean.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/point_grid.hpp"
#include "jamscape/observe/wall_margin.hpp"

namespace jam {
PairCorrelation pair_correlation(const Packing& p, const MeasureOptions& options) {
  const auto bins = static_cast<std::size_t>(std::max(1.0, std::round(options.pair_range / options.pair_bin)));
  PairCorrelation result;
  for (std::size_t b = 0; b < bins; ++b) result.distance.push_back((static_cast<double>(b) + 0.5) * options.pair_bin);
  result.g.assign(bins, std::numeric_limits<double>::quiet_NaN());
  result.references.assign(bins, 0);
  if (p.grains.size() == 0) return result;

  const double diameter = 2 * mean_of(p.grains.radius), width = options.pair_bin * diameter;
  const Room around = room_with_margin(p, options.pair_margin * diameter, diameter / 2);
  const std::vector<Vec3> position = around.wrapped(p.grains.position);
  std::vector<std::uint32_t> grains_with(bins + 1, 0);  // reference grains whose first so many bins count
  std::vector<std::uint32_t> bins_of(p.grains.size(), 0);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < p.grains.size(); ++i) {
    const Room::Place r = around.place(position[i]);
    if (!r.inside) continue;
    ++inside;
    const double whole = std::min(borders_reached(r.reach / width), static_cast<double>(bins));
    bins_of[i] = static_cast<std::uint32_t>(whole);
    ++grains_with[bins_of[i]];
  }
  std::uint32_t farther = 0;
  for (std::size_t b = bins; b-- > 0;) result.references[b] = farther += grains_with[b + 1];
  const auto most = *std::max_element(bins_of.begin(), bins_of.end());
  if (most == 0) return result;

  const double range = static_cast<double>(most) * width, per_width = 1 / width;
  const PointGrid grid(around.with_copies(position, range), std::max(diameter, range / 6));
  std::vector<std::uint32_t> count(bins, 0);
  for (std::size_t i = 0; i < p.grains.size(); ++i) {
    if (bins_of[i] == 0) continue;
    const std::uint32_t last = bins_of[i] - 1;
    grid.each_within(position[i], on_from(static_cast<double>(bins_of[i]) * width), [&](double r2) {
      ++count[std::min(static_cast<std::uint32_t>(borders_reached(std::sqrt(r2) * per_width)), last)];
    });
    --count[0];  // itself
  }

  const double density = static_cast<double>(inside) / around.volume_inside();
  for (std::size_t b = 0; b < bins; ++b) {
    if (result.references[b] == 0) continue;
    const double inner = static_cast<double>(b) * width;
    result.g[b] = count[b] / (result.references[b] * density * shell_volume(p.dimension, inner, inner + width));
  }
  return result;
}

Measure pair_correlation_measure() {
  return rows_measure(
      {"pair_correlation", "pair correlation",
       "g(d) = n(d)/(N_ref rho s), d in mean diameters (of clusters the circumscribed spheres), s the shell d_1 <= d < "
       "d_2: pi (d_2^2 - d_1^2) (2D), 4 pi (d_2^3 - d_1^3)/3 (3D); n(d) the grains in the shells about N_ref reference "
       "grains, whose centres are at least a margin from every wall (pair_margin, at most a sixth of the width), rho "
       "= (those grains)/(area or volume beyond the margins): 1 for an ideal gas. A grain is a reference at d only "
       "while d_2 <= its distance to every wall less the radius of a bead and half a mean diameter, and d_2 <= half of "
       "every periodic length; bins without reference grains are NaN. round(pair_range/pair_bin) bins. Walls are the "
       "sides of the box that are not periodic (of bead walls the lines of centres) and a cylinder.",
       "S1 Sec. III.B, Fig. 7 (there in arbitrary units); theory sec. 4"},
      {{"distance", "d", "centre of the bin, in mean diameters"}, {"g", "", "pair correlation"}}, 1, true,
      [](const Snapshot& s) -> std::vector<std::vector<double>> {
        PairCorrelation g = pair_correlation(s.packing(), s.options());
        return {std::move(g.distance), std::move(g.g)};
      });
}

}  // namespace jam
