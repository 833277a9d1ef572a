// Corners of bead walls: who is caught between two rows there.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "compression.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

/// Four discs, one to a corner, compressed with friction.
SystemOptions four(BeadRows rows) {
  SystemOptions s;
  s.grains.count = 4;
  s.grains.sizes = SizeLaw::uniform;
  s.grains.width = 0.4;
  s.domain.bead_rows = rows;
  s.contact.friction = 0.5;
  s.integrator.step = 0.01;
  s.stages = {compression("squeeze", 0.9, 1e-3, 4)};
  return s;
}

struct Caught {
  int grains = 0;        ///< trapped, over all runs and frames
  double resultant = 1;  ///< the least
  int pushed = 0;        ///< grains that two walls push
};

/// A grain is trapped where its walls push against one another and not against the packing: the sum of the forces, one
/// of each wall, is less than .4 of the sum of their magnitudes (.71 in a corner of smooth walls; 0 between two
/// plates).
void count(const Packing& p, Caught& caught) {
  std::map<std::uint32_t, std::map<std::int32_t, Vec3>> pushes;
  for (std::size_t k = 0; k < p.contacts.size(); ++k)
    if (p.contacts.j[k] < 0)
      pushes[p.contacts.i[k]][p.contacts.j[k]] +=
          p.contacts.tangential_force[k] - p.contacts.normal_force[k] * p.contacts.normal[k];
  for (const auto& [grain, walls] : pushes) {
    if (walls.size() < 2) continue;
    Vec3 sum{};
    double magnitudes = 0;
    for (const auto& [wall, force] : walls) sum += force, magnitudes += norm(force);
    if (!(magnitudes > 1e-3)) continue;  // of those who only touch, nothing can be said
    ++caught.pushed;
    caught.resultant = std::min(caught.resultant, norm(sum) / magnitudes);
    if (norm(sum) < 0.4 * magnitudes) ++caught.grains;
  }
}

Caught caught_by(BeadRows rows) {
  Caught caught;
  Hooks hooks;
  hooks.largest_ledger_error = 1;
  hooks.frame = [&](std::size_t, const Packing& p) { count(p, caught); };
  for (std::uint64_t r = 0; r < 10; ++r) simulate(four(rows), {2013, "four", r}, hooks);
  return caught;
}

TEST(Corners, rigid_rows_catch_grains_between_them_and_a_frame_none) {
  const Caught rigid = caught_by(BeadRows::rigid), framed = caught_by(BeadRows::framed);
  RecordProperty("rigid_pushed", rigid.pushed);
  RecordProperty("framed_pushed", framed.pushed);
  EXPECT_GT(rigid.pushed, 40);
  EXPECT_GE(rigid.grains, 4);
  EXPECT_LT(rigid.resultant, 0.2);
  EXPECT_GT(framed.pushed, 40);
  EXPECT_EQ(framed.grains, 0);
  EXPECT_GT(framed.resultant, 0.55);
}

// The beads next to a corner bar a disc that touches both, whatever the sizes: nothing fits between them.
TEST(Corners, a_frame_has_a_bead_in_each_corner_and_no_room_behind_the_next_ones) {
  for (const double width : {0.0, 0.4, 1.0, 1.5}) {
    SystemOptions s = four(BeadRows::framed);
    s.grains.count = 100;
    s.grains.width = width;
    const EngineSetup<2> setup = start<2>(s, {1, "frame", 0});
    const double length = setup.walls[1].position - setup.walls[0].position;
    for (const EngineWall<2>& wall : setup.walls) {
      const int along = 1 - wall.axis;
      EXPECT_EQ(wall.beads.front()[along], 0);
      EXPECT_EQ(wall.beads.back()[along], length);
      ASSERT_EQ(wall.along.size(), wall.beads.size());
      EXPECT_EQ(wall.along.front(), -0.5);
      EXPECT_EQ(wall.along.back(), 0.5);
      const double spacing = wall.beads[1][along], touching = 0.5 + (1 - width / 2) / 2;
      EXPECT_LE(spacing, 1);
      EXPECT_LE(0.9 * spacing, touching * (1 + 1e-15));
      for (std::size_t b = 1; b < wall.beads.size(); ++b)
        EXPECT_NEAR(wall.beads[b][along] - wall.beads[b - 1][along], spacing, 1e-12);
    }
  }
}

TEST(Corners, rows_of_a_frame_cannot_be_shifted) {
  SystemOptions s = four(BeadRows::framed);
  s.domain.bead_phase = 0.25;
  try {
    check_start(s);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("domain.bead_phase"), std::string::npos);
  }
  s.domain.bead_rows = BeadRows::closing;
  check_start(s);
}

}  // namespace
}  // namespace jam
