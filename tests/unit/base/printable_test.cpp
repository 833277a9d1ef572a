#include "jamscape/base/printable.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

TEST(Printable, ControlBytesAreShownAndLettersStay) {
  EXPECT_EQ(printable("\x1b[31mred\a\x7f"), "\\x1b[31mred\\x07\\x7f");
  EXPECT_EQ(printable("ρ_c = 0.84 ± é, 力"), "ρ_c = 0.84 ± é, 力");
  EXPECT_EQ(printable("a\tb\nc"), "a\tb\nc");
  EXPECT_EQ(printable("a\nb\r", LineEnds::escape), "a\\x0ab\\x0d");
  EXPECT_EQ(printable("\xc2\x9b"
                      "1m"),
            "\\xc2\\x9b"
            "1m")
      << "the control byte that begins a sequence in Latin-1";
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "gnp"),
            "\\xe2\\x80\\xaegnp")
      << "writing from right to left";
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, BytesThatAreNoUtf8) {
  for (const char* wrong : {"\x80", "\xff", "\xc0\xaf", "\xed\xa0\x80", "\xe2\x82", "\xf5\x80\x80\x80"}) {
    const std::string text = printable(wrong);
    EXPECT_EQ(text.find_first_of(wrong), std::string::npos) << text;
    EXPECT_EQ(text.substr(0, 2), "\\x");
  }
}

TEST(Printable, ErrorsShowNoControlBytes) {
  EXPECT_EQ(std::string(data_error("'\x1b[2J' is no number", "\x1b.csv:1:1", "not \a").what()),
            "\\x1b.csv:1:1: '\\x1b[2J' is no number\n  try: not \\x07");
}

}  // namespace
}  // namespace jam
