// What the report takes from a study of interaction networks: relaxations, level sets, spheres.
#include <gtest/gtest.h>

#include <filesystem>

#include "fixture.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/jamming.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

struct Writer {
  static constexpr const char* name = "jamscape-networks-";
  static void write(const fs::path& folder) { write_network_fixture(folder); }
};
using NetworkBlocks = testing::StoredResults<Writer>;

MeasureOptions total_forces() {
  MeasureOptions options;
  options.force = EdgeForce::total;
  return options;
}

TEST_F(NetworkBlocks, TheInflectionIsWhereASystemJams) {
  const auto points = jamming_points(open_results(folder()));
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[2]->quantity, "rho_j");
  EXPECT_EQ(points[2]->value, 0.57);
}

TEST_F(NetworkBlocks, UnrelaxedRealisationsAreCounted) {
  const Results results = open_results(folder());
  const Json frames = frames_block(results);
  // one of four realisations at every fifth frame from the fourth on
  EXPECT_EQ(frames["systems"][0]["unrelaxed"], (Json{0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  const Json relaxations = study_block(results)["systems"][0]["relaxations"];
  EXPECT_EQ(relaxations["budget"], 3);
  EXPECT_EQ(relaxations["fluctuation"].get<int>() + relaxations["energy"].get<int>() + 3, 4 * 14);
}

TEST_F(NetworkBlocks, FramesBetweenRelaxationsAreLeftOut) {
  Results results = open_results(folder());
  results.relaxations[0] = {{3, {1, 0, 0}}, {7, {0, 0, 1}}};
  results.states[0] = {3, 7};
  EXPECT_EQ(frames_block(results)["systems"][0]["rho"].size(), 2u);
  EXPECT_EQ(surfaces_block(results)["systems"][0]["rho"].size(), 2u);
  EXPECT_EQ(choose_pictures(results)[0].all.size(), 2u);
}

TEST_F(NetworkBlocks, PicturesOfPackingFractionsASystemNeverComesToAreNotTaken) {
  Results results = open_results(folder());
  results.study.report.pictures = {0.55, 0.87};
  const auto sources = choose_pictures(results);
  const auto rhos = [&](std::size_t system) {
    std::vector<double> out;
    for (const PictureFrame& frame : sources[system].frames)
      if (!frame.own) out.push_back(frame.rho);
    return out;
  };
  EXPECT_EQ(rhos(0), std::vector<double>{0.87});
  EXPECT_EQ(rhos(2), std::vector<double>{0.55});
}

TEST_F(NetworkBlocks, ASurfaceHasARowPerPackingFraction) {
  const Json surfaces = surfaces_block(open_results(folder()));
  const Json& spheres = surfaces["systems"][2];
  EXPECT_EQ(spheres["rho"].size(), 14u);
  EXPECT_EQ(spheres["thresholds"].size(), 61u);
  for (const auto& [name, estimate] : spheres["quantities"].items()) {
    EXPECT_EQ(estimate["mean"].size(), 14u * 61u) << name;
    EXPECT_EQ(estimate["se"].size(), 14u * 61u) << name;
  }
  // The threshold runs fastest: the last value of the first row belongs to the highest threshold.
  EXPECT_TRUE(spheres["quantities"]["percolating_grains"]["mean"][60].is_null());
  EXPECT_GT(spheres["quantities"]["percolating_grains"]["mean"][13 * 61].get<double>(), 0.8);
}

TEST_F(NetworkBlocks, WhatHasNoMeaningInADimensionIsLeftOut) {
  const Results results = open_results(folder());
  const Json surfaces = surfaces_block(results), frames = frames_block(results);
  EXPECT_FALSE(surfaces["systems"][0]["quantities"].contains("b2"));
  EXPECT_TRUE(surfaces["systems"][2]["quantities"].contains("b2"));
  EXPECT_TRUE(frames["systems"][0]["quantities"].contains("psi6"));
  EXPECT_FALSE(frames["systems"][2]["quantities"].contains("psi6"));
  EXPECT_FALSE(frames["systems"][0]["quantities"].contains("tp2"));
}

TEST_F(NetworkBlocks, SpheresHaveThreeAxes) {
  const Json networks = networks_block(choose_pictures(open_results(folder())), total_forces());
  EXPECT_EQ(networks["systems"][0][0]["axes"].size(), 2u);
  const Json& spheres = networks["systems"][2][0];
  EXPECT_EQ(spheres["axes"].size(), 3u);
  EXPECT_EQ(spheres["upper"].size(), 3u);
  EXPECT_EQ(spheres["grains"], 343);
  EXPECT_GT(spheres["nodes"], spheres["grains"]);  // ends of lines at the periodic border
}

}  // namespace
}  // namespace jam
