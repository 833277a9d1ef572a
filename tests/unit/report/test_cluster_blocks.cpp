// What the report takes from a study of clusters in containers: shapes, final states, packings.
#include <gtest/gtest.h>

#include <filesystem>

#include "fixture.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/report.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

struct Writer {
  static constexpr const char* name = "jamscape-clusters-";
  static void write(const fs::path& folder) { write_cluster_fixture(folder, 40); }
};
using ClusterBlocks = testing::StoredResults<Writer>;

Json many(const Results& results, const std::string& measure) {
  for (const ManyChoice& choice : many_choices())
    if (choice.measure == measure) return many_block(results, choice);
  return {};
}

MeasureOptions total_forces() {
  MeasureOptions options;
  options.force = EdgeForce::total;
  return options;
}

TEST_F(ClusterBlocks, ShapesComeFromTheStoredFrames) {
  const Results results = open_results(folder());
  const Json shapes = shapes_block(results, choose_pictures(results));
  ASSERT_EQ(shapes["systems"].size(), 6u);
  const Json& cross = shapes["systems"][1][0];
  EXPECT_EQ(cross["name"], "cross");
  EXPECT_EQ(cross["aspect"], 3);
  EXPECT_NEAR(cross["sphericity"].get<double>(), 0.7539, 1e-4);
  EXPECT_NEAR(cross["d1"].get<double>(), 0.745, 1e-3);  // S3 Table 2
  EXPECT_EQ(cross["arms"].size(), 2u);
  EXPECT_EQ(cross["arms"][0].size(), 8u);
  EXPECT_EQ(shapes["systems"][4][0]["arms"].size(), 3u);
  EXPECT_NEAR(shapes["systems"][4][0]["j1"].get<double>(), 0.577, 1e-3);
}

TEST_F(ClusterBlocks, TheLastStateOfAContainerIsTheFinalOne) {
  const Results results = open_results(folder());
  EXPECT_TRUE(frames_block(results).is_null());
  const Json final = final_block(results);
  ASSERT_EQ(final["systems"].size(), 6u);
  EXPECT_EQ(final["systems"][0]["realisations"], 3);
  const Json& k = final["systems"][0]["quantities"]["tail_k"];
  EXPECT_NEAR(k["mean"].get<double>(), 1.42, 0.05);
  EXPECT_GT(k["se"].get<double>(), 0);
  EXPECT_EQ(final["systems"][0]["quantities"]["tail_k_pooled"]["se"], 0.02);
  EXPECT_TRUE(transitions_block(results).is_null());  // nothing of it is a transition
}

TEST_F(ClusterBlocks, DistributionsAreThoseOfTheFinalState) {
  const Results results = open_results(folder());
  for (const char* measure : {"contact_force_distribution", "stress_distribution", "radial_distribution"}) {
    const Json block = many(results, measure);
    ASSERT_EQ(block["systems"].size(), 6u) << measure;
    ASSERT_EQ(block["systems"][0]["frames"].size(), 1u) << measure;
    EXPECT_EQ(block["systems"][0]["frames"][0]["rho"], 0.5);
  }
  EXPECT_EQ(many(results, "contact_force_distribution")["systems"][0]["frames"][0]["x"].size(), 50u);
  EXPECT_LE(many(results, "radial_distribution")["systems"][0]["frames"][0]["x"].back(), 4);
}

TEST_F(ClusterBlocks, AContainerIsPicturedAfterEachStage) {
  const Results results = open_results(folder());
  const auto sources = choose_pictures(results);
  const Json networks = networks_block(sources, total_forces());
  ASSERT_EQ(networks["systems"][5].size(), 3u);
  const char* stages[] = {"settle", "press", "relax"};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(networks["systems"][5][k]["stage"], stages[k]);
    EXPECT_NEAR(networks["systems"][5][k]["rho"].get<double>(), 0.4 + 0.05 * static_cast<double>(k), 1e-9);
  }
  const Json& stars = networks["systems"][5][2];
  EXPECT_EQ(stars["clusters"]["orientation"].size(), 4u);
  EXPECT_EQ(stars["clusters"]["shapes"].size(), 1u);
  EXPECT_EQ(stars["clusters"]["cylinder"]["axis"], 1);
  EXPECT_NEAR(stars["clusters"]["cylinder"]["radius"].get<double>(), 2.5 * 8.5, 1e-9);
  const Json& crosses = networks["systems"][0][2]["clusters"];
  EXPECT_EQ(crosses["orientation"].size(), 2u);
  EXPECT_FALSE(crosses.contains("cylinder"));
}

TEST_F(ClusterBlocks, ASystemWhoseTaskIsNotThereHasNoPictures) {
  Results results = open_results(folder());
  results.study.systems[0].options.grains.count = 41;  // another task than the one stored
  const auto sources = choose_pictures(results);
  EXPECT_TRUE(sources[0].frames.empty());
  EXPECT_EQ(shapes_block(results, sources)["systems"][0][0]["name"], "cross");  // as its options say
  EXPECT_EQ(sources[1].frames.size(), 3u);
}

TEST_F(ClusterBlocks, WhatS3PrintsStandsBesideIt) {
  write_report(folder());
  EXPECT_NE(read_text(folder() / "report.html").find("id=\"data-conzelmann\""), std::string::npos);
  const Json paper = conzelmann_block();
  EXPECT_EQ(paper["mueth"]["x"].size(), 101u);
  EXPECT_NEAR(paper["mueth"]["y"][0].get<double>(), 0.75, 1e-9);           // 3 (1 - .75)
  EXPECT_NEAR(paper["exponent_slab"]["y"][0].get<double>(), 0.747, 1e-3);  // theory sec. 5
  EXPECT_NEAR(paper["exponent_2d"]["y"][0].get<double>(), 1.335, 1e-3);
  EXPECT_TRUE(paper["peaks"][4]["peaks"][2].is_null());
}

}  // namespace
}  // namespace jam
