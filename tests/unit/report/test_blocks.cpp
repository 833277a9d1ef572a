// What the report takes from a folder of results.
#include <gtest/gtest.h>

#include <filesystem>

#include "fixture.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/report.hpp"
#include "jamscape/study/measure_task.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

struct Writer {
  static constexpr const char* name = "jamscape-blocks-";
  static void write(const fs::path& folder) { write_fixture(folder); }
};
using ReportBlocks = testing::StoredResults<Writer>;

TEST_F(ReportBlocks, StudyNamesWhatDiffers) {
  const Json study = study_block(open_results(folder()));
  EXPECT_EQ(study["swept"], Json({"grains.width", "contact.friction"}));
  ASSERT_EQ(study["systems"].size(), 3u);
  EXPECT_EQ(study["systems"][2]["swept"], Json({{"grains.width", 0.4}, {"contact.friction", 0.5}}));
  EXPECT_EQ(study["systems"][0]["realisations"], 3);
  EXPECT_EQ(study["systems"][0]["options"]["grains.count"], 400);
  EXPECT_EQ(study["systems"][0]["options"]["speed"], 2.5e-5);
}

TEST_F(ReportBlocks, FramesAreOrderedByPackingFraction) {
  const Json frames = frames_block(open_results(folder()));
  const auto rho = frames["systems"][1]["rho"].get<std::vector<double>>();
  EXPECT_TRUE(std::is_sorted(rho.begin(), rho.end()));
  EXPECT_EQ(std::adjacent_find(rho.begin(), rho.end()), rho.end());
  for (const auto& [name, estimate] : frames["systems"][1]["quantities"].items()) {
    EXPECT_EQ(estimate["mean"].size(), rho.size()) << name;
    EXPECT_EQ(estimate["se"].size(), rho.size()) << name;
  }
}

TEST_F(ReportBlocks, DistributionsAreThoseOfTheChosenFrames) {
  const Json forces = many_block(open_results(folder()), many_choices()[0]);
  std::vector<double> rho;
  for (const Json& frame : forces["systems"][0]["frames"]) rho.push_back(frame["rho"]);
  EXPECT_EQ(rho, (std::vector<double>{0.76, 0.78, 0.8, 0.82, 0.84, 0.86, 0.88, 0.9}));
  const Json pairs = many_block(open_results(folder()), many_choices()[1]);
  ASSERT_EQ(pairs["systems"][0]["frames"].size(), 1u);
  EXPECT_EQ(pairs["systems"][0]["frames"][0]["rho"], 0.9);
}

TEST_F(ReportBlocks, PicturesComeFromStoredFrames) {
  const auto sources = choose_pictures(open_results(folder()));
  const Json networks = networks_block(sources, {});
  ASSERT_EQ(networks["systems"].size(), 3u);
  // ten multiples of .02, and the frame above rho_c = .861
  EXPECT_EQ(networks["systems"][0].size(), 11u);
  const Json& last = networks["systems"][0].back();
  EXPECT_EQ(last["rho"], 0.9);
  EXPECT_EQ(last["grains"], 400);
  EXPECT_GT(last["contacts"], 400);
  const Json diagrams = diagrams_block(sources, {});
  EXPECT_EQ(diagrams["systems"][0].back()["dimensions"][0]["pairs"], 200);
  EXPECT_EQ(diagrams["systems"][0].back()["dimensions"][1]["pairs"], 100);
}

TEST_F(ReportBlocks, ThePicturesAskedForAreTaken) {
  Results results = open_results(folder());
  results.study.report.pictures = {0.81, 0.9};
  const auto sources = choose_pictures(results);
  ASSERT_EQ(sources[0].frames.size(), 3u);
  EXPECT_NEAR(sources[0].frames[0].rho, 0.81, 1e-9);
  EXPECT_FALSE(sources[0].frames[0].own);
  EXPECT_NEAR(sources[0].frames[1].rho, 0.87, 1e-9);  // the first above rho_c = .861
  EXPECT_TRUE(sources[0].frames[1].own);
}

TEST_F(ReportBlocks, WhatIsMissingIsNull) {
  const fs::path other = folder() / "bare";
  write_fixture(other, {.ensemble = false, .tasks = false, .transitions = false});
  const Results results = open_results(other);
  EXPECT_TRUE(frames_block(results).is_null());
  EXPECT_TRUE(transitions_block(results).is_null());
  EXPECT_TRUE(score_block(results).is_null());
  EXPECT_TRUE(many_block(results, many_choices()[0]).is_null());
  EXPECT_TRUE(networks_block(choose_pictures(results), {}).is_null());
  EXPECT_FALSE(study_block(results).is_null());
}

TEST_F(ReportBlocks, PublishedValuesStandBesideOurs) {
  const fs::path scored = folder() / "scored";
  write_fixture(scored);
  Results results = open_results(scored);
  EXPECT_TRUE(score_block(results).is_null());  // a study that names no targets
  results.study.info.targets = "kramar2013";
  for (const PictureSource& source : choose_pictures(results))
    measure_task(source.folder, chosen_measures(results.study), results.study.measure);
  const Json score = score_block(results);
  EXPECT_EQ(score["published"], (Json{{{"system", 0}, {"value", 0.8615}},
                                      {{"system", 1}, {"value", 0.814}},
                                      {{"system", 2}, {"value", 0.7884}}}));
  ASSERT_FALSE(score["rows"].empty());
  for (const Json& row : score["rows"]) EXPECT_EQ(row["verdict"], "insufficient") << row;  // one run each
}

TEST_F(ReportBlocks, TheSameResultsGiveTheSamePage) {
  write_report(folder());
  const std::string first = read_text(folder() / "report.html");
  fs::remove(folder() / "report.html");
  write_report(folder());
  EXPECT_EQ(read_text(folder() / "report.html"), first);
  EXPECT_EQ(first.find("data-conzelmann"), std::string::npos);  // discs have no shapes
}

TEST_F(ReportBlocks, AFolderWithoutAStudyIsNamed) {
  const fs::path empty = folder() / "empty";
  fs::create_directories(empty);
  try {
    write_report(empty);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), empty.string());
    EXPECT_FALSE(error.suggestion().empty());
  }
  EXPECT_FALSE(fs::exists(empty / "report.html"));
}

}  // namespace
}  // namespace jam
