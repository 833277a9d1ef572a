// What S3 prints, for the figures of final states.
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/conzelmann.hpp"
#include "jamscape/stats/force_laws.hpp"

namespace jam {
namespace {

namespace paper = conzelmann;

/// A law at even steps.
template <class Law>
Json curve(double from, double to, int steps, Law law) {
  std::vector<double> x, y;
  for (int k = 0; k <= steps; ++k) {
    x.push_back(from + (to - from) * k / steps);
    y.push_back(law(x.back()));
  }
  return {{"x", rounded(x)}, {"y", rounded(y, 4)}};
}

}  // namespace

Json conzelmann_block() {
  Json exponents = Json::array();
  for (const auto& point : paper::tail_exponents)
    exponents.push_back({{"domain", point.domain},
                         {"sphericity", rounded(point.sphericity)},
                         {"exponent", rounded(point.exponent)},
                         {"error", point.error > 0 ? rounded(point.error) : Json()}});
  Json peaks = Json::array();
  for (const auto& row : paper::peaks) {
    Json at = Json::array();
    for (const double peak : row.peak) at.push_back(peak > 0 ? rounded(peak) : Json());
    peaks.push_back({{"dimension", row.dimension}, {"sphericity", rounded(row.sphericity)}, {"peaks", std::move(at)}});
  }
  Json plane = curve(paper::fit_from_2d, 1, 2, paper::exponent_2d);
  Json slab = curve(paper::fit_from_slab, 1, 60, paper::exponent_slab);
  return {{"mueth", curve(0, 10, 100, [](double f) { return density(MuethLaw{}, f); })},
          {"exponents", std::move(exponents)},
          {"exponent_2d", std::move(plane)},
          {"exponent_slab", std::move(slab)},
          {"plateau", {rounded(paper::plateau_from), rounded(paper::plateau_to)}},
          {"critical", {{"crosses", paper::critical_crosses}, {"stars", paper::critical_stars}}},
          {"peaks", std::move(peaks)}};
}

}  // namespace jam
