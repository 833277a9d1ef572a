// A periodic box that shrinks brings grains nearer to each other, and the dashpots feel it: work that goes in is the
// energy that comes out, and a perfect lattice has the forces it must have.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compression.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

struct Squeezed {
  std::vector<Packing> frames;
  double drift = 0;     ///< largest change of the ledger
  double expected = 0;  ///< integral of p d(-V), p = sum F_n r/(D V), by frames
};

Squeezed squeeze(SystemOptions s, const char* name) {
  s.domain.walls = WallModel::periodic;
  s.domain.area = AreaConvention::actual;
  Squeezed out;
  Hooks hooks;
  hooks.frame = [&](std::size_t, const Packing& p) { out.frames.push_back(p); };
  EXPECT_EQ(simulate(s, {11, name, 0}, hooks), Outcome::finished);
  const auto volume = [](const Packing& p) { return std::pow(p.domain.hi[0] - p.domain.lo[0], p.dimension); };
  const auto pressure = [&](const Packing& p) {
    double virial = 0;
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto i = static_cast<std::size_t>(p.contacts.i[k]), j = static_cast<std::size_t>(p.contacts.j[k]);
      virial += p.contacts.normal_force[k] * (p.grains.radius[i] + p.grains.radius[j] - p.contacts.overlap[k]);
    }
    return virial / (p.dimension * volume(p));
  };
  for (std::size_t f = 1; f < out.frames.size(); ++f) {
    const Packing &a = out.frames[f - 1], &b = out.frames[f];
    out.drift = std::max(out.drift, std::abs(b.energy.sum() - out.frames[0].energy.sum()));
    out.expected += 0.5 * (pressure(a) + pressure(b)) * (volume(a) - volume(b));
  }
  return out;
}

SystemOptions discs(double dt, double friction) {
  SystemOptions s;
  s.grains.count = 100;
  s.contact.friction = friction;
  s.integrator.step = dt;
  s.stages = {compression("squeeze", 0.9, 1e-3, 301)};
  return s;
}

TEST(ShrinkingBox, the_ledger_closes_with_the_step) {
  for (const double friction : {0.0, 0.5}) {
    const auto part = [&](double dt) {
      const Squeezed run = squeeze(discs(dt, friction), "steps");
      const EnergyLedger& end = run.frames.back().energy;
      EXPECT_NEAR(end.wall_work, run.expected, 0.03 * end.wall_work) << dt;
      return run.drift / (end.damped + end.rubbed);
    };
    const double coarse = part(0.02), fine = part(0.005);
    EXPECT_LT(fine, 0.01) << friction;
    if (friction > 0) continue;  // the paths of two steps part, and so do their drifts
    EXPECT_LT(fine, coarse / 3);
  }
}

// Fast, and from rest: almost all work goes through the dashpots.
TEST(ShrinkingBox, compression_from_rest_makes_no_energy) {
  for (const int dimension : {2, 3})
    for (const NormalLaw law : {NormalLaw::linear, NormalLaw::ratio, NormalLaw::hertz, NormalLaw::tsuji}) {
      SystemOptions s = discs(0.002, 0.5);
      s.domain.dimension = dimension;
      s.contact.law = law;
      s.contact.damping = DampingRule::clipped;
      if (hertzian(law)) s.contact.stiffness = 300, s.contact.impact_speed = 0.1;
      if (dimension == 3) s.grains.count = 216, s.start.packing_fraction = 0.4;
      s.start.speed = 0;
      s.stages = {compression("squeeze", dimension == 2 ? 0.86 : 0.66, 1e-2, 21)};
      const Squeezed run = squeeze(s, "rest");
      EXPECT_LT(run.drift, 0.02 * run.frames.back().energy.wall_work) << dimension << " " << static_cast<int>(law);
    }
}

// Neighbours at distance a that come closer with the box at a' = a (2 speed)/L: F = k (1 - a) + gamma mbar a'.
TEST(ShrinkingBox, a_square_lattice_has_its_forces) {
  SystemOptions s;
  s.grains.count = 16;
  s.grains.sizes = SizeLaw::monodisperse;
  s.start.speed = 0;
  s.stages = {compression("compress", 0.9, 1e-4, 4)};
  const Squeezed run = squeeze(s, "lattice");
  const Packing& end = run.frames.back();
  const double a = std::sqrt(std::numbers::pi / 4 / 0.9), k = std::numbers::pi * std::numbers::pi / 2;
  const PairLaw<> law = scenes::s1_law(0.5, 0.5);
  const double force = k * (1 - a) + law.gamma_n * 0.5 * 2e-4 * a / (4 * a);
  ASSERT_EQ(end.contacts.size(), 32u);
  for (std::size_t c = 0; c < end.contacts.size(); ++c) {
    EXPECT_NEAR(end.contacts.overlap[c], 1 - a, 2e-6);
    EXPECT_NEAR(end.contacts.normal_force[c], force, 1e-5);
  }
  // a contact that closes is no contact at zero force
  for (const Packing& p : run.frames)
    for (std::size_t c = 0; c < p.contacts.size(); ++c) EXPECT_GT(p.contacts.normal_force[c], 0);
}

}  // namespace
}  // namespace jam
