#include "jamscape/base/hash.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

std::string sha256(std::string_view text) {
  Sha256 sha;
  sha.add(text);
  return sha.hex();
}

// FIPS 180-4 and NIST's example values.
TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesAreLikeTheWhole) {
  const std::string text(200, 'x');
  for (const std::size_t cut : {0u, 1u, 55u, 56u, 63u, 64u, 65u, 128u, 199u}) {
    Sha256 sha;
    sha.add(text.substr(0, cut));
    sha.add(text.substr(cut));
    EXPECT_EQ(sha.hex(), sha256(text)) << cut;
  }
}

TEST(ShortHash, IsTheBeginningOfTheDigest) { EXPECT_EQ(short_hash("abc"), "ba7816bf8f01cfea"); }

}  // namespace
}  // namespace jam
