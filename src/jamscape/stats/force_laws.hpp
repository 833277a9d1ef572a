// Two laws for the distribution of contact forces, f in units of the mean, and their least-squares fits to all bins.
//
//   Mueth      P(f) = a (1 - b exp(-f^2)) exp(-beta f)     literature: a = 3, b = .75, beta = 1.5 (norm .989, mean
//   .977) Gaussian   P(f) = h exp(-(f - c)^2/(2 w^2))            for f >= 0, so h is no norm; what "type A" is likened
//   to
//
// Source: Mueth, Jaeger, Nagel, Phys. Rev. E 57, 3164 (1998); S3 Eq. 1 and Fig. 1; theory sec. 4.
#pragma once

#include <span>

namespace jam {

struct MuethLaw {
  double a = 3, b = 0.75, beta = 1.5;
};

double density(const MuethLaw& law, double f);

struct GaussianLaw {
  double height = 0, centre = 0, width = 0;
};

double density(const GaussianLaw& law, double f);

/// Unweighted; all members NaN where there are too few bins or no fit. Mueth's by separable_fit for beta from .02 to
/// 50; the Gaussian from several starts, the lowest residual taken. A distribution that falls
/// from its first bin on has no Gaussian: its centre runs away below 0 and is NaN then, or far below 0.
MuethLaw fit_mueth(std::span<const double> centre, std::span<const double> density);
GaussianLaw fit_gaussian(std::span<const double> centre, std::span<const double> density);

}  // namespace jam
