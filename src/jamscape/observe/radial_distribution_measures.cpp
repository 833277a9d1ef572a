#include <cmath>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/radial_distribution.hpp"
#include "jamscape/stats/none.hpp"
#include "jamscape/stats/shell_peaks.hpp"

namespace jam {
namespace {

constexpr std::size_t kResamples = 100;  // an error to a tenth of itself

std::vector<std::vector<double>> rows(const Snapshot& s) {
  RadialDistribution rdf = radial_distribution(s.packing(), s.options());
  const std::vector<double> pairs = rdf.sum(rdf.pairs), ideal = rdf.sum(rdf.ideal);
  std::vector<double> g, references(rdf.distance.size(), 0.0);
  for (std::size_t b = 0; b < pairs.size(); ++b) g.push_back(ideal[b] > 0 ? pairs[b] / ideal[b] : none);
  for (const std::vector<double>& reference : rdf.ideal)
    for (std::size_t b = 0; b < references.size(); ++b) references[b] += reference[b] > 0;
  return {std::move(rdf.distance), std::move(g), pairs, ideal, references};
}

std::vector<double> peaks(const Snapshot& s) {
  const Packing& p = s.packing();
  const RadialDistribution rdf = radial_distribution(p, s.options());
  Random random(static_cast<std::uint64_t>(p.step), "radial distribution", 0, "bootstrap");
  std::vector<double> row;
  for (const Estimate& peak : shell_peaks(rdf.distance, rdf.pairs, rdf.ideal, kResamples, random))
    row.insert(row.end(), {peak.value, peak.error});
  Distances expected{none, none, none, none};
  if (p.shapes.size() == 1) expected = contact_distances(p.shapes.front());
  row.insert(row.end(), {expected.d1, expected.d2, expected.d3, expected.j1, static_cast<double>(rdf.pairs.size()),
                         rdf.margin_ends, rdf.margin_sides, rdf.length});
  return row;
}

}  // namespace

Measure radial_distribution_measure() {
  Measure m = rows_measure(
      {"radial_distribution", "radial distribution of the grains' centres",
       "G(r) = pairs/ideal, r in L: the grains in the shell r_1 <= r < r_2 about all references, and those an ideal "
       "gas "
       "of density rho_N = N/V has there, N_ref rho_N times pi (r_2^2 - r_1^2) (2D), 4 pi (r_2^3 - r_1^3)/3 (3D); V as "
       "for stress. L: mean over the grains of the length of their shape at size factor 1, mean diameter of discs and "
       "spheres. References are away from the walls by rdf_margin_ends (along the axis of the lid), rdf_margin_sides, "
       "rdf_margin_cylinder, each times L, or, where twice that is more than three "
       "quarters of the width, by a sixth of the width if that is less (columns of rdf_peaks say what was used), and "
       "count at r only while r_2 <= their distance to every wall less the radius of a bead and the mean radius (of "
       "the thinnest arm), and <= half of every periodic length. In three dimensions the sides of a slab narrower "
       "than twice the range have no margin, and the ideal gas has the part of the shell between them. "
       "round(rdf_range/rdf_bin) bins. S3 prints 4 r^2 Delta r and N in place of N_ref.",
       "S3 Eqs. 9, 10, Fig. 7; theory sec. 4, 5"},
      {{"distance", "L", "centre of the bin"},
       {"g", "", "G(r); missing without references"},
       {"pairs", "", "grains in the shells, a pair of two references twice"},
       {"ideal", "", "the same in an ideal gas"},
       {"references", "", "references whose shell is inside the walls"}},
      1, true, rows);
  m.ratios = {{"g_pooled", "pairs", "ideal", "G(r) of all realisations together"}};
  return m;
}

Measure rdf_peaks_measure() {
  const char* d = "; missing for shapes other than one kind of cross or star";
  return seldom_measure(
      {"rdf_peaks", "peaks of the radial distribution",
       "Maxima of G(r) (measure radial_distribution) smoothed over 3 bins: the highest at r_1, the highest within 1.5 "
       "to "
       "2.5 r_1, and within 2.5 to 3.5 r_1; placed by a parabola. Missing where G does not fall on both sides within "
       "r_1/2 by .05 and by 4 errors of its counts. Errors by bootstrap over the references, which ignores that "
       "neighbours share their pairs. Beside them the distances of S3's closest configurations: D_1 = sqrt(d^2 + ((L + "
       "d)/2)^2), D_2 = 2 D_1, D_3 = 3 D_1, J_1 = sqrt(3) d.",
       "S3 Eqs. 11, 12, Table 2; theory sec. 4, 6"},
      {{"rdf_peak1", "L", "position of the first peak"},
       {"rdf_peak1_error", "L", "its standard error"},
       {"rdf_peak2", "L", "position of the second peak"},
       {"rdf_peak2_error", "L", "its standard error"},
       {"rdf_peak3", "L", "position of the third peak"},
       {"rdf_peak3_error", "L", "its standard error"},
       {"rdf_d1", "L", std::string("D_1") + d},
       {"rdf_d2", "L", std::string("D_2") + d},
       {"rdf_d3", "L", std::string("D_3") + d},
       {"rdf_j1", "L", std::string("J_1, of nested stars") + d},
       {"rdf_references", "", "reference grains"},
       {"rdf_margin_ends", "L", "margin used at lid and floor; 0 without walls"},
       {"rdf_margin_sides", "L", "margin used at the sides, the least of several; 0 without walls and in thin slabs"},
       {"rdf_length", "d", "L"}},
      peaks);
}

}  // namespace jam
