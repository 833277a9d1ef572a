#include "jamscape/study/builtin.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {
namespace {

TEST(BuiltinStudies, AreThereAndCanBe) {
  const std::vector<std::string_view> names = builtin_studies();
  for (const char* name : {"quickstart", "kramar2013", "kramar2013-mu0-rp0", "kramar2013-mu0.5-rp0.4"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  for (const std::string_view name : names) {
    const std::string file = std::string(name) + ".toml";
    const Study study = read_study_text(builtin_file(file), file);
    EXPECT_EQ(study.info.name, name);
    EXPECT_FALSE(study.info.title.empty()) << name;
    EXPECT_FALSE(list_tasks(study).empty()) << name;
  }
}

// S1 Sec. II.A, App. A: what the study must be to be called that.
TEST(BuiltinStudies, Kramar2013IsThePapersSystem) {
  const Study s = read_study_text(builtin_file("kramar2013.toml"), "kramar2013.toml");
  ASSERT_EQ(s.systems.size(), 6u);
  EXPECT_EQ(s.info.realisations, 20);
  for (const System& system : s.systems) {
    EXPECT_EQ(system.options.grains.count, 45 * 45);
    EXPECT_EQ(system.options.integrator.scheme, Scheme::gear5);
    EXPECT_EQ(system.options.integrator.step, 0.02);
    EXPECT_EQ(system.options.stages.back().speed, 2.5e-5);
    EXPECT_EQ(system.options.stages.back().to, 0.9);
    EXPECT_EQ(system.options.contact.restitution, 0.5);
    EXPECT_EQ(system.options.domain.walls, WallModel::beads);
  }
  const std::vector<Task> tasks = list_tasks(s);
  EXPECT_EQ(tasks.size(), 120u);
  EXPECT_EQ(tasks.front().plan.frames.size(), 112u) << "100 frames and the multiples of .02";
}

TEST(BuiltinStudies, TheVariantsShareTheirRunsWithTheWhole) {
  const Study whole = read_study_text(builtin_file("kramar2013.toml"), "whole");
  const std::vector<Task> all = list_tasks(whole);
  for (const System& system : whole.systems) {
    const std::string file = "kramar2013-" + system.name + ".toml";
    const Study one = read_study_text(builtin_file(file), file);
    const std::string hash = list_tasks(one).front().hash;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Task& t) { return t.hash == hash; })) << file;
  }
}

}  // namespace
}  // namespace jam
