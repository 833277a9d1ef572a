#include <gtest/gtest.h>

#include <limits>

#include "jamscape/report/json.hpp"

namespace jam {
namespace {

TEST(ReportJson, RoundsToSignificantDigits) {
  EXPECT_EQ(rounded(0.123456789, 5).dump(), "0.12346");
  EXPECT_EQ(rounded(1234567.0, 3).dump(), "1230000");
  EXPECT_EQ(rounded(2.5e-9, 5).dump(), "2.5e-09");
  EXPECT_EQ(rounded(3.0).dump(), "3");
}

TEST(ReportJson, NumbersThatAreNoneBecomeNull) {
  EXPECT_EQ(rounded({std::numeric_limits<double>::quiet_NaN(), 1, std::numeric_limits<double>::infinity()}).dump(),
            "[null,1,null]");
}

// RFC 4648, section 10.
TEST(ReportJson, Base64KnownAnswers) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(ReportJson, WordsSpanTheRangeAndAreClipped) {
  EXPECT_EQ(packed_words({-1, 0, 1, 2}, 0, 1), base64(std::string("\x00\x00\x00\x00\xff\xff\xff\xff", 8)));
  EXPECT_EQ(packed_words({3}, 3, 3), base64(std::string("\x00\x00", 2)));
}

TEST(ReportJson, IndicesAreLittleEndian) {
  EXPECT_EQ(packed_indices({1, 258}, false), base64(std::string("\x01\x00\x02\x01", 4)));
  EXPECT_EQ(packed_indices({65536}, true), base64(std::string("\x00\x00\x01\x00", 4)));
}

}  // namespace
}  // namespace jam
