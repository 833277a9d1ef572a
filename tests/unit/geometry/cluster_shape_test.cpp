#include "jamscape/geometry/cluster_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/arm_union.hpp"

namespace jam {
namespace {

using std::numbers::pi;

void expect_same_integrals(const ClusterShape& a, const ClusterShape& b, double tolerance) {
  EXPECT_NEAR(a.volume, b.volume, tolerance);
  EXPECT_NEAR(a.surface, b.surface, tolerance);
  EXPECT_NEAR(a.area, b.area, tolerance);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a.inertia[k], b.inertia[k], tolerance);
}

/// Theory sec. 2.6, to the digits printed there; `paper` is S3's Table S1.
struct Row {
  double aspect, cross_volume, cross_surface, cross_psi, cross_paper, cross_inertia;
  double star_volume, star_surface, star_psi, star_paper, star_inertia, d1;
};
constexpr Row table[] = {
    {1.1, .63950, 3.5959, .9983, .995, .11935, .66277, 3.6812, .9986, .995, .11707, 1.318},
    {1.7, 1.48278, 6.7403, .9329, .933, .26729, 1.81403, 7.7135, .9325, .933, .23530, 0},
    {2.25, 2.34403, 10.1372, .8418, .842, .44740, 3.10183, 12.7205, .8086, .809, .36494, 0},
    {3, 3.52212, 14.8496, .7539, .754, .76638, 4.86897, 19.7891, .7020, .702, .58661, .745},
    {4, 5.09292, 21.1327, .6774, .677, 1.33320, 7.22517, 29.2138, .6187, .619, .97506, 0},
    {6, 8.23451, 33.6991, .5852, .585, 2.96264, 11.93756, 48.0634, .5255, .526, 2.08144, .607},
    {8.5, 12.1615, 49.4071, .5176, .518, 5.93465, 17.82804, 71.6253, .4608, .462, 4.08745, .571},
    {11, 16.0885, 65.1150, .4733, .473, 9.94753, 23.71853, 95.1873, .4194, .419, 6.78723, .553},
};

TEST(ClusterShape, TableOfTheTheory) {
  for (const Row& row : table) {
    SCOPED_TRACE(row.aspect);
    const ClusterShape cross = cross_shape(row.aspect), star = star_shape(row.aspect);
    // Below L/d = 2 the printed volumes come from a coarser quadrature, good to 3e-5.
    EXPECT_NEAR(cross.volume, row.cross_volume, row.aspect < 2 ? 3e-5 : row.aspect < 8 ? 6e-6 : 6e-5);
    EXPECT_NEAR(cross.surface, row.cross_surface, 6e-5);
    EXPECT_NEAR(sphericity(cross), row.cross_psi, 7e-5);
    EXPECT_NEAR(cross.inertia[2] / cross.volume, row.cross_inertia, 6e-6);
    EXPECT_NEAR(star.volume, row.star_volume, row.aspect < 2 ? 3e-5 : 6e-6);
    EXPECT_NEAR(star.surface, row.star_surface, 6e-5);
    EXPECT_NEAR(sphericity(star), row.star_psi, 6e-5);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(star.inertia[k] / star.volume, row.star_inertia, 6e-6);
    if (row.d1 > 0) {
      EXPECT_NEAR(contact_distances(cross).d1, row.d1, 6e-4);
    }
  }
}

TEST(ClusterShape, ThePapersSphericitiesButForTheRoundest) {
  for (const Row& row : table) {
    SCOPED_TRACE(row.aspect);
    // 1.1 is an erratum of S3 (its .995 belongs to L/d of 1.17 and 1.19); the star of 8.5 is .462 in its table, .461 in
    // its text.
    const double cross = row.aspect == 1.1 ? 4e-3 : 5e-4, star = row.aspect == 1.1   ? 4e-3
                                                                 : row.aspect == 8.5 ? 1.5e-3
                                                                                     : 6e-4;
    EXPECT_NEAR(sphericity(cross_shape(row.aspect)), row.cross_paper, cross);
    EXPECT_NEAR(sphericity(star_shape(row.aspect)), row.star_paper, star);
  }
  EXPECT_GT(sphericity(cross_shape(1.1)), .998);
  EXPECT_NEAR(sphericity(cross_shape(1.17)), .995, 5e-4);
  EXPECT_NEAR(sphericity(star_shape(1.19)), .995, 5e-4);
}

TEST(ClusterShape, ClosedFormsAgreeWithTheIntegral) {
  for (const double aspect : {1.0, 1.3, 2.0, 3.0, 11.0})
    expect_same_integrals(rod_shape(aspect), custom_shape(rod_shape(aspect).arms, 3), 1e-8);
  for (const double aspect : {2.0, 2.25, 4.0, 11.0}) {
    SCOPED_TRACE(aspect);
    expect_same_integrals(cross_shape(aspect), custom_shape(cross_shape(aspect).arms, 2), 1e-8);
    expect_same_integrals(star_shape(aspect), custom_shape(star_shape(aspect).arms, 3), 1e-8);
  }
}

/// A star's volume and inertia from its distance R to the boundary: V = int R^3/3, I = 2/3 int R^5/5 over all
/// directions. Arm x is the farthest where |u_x| is the largest component, an eighth of that region being 0 < phi <
/// pi/4, tan theta < 1 / cos phi (theta from the arm, phi about it).
TEST(ClusterShape, StarsBelowTwoAgreeWithTheirRadialIntegral) {
  for (const double aspect : {1.1, 1.4, 1.7, 1.95}) {
    const double r = .5, h = (aspect - 1) / 2;
    const int n = 400, m = 3000;
    double volume = 0, fourth = 0;
    for (int a = 0; a < n; ++a) {
      const double top = std::atan(1 / std::cos(pi / 4 * (a + .5) / n));
      for (int b = 0; b < m; ++b) {
        const double t = top * (b + .5) / m, c = std::cos(t), s = std::sin(t);
        const double to_side = r / s;
        const double R = to_side * c < h ? to_side : h * c + std::sqrt(r * r - h * h * s * s);
        const double solid = s * top / m * (pi / 4 / n);
        volume += solid * R * R * R / 3;
        fourth += solid * std::pow(R, 5) / 5;
      }
    }
    const ClusterShape star = star_shape(aspect);
    EXPECT_NEAR(48 * volume, star.volume, 2e-6) << aspect;
    EXPECT_NEAR(48 * fourth * 2 / 3, star.inertia[0], 2e-6) << aspect;
  }
}

TEST(ClusterShape, ContinuousWhereTheClosedFormsBegin) {
  expect_same_integrals(cross_shape(2 - 1e-9), cross_shape(2), 5e-8);
  expect_same_integrals(star_shape(2 - 1e-9), star_shape(2), 5e-8);
}

TEST(ClusterShape, OfAspectRatioOneIsTheSphere) {
  const ClusterShape sphere = sphere_shape();
  EXPECT_DOUBLE_EQ(sphere.volume, pi / 6);
  EXPECT_DOUBLE_EQ(sphere.surface, pi);
  EXPECT_DOUBLE_EQ(sphere.area, pi / 4);
  EXPECT_DOUBLE_EQ(sphere.inertia[0] / sphere.volume, 0.1);  // 2/5 r^2
  EXPECT_DOUBLE_EQ(sphericity(sphere), 1);
  for (const ClusterShape& shape : {rod_shape(1), cross_shape(1), star_shape(1)}) {
    EXPECT_EQ(shape.arms.size(), 1u);
    expect_same_integrals(shape, sphere, 1e-15);
  }
  expect_same_integrals(cross_shape(1 + 1e-7), sphere, 1e-6);
  expect_same_integrals(star_shape(1 + 1e-7), sphere, 1e-6);
}

TEST(ClusterShape, LengthsOfTheNamedShapes) {
  const ClusterShape star = star_shape(5);
  EXPECT_DOUBLE_EQ(star.length, 5);
  EXPECT_DOUBLE_EQ(star.circumradius, 2.5);
  EXPECT_DOUBLE_EQ(aspect_ratio(star), 5);
  EXPECT_EQ(star.name, "star");
  EXPECT_EQ(star.arms.size(), 3u);
  EXPECT_DOUBLE_EQ(star.area, 2 * (4 + pi / 4) - 1);
}

TEST(ClusterShape, ContactDistances) {
  const Distances three = contact_distances(star_shape(3));
  EXPECT_NEAR(three.d1, std::sqrt(1 + 4.0) / 3, 1e-15);
  EXPECT_DOUBLE_EQ(three.d2, 2 * three.d1);
  EXPECT_DOUBLE_EQ(three.d3, 3 * three.d1);
  EXPECT_NEAR(three.j1, .577, 5e-4);
  EXPECT_TRUE(std::isnan(contact_distances(rod_shape(3)).d1));
}

TEST(ClusterShape, RefusesAnAspectRatioBelowOne) {
  EXPECT_THROW(cross_shape(0.9), Error);
  EXPECT_THROW(star_shape(std::nan("")), Error);
  EXPECT_THROW(rod_shape(-2), Error);
}

}  // namespace
}  // namespace jam
