// The law of S3: one damping ratio for all masses, Coulomb limit on the spring alone (theory sec. 2.4).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/contact/damping.hpp"

namespace jam {
namespace {

ContactOptions s3() {
  ContactOptions o;
  o.law = NormalLaw::ratio;
  o.damping = DampingRule::clipped;
  o.damping_ratio = 0.2;
  o.stiffness = 400;
  o.tangential_stiffness = 0.5;
  o.friction = 0.5;
  return o;
}

TEST(DampingRatio, GivesTheRestitutionsOfTheory24) {
  EXPECT_NEAR(linear_restitution(0.2, DampingRule::unclipped), 0.5266, 5e-5);
  EXPECT_NEAR(linear_restitution(0.2, DampingRule::clipped), 0.5717, 5e-5);
}

TEST(DampingRatio, MatchesThePrintedDashpots) {
  const PairLaw<> law = grain_law(s3(), 1);
  const double k_n = 800, k_t = 400;  // as printed: springs k_n/2 and k_t/2
  for (const double mbar : {0.2, 0.5, 3.0}) {
    EXPECT_NEAR(law.gamma_n * damped_mass<NormalLaw::ratio>(mbar, 1.0), 0.2 * std::sqrt(2 * mbar * k_n), 1e-12);
    EXPECT_NEAR(law.gamma_t * damped_mass<NormalLaw::ratio>(mbar, 1.0), 0.2 * std::sqrt(2 * mbar * k_t), 1e-12);
  }
  EXPECT_EQ(law.k_n, 400);
  EXPECT_EQ(law.k_t, 200);
}

TEST(DampingRatio, SolvedForTheRestitutionIsTheSame) {
  ContactOptions o = s3();
  o.damping_ratio = -1;
  o.restitution = linear_restitution(0.2, DampingRule::clipped);
  EXPECT_NEAR(grain_law(o, 1).gamma_n, grain_law(s3(), 1).gamma_n, 1e-9);
  EXPECT_NEAR(wall_law(o, 1).gamma_n, grain_law(s3(), 1).gamma_n, 1e-9) << "mbar = m at a wall comes in by itself";
}

TEST(DampingRatio, LimitsFrictionByTheSpringAlone) {
  const PairLaw<> law = grain_law(s3(), 1);
  const Vec3 n{1, 0, 0}, approaching{0.3, 2.0, 0};
  Vec3 spring{};
  const auto f = touch<3, NormalLaw::ratio, true>(law, n, 0.01, 0.5, approaching, Vec3{}, spring, 0.01);
  EXPECT_GT(f.normal, 400 * 0.01) << "the dashpot pushes on approach";
  EXPECT_NEAR(norm(f.tangential), 0.5 * 400 * 0.01, 1e-12);
  EXPECT_NEAR(f.limit, 0.5 * 400 * 0.01, 1e-12);
}

TEST(DampingRatio, IsRefusedForHertz) {
  ContactOptions o = s3();
  o.law = NormalLaw::hertz;
  EXPECT_THROW(grain_law(o, 1), Error);
}

}  // namespace
}  // namespace jam
