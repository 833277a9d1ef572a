#include "jamscape/study/transitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jamscape/study/states.hpp"
#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

/// Three runs of a Z that jumps like a logistic at .80, .81 and .82, and a plain packing fraction .01 higher.
FrameSeries jumping() {
  FrameSeries s;
  s.quantity = {"packing_fraction_plain", "z"};
  s.value.resize(2);
  s.realisations = 3;
  for (int k = 0; k <= 100; ++k) s.target.push_back(0.7 + 0.002 * k), s.kinds.push_back({"compress", 0.7 + 0.002 * k});
  for (const double jump : {0.80, 0.81, 0.82}) {
    std::vector<double> z, plain;
    for (const double x : s.target) {
      z.push_back(6 / (1 + std::exp(-(x - jump) / 0.004)));
      plain.push_back(x + 0.01);
    }
    s.value[0].push_back(plain);
    s.value[1].push_back(z);
  }
  return s;
}

const Transition& get(const std::vector<Transition>& all, std::string_view name) {
  for (const Transition& t : all)
    if (t.quantity == name) return t;
  throw std::logic_error("no such transition");
}

TEST(Transitions, FindTheJumpByEveryReading) {
  const std::vector<Transition> t = find_jamming(jumping(), {}, 1, "key");
  EXPECT_EQ(get(t, "rho_c").n, 3u);
  EXPECT_NEAR(get(t, "rho_c").value, 0.81, 1e-4) << "the mean of three jumps crosses 3 in the middle one";
  EXPECT_NEAR(get(t, "rho_c_single").value, 0.81, 1e-4);
  EXPECT_NEAR(get(t, "rho_c_single").se, 0.01 / std::sqrt(3), 1e-4);
  EXPECT_NEAR(get(t, "rho_c_plain").value, 0.82, 1e-4);
  EXPECT_NEAR(get(t, "rho_inflection").value, 0.81, 2e-3);
  EXPECT_GT(get(t, "rho_c").se, 0);
}

TEST(Transitions, AreTheSameEveryTime) {
  const std::vector<Transition> a = find_jamming(jumping(), {}, 1, "key"), b = find_jamming(jumping(), {}, 1, "key");
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].value, b[k].value) << a[k].quantity;
    EXPECT_EQ(a[k].se, b[k].se) << a[k].quantity;
  }
}

TEST(Transitions, AFrameGivenTwiceDoesNoHarm) {
  FrameSeries s = jumping();
  s.target.insert(s.target.begin() + 50, s.target[50]);
  s.kinds.insert(s.kinds.begin() + 50, s.kinds[50]);
  for (auto& quantity : s.value)
    for (auto& run : quantity) run.insert(run.begin() + 50, run[50]);
  EXPECT_EQ(get(find_jamming(s, {}, 1, "key"), "rho_c").value,
            get(find_jamming(jumping(), {}, 1, "key"), "rho_c").value);
}

TEST(Transitions, NoneBelowJammingAndWithoutZ) {
  FrameSeries s = jumping();
  for (auto& run : s.value[1])
    for (double& z : run) z = std::min(z, 2.0);
  EXPECT_TRUE(std::isnan(get(find_jamming(s, {}, 1, "key"), "rho_c").value));
  s.quantity[1] = "other";
  EXPECT_TRUE(find_jamming(s, {}, 1, "key").empty());
}

/// The same runs, with a frame before every relaxation in which nothing touches, and a Z without rattlers 1 higher.
FrameSeries relaxed() {
  const FrameSeries dense = jumping();
  FrameSeries s;
  s.quantity = {"packing_fraction_plain", "z", "z_backbone", "percolates"};
  s.realisations = 3;
  s.value.assign(4, std::vector<std::vector<double>>(3));
  for (std::size_t k = 0; k < dense.target.size(); k += 5)
    for (const bool rest : {false, true}) {
      s.target.push_back(dense.target[k]);
      s.kinds.push_back({"steps", dense.target[k], rest});
      for (std::size_t r = 0; r < 3; ++r) {
        const double z = dense.value[1][r][k];
        s.value[0][r].push_back(dense.value[0][r][k]);
        s.value[1][r].push_back(rest ? z : 0);
        s.value[2][r].push_back(rest ? z + 1 : 0);
        s.value[3][r].push_back(rest && z > 3 ? 1 : 0);
      }
    }
  return s;
}

TEST(Transitions, OfRelaxedStatesAreS2s) {
  const std::vector<Transition> t = find_jamming(relaxed(), {}, 1, "key");
  EXPECT_NEAR(get(t, "rho_c").value, 0.81, 1e-3) << "frames that are not relaxed do not count";
  EXPECT_NEAR(get(t, "rho_j").value, 0.81, 2e-3);
  EXPECT_GT(get(t, "rho_j").se, 0.001);
  EXPECT_NEAR(get(t, "z_at_rho_j").value, 3, 0.1) << "half way up";
  EXPECT_NEAR(get(t, "z_backbone_at_rho_j").value, 4, 0.1);
  EXPECT_NEAR(get(t, "rho_j_backbone").value, get(t, "rho_j").value, 1e-9);
  const double above = get(t, "z_above").value;
  EXPECT_GT(above, 2.9);
  EXPECT_LT(above, 5.5);
  EXPECT_NEAR(get(t, "z_backbone_above").value, above + 1, 1e-9);
  EXPECT_NEAR(get(t, "rho_p").value, 0.81, 0.011) << "first states with more than 3";
  EXPECT_EQ(get(t, "rho_p").n, 3u);
}

// A stage that relaxes at the end of a compression adds its state to the curve; it was the whole curve once.
TEST(Transitions, ARelaxationAtTheEndLeavesThoseOfTheCompression) {
  FrameSeries s = jumping();
  s.target.push_back(s.target.back()), s.kinds.push_back({"rest", s.target.back(), true});
  for (auto& quantity : s.value)
    for (auto& run : quantity) run.push_back(run.back());
  const std::vector<Transition> t = find_jamming(s, {}, 1, "key"), before = find_jamming(jumping(), {}, 1, "key");
  ASSERT_EQ(t.size(), before.size());
  for (std::size_t k = 0; k < t.size(); ++k) EXPECT_EQ(t[k].value, before[k].value) << t[k].quantity;
  EXPECT_FALSE(s.relaxed());
}

TEST(States, AreRelaxedOnesUnlessACompressionHasMore) {
  using Frames = std::vector<FrameKind>;
  const auto of = [](const Frames& f) { return find_states(f).frames; };
  using Indices = std::vector<std::size_t>;
  const FrameKind a{"compress", 0.7, false}, b{"compress", 0.8, false}, c{"compress", 0.9, false};
  EXPECT_EQ(of({a, b, c}), (Indices{0, 1, 2}));
  EXPECT_EQ(of({a, b, c, {"rest", 0.9, true}}), (Indices{0, 1, 2})) << "the same packing fraction";
  EXPECT_EQ(of({a, b, c, {"rest", 0.91, true}}), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(of({{"rest", 0.6, true}, a, b, c}), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(of({{"steps", 0.8, false}, {"steps", 0.8, true}, {"steps", 0.9, false}, {"steps", 0.9, true}}),
            (Indices{1, 3}));
  EXPECT_EQ(of({a, b, {"steps", 0.82, true}, {"steps", 0.84, true}, {"steps", 0.86, true}}), (Indices{2, 3, 4}));
  EXPECT_EQ(of({{"settle", 0.5, false}, {"press", 0.6, false}, {"relax", 0.6, true}}), (Indices{2}));
  EXPECT_EQ(of({{"settle", 0.5, false}, {"press", 0.6, false}}), (Indices{0, 1}));
}

// Frames whose ledger is off enter no mean: here the last one, of a single run.
TEST(Transitions, LeaveFramesOutThatARunHasMarked) {
  FrameSeries s = jumping();
  s.left_out.assign(s.target.size(), false);
  for (std::size_t k = 60; k < s.target.size(); ++k) {  // from .82 on
    s.left_out[k] = true;
    for (auto& curves : s.value)
      for (auto& run : curves) run[k] = k < 80 ? 0 : 6;  // would put the last crossing there
  }
  EXPECT_NEAR(get(find_jamming(s, {}, 1, "key"), "rho_c").value, 0.81, 1e-4);
  const std::size_t marked = s.target.size() - 60;
  s.left_out.assign(s.target.size(), false);
  for (std::size_t k = 40; k < s.target.size(); ++k) s.left_out[k] = true;  // all jammed ones
  const Transition none_left = get(find_jamming(s, {}, 1, "key"), "rho_c");
  EXPECT_TRUE(std::isnan(none_left.value));
  EXPECT_EQ(none_left.left_out, marked + 20);
  EXPECT_NE(why_missing(none_left).find("marked"), std::string::npos) << why_missing(none_left);
  s.left_out.assign(s.target.size(), true);
  EXPECT_TRUE(find_jamming(s, {}, 1, "key").empty());
}

TEST(Transitions, ARunThatNeverPercolatesHasNoOnset) {
  FrameSeries s = relaxed();
  for (double& p : s.value[3][1]) p = 0;
  EXPECT_EQ(get(find_jamming(s, {}, 1, "key"), "rho_p").n, 2u);
  s.value[3][0].back() = 0;
  EXPECT_EQ(get(find_jamming(s, {}, 1, "key"), "rho_p").n, 1u) << "it must last to the end";
}

/// Runs that jam at .80, .81, .82: z rises by a line to 6 at .05 above, pressure like (rho - rho_J)^power.
FrameSeries pressing(double power) {
  FrameSeries s;
  s.quantity = {"z", "pressure"};
  s.value.resize(2);
  s.realisations = 3;
  for (int k = 0; k <= 100; ++k) s.target.push_back(0.7 + 0.002 * k), s.kinds.push_back({"compress", 0.7 + 0.002 * k});
  for (const double jam : {0.80, 0.81, 0.82}) {
    std::vector<double> z, p;
    for (const double x : s.target) {
      z.push_back(x < jam ? 0 : 3 + 60 * (x - jam));
      p.push_back(x < jam ? 1e-7 : 1e-5 + 2 * std::pow(x - jam, power));
    }
    s.value[0].push_back(z), s.value[1].push_back(p);
  }
  return s;
}

TEST(Transitions, AtAChosenContactNumberAndByTheOnsetOfPressure) {
  FrameSeries one = pressing(1);
  one.realisations = 1;
  for (auto& quantity : one.value) quantity.resize(1);
  const std::vector<Transition> t = find_jamming(one, {4.5, 1e-3, 1}, 1, "key");
  EXPECT_NEAR(get(t, "rho_z").value, 0.80 + 1.5 / 60, 1e-9);
  EXPECT_NEAR(get(t, "rho_pressure").value, 0.8005, 1e-5) << "2 (rho - .8) = .001, but for the 1e-5 added";
  EXPECT_NEAR(get(t, "rho_pressure_zero").value, 0.8, 1e-5);
  EXPECT_TRUE(std::isnan(get(t, "rho_pressure").se)) << "one run has no error";
  const std::vector<Transition> three = find_jamming(pressing(1), {4.5, 1e-3, 1}, 1, "key");
  EXPECT_EQ(get(three, "rho_pressure").n, 3u);
  EXPECT_GT(get(three, "rho_pressure").se, 0.004);
  FrameSeries hertz = pressing(1.5);
  hertz.realisations = 1;
  for (auto& quantity : hertz.value) quantity.resize(1);
  EXPECT_NEAR(get(find_jamming(hertz, {4, 1e-4, 1.5}, 1, "key"), "rho_pressure_zero").value, 0.8, 3e-4);
  EXPECT_TRUE(std::isnan(get(find_jamming(one, {20, 1e3, 1}, 1, "key"), "rho_z").value));
  EXPECT_TRUE(std::isnan(get(find_jamming(one, {20, 1e3, 1}, 1, "key"), "rho_pressure").value));
}

TEST(Transitions, TheOnsetOfPercolationIsNoSharperThanTheStates) {
  FrameSeries s = relaxed();
  for (auto& run : s.value[3]) run = s.value[3][0];  // all percolate from the same state on, .01 after the one before
  EXPECT_NEAR(get(find_jamming(s, {}, 1, "key"), "rho_p").se, 0.01 / std::sqrt(12.0), 1e-9);
}

TEST(Transitions, AFitThatFailedIsNotCalledNotReached) {
  EXPECT_EQ(why_missing("rho_c"), "not reached");
  EXPECT_EQ(why_missing("rho_pressure"), "not reached");
  for (const char* fitted : {"rho_j", "rho_inflection", "z_at_rho_j", "tail_k_pooled", "mueth_beta_pooled"})
    EXPECT_EQ(why_missing(fitted).substr(0, 6), "no fit") << fitted;
  for (const TransitionKind& kind : transition_kinds()) EXPECT_FALSE(kind.missing.empty()) << kind.name;
}

// Whatever is found has a sentence that `jamscape explain` can give.
TEST(Transitions, AreAllExplained) {
  const auto kinds = transition_kinds();
  for (const Transition& t : find_jamming(jumping(), {}, 1, "key")) {
    const auto named = [&](const TransitionKind& k) { return k.name == t.quantity && !k.text.empty(); };
    EXPECT_EQ(std::count_if(kinds.begin(), kinds.end(), named), 1) << t.quantity;
  }
}

}  // namespace
}  // namespace jam
