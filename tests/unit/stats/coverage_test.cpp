// Do errors mean what they say? Data of known truth, many times over: an interval of nominally 68 % has to hold the truth
// 68 times in a hundred, within the binomial error of the count. An error that rests on the scatter of n realisations
// is taken times Student's t_n, as its header says; one that rests on counted contacts is taken as it is.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "jamscape/stats/crossing.hpp"
#include "jamscape/stats/exponential_tail.hpp"
#include "jamscape/stats/force_tail.hpp"
#include "jamscape/stats/inflection.hpp"
#include "jamscape/stats/moments.hpp"
#include "jamscape/stats/resampling.hpp"
#include "jamscape/stats/shell_peaks.hpp"
#include "samples.hpp"

namespace jam {
namespace {

using namespace test;

constexpr double nominal = 0.6827;

double student(std::size_t n) {
  switch (n) {
    case 2:
      return 1.8373;
    case 5:
      return 1.1416;
    default:
      return 1.0267;  // 20
  }
}

using Trial = std::function<Estimate(Random&)>;

/// How often the truth lies within `factor` errors.
double coverage(std::uint64_t trials, double truth, double factor, const Trial& trial) {
  double covered = 0;
  for (std::uint64_t t = 0; t < trials; ++t) {
    Random random(2026, "coverage", t, "data");
    const Estimate e = trial(random);
    covered += std::abs(e.value - truth) <= factor * e.error;
  }
  return covered / static_cast<double>(trials);
}

double binomial(std::uint64_t trials) { return std::sqrt(nominal * (1 - nominal) / static_cast<double>(trials)); }

class OfRealisations : public testing::TestWithParam<std::size_t> {
 protected:
  void covers(std::uint64_t trials, double truth, const Trial& trial) const {
    EXPECT_NEAR(coverage(trials, truth, student(GetParam()), trial), nominal, 3 * binomial(trials)) << GetParam();
  }
  std::vector<double> normals(Random& random) const {
    std::vector<double> x(GetParam());
    for (double& v : x) v = 2 + 0.3 * normal(random);
    return x;
  }
};

INSTANTIATE_TEST_SUITE_P(Coverage, OfRealisations, testing::Values(2, 5, 20));

double mean_at(const std::vector<double>& x, std::span<const std::size_t> which) {
  double sum = 0;
  for (const std::size_t k : which) sum += x[k];
  return sum / static_cast<double>(which.size());
}

TEST_P(OfRealisations, Mean) {
  covers(2000, 2, [&](Random& random) {
    const Moments m = moments(normals(random));
    return Estimate{m.mean, m.se, m.n};
  });
}

TEST_P(OfRealisations, Jackknife) {
  covers(2000, 4, [&](Random& random) {
    const std::vector<double> x = normals(random);
    // a smooth statistic that is no mean: twice the mean, the way there bent by a part in a hundred
    return jackknife(x.size(), [&](std::span<const std::size_t> w) {
      const double m = mean_at(x, w);
      return 2 * m + 0.02 * (m - 2) * (m - 2);
    });
  });
}

TEST_P(OfRealisations, Bootstrap) {
  covers(2000, 2, [&](Random& random) {
    const std::vector<double> x = normals(random);
    return bootstrap(x.size(), 200, random, [&](std::span<const std::size_t> w) { return mean_at(x, w); });
  });
}

/// Contact numbers that jump at .8 +- .004, noise on every state.
struct Jumps {
  std::vector<double> rho;
  std::vector<std::vector<double>> z;
};

Jumps jumps(std::size_t n, Random& random) {
  Jumps j;
  for (int k = 0; k <= 40; ++k) j.rho.push_back(0.7 + 0.005 * k);
  for (std::size_t r = 0; r < n; ++r) {
    const double at = 0.8 + 0.004 * normal(random);
    std::vector<double> z;
    for (const double x : j.rho) z.push_back(0.3 + 5.4 / (1 + std::exp(-(x - at) / 0.012)) + 0.02 * normal(random));
    j.z.push_back(std::move(z));
  }
  return j;
}

TEST_P(OfRealisations, CrossingOfTheMean) {
  covers(1000, 0.8, [&](Random& random) {
    const Jumps j = jumps(GetParam(), random);
    return crossing_of_mean(j.rho, j.z, 3);
  });
}

TEST_P(OfRealisations, InflectionOfTheMean) {
  covers(150, 0.8, [&](Random& random) {
    const Jumps j = jumps(GetParam(), random);
    return inflection_of_mean(j.rho, j.z, 40, random);
  });
}

TEST_P(OfRealisations, FirstShell) {
  covers(400, 1, [&](Random& random) {
    std::vector<double> r;
    std::vector<std::vector<double>> pairs(GetParam()), ideal(GetParam());
    for (int k = 0; k < 100; ++k) r.push_back(0.01 + 0.02 * k);
    for (std::size_t n = 0; n < GetParam(); ++n) {
      const double at = 1 + 0.03 * normal(random);
      for (const double x : r) {
        ideal[n].push_back(1000 * x);
        const double u = (x - at) / 0.15, mean = ideal[n].back() * (0.2 + 2 * std::exp(-0.5 * u * u));
        pairs[n].push_back(std::max(0.0, std::round(mean + std::sqrt(mean) * normal(random))));
      }
    }
    return shell_peaks(r, pairs, ideal, 40, random)[0];
  });
}

/// Of forces whose mean is known to be 1, the exponent of their tail: what the estimators give for endless data.
Counts exact_counts(double n) {
  Counts c = counts({});
  for (std::size_t k = 0; k < 50; ++k) {
    const double lo = 0.2 * static_cast<double>(k);
    c.norm[k] = 0.2 * n;
    c.count[k] = n * (std::exp(-lo) - std::exp(-lo - 0.2));
  }
  return c;
}

Counts drawn_counts(std::size_t n, Random& random) {
  std::vector<double> sample(n);
  for (double& f : sample) f = exponential(random);
  return counts(sample);
}

TEST_P(OfRealisations, PooledTail) {
  const Counts truth = exact_counts(1e6);
  covers(200, tail_exponent(truth.centre, truth.count, truth.norm).value, [&](Random& random) {
    std::vector<Counts> runs;
    for (std::size_t r = 0; r < GetParam(); ++r) runs.push_back(drawn_counts(1000, random));
    return jackknife(runs.size(), [&](std::span<const std::size_t> which) {
      Counts sum = counts({});
      for (const std::size_t r : which)
        for (std::size_t k = 0; k < 50; ++k) sum.count[k] += runs[r].count[k], sum.norm[k] += runs[r].norm[k];
      return tail_exponent(sum.centre, sum.count, sum.norm).value;
    });
  });
}

class OfContacts : public testing::TestWithParam<std::size_t> {
 protected:
  void covers(double truth, const Trial& trial) const {
    EXPECT_NEAR(coverage(400, truth, 1, trial), nominal, 3 * binomial(400)) << GetParam();
  }
};

INSTANTIATE_TEST_SUITE_P(Coverage, OfContacts, testing::Values(1000, 5000));

TEST_P(OfContacts, TailByFreePrefactor) {
  const Counts truth = exact_counts(1e6);
  covers(tail_exponent(truth.centre, truth.count, truth.norm).value, [&](Random& random) {
    const Counts c = drawn_counts(GetParam(), random);
    return tail_exponent(c.centre, c.count, c.norm);
  });
}

TEST_P(OfContacts, Bend) {
  const Counts truth = exact_counts(1e6);
  covers(force_bend(truth.centre, truth.count, truth.norm).value, [&](Random& random) {
    const Counts c = drawn_counts(GetParam(), random);
    return force_bend(c.centre, c.count, c.norm);
  });
}

// Bins up to 4: further out a bin holds a force or none, and the line is biased by those it leaves out.
TEST_P(OfContacts, TailByLogarithms) {
  covers(1, [&](Random& random) {
    Histogram h(Spacing::linear, 0, 4, 20);
    const std::size_t n = 5 * GetParam();
    for (std::size_t k = 0; k < n; ++k) h.add(exponential(random));
    const std::vector<double> count(h.counts().begin(), h.counts().end());
    return tail_exponent_loglinear(h.centres(), count, std::vector<double>(20, 0.2 * static_cast<double>(n)));
  });
}

class OfForcesAboveTheMean : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Coverage, OfForcesAboveTheMean, testing::Values(2, 5, 20));

// k/sqrt(n) covers by .738, .697 and .686: exact, from the gamma distribution of the excess.
TEST_P(OfForcesAboveTheMean, TailByLikelihood) {
  const std::size_t n = GetParam();
  const double exact = n == 2 ? 0.7376 : n == 5 ? 0.6967 : 0.6861;
  const double found = coverage(4000, 1.4, 1, [&](Random& random) {
    double excess = 0;
    for (std::size_t k = 0; k < n; ++k) excess += exponential(random, 1.4);
    return tail_exponent_likelihood(n, excess);
  });
  EXPECT_NEAR(found, exact, 3 * binomial(4000));
}

}  // namespace
}  // namespace jam
