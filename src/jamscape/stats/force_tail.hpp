// What S3 says of a distribution of forces (or stresses) in units of their mean, from its histogram: the exponent of
// its tail, the laws it follows, and whether it has a peak.
//
//   prominence = P(peak) - P(valley): the peak is the highest bin beyond f = .3, the valley the lowest bin before it, of
//                equal ones (to 1e-12) the first
//   error^2    = counting errors of the two bins, P^2/count, added
//   type A     prominence > 2 errors: there is a peak ("Gaussian-like"); else type B, which falls from f = 0 on
//
//   bend        c of ln P = a + b f + c f^2 on the bins .2 < f < 2, weighted with their counts: below 0 where P(f) has
//   a
//               peak or a shoulder near its mean, 0 for an exponential, above 0 for a curve that is steepest at f = 0
//
// A curve that rises towards f = 0 and has a peak beyond a dip is of type A. Mueth's law with its literature values has
// a shoulder and no peak: type B by this rule. Histograms of several realisations are pooled by adding counts and norms
// (curves.hpp, ratio_of_sums); the fits then see one curve. Source: S3 Fig. 1, 5, 6; theory sec. 4.
#pragma once

#include <span>

#include "jamscape/stats/exponential_tail.hpp"
#include "jamscape/stats/force_laws.hpp"

namespace jam {

struct ForcePeak {
  double position = 0;    ///< centre of the bin
  double prominence = 0;  ///< below 0 where the curve falls all the way
  double error = 0;       ///< of the prominence
  bool stands_out = false;
};

struct ForceTail {
  Estimate exponent;   ///< free prefactor
  Estimate loglinear;  ///< line through ln P
  MuethLaw mueth;
  GaussianLaw gaussian;
  ForcePeak peak;
  Estimate bend;

  bool type_a() const { return peak.stands_out; }
};

/// From the weights alone: counts are taken as Poissonian. NaN with fewer than four bins that hold something.
Estimate force_bend(std::span<const double> centre, std::span<const double> count, std::span<const double> norm);

/// P = count/norm with norm = values counted times width of the bin. NaN without bins beyond .3 or without counts.
ForcePeak force_peak(std::span<const double> centre, std::span<const double> count, std::span<const double> norm);

/// All of it from a histogram in units of the mean; the tail begins at 1. Spans of different lengths are a data error.
ForceTail force_tail(std::span<const double> centre, std::span<const double> count, std::span<const double> norm);

}  // namespace jam
