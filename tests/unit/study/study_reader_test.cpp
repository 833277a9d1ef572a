// What a person gets wrong in a study file, and what the program says then.
#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "jamscape/study/study.hpp"
#include "small_study.hpp"

namespace jam {
namespace {

Study read(std::string_view text, const std::vector<Setting>& settings = {}) {
  return read_study_text(text, "s.toml", settings);
}

std::string complaint(const std::string& text, const std::vector<Setting>& settings = {}) {
  return complaint_about(text, "s.toml", settings);
}

/// One more system, from line 26 on.
std::string with(const std::string& more) { return std::string(small_study) + "[[system]]\nname = \"new\"\n" + more; }

TEST(StudyReader, ReadsSystemsWithTheirOverrides) {
  const Study s = read(small_study);
  EXPECT_EQ(s.info.name, "small");
  EXPECT_EQ(s.info.seed, 5);
  ASSERT_EQ(s.systems.size(), 2u);
  EXPECT_EQ(s.systems[0].name, "smooth");
  EXPECT_EQ(s.systems[0].options.contact.friction, 0);
  EXPECT_EQ(s.systems[1].options.contact.friction, 0.5);
  EXPECT_EQ(s.systems[1].options.grains.count, 100);
  EXPECT_EQ(s.systems[0].options.stages.at(0).speed, 1e-3);
  EXPECT_EQ(s.systems[1].options.stages.at(0).speed, 2e-3);
}

TEST(StudyReader, AStudyWithoutSystemsIsOne) {
  const Study s = read("[study]\nname = \"one\"\n[[stage]]\nto = 0.7\n");
  ASSERT_EQ(s.systems.size(), 1u);
  EXPECT_EQ(s.systems[0].name, "one");
  EXPECT_EQ(s.systems[0].options.stages.at(0).name, "compress-1");
}

TEST(StudyReader, SweepsGiveEveryCombination) {
  const Study s = read(
      "[study]\nname = \"w\"\n[[stage]]\nto = 0.7\n[sweep]\ngrains.width = [0.1, 0.2]\ncontact.friction = [0, 0.5]\n");
  std::vector<std::string> names;
  for (const System& system : s.systems) names.push_back(system.name);
  EXPECT_EQ(names, (std::vector<std::string>{"width=0.1_friction=0", "width=0.1_friction=0.5", "width=0.2_friction=0",
                                             "width=0.2_friction=0.5"}));
  EXPECT_EQ(s.systems[2].options.grains.width, 0.2);
  EXPECT_EQ(varied_options(s), (std::vector<std::string>{"grains.width", "contact.friction"}));
}

TEST(StudyReader, SweepsMultiplyNamedSystems) {
  const Study s = read(std::string(small_study) + "[sweep]\nstage.compress.to = [0.75, 0.8]\n");
  ASSERT_EQ(s.systems.size(), 4u);
  EXPECT_EQ(s.systems[3].name, "rough_to=0.8");
  EXPECT_EQ(s.systems[2].options.stages[0].to, 0.75);
}

TEST(StudyReader, AValueGivenTwiceIsSaid) {
  EXPECT_EQ(complaint("[study]\nname = \"zero\"\n[[stage]]\nto = 0.7\n[sweep]\ncontact.friction = [0.0, -0.0]\n"),
            "s.toml:6:26 | 'sweep.contact.friction' has the value 0 twice | each value once");
}

TEST(StudyReader, SymbolsOfTheTradeAreUnderstood) {
  const auto hint = [](const std::string& line) {
    const std::string text = complaint("[study]\nname = \"a\"\n[[stage]]\nto = 0.7\n" + line);
    return text.substr(text.rfind('|') + 2);
  };
  EXPECT_EQ(hint("[contact]\nmu = 0.5\n"), "did you mean 'contact.friction'?");
  EXPECT_EQ(hint("[grains]\nmu = 0.5\n"), "did you mean 'contact.friction'?");
  EXPECT_EQ(hint("[contact]\ne = 0.5\n"), "did you mean 'contact.restitution'?");
  EXPECT_EQ(hint("[integrator]\ndt = 0.5\n"), "did you mean 'integrator.step'?");
  EXPECT_EQ(hint("[grains]\nn = 5\n"), "did you mean 'grains.count'?");
  EXPECT_EQ(hint("[grains]\nr_p = 0.5\n"), "did you mean 'grains.width'?");
}

TEST(StudyReader, MeasuresAskedForByNameAreTakenAtEveryFrame) {
  const std::string stage = "[study]\nname = \"a\"\n[[stage]]\nto = 0.7\n";
  EXPECT_EQ(read(stage).measure.rows_every, 0.02);
  EXPECT_EQ(read(stage + "[measure]\nlist = [\"force_distribution\"]\n").measure.rows_every, 0);
  EXPECT_EQ(read(stage + "[measure]\nlist = [\"force_distribution\"]\nrows_every = 0.1\n").measure.rows_every, 0.1);
}

TEST(StudyReader, UnknownKeysPointAtThemselves) {
  EXPECT_EQ(complaint("[study]\nname = \"a\"\n[contact]\nfrction = 1\n"),
            "s.toml:4:1 | unknown key 'contact.frction' | did you mean 'contact.friction'?");
  EXPECT_EQ(complaint("[studdy]\nname = \"a\"\n"), "s.toml:1:2 | unknown key 'studdy' | did you mean 'study'?");
  EXPECT_NE(
      complaint("[study]\nname = \"a\"\n[[stage]]\nspeeed = 1e-3\n").find("s.toml:4:1 | unknown key 'stage.speeed'"),
      std::string::npos);
  EXPECT_NE(complaint(with("grain.width = 0.1\n")).find("did you mean 'grains.width'?"), std::string::npos);
  EXPECT_NE(complaint(with("stage.compres.speed = 0.1\n")).find("did you mean 'stage.compress.speed'?"),
            std::string::npos);
}

TEST(StudyReader, WrongTypesUnitsAndRanges) {
  EXPECT_NE(complaint(with("grains.count = 2.5\n")).find("an integer is expected"), std::string::npos);
  const std::string range = complaint(with("contact.friction = -1\n"));
  EXPECT_EQ(range.find("s.toml:26:20 | 'contact.friction' = -1.0 is out of range: it must be at least 0"), 0u) << range;
  EXPECT_NE(complaint(with("stage.compress.speed = \"1 cm/s\"\n")).find("scaled units"), std::string::npos);
  EXPECT_NE(complaint(with("domain.walls = \"beeds\"\n")).find("domain.walls = \"beads\""), std::string::npos);
  EXPECT_NE(complaint("study = 3\n").find("'study' must be a table"), std::string::npos);
  EXPECT_NE(complaint("[study]\nname = \"a\"\n[stage]\nto = 1\n").find("[[stage]]"), std::string::npos);
}

TEST(StudyReader, OptionsOfMeasuresThatDoNotGoTogether) {
  EXPECT_EQ(complaint(with("[measure]\nforce_min = 0\n")).find("s.toml:"), 0u);
  EXPECT_NE(complaint(with("[measure]\nforce_min = 0\n")).find("logarithmic bins"), std::string::npos);
  EXPECT_NE(complaint(with("[measure]\nlevel_max = 1e6\n")).find("too many"), std::string::npos);
  EXPECT_NO_THROW(read(with("[measure]\nforce_min = 0\nforce_scale = \"linear\"\n")));
}

TEST(StudyReader, RepeatedKeysAndBrokenSyntax) {
  EXPECT_EQ(complaint("[study]\nname = \"a\"\nname = \"b\"\n").substr(0, 9), "s.toml:3:");
  EXPECT_EQ(complaint("[study\n").substr(0, 9), "s.toml:1:");
}

TEST(StudyReader, NamesMustBeThereAndDiffer) {
  EXPECT_NE(complaint("[[stage]]\nto = 0.7\n").find("has no name"), std::string::npos);
  EXPECT_NE(complaint("[study]\nname = \"../up\"\n[[stage]]\nto = 0.7\n").find("cannot be the name"),
            std::string::npos);
  EXPECT_NE(complaint(with("[[system]]\nname = \"rough\"\n")).find("two systems are named 'rough'"), std::string::npos);
  EXPECT_NE(complaint(with("[[system]]\ncontact.friction = 1\n")).find("a system has no name"), std::string::npos);
  EXPECT_NE(complaint("[study]\nname = \"a\"\n").find("has no stages"), std::string::npos);
  EXPECT_NE(complaint("[study]\nname = \"a\"\n[[stage]]\nname = \"x\"\n[[stage]]\nname = \"x\"\n").find("two stages"),
            std::string::npos);
}

TEST(StudyReader, SettingsFromTheCommandLine) {
  const Study s = read(small_study, {{"study.realisations", "7"},
                                     {"stage.compress.to", "0.75"},
                                     {"domain.walls", "flat"},
                                     {"system.rough.contact.friction", "0.3"},
                                     {"measure.list", "[\"coordination\"]"}});
  EXPECT_EQ(s.info.realisations, 7);
  EXPECT_EQ(s.systems[1].options.stages[0].to, 0.75);
  EXPECT_EQ(s.systems[0].options.domain.walls, WallModel::flat);
  EXPECT_EQ(s.systems[1].options.contact.friction, 0.3);
  EXPECT_EQ(s.measures.list, (std::vector<std::string>{"coordination"}));
}

TEST(StudyReader, SettingsWithoutEffectAreRefused) {
  EXPECT_NE(complaint(std::string(small_study), {{"contact.friction", "0.3"}}).find("would have no effect"),
            std::string::npos);
  EXPECT_NE(complaint(std::string(small_study), {{"system.rogh.contact.friction", "0.3"}}).find("smooth, rough"),
            std::string::npos);
  EXPECT_NE(complaint(std::string(small_study), {{"grains.cuont", "3"}}).find("--set grains.cuont=3 | unknown key"),
            std::string::npos);
  EXPECT_THROW(read_setting("contact.friction"), Error);
  EXPECT_THROW(read_setting("=3"), Error);
}

TEST(StudyReader, AMissingFileIsAMistakeOfTheCommandLine) {
  try {
    read_study("no/such/file.toml");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
  }
}

}  // namespace
}  // namespace jam
