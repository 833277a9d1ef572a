#include "jamscape/study/study.hpp"

#include <gtest/gtest.h>

#include <set>

#include "jamscape/base/error.hpp"
#include "jamscape/study/identity.hpp"
#include "small_study.hpp"

namespace jam {
namespace {

TEST(PrintStudy, ReadsBackToTheSame) {
  const Study s = read_study_text(small_study, "s.toml");
  const std::string printed = print_study(s);
  const Study again = read_study_text(printed, "printed");
  EXPECT_EQ(print_study(again), printed);
  ASSERT_EQ(again.systems.size(), s.systems.size());
  for (std::size_t k = 0; k < s.systems.size(); ++k) {
    EXPECT_EQ(again.systems[k].name, s.systems[k].name);
    EXPECT_EQ(physics_text(again.systems[k].options), physics_text(s.systems[k].options));
  }
}

TEST(PrintStudy, KeepsSystemsWithStagesOfTheirOwn) {
  const Study s =
      read_study_text(std::string(small_study) +
                          "[[system]]\nname = \"two\"\ngrains.width = 0.3\n[[system.stage]]\nname = \"a\"\nto = "
                          "0.7\n[[system.stage]]\nname = \"b\"\nto = 0.9\nframes_at = [0.85]\n",
                      "s.toml");
  const Study again = read_study_text(print_study(s), "printed");
  ASSERT_EQ(again.systems.at(2).options.stages.size(), 2u);
  EXPECT_EQ(again.systems[2].options.stages[1].frames_at, (std::vector<double>{0.85}));
  EXPECT_EQ(again.systems[2].options.grains.width, 0.3);
}

TEST(PrintStudy, AStageMayBeNamelessButNotRenamed) {
  const std::string text = "[study]\nname = \"w\"\n[[stage]]\nname = \"\"\nto = 0.7\n";
  EXPECT_EQ(read_study_text(text, "s.toml").systems.at(0).options.stages.at(0).name, "compress-1");
  EXPECT_THROW(read_study_text(text, "s.toml", {{"stage.compress-1.name", "other"}}), Error);
}

TEST(PrintStudy, ResolvesSweeps) {
  const Study s =
      read_study_text("[study]\nname = \"w\"\n[[stage]]\nto = 0.7\n[sweep]\ngrains.width = [0.1, 0.2]\n", "s.toml");
  const Study again = read_study_text(print_study(s), "printed");
  ASSERT_EQ(again.systems.size(), 2u);
  EXPECT_EQ(again.systems[1].name, "width=0.2");
  EXPECT_EQ(again.systems[1].options.grains.width, 0.2);
}

TEST(VariedOptions, LeaveOutNamesAndFrames) {
  const Study s = read_study_text(small_study, "s.toml", {{"system.rough.stage.compress.frames", "9"}});
  EXPECT_EQ(varied_options(s), (std::vector<std::string>{"contact.friction", "stage.compress.speed"}));
}

TEST(KnownOptions, EveryOneSaysWhatItIs) {
  std::set<std::string> keys;
  for (const KnownOption& o : known_options()) {
    EXPECT_FALSE(o.meta.text.empty()) << o.key;
    EXPECT_TRUE(keys.insert(o.key).second) << o.key << " twice";
  }
  EXPECT_TRUE(keys.contains("grains.width") && keys.contains("stage.speed") && keys.contains("measure.clamp"));
}

}  // namespace
}  // namespace jam
