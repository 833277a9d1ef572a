#include "jamscape/base/schema.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "jamscape/base/error.hpp"

namespace jam {

enum class Colour { red, green };
template <>
struct EnumNames<Colour> {
  static constexpr std::pair<Colour, std::string_view> values[] = {{Colour::red, "red"}, {Colour::green, "green"}};
};

namespace {

struct Inner {
  double speed = 0.5;
  template <class V>
  void describe(V& v) {
    v.option("speed", speed, {.text = "speed", .unit = "d/tau_c", .min = 0, .max = 1, .above_min = true});
  }
};

struct Outer {
  bool on = true;
  std::int64_t count = 3;
  std::string name = "n";
  std::vector<double> at = {0.5, 1};
  std::vector<std::string> list;
  Colour colour = Colour::red;
  Inner inner;
  template <class V>
  void describe(V& v) {
    v.option("on", on, {.text = "on"});
    v.option("count", count, {.text = "count", .min = 1, .max = 10});
    v.option("name", name, {.text = "name"});
    v.option("at", at, {.text = "at", .min = 0, .max = 2});
    v.option("list", list, {.text = "list"});
    v.option("colour", colour, {.text = "colour"});
    v.group("inner", inner);
  }
};

class Schema : public testing::Test {
 protected:
  const Option& option(std::string_view key) {
    for (const Option& o : options_)
      if (o.key == key) return o;
    throw std::logic_error("no option");
  }
  void set(std::string_view key, Written value) {
    value.place = "f.toml:1:2";
    assign(option(key), value);
  }
  /// The error of an assignment that must fail; nothing may have changed.
  std::string refused(std::string_view key, Written value) {
    const std::string before = print_value(option(key));
    try {
      set(key, std::move(value));
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::usage);
      EXPECT_EQ(e.place(), "f.toml:1:2");
      EXPECT_FALSE(e.suggestion().empty());
      EXPECT_EQ(print_value(option(key)), before);
      return e.problem();
    }
    ADD_FAILURE() << key << " was taken";
    return {};
  }
  Outer outer_;
  std::vector<Option> options_ = options_of(outer_, "o.");
};

TEST_F(Schema, ListsKeysInOrder) {
  std::vector<std::string> keys;
  for (const Option& o : options_) keys.push_back(o.key);
  EXPECT_EQ(keys,
            (std::vector<std::string>{"o.on", "o.count", "o.name", "o.at", "o.list", "o.colour", "o.inner.speed"}));
}

TEST_F(Schema, SetsTheMembers) {
  set("o.on", {false, {}});
  set("o.count", {std::int64_t{7}, {}});
  set("o.name", {std::string("x"), {}});
  set("o.at", {std::vector<Written>{{0.25, {}}, {std::int64_t{2}, {}}}, {}});
  set("o.colour", {std::string("green"), {}});
  set("o.inner.speed", {std::int64_t{1}, {}});
  EXPECT_FALSE(outer_.on);
  EXPECT_EQ(outer_.count, 7);
  EXPECT_EQ(outer_.name, "x");
  EXPECT_EQ(outer_.at, (std::vector<double>{0.25, 2}));
  EXPECT_EQ(outer_.colour, Colour::green);
  EXPECT_EQ(outer_.inner.speed, 1);
}

TEST_F(Schema, TakesTheOptionsOwnUnit) {
  set("o.inner.speed", {std::string("2.5e-5 d/tau_c"), {}});
  EXPECT_EQ(outer_.inner.speed, 2.5e-5);
}

TEST_F(Schema, RefusesWrongTypes) {
  EXPECT_NE(refused("o.on", {std::int64_t{1}, {}}).find("true or false"), std::string::npos);
  EXPECT_NE(refused("o.count", {1.5, {}}).find("an integer"), std::string::npos);
  EXPECT_NE(refused("o.inner.speed", {true, {}}).find("a number (in d/tau_c)"), std::string::npos);
  EXPECT_NE(refused("o.inner.speed", {std::string("fast"), {}}).find("a number"), std::string::npos);
  EXPECT_NE(refused("o.at", {0.5, {}}).find("a list of numbers"), std::string::npos);
}

TEST_F(Schema, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(refused("o.count", {std::int64_t{11}, {}}),
            "'o.count' = 11.0 is out of range: it must be at least 1 and at most 10");
  EXPECT_NE(refused("o.inner.speed", {0.0, {}}).find("above 0"), std::string::npos)
      << "the smallest value is not allowed";
  EXPECT_NE(refused("o.inner.speed", {std::numeric_limits<double>::quiet_NaN(), {}}).find("out of range"),
            std::string::npos);
}

TEST_F(Schema, RefusesUnknownNamesWithTheNearest) {
  try {
    set("o.colour", {std::string("grean"), {}});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.problem().find("one of \"red\", \"green\""), std::string::npos);
    EXPECT_EQ(e.suggestion(), "o.colour = \"green\"");
  }
}

TEST_F(Schema, PrintsWhatTomlReads) {
  EXPECT_EQ(print_value(option("o.on")), "true");
  EXPECT_EQ(print_value(option("o.count")), "3");
  EXPECT_EQ(print_value(option("o.name")), "\"n\"");
  EXPECT_EQ(print_value(option("o.at")), "[0.5, 1.0]");
  EXPECT_EQ(print_value(option("o.colour")), "\"red\"");
  EXPECT_EQ(print_text("a\"b\\c\n"), "\"a\\\"b\\\\c\\n\"");
}

TEST(PrintNumber, RoundTripsAndLooksLikeAFloat) {
  EXPECT_EQ(print_number(1), "1.0");
  EXPECT_EQ(print_number(0.1), "0.1");
  EXPECT_EQ(print_number(2.5e-5), "2.5e-05");
  for (const double x : {1.0 / 3, 1e300, 5e-324, -0.1, 0.1 + 0.2})
    EXPECT_EQ(std::strtod(print_number(x).c_str(), nullptr), x);
}

TEST(UnknownKey, OffersTheNearest) {
  try {
    throw_unknown_key("grains.cuont", {"grains.count", "grains.width"}, "f:1:1");
  } catch (const Error& e) {
    EXPECT_EQ(e.problem(), "unknown key 'grains.cuont'");
    EXPECT_EQ(e.suggestion(), "did you mean 'grains.count'?");
  }
}

}  // namespace
}  // namespace jam
