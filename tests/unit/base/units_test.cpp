#include "jamscape/base/units.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr OptionMeta speed{.text = "speed", .unit = "d/tau_c"};
constexpr OptionMeta mass{.text = "a mass", .unit = "m"};
constexpr OptionMeta bare{.text = "a ratio"};
constexpr OptionMeta young{.text = "Young's modulus", .unit = "Pa", .si = true};
constexpr Scales hydrogel{0.01735, 0.003, 0.0063984};

std::string problem(std::string_view text, const OptionMeta& meta, const Scales& scales = {}) {
  try {
    read_quantity(text, "key", meta, "f:1:1", scales);
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
  EXPECT_EQ(read_quantity("3 tau_c^-1 d", "key", speed, "", hydrogel), 3);
}

TEST(Units, AnythingElseIsRefusedWithItsReason) {
  EXPECT_NE(problem("1 m/s", speed).find("scaled units"), std::string::npos);
  EXPECT_NE(problem("1 m/s", speed).find("[units]"), std::string::npos);
  EXPECT_NE(problem("1 furlong", speed).find("no unit of this option"), std::string::npos);
  EXPECT_NE(problem("1 furlong", speed).find("1 d/tau_c"), std::string::npos) << "says what would do";
  EXPECT_NE(problem("1", speed).find("without a unit"), std::string::npos);
  EXPECT_NE(problem("1 d", bare).find("has no unit"), std::string::npos);
  EXPECT_NE(problem("quick", speed).find("a number is expected"), std::string::npos);
  EXPECT_NE(problem("", speed).find("a number is expected"), std::string::npos);
}

TEST(Units, ScaledUnitsAreProductsOfThree) {
  EXPECT_TRUE(same(read_scaled_unit("m/tau_c^2").value(), {0, 1, -2}));
  EXPECT_TRUE(same(read_scaled_unit("m/(d^0.5 tau_c^2)").value(), {-0.5, 1, -2}));
  EXPECT_TRUE(same(read_scaled_unit("m/d^.5/tau_c^2").value(), {-0.5, 1, -2}));
  EXPECT_TRUE(same(read_scaled_unit("1/tau_c").value(), {0, 0, -1}));
  EXPECT_TRUE(same(read_scaled_unit("").value(), {}));
  for (const char* wrong : {"s", "d/", "/d/", "d^", "(d", "d)", "d//m", "d^1e9", "2 d"})
    EXPECT_FALSE(read_scaled_unit(wrong).has_value()) << wrong;
}

TEST(Units, SiUnitsOfOneQuantityAgree) {
  const auto in_si = [](double value, std::string_view text) {
    const Unit u = read_si_unit(text).value();
    return value * u.over / u.under;
  };
  EXPECT_EQ(in_si(1.735, "cm"), 0.01735) << "the double nearest to the decimal number";
  EXPECT_EQ(in_si(3.0, "g"), 0.003);
  EXPECT_EQ(in_si(0.01, "cm/s"), 1e-4);
  EXPECT_EQ(in_si(1, "g/cm^3"), 1000);
  EXPECT_EQ(in_si(36, "km/h"), 10);
  EXPECT_EQ(in_si(23.45, "kPa"), 23450);
  EXPECT_TRUE(same(read_si_unit("N/m^1.5").value().dimensions, read_si_unit("kg/(m^.5 s^2)").value().dimensions));
  EXPECT_TRUE(same(read_si_unit("kg m/s^2").value().dimensions, read_si_unit("J/m").value().dimensions));
  EXPECT_TRUE(same(read_si_unit("rad/s").value().dimensions, read_si_unit("Hz").value().dimensions));
}

TEST(Units, ScalesTurnSiIntoScaledNumbers) {
  EXPECT_NEAR(read_quantity("0.01 cm/s", "key", speed, "", hydrogel), 3.69e-5, 1e-7);
  EXPECT_EQ(read_quantity("1.735 cm", "key", {.text = "", .unit = "d"}, "", hydrogel), 1);
  EXPECT_EQ(read_quantity("6 g", "key", mass, "", hydrogel), 2);
  EXPECT_EQ(read_quantity("2 m", "key", mass, "", hydrogel), 2) << "the scaled unit of the option comes first";
  EXPECT_NEAR(read_quantity("2 m", "key", {.text = "", .unit = "d"}, "", hydrogel), 115.27, 0.01) << "two metres";
  EXPECT_NEAR(read_quantity("361.7 N/m", "key", {.text = "", .unit = "m/tau_c^2"}, "", hydrogel), 4.936, 1e-3);
}

TEST(Units, ConvertedNumbersHaveTwelveDigits) {
  EXPECT_EQ(to_scaled(1, {1, 0, 0}, {3, 1, 1}), 0.333333333333);
  EXPECT_EQ(read_quantity("1 d/tau_c", "key", speed, "", {3, 1, 1}), 1) << "scaled numbers stay as they are";
}

TEST(Units, DimensionsMustAgree) {
  EXPECT_NE(problem("1 kg", speed, hydrogel).find("that is a unit of kg"), std::string::npos);
  EXPECT_NE(problem("1 kg", speed, hydrogel).find("an SI unit such as m/s"), std::string::npos);
  EXPECT_NE(problem("1 cn/s", speed, hydrogel).find("no unit"), std::string::npos);
  EXPECT_NE(problem("1 cmm", {.text = "", .unit = "d"}, hydrogel).find("did you mean 'cm'?"), std::string::npos);
}

TEST(Units, OptionsInSiNeedNoScales) {
  EXPECT_EQ(read_quantity("23.45 kPa", "key", young, ""), 23450);
  EXPECT_EQ(read_quantity("2 N/m^2", "key", young, ""), 2);
  EXPECT_NE(problem("2 N/m", young).find("'key' cannot be in 'N/m'"), std::string::npos);
  EXPECT_NE(problem("2 d", young).find("no unit of this option"), std::string::npos);
}

TEST(Units, SiUnitsAreWrittenForPeople) {
  EXPECT_EQ(si_unit({1, 0, -1}), "m/s");
  EXPECT_EQ(si_unit({-0.5, 1, -2}), "kg/(m^0.5 s^2)");
  EXPECT_EQ(si_unit({0, 0, -1}), "1/s");
}

}  // namespace
}  // namespace jam
