#include "jamscape/study/targets.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/study/builtin.hpp"

namespace jam {
namespace {

TEST(Targets, OfKramar2013HoldTableOne) {
  const std::vector<Target> targets = read_targets(builtin_file("kramar2013.targets.toml"), "targets");
  std::vector<double> table;
  for (const Target& t : targets) {
    EXPECT_FALSE(t.source.empty()) << t.name;
    EXPECT_EQ(t.realisations, 20) << t.name;
    if (!t.is_value()) continue;
    EXPECT_EQ(t.left.quantity, "rho_c");
    EXPECT_EQ(t.tolerance, 0.004);
    table.push_back(t.right.value);
    EXPECT_EQ(t.known_deviation.empty(), t.right.value != 0.7884) << t.name;
  }
  EXPECT_EQ(table, (std::vector<double>{0.8615, 0.8448, 0.8282, 0.8140, 0.7962, 0.7884}));
  EXPECT_GT(targets.size(), 20u);
}

// The rows of theory sec. 6a.
TEST(Targets, OfNetworksHoldTheJammingPointsAndPeaks) {
  const std::vector<Target> targets = read_targets(builtin_file("networks-2d-3d.targets.toml"), "targets");
  std::vector<double> rho_j, peaks;
  std::size_t orders = 0;
  for (const Target& t : targets) {
    EXPECT_FALSE(t.source.empty()) << t.name;
    EXPECT_EQ(t.realisations, 20) << t.name;
    EXPECT_FALSE(t.left.where.empty()) << t.name << " names its system";
    orders += t.is_order();
    if (t.left.quantity == "rho_j" && t.is_value()) rho_j.push_back(t.right.value);
    if (t.left.reduce == Reduce::argmax) {
      peaks.push_back(t.right.value);
      EXPECT_EQ(t.tolerance, 0.25);
    }
  }
  EXPECT_EQ(rho_j, (std::vector<double>{0.834, 0.842, 0.57}));
  EXPECT_EQ(peaks, (std::vector<double>{1.25, 1.5, 2.0}));
  EXPECT_GT(orders, 20u);
}

TEST(Targets, StatesAreNamed) {
  const StateName s = read_state("rho_j-0.04", "here");
  EXPECT_EQ(s.transition, "rho_j");
  EXPECT_EQ(s.offset, -0.04);
  EXPECT_EQ(read_state("rho_c", "here").offset, 0);
  EXPECT_EQ(read_state("0.8", "here").offset, 0.8);
  EXPECT_EQ(read_state("last", "here").kind, StateName::Kind::last);
  for (const char* bad : {"", "rho_j+", "rho_j*2", "later", "0.8 d", "nan"})
    EXPECT_THROW(read_state(bad, "here"), Error);
}

TEST(Targets, AnOrderHasTwoSides) {
  const std::vector<Target> t = read_targets(
      "[[target]]\nname = \"a\"\nleft = { quantity = \"z\", at = \"0.8\", where = { contact.friction = 0 } }\nright = "
      "{ value = 3 }\n",
      "t.toml");
  ASSERT_EQ(t.size(), 1u);
  EXPECT_FALSE(t[0].is_value());
  EXPECT_TRUE(t[0].is_order());
  ASSERT_EQ(t[0].left.where.size(), 1u);
  EXPECT_EQ(t[0].left.where[0].first, "contact.friction");
  EXPECT_EQ(t[0].right.value, 3);
}

TEST(Targets, MistakesHavePlaces) {
  const auto place = [](const char* text) {
    try {
      read_targets(text, "t.toml");
    } catch (const Error& e) {
      return e.place();
    }
    return std::string("none");
  };
  EXPECT_EQ(place("[[target]]\nname = \"a\"\nquantty = \"z\"\n"), "t.toml:3:1");
  EXPECT_EQ(place("[[target]]\nname = \"a\"\nquantity = \"z\"\nwhere = { contact.frction = 0 }\nvalue = 1\n"),
            "t.toml:4:19");
  EXPECT_EQ(place("[[target]]\nquantity = \"z\"\nvalue = 1\n"), "t.toml:1:1");
  EXPECT_EQ(place("[[target]]\nname = \"a\"\nquantity = \"z\"\n"), "t.toml:1:1") << "nothing to compare with";
  const auto left = [&](const std::string& side) {
    return place(("[[target]]\nname = \"a\"\nleft = { " + side + " }\nright = { value = 1 }\n").c_str());
  };
  EXPECT_EQ(left("quantity = \"z\", at = \"rho_j*2\""), "t.toml:3:31");
  EXPECT_EQ(left("quantity = \"z\", at = \"max\", between = [\"0.8\"]"), "t.toml:3:48");
  EXPECT_EQ(left("quantity = \"z\", at = \"max\", between = [\"0.8\", \"max\"]"), "t.toml:3:56");
  EXPECT_EQ(left("quantity = \"z\", at = \"0.8\", reduce = \"median\""), "t.toml:3:47");
  EXPECT_EQ(left("value = 3"), "t.toml:1:1") << "two constants";
  EXPECT_EQ(left("quantity = \"level_sets.b0\""), "t.toml:1:1") << "at which state?";
}

}  // namespace
}  // namespace jam
