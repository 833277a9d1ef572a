#include "jamscape/base/nearest.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(EditDistance, CountsSingleLetters) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("friction", "friction"), 0u);
  EXPECT_EQ(edit_distance("frction", "friction"), 1u);
  EXPECT_EQ(edit_distance("frictoin", "friction"), 1u) << "neighbours swapped";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> known = {"grains.count", "grains.width", "contact.friction", "contact.wall_friction"};
  EXPECT_EQ(nearest("contact.frction", known), "contact.friction");
  EXPECT_EQ(nearest("grain.count", known), "grains.count");
  EXPECT_EQ(nearest("friction", known), "contact.friction") << "by its last part";
  EXPECT_EQ(nearest("grains.friction", known), "contact.friction") << "in the wrong group";
}

TEST(Nearest, DoesNotGuessWildly) { EXPECT_EQ(nearest("temperature", {"grains.count", "contact.friction"}), ""); }

}  // namespace
}  // namespace jam
