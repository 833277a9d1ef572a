// How fast the tail of a distribution falls: the exponent k of P(f) ~ exp(-k f) beyond a value, f in units of the mean.
//
//   free prefactor       P = A exp(-k f) by unweighted least squares on the bins with centre > from
//   log-linear           a line through ln P on those of these bins that are not empty
//   maximum likelihood   k = 1/(<f> - from) over the n values above `from`; standard error k/sqrt(n)
//
// Errors are those of counting: the contacts are independent, P = count/norm has the variance count/norm^2 and ln P that
// of 1/count, carried through each estimator. The law's misfit is not in them, and their mean is taken as known: forces
// divided by their own mean scatter less (10^4 of Mueth's law: .024 where .032 is stated, by maximum likelihood .015 and .021).
//
// "Above `from`" is above it by more than rounding (base/border.hpp), of values and of bin centres alike: forces that
// are equal up to round-off have none above their mean.
//
// On a law that is no pure exponential they differ: on Mueth's (force_laws.hpp) with bins of .2 up to 10 and 10^4
// values they give 1.248, 1.31 and 1.356. The first is what S3's values and confidence bounds agree with. Its fit is to
// densities, so the first bins decide; the second hangs on the last bins, where a bin holds one value or none. S3
// prints exp(-k f) without a prefactor; that would give .886 on the same law. Source: S3 Eq. 2; theory sec. 4.
#pragma once

#include <cstddef>
#include <span>

#include "jamscape/stats/resampling.hpp"

namespace jam {

/// P = count/norm, norm = values counted times width of the bin; n = bins used; NaN with fewer than three bins, or
/// fewer than two that hold something. The spans have the same length, else a data error.
Estimate tail_exponent(std::span<const double> centre, std::span<const double> count, std::span<const double> norm,
                       double from = 1);

/// The same for the line through ln P; n = bins that are not empty, at least three.
Estimate tail_exponent_loglinear(std::span<const double> centre, std::span<const double> count,
                                 std::span<const double> norm, double from = 1);

/// From n values above `from` and the sum of their excess f - from; NaN for n = 0, no error for n < 2.
Estimate tail_exponent_likelihood(std::size_t n, double excess);

/// From a sample, of which the values above `from` count.
Estimate tail_exponent_likelihood(std::span<const double> sample, double from = 1);

}  // namespace jam
