#include "jamscape/base/table.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

TEST(Table, FindsColumnsByName) {
  Table t;
  EXPECT_EQ(t.rows(), 0u);
  t.add("x", std::vector<double>{0.5, 1.5});
  t.add("n", std::vector<std::int64_t>{1, 2});
  t.add("s", std::vector<std::string>{"a", "b"});
  EXPECT_EQ(t.rows(), 2u);
  EXPECT_TRUE(t.has("n"));
  EXPECT_FALSE(t.has("m"));
  EXPECT_EQ(t.numbers("n"), (std::vector<double>{1, 2}));
  EXPECT_THROW(t.numbers("s"), Error);
  try {
    t.column("m");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.suggestion(), "its columns are: x, n, s");
  }
}

}  // namespace
}  // namespace jam
