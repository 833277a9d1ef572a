// The mean of many numbers, and numbers in units of their mean: the one way in which forces are divided by <F>.
//
// The sum keeps what each addition rounds away (Knuth's two-sum, eight sums side by side), so the mean is right to its
// last digits however many numbers there are, and n equal numbers have just that number as their mean. The order of
// sums is fixed: equal input gives equal bits.
#pragma once

#include <span>
#include <vector>

namespace jam {

/// 0 without numbers.
double mean_of(std::span<const double> values);

/// value/mean, one division; as it is where the mean is not above 0.
inline double over_mean(double value, double mean) { return mean > 0 ? value / mean : value; }
void divide_by_mean(std::span<double> values, double mean);
std::vector<double> over_mean(std::vector<double> values);

}  // namespace jam
