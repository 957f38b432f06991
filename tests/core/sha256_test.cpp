#include "core/sha256.h"

#include <gtest/gtest.h>

namespace weir {

namespace {

// The examples of FIPS 180-4 (published with it by NIST): no block, one block, two blocks.
TEST(Sha256, GivesThePublishedValues) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

// One million letters a, of the same examples, in pieces that do not end at a block.
TEST(Sha256, TakesItsInputInPieces) {
  const std::string piece(625, 'a');
  Sha256 hash;
  for (int i = 0; i < 1600; ++i) hash.add(piece.data(), piece.size());
  EXPECT_EQ(hash.hex(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace

}  // namespace weir
