// Samples of laws with known tails.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/stats/force_laws.hpp"
#include "jamscape/stats/histogram.hpp"

namespace jam::test {

inline double exponential(Random& random, double k = 1) { return -std::log(1 - random.uniform()) / k; }

/// Values of Mueth's law over their mean, as a measured distribution has them; by rejection from the exponential above
/// it.
inline std::vector<double> mueth_sample(std::size_t n, std::uint64_t seed) {
  Random random(seed, "mueth", 0, "forces");
  std::vector<double> sample;
  while (sample.size() < n) {
    const double f = exponential(random, 1.5);
    if (random.uniform() < 1 - 0.75 * std::exp(-f * f)) sample.push_back(f);
  }
  const double mean = std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(n);
  for (double& f : sample) f /= mean;
  return sample;
}

/// |standard normal|, by Box and Muller.
inline double normal(Random& random) {
  return std::sqrt(2 * exponential(random)) * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Counts in S3's bins: 50 of .2 on [0, 10].
struct Counts {
  std::vector<double> centre, count, norm, density;
};

inline Counts counts(const std::vector<double>& sample) {
  Histogram h(Spacing::linear, 0, 10, 50);
  for (const double f : sample) h.add(f);
  return {h.centres(),
          {h.counts().begin(), h.counts().end()},
          std::vector<double>(50, 0.2 * static_cast<double>(sample.size())),
          h.density()};
}

}  // namespace jam::test
