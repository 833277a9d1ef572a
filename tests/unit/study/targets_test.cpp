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

TEST(Targets, AnOrderHasTwoSides) {
  const std::vector<Target> t = read_targets(
      "[[target]]\nname = \"a\"\nleft = { quantity = \"z\", at = \"0.8\", where = { contact.friction = 0 } }\nright = "
      "{ value = 3 }\n",
      "t.toml");
  ASSERT_EQ(t.size(), 1u);
  EXPECT_FALSE(t[0].is_value());
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
}

}  // namespace
}  // namespace jam
