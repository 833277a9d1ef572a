#include "jamscape/observe/contact_forces.hpp"

#include <gtest/gtest.h>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/force_distribution.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

double value(const Measure& m, const Snapshot& s, const std::string& column) {
  return m.evaluate(s).numbers(column).at(0);
}

// Two crosses that touch three times with forces 1, 2, 9, a dashpot that pulls, and a wall.
Packing touching() {
  Packing p = box(2, {20, 9, 0});
  p.shapes = {cross_shape(4)};
  add_walls(p);
  for (const double x : {3.0, 6.5}) add_body(p, {x, 2, 0});
  add_contact_at(p, 0, -1, {0, 2, 0}, {-1, 0, 0}, 50);
  const double forces[] = {1, 2, 9, -0.5};
  for (std::uint16_t k = 0; k < 4; ++k)
    add_contact_at(p, 0, 1, {4.7, 2.0 + k, 0}, {1, 0, 0}, forces[k], {0, 3, 0}, k, 0);
  return p;
}

TEST(ContactForces, AreOfEveryContactBetweenBodiesThatPushes) {
  const Packing p = touching();
  EXPECT_EQ(contact_forces(p), (std::vector<double>{1, 2, 9}));
  const Snapshot s(p, {});
  const Measure m = contact_forces_measure();
  EXPECT_EQ(value(m, s, "force_contacts"), 3);
  EXPECT_EQ(value(m, s, "mean_contact_force"), 4);
  EXPECT_EQ(value(m, s, "largest_force"), 2.25);
  EXPECT_EQ(value(m, s, "fraction_above_max"), 0);
  EXPECT_EQ(s.network().graph.edges(), 1u);  // one pair
}

TEST(ContactForces, FractionsAreOfAllContacts) {
  Packing p = box(2, {60, 4, 0});
  for (int k = 0; k < 41; ++k) add_grain(p, {1.0 + k, 2, 0});
  for (std::uint32_t k = 0; k < 40; ++k)
    add_contact(p, k, static_cast<std::int32_t>(k) + 1, k == 3 ? 17.5 : k == 9 ? 25 : 1);  // mean 80.5/40
  const Snapshot s(p, {});
  EXPECT_DOUBLE_EQ(value(contact_forces_measure(), s, "fraction_above_8"), 2 / 40.);
  EXPECT_DOUBLE_EQ(value(contact_forces_measure(), s, "fraction_above_max"), 1 / 40.);
  EXPECT_DOUBLE_EQ(value(contact_forces_measure(), s, "largest_force"), 25 / 2.0125);
}

TEST(ContactForceDistribution, CountsWhatLiesBeyondInItsNorm) {
  const Packing p = touching();
  MeasureOptions options;
  options.contact_force_max = 2;
  options.contact_force_bins = 4;
  const Table t = contact_force_distribution_measure().evaluate(Snapshot(p, options));
  EXPECT_EQ(t.numbers("force"), (std::vector<double>{0.25, 0.75, 1.25, 1.75}));
  EXPECT_EQ(t.numbers("count"), (std::vector<double>{1, 1, 0, 0}));  // 1/4, 2/4, and 9/4 beyond
  EXPECT_EQ(t.numbers("norm"), (std::vector<double>(4, 1.5)));
  EXPECT_EQ(t.numbers("density"), (std::vector<double>{1 / 1.5, 1 / 1.5, 0, 0}));
}

TEST(ContactForceDistribution, HasThePapersBinsByDefault) {
  Packing p = cloud(2, 500, 2);
  const Table t = contact_force_distribution_measure().evaluate(Snapshot(p, {}));
  ASSERT_EQ(t.rows(), 50u);
  EXPECT_NEAR(t.numbers("force")[0], 0.1, 1e-12);
  EXPECT_NEAR(t.numbers("force")[49], 9.9, 1e-12);
  double inside = 0;
  for (const double n : t.numbers("count")) inside += n;
  double integral = 0;
  for (const double density : t.numbers("density")) integral += 0.2 * density;
  const Snapshot s(p, {});
  EXPECT_NEAR(integral, inside / value(contact_forces_measure(), s, "force_contacts"), 1e-12);
}

TEST(ContactForces, OfNothing) {
  const Packing p = box(3, {1, 1, 1});
  const Snapshot s(p, {});
  for (const char* column : {"force_contacts", "mean_contact_force", "fraction_above_max", "largest_force"})
    EXPECT_EQ(value(contact_forces_measure(), s, column), 0) << column;
  const Table t = contact_force_distribution_measure().evaluate(s);
  EXPECT_EQ(t.numbers("density"), std::vector<double>(50, 0.0));
}

TEST(ContactForces, AMarginLeavesOutWhatIsNearAWall) {
  Packing p = box(2, {12, 12, 0});
  add_walls(p);
  for (const double x : {0.5, 1.5, 2.5, 3.5}) add_grain(p, {x, 6, 0});
  add_contact(p, 0, 1, 1);  // at 1, 2 and 3 from the wall
  add_contact(p, 1, 2, 2);
  add_contact(p, 2, 3, 4);
  MeasureOptions away;
  away.force_margin = 2;  // a sixth of the width too; a contact on the margin counts
  EXPECT_EQ(contact_forces(p, away), (std::vector<double>{2, 4}));
  away.force_margin = 5;
  EXPECT_EQ(contact_forces(p, away), (std::vector<double>{2, 4}));
  away.force_margin = 1.5;
  const Histogram h = force_distribution(p, Snapshot(p, away).network(), away);
  EXPECT_EQ(h.total(), 2);
  EXPECT_EQ(contact_forces(p), (std::vector<double>{1, 2, 4}));
}

// Ten forces of which one is 8 times the mean, computed with round-off: on the border, not above it.
TEST(ContactForces, AForceOnABorderIsNotAboveIt) {
  Packing p = box(2, {40, 10, 0});
  for (int k = 0; k < 11; ++k) add_grain(p, {1.0 + k, 1, 0});
  for (std::uint32_t k = 0; k < 9; ++k) add_contact(p, k, static_cast<std::int32_t>(k) + 1, .1 * 2 / 9);
  add_contact(p, 9, 10, .8);
  const Table t = contact_forces_measure().evaluate(Snapshot(p, {}));
  EXPECT_EQ(t.numbers("fraction_above_8").at(0), 0);
  EXPECT_NEAR(t.numbers("largest_force").at(0), 8, 1e-12);
}

}  // namespace
}  // namespace jam
