#include "jamscape/topology/bit_column.hpp"

#include <gtest/gtest.h>

#include <set>

#include "networks.hpp"

namespace jam {
namespace {

TEST(BitColumn, behaves_as_a_set_under_symmetric_difference) {
  for (const std::size_t rows : {1u, 63u, 64u, 65u, 4096u, 4097u, 300000u}) {
    BitColumn column;
    column.reset(rows);
    std::set<std::size_t> expected;
    auto random = examples::stream(rows);
    for (int i = 0; i < 2000; ++i) {
      const auto row = static_cast<std::size_t>(random.below(rows));
      column.toggle(row);
      if (!expected.erase(row)) expected.insert(row);
      ASSERT_EQ(column.empty(), expected.empty());
      if (!expected.empty()) {
        ASSERT_EQ(column.largest(), *expected.rbegin());
      }
    }
    while (!expected.empty()) {
      ASSERT_EQ(column.largest(), *expected.rbegin());
      column.toggle(*expected.rbegin());
      expected.erase(*expected.rbegin());
    }
    EXPECT_TRUE(column.empty());
  }
}

TEST(BitColumn, without_rows_is_empty) {
  BitColumn column;
  column.reset(0);
  EXPECT_TRUE(column.empty());
}

}  // namespace
}  // namespace jam
