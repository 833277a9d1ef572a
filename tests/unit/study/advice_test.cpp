#include "jamscape/study/advice.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

std::vector<std::string> said(const std::string& more) {
  const Study study = read_study_text(
      "[study]\nname = \"a\"\nrealisations = 3\n[grains]\ncount = 100\n[start]\npacking_fraction = 0.5\n[[stage]]\nname "
      "= \"compress\"\nto = 0.8\nspeed = 1e-3\nframes = 4\n",
      "a.toml", {read_setting(more)});
  return advice(study, plan_tasks(study));
}

void expect(const std::string& setting, const std::string& words) {
  const std::vector<std::string> all = said(setting);
  ASSERT_EQ(all.size(), 1u) << setting;
  EXPECT_NE(all[0].find(words), std::string::npos) << all[0];
}

TEST(Advice, SaysWithTheNumberThatWouldDo) {
  EXPECT_TRUE(said("study.seed=2").empty());
  expect("start.packing_fraction=0.7", "closed to 0.7 by itself");
  expect("contact.stiffness=1e6", "integrator.step = 4e-05 would");  // pi sqrt(m/2/k)/50, m = .64 of the smallest grain
  expect("stage.compress.frames=0", "one is taken at the end");
}

TEST(Advice, SaysWhatTheNominalAreaHides) {
  const std::vector<std::string> all = said("grains.width=1.5");  // <d^2> = 1 + 1.5^2/12
  const auto found = [&](const std::string& words) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& s) { return s.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(found("1.19 times as much: 0.8 is truly 0.95"));
}

}  // namespace
}  // namespace jam
