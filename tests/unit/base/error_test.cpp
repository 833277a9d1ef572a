#include "jamscape/base/error.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(Error, ReadsPlaceProblemAndWhatToTry) {
  const Error e = usage_error("unknown key 'x'", "a.toml:3:1", "did you mean 'y'?");
  EXPECT_STREQ(e.what(), "a.toml:3:1: unknown key 'x'\n  try: did you mean 'y'?");
  EXPECT_EQ(e.code(), ExitCode::usage);
}

TEST(Error, NeedsNeitherPlaceNorSuggestion) {
  const Error e = data_error("truncated");
  EXPECT_STREQ(e.what(), "truncated");
  EXPECT_EQ(static_cast<int>(e.code()), 3);
}

}  // namespace
}  // namespace jam
