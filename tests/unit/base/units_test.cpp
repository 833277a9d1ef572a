#include "jamscape/base/units.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr OptionMeta speed{.text = "speed", .unit = "d/tau_c"};
constexpr OptionMeta bare{.text = "a ratio"};

std::string problem(std::string_view text, const OptionMeta& meta) {
  try {
    read_quantity(text, "key", meta, "f:1:1");
  } catch (const Error& e) {
    EXPECT_EQ(e.place(), "f:1:1");
    return e.problem() + " / " + e.suggestion();
  }
  return {};
}

TEST(Units, TheOptionsOwnUnitWithOrWithoutBlanks) {
  EXPECT_EQ(read_quantity("2.5e-5 d/tau_c", "key", speed, ""), 2.5e-5);
  EXPECT_EQ(read_quantity("  2.5e-5d/tau_c ", "key", speed, ""), 2.5e-5);
  EXPECT_EQ(read_quantity("-1 d / tau_c", "key", speed, ""), -1);
}

TEST(Units, AnythingElseIsRefusedWithItsReason) {
  EXPECT_NE(problem("1 m/s", speed).find("scaled units"), std::string::npos);
  EXPECT_NE(problem("1 furlong", speed).find("no unit of this option"), std::string::npos);
  EXPECT_NE(problem("1 furlong", speed).find("1 d/tau_c"), std::string::npos) << "says what would do";
  EXPECT_NE(problem("1", speed).find("without a unit"), std::string::npos);
  EXPECT_NE(problem("1 d", bare).find("has no unit"), std::string::npos);
  EXPECT_NE(problem("quick", speed).find("a number is expected"), std::string::npos);
  EXPECT_NE(problem("", speed).find("a number is expected"), std::string::npos);
}

}  // namespace
}  // namespace jam
