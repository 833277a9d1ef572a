// A crystal given in two equivalent cells has the same numbers for every measure.
#include "jamscape/packing/cell.hpp"

#include <gtest/gtest.h>

#include "jamscape/observe/measure.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

/// The face-centred cubic lattice of diameter 1, n cells of four spheres along each edge.
Packing fcc(int n) {
  const double a = std::sqrt(2.0);
  Packing p = box(3, {n * a, n * a, n * a}, true);
  const Vec3 basis[] = {{0, 0, 0}, {a / 2, a / 2, 0}, {a / 2, 0, a / 2}, {0, a / 2, a / 2}};
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (const Vec3& b : basis) add_grain(p, Vec3{0.1, 0.2, 0.3} + b + Vec3{x * a, y * a, z * a});
  touch(p);
  return p;
}

/// Forces, velocities and energies without any order; the springs of some contacts open.
void shake(Packing& p) {
  Random random(5, "cell", 0, "forces");
  const auto vector = [&] {
    return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), p.dimension == 3 ? random.uniform(-1, 1) : 0.0};
  };
  Contacts& k = p.contacts;
  for (std::size_t c = 0; c < k.size(); ++c) {
    k.normal_force[c] = random.uniform(0, 2);
    const Vec3 f = vector();
    k.tangential_force[c] = f - dot(f, k.normal[c]) * k.normal[c];
    if (c % 7 == 0) k.normal_force[c] = 0, k.tangential_force[c] = {}, k.overlap[c] = -0.001;
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i) p.grains.velocity[i] = vector();
  p.packing_fraction = 0.8;
  p.energy = {1, 2, 3, 4, 5, 6};
}

/// The same lattice of grains in the cell whose edge k is lengthened by `times` edge l; grains move into that cell.
Packing in_other_cell(Packing p, std::size_t k, std::size_t l, int times) {
  std::array<Vec3, 3> edges{p.domain.edge(0), p.domain.edge(1), p.domain.edge(2)};
  edges[k] += static_cast<double>(times) * edges[l];
  p.domain = make_cell(p.domain.lo, edges, p.domain.periodic);
  Contacts& c = p.contacts;
  for (auto& image : c.image) image[l] = static_cast<std::int8_t>(image[l] - times * image[k]);
  const Faces faces(p.domain, p.dimension);
  std::vector<std::array<int, 3>> moved(p.grains.size());
  for (std::size_t n = 0; n < p.grains.size(); ++n)
    for (int a = 0; a < p.dimension; ++a) {
      const auto e = static_cast<std::size_t>(a);
      moved[n][e] = static_cast<int>(std::floor(faces.above_low(a, p.grains.position[n]) / faces.width(a)));
    }
  const auto shift = [&](std::size_t n, int sign) {
    Vec3 s{};
    for (std::size_t e = 0; e < 3; ++e) s += static_cast<double>(sign * moved[n][e]) * edges[e];
    return s;
  };
  for (std::size_t n = 0; n < p.grains.size(); ++n) p.grains.position[n] += shift(n, -1);
  for (std::size_t m = 0; m < c.size(); ++m) {
    const auto j = static_cast<std::size_t>(c.j[m]);
    c.point[m] += shift(c.i[m], -1);
    for (std::size_t e = 0; e < 3; ++e)
      c.image[m][e] = static_cast<std::int8_t>(c.image[m][e] + moved[j][e] - moved[c.i[m]][e]);
  }
  return p;
}

MeasureOptions options() {
  MeasureOptions o;
  o.rows_every = 0;
  o.pair_range = 3;
  o.pair_bin = 0.17;
  o.rdf_range = 3;
  o.rdf_bin = 0.17;
  return o;
}

void expect_same_numbers(const Packing& a, const Packing& b, const std::string& where) {
  const Snapshot one(a, options()), other(b, options());
  for (const Measure& m : measures()) {
    const Table x = m.evaluate(one), y = m.evaluate(other);
    ASSERT_EQ(x.rows(), y.rows()) << m.name;
    EXPECT_GT(x.rows(), 0u) << m.name;
    for (const ColumnInfo& column : m.columns) {
      const auto u = x.numbers(column.name), v = y.numbers(column.name);
      for (std::size_t r = 0; r < u.size(); ++r)
        if (std::isnan(u[r]) || std::isnan(v[r]))
          EXPECT_EQ(std::isnan(u[r]), std::isnan(v[r])) << where << ": " << column.name << ", row " << r;
        else
          EXPECT_NEAR(u[r], v[r], 1e-9 * (1 + std::abs(u[r]))) << where << ": " << column.name << ", row " << r;
    }
  }
}

TEST(Cell, AHexagonalCrystalHasTheSameNumbersInEveryCell) {
  Packing p = hexagonal(8, 8);
  shake(p);
  ASSERT_GT(p.contacts.size(), 180u);
  for (const int times : {1, -1, 3}) {
    const Packing tilted = in_other_cell(p, 1, 0, times);
    ASSERT_FALSE(tilted.domain.upright());
    expect_same_numbers(p, tilted, "b + " + std::to_string(times) + " a");
  }
  expect_same_numbers(p, in_other_cell(p, 0, 1, 2), "a + 2 b");
}

TEST(Cell, ACubicCrystalHasTheSameNumbersInEveryCell) {
  Packing p = fcc(3);
  shake(p);
  ASSERT_EQ(p.contacts.size(), 6 * p.grains.size());
  expect_same_numbers(p, in_other_cell(p, 1, 0, 1), "b + a");
  expect_same_numbers(p, in_other_cell(in_other_cell(p, 2, 0, -1), 2, 1, 2), "c - a + 2 b");
  expect_same_numbers(p, in_other_cell(in_other_cell(p, 0, 1, 1), 2, 0, 1), "a + b, c + a + b");
}

/// A lattice no upright cell stands for: five rows, each shifted by half a diameter.
TEST(Cell, AShearedCrystalHasTheSameNumbersInEveryCell) {
  Packing p = in_other_cell(hexagonal(10, 10), 1, 0, 0);
  p.domain.tilt[1][0] = 0.5;  // sheared by half a diameter over ten rows: grains and contacts go with it
  const double per_height = 0.5 / (p.domain.hi[1] - p.domain.lo[1]);
  for (Vec3& x : p.grains.position) x[0] += per_height * x[1];
  for (Vec3& x : p.contacts.point) x[0] += per_height * x[1];
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const Vec3 l = branch(p, c);
    p.contacts.normal[c] = (1 / norm(l)) * l;
  }
  shake(p);
  EXPECT_FALSE(reduced(p.domain, 2).upright());
  EXPECT_NEAR(cell_volume(p.domain, 2), 100 * std::sqrt(0.75), 1e-12);
  for (const int times : {1, -1, 4}) expect_same_numbers(p, in_other_cell(p, 1, 0, times), std::to_string(times));
}

TEST(Cell, IsReducedToTheBoxItStandsFor) {
  const Domain cell = make_cell({1, 2, 3}, {Vec3{4, 0, 0}, Vec3{8, 5, 0}, Vec3{-12, 10, 6}}, {true, true, true});
  const Domain box = reduced(cell, 3);
  EXPECT_TRUE(box.upright());
  EXPECT_EQ(box.edge(0), (Vec3{4, 0, 0}));
  EXPECT_EQ(box.edge(1), (Vec3{0, 5, 0}));
  EXPECT_EQ(box.edge(2), (Vec3{0, 0, 6}));
  EXPECT_DOUBLE_EQ(cell_volume(cell, 3), 120);
  const Domain hexagons = make_cell({}, {Vec3{4, 0, 0}, Vec3{2, std::sqrt(12.0), 0}, Vec3{}}, {true, true, false});
  EXPECT_FALSE(reduced(hexagons, 2).upright());
  const Faces faces(hexagons, 2);
  EXPECT_NEAR(faces.width(0), std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(norm(faces.wrapped({9, 7.5, 0}) - Vec3{9 - 2 * 2 - 4, 7.5 - 2 * std::sqrt(12.0), 0}), 0, 1e-12);
}

/// Floor and lid, and sides that repeat: where the sides are cut is a matter of taste.
TEST(Cell, WallsAcrossATiltedSideAreThoseOfTheUprightCell) {
  Packing p = hexagonal(8, 8);
  p.domain.periodic[1] = false;
  p.domain.hi[1] += 0.3;
  p.contacts = {};
  for (const double sign : {1.0, -1.0}) {
    Wall w;
    w.position = sign > 0 ? p.domain.lo : p.domain.hi;
    w.normal[1] = sign;
    p.walls.push_back(w);
  }
  give_roles(p, 1);
  touch(p);
  shake(p);
  Packing tilted = p;
  tilted.domain.tilt[1][0] = 2.5;
  EXPECT_TRUE(reduced(tilted.domain, 2).upright());
  expect_same_numbers(p, tilted, "slanted sides");
}

TEST(Cell, WallsOnAllSidesOfATiltedCellAreRefusedByName) {
  Packing p = hexagonal(4, 4);
  p.domain.periodic = {};
  p.domain.tilt[1][0] = 1;
  add_walls(p);
  EXPECT_EQ(lacking(find_measure("walls").needs, p), "the cell between the walls is tilted");
  const Table row = find_measure("walls").evaluate(Snapshot(static_cast<const Packing&>(p), options()));
  EXPECT_TRUE(std::isnan(row.numbers("wall_pressure")[0]));
}

TEST(Knowledge, MeasuresOfWhatIsNotKnownAreMissing) {
  Packing p = hexagonal(4, 4);
  p.knows.velocities = p.knows.energies = false;
  const Snapshot s(p, options());
  for (const char* name : {"kinetic_stress", "energy"}) {
    EXPECT_NE(lacking(find_measure(name).needs, p), "");
    const Measure& measure = find_measure(name);
    const Table row = measure.evaluate(s);
    for (const ColumnInfo& column : measure.columns)
      EXPECT_TRUE(std::isnan(row.numbers(column.name)[0])) << column.name;
  }
  EXPECT_FALSE(std::isnan(find_measure("stress").evaluate(s).numbers("pressure")[0]));
}

}  // namespace
}  // namespace jam
