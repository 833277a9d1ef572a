#include "jamscape/stats/force_tail.hpp"

#include <cmath>
#include <vector>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/stats/least_squares.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

constexpr double kFirstBins = 0.3;  // mean forces; a maximum up to here is the end of a curve that falls from 0
constexpr double kBendFrom = 0.2, kBendTo = 2;  // around the mean, away from the tail and from f = 0
constexpr double kErrorsToStandOut = 2;         // the highest of many equal bins is some 2 errors above the lowest

void check(std::span<const double> centre, std::span<const double> count, std::span<const double> norm) {
  if (centre.size() != count.size() || centre.size() != norm.size())
    throw data_error("a histogram needs as many counts and norms as bin centres");
}

double ratio(double count, double norm) { return norm > 0 ? count / norm : 0; }

}  // namespace

ForcePeak force_peak(std::span<const double> centre, std::span<const double> count, std::span<const double> norm) {
  check(centre, count, norm);
  const auto p = [&](std::size_t k) { return ratio(count[k], norm[k]); };
  std::size_t first = 0;
  while (first < centre.size() && !exceeds(centre[first], kFirstBins)) ++first;
  std::size_t peak = first;
  for (std::size_t k = first; k < centre.size(); ++k)
    if (exceeds(p(k), p(peak))) peak = k;  // the first of equals: widths of equal bins differ in their last digit
  if (first == 0 || peak >= centre.size() || !(count[peak] > 0)) return {none, none, none, false};
  std::size_t valley = 0;
  for (std::size_t k = 0; k < peak; ++k)
    if (exceeds(p(valley), p(k))) valley = k;
  ForcePeak result{centre[peak], p(peak) - p(valley), 0, false};
  for (const std::size_t k : {peak, valley})
    result.error = std::hypot(result.error, ratio(std::sqrt(count[k]), norm[k]));
  result.stands_out = result.prominence > kErrorsToStandOut * result.error;
  return result;
}

Estimate force_bend(std::span<const double> centre, std::span<const double> count, std::span<const double> norm) {
  check(centre, count, norm);
  // Normal equations of the parabola; ln P has the variance 1/count.
  double moments[5] = {}, right[3] = {};
  std::size_t bins = 0;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    if (!exceeds(centre[k], kBendFrom) || reaches(centre[k], kBendTo) || !(count[k] > 0)) continue;
    const double y = std::log(ratio(count[k], norm[k]));
    double power = count[k];
    for (std::size_t n = 0; n < 5; ++n, power *= centre[k]) {
      moments[n] += power;
      if (n < 3) right[n] += power * y;
    }
    ++bins;
  }
  if (bins < 4) return {none, none, bins};
  const double* m = moments;
  const std::vector<double> matrix{m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4]};
  const std::vector<double> parabola = solve_linear(matrix, {right, right + 3}), unit = solve_linear(matrix, {0, 0, 1});
  if (parabola.empty() || unit.empty()) return {none, none, bins};
  return {parabola[2], std::sqrt(unit[2]), bins};
}

ForceTail force_tail(std::span<const double> centre, std::span<const double> count, std::span<const double> norm) {
  check(centre, count, norm);
  std::vector<double> density(centre.size());
  for (std::size_t k = 0; k < centre.size(); ++k) density[k] = ratio(count[k], norm[k]);
  return {tail_exponent(centre, count, norm), tail_exponent_loglinear(centre, count, norm),
          fit_mueth(centre, density),         fit_gaussian(centre, density),
          force_peak(centre, count, norm),    force_bend(centre, count, norm)};
}

}  // namespace jam
