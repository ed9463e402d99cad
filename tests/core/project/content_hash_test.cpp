#include "core/base/error.h"
#include "core/project/content_hash.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace espalier {
namespace {

// Values of the reference implementation, xxHash 0.8, seed 0.
TEST(ContentHash, IsXxh64) {
  EXPECT_EQ(contentHash(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(contentHash("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(contentHash("abc"), 0x44BC2CF5AD770999U);
  EXPECT_EQ(contentHash("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1U);
}

TEST(ContentHash, OfAFileIsThatOfItsBytes) {
  const auto file = test::freshFolder() / "scan.xyz";
  std::string bytes;
  for (int i = 0; i < 400'000; ++i)
    bytes += std::to_string(i % 997) + " "; // more than one buffer, no multiple of a stripe
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_EQ(contentHashOfFile(file), contentHash(bytes));
}

TEST(ContentHash, OfAMissingFileIsAnError) {
  EXPECT_THROW((void)contentHashOfFile(test::freshFolder() / "none.xyz"), Error);
}

} // namespace
} // namespace espalier
