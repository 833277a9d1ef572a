#include "jamscape/observe/force_tail.hpp"

#include "jamscape/base/mean.hpp"
#include "jamscape/observe/contact_forces.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/stats/force_tail.hpp"

namespace jam {
namespace {

std::vector<double> values(const Snapshot& s) {
  const std::vector<double> forces = over_mean(contact_forces(s.packing(), s.options()));
  const auto columns = distribution_columns(forces, s.options());
  const ForceTail t = force_tail(columns[0], columns[2], columns[3]);
  const Estimate likelihood = tail_exponent_likelihood(forces);
  const auto above = static_cast<double>(likelihood.n);
  return {t.exponent.value,
          t.exponent.error,
          t.loglinear.value,
          t.loglinear.error,
          likelihood.value,
          likelihood.error,
          above,
          likelihood.n > 0 ? above / likelihood.value : 0.0,
          t.mueth.a,
          t.mueth.b,
          t.mueth.beta,
          t.gaussian.centre,
          t.gaussian.width,
          t.peak.position,
          t.peak.prominence,
          t.peak.error,
          t.type_a() ? 1.0 : 0.0,
          t.bend.value,
          t.bend.error};
}

}  // namespace

Measure force_tail_measure() {
  Measure m = seldom_measure(
      {"force_tail", "tail and shape of the distribution of contact forces",
       "From P(f) of the measure contact_force_distribution. tail_k: P = A exp(-k f) by unweighted least squares on "
       "the bins with centre > 1 (a fit without the prefactor A, as printed, would give .9 where this gives 1.25); "
       "tail_k_loglinear: a line through ln P of those that are not empty; tail_k_mle = 1/(<f> - 1) over f > 1. The "
       "three differ by .1 on one and the same law. Mueth: P = a (1 - b exp(-f^2)) exp(-beta f), Gaussian: P = h "
       "exp(-(f - c)^2/(2 w^2)), both by least squares on all bins. The peak is the highest bin beyond f = .3, its "
       "prominence "
       "the height above the lowest bin before it; type A where that exceeds twice its counting error, else type B. "
       "bend: c of ln P = a + b f + c f^2 on .2 < f < 2.",
       "S3 Eqs. 1, 2, Figs. 1, 5, 6; theory sec. 4"},
      {{"tail_k", "", "k by least squares with a free prefactor"},
       {"tail_k_error", "", "its standard error: P = count/norm varies by count/norm^2, carried through the fit"},
       {"tail_k_loglinear", "", "k from the line through ln P"},
       {"tail_k_loglinear_error", "", "its standard error: ln P varies by 1/count, carried through the line"},
       {"tail_k_mle", "", "k by maximum likelihood, without bins"},
       {"tail_k_mle_error", "", "its standard error, k/sqrt(tail_contacts)"},
       {"tail_contacts", "", "contacts with f > 1, by more than 1e-12 of it"},
       {"tail_excess", "", "sum of f - 1 over them"},
       {"mueth_a", "", "a of Mueth's law"},
       {"mueth_b", "", "b of Mueth's law"},
       {"mueth_beta", "", "beta of Mueth's law"},
       {"gauss_centre", "<F_n>", "c of the Gaussian; far below 0 or missing where P(f) falls from f = 0 on"},
       {"gauss_width", "<F_n>", "w of the Gaussian"},
       {"peak_position", "<F_n>", "centre of the peak's bin"},
       {"peak_prominence", "1/<F_n>", "P at the peak less P of the lowest bin before it"},
       {"peak_prominence_error", "1/<F_n>", "its counting error"},
       {"type_a", "", "1 where the peak stands out by more than two errors, 0 where P(f) is of type B"},
       {"bend", "1/<F_n>^2",
        "curvature of ln P near the mean: below 0 with a peak or a shoulder, 0 for an exponential"},
       {"bend_error", "1/<F_n>^2", "its counting error"}},
      values);
  m.ratios = {{"tail_k_mle_pooled", "tail_contacts", "tail_excess", "k by maximum likelihood over all realisations"}};
  return m;
}

}  // namespace jam
