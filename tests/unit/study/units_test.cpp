// [units] in a study file. Numbers: the table of theory sec. 2.2.
#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/study.hpp"
#include "small_study.hpp"
#include "jamscape/study/targets.hpp"

namespace jam {
namespace {

constexpr const char* hydrogel = R"([study]
name = "u"
[units]
length = "1.735 cm"
mass = "3.0 g"
young = "23.45 kPa"
poisson = 0.5
speed = "0.01 cm/s"
[[stage]]
name = "compress"
to = 0.7
speed = "0.01 cm/s"
[[system]]
name = "lin"
[[system]]
name = "hertz"
contact.law = "hertz"
[[system]]
name = "mean"
contact.law = "hertz"
units.reduced_mass = "mean"
)";

Study read(const std::string& text, const std::vector<Setting>& settings = {}) {
  return read_study_text(text, "u.toml", settings);
}

std::string complaint(const std::string& text, const std::vector<Setting>& settings = {}) {
  return complaint_about(text, "u.toml", settings);
}

TEST(StudyUnits, EachSystemHasItsCollisionTime) {
  const Study s = read(hydrogel);
  ASSERT_EQ(s.systems.size(), 3u);
  EXPECT_NEAR(s.systems[0].scales.time, 6.398e-3, 1e-6);
  EXPECT_NEAR(s.systems[1].scales.time, 63.47e-3, 1e-5);
  EXPECT_NEAR(s.systems[2].scales.time, 83.75e-3, 1e-5);
  EXPECT_EQ(s.systems[0].scales.length, 0.01735);
  EXPECT_EQ(s.systems[0].scales.mass, 0.003);
}

TEST(StudyUnits, StiffnessAndSpeedsFollow) {
  const Study s = read(hydrogel);
  const double stiffness[] = {4.9348, 485.65, 845.6}, speed[] = {3.69e-5, 3.66e-4, 4.83e-4};
  for (std::size_t k = 0; k < 3; ++k) {
    const SystemOptions& o = s.systems[k].options;
    EXPECT_NEAR(o.contact.stiffness, stiffness[k], 1e-4 * stiffness[k]) << k;
    EXPECT_NEAR(o.contact.impact_speed, speed[k], 2e-3 * speed[k]) << k;
    EXPECT_EQ(o.stages.at(0).speed, o.contact.impact_speed) << "both are v0";
  }
}

TEST(StudyUnits, WhatAStudySetsItselfStays) {
  const Study s = read(hydrogel, {{"contact.stiffness", "7"}, {"contact.impact_speed", "\"1 d/tau_c\""}});
  EXPECT_EQ(s.systems[1].options.contact.stiffness, 7);
  EXPECT_EQ(s.systems[1].options.contact.impact_speed, 1);
  const Study t = read(hydrogel, {{"system.hertz.contact.stiffness", "\"2746 N/m^1.5\""}});
  EXPECT_NEAR(t.systems[1].options.contact.stiffness, 485.65, 0.1);
  const Study u = read(hydrogel, {{"system.lin.stage.compress.speed", "0.25"}});
  EXPECT_EQ(u.systems[0].options.stages.at(0).speed, 0.25) << "a bare number is a scaled one";
}

TEST(StudyUnits, ATimeOfItsOwnNeedsNoMaterial) {
  const Study s = read(
      "[study]\nname = \"u\"\n[units]\nlength = \"1 mm\"\nmass = 1e-6\ntime = \"2 ms\"\n[[stage]]\n"
      "to = 0.7\nspeed = \"1 mm/s\"\n");
  EXPECT_EQ(s.systems.at(0).options.stages.at(0).speed, 2e-3);
  EXPECT_EQ(s.systems[0].options.contact.stiffness, ContactOptions{}.stiffness);
}

TEST(StudyUnits, TheResolvedStudyShowsScaledNumbersAndTheScales) {
  const Study s = read(hydrogel);
  const std::string text = print_study(s);
  EXPECT_NE(text.find("[units]\nlength = 0.01735\nmass = 0.003\nyoung = 23450.0\nspeed = 0.0001\n"), std::string::npos);
  EXPECT_NE(text.find("tau_c = 0.0063"), std::string::npos);
  EXPECT_NE(text.find("units.reduced_mass = \"mean\""), std::string::npos);
  EXPECT_EQ(text.find("cm/s"), std::string::npos);
  const Study again = read(text);
  EXPECT_EQ(print_study(again), text);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(physics_text(again.systems.at(k).options), physics_text(s.systems[k].options));
    EXPECT_EQ(again.systems[k].scales.time, s.systems[k].scales.time);
  }
}

TEST(StudyUnits, UnitsSweepLikeOtherOptions) {
  const Study s = read(
      "[study]\nname = \"u\"\n[units]\nlength = 1.0\nmass = 1.0\nyoung = 1.0\nspeed = 1.0\n[[stage]]\nto = 0.7\n"
      "[sweep]\nunits.reduced_mass = [\"half\", \"mean\"]\n");
  ASSERT_EQ(s.systems.size(), 2u);
  EXPECT_EQ(s.systems[1].name, "reduced_mass=mean");
  EXPECT_NEAR(s.systems[1].options.contact.stiffness, 2 * s.systems[0].options.contact.stiffness, 1e-9);
}

TEST(StudyUnits, MistakesHavePlaces) {
  const std::string text = hydrogel;
  const auto without = [&](const std::string& line) {
    std::string t = text;
    t.erase(t.find(line), line.size() + 1);
    return complaint(t);
  };
  EXPECT_NE(without("length = \"1.735 cm\"").find("u.toml:4:1 | the group [units] has no 'length'"), std::string::npos);
  EXPECT_NE(without("mass = \"3.0 g\"").find("mass = \"3.0 g\" below [units]"), std::string::npos);
  EXPECT_NE(without("speed = \"0.01 cm/s\"").find("has no 'speed'"), std::string::npos) << "Hertz needs it";
  EXPECT_NE(without("young = \"23.45 kPa\"").find("has no 'young'"), std::string::npos);
  EXPECT_NE(complaint(text + "contact.stiffness = \"1 N/m\"\n").find("u.toml:22:"), std::string::npos);
  EXPECT_NE(complaint(text + "contact.stiffness = \"1 N/m\"\n").find("kg/(m^0.5 s^2)"), std::string::npos)
      << "of the Hertz law";
  EXPECT_NE(complaint(text, {{"units.young", "\"23 kPas\""}}).find("did you mean 'kPa'?"), std::string::npos);
  EXPECT_NE(complaint(text, {{"units.yung", "1"}}).find("did you mean 'units.young'?"), std::string::npos);
  EXPECT_NE(complaint(text, {{"units.poisson", "0.7"}}).find("out of range"), std::string::npos);
}

}  // namespace
}  // namespace jam
