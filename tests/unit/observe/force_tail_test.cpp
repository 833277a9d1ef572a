#include "jamscape/observe/force_tail.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

TEST(ForceTailMeasure, OfExponentialForces) {
  const Packing p = cloud(2, 4000, 6);  // forces are exponential, mean 1
  const Snapshot s(p, {});
  const Table t = force_tail_measure().evaluate(s);
  const auto value = [&](const char* column) { return t.numbers(column).at(0); };
  EXPECT_NEAR(value("tail_k"), 1, 4 * value("tail_k_error"));
  EXPECT_LT(value("tail_k_error"), 0.05);
  EXPECT_NEAR(value("tail_k_mle"), 1, 4 * value("tail_k_mle_error"));
  EXPECT_NEAR(value("tail_k_loglinear"), 1, 0.2);
  EXPECT_NEAR(value("tail_contacts") / value("tail_excess"), value("tail_k_mle"), 1e-12);
  EXPECT_EQ(value("type_a"), 0);
  EXPECT_LT(value("peak_prominence"), 0);
}

TEST(ForceTailMeasure, OfForcesAroundTheirMeanIsTypeA) {
  Packing p = cloud(2, 1500, 6);
  Random random(3, "force tail", 0, "forces");
  for (double& f : p.contacts.normal_force) {
    f = 0;
    for (int k = 0; k < 4; ++k) f += 0.5 * random.uniform();  // about 1, sd .29
  }
  const Snapshot s(p, {});
  const Table t = force_tail_measure().evaluate(s);
  EXPECT_EQ(t.numbers("type_a")[0], 1);
  EXPECT_NEAR(t.numbers("peak_position")[0], 1, 0.11);
  EXPECT_NEAR(t.numbers("gauss_centre")[0], 1, 0.02);
  EXPECT_NEAR(t.numbers("gauss_width")[0], 0.29, 0.02);
}

TEST(ForceTailMeasure, IsMissingBetweenThePackingFractionsOfTables) {
  Packing p = cloud(2, 400, 6);
  p.packing_fraction = 0.807;
  const Snapshot s(p, {});
  const Table t = force_tail_measure().evaluate(s);
  ASSERT_EQ(t.rows(), 1u);
  for (const Column& c : t.columns) EXPECT_TRUE(std::isnan(t.numbers(c.name)[0])) << c.name;
}

}  // namespace
}  // namespace jam
