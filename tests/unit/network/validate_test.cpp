#include "jamscape/network/validate.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

std::string problem(const WeightedGraph& g) {
  try {
    validate(g);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::data);
    EXPECT_FALSE(error.suggestion().empty());
    return error.problem();
  }
  return "";
}

TEST(Validate, takes_good_graphs) {
  EXPECT_EQ(problem({}), "");
  EXPECT_EQ(problem({5, {}, {}, {}}), "");
  EXPECT_EQ(problem({3, {0, 2, 2}, {1, 1, 0}, {1, 0, 2}}), "");
}

TEST(Validate, names_the_edge) {
  EXPECT_EQ(problem({3, {0, 1}, {1, 3}, {1, 1}}).substr(0, 14), "edge 1 (1 - 3,");
  EXPECT_EQ(problem({3, {0, 2}, {1, 2}, {1, 1}}).substr(0, 14), "edge 1 (2 - 2,");
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1., -1e-300, inf, nan}) {
    EXPECT_EQ(problem({3, {0, 2}, {1, 1}, {1, bad}}).substr(0, 14), "edge 1 (2 - 1,") << bad;
  }
}

TEST(Validate, names_both_of_a_repeated_pair) {
  const auto text = problem({4, {0, 2, 3, 1}, {1, 3, 1, 0}, {1, 1, 1, 4}});
  EXPECT_NE(text.find("edge 3 (1 - 0"), std::string::npos) << text;
  EXPECT_NE(text.find("edge 0 (0 - 1"), std::string::npos) << text;
}

TEST(Validate, wants_arrays_of_one_length) {
  WeightedGraph g{3, {0}, {1}, {1, 2}};
  EXPECT_THROW(validate(g), Error);
}

}  // namespace
}  // namespace jam
