#include "core/base/text.h"
#include "core/io/bytes/byte_stream.h"
#include "core/io/bytes/line_stream.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// Lines of all lengths up to some, one longer than any block, and a last one without its end.
std::string longText() {
  std::string text = "\xEF\xBB\xBF";
  for (std::size_t i = 0; text.size() < 3'000'000; ++i)
    text += std::string(i % 300, static_cast<char>('a' + i % 26)) + (i % 3 == 0 ? "\r\n" : "\n");
  return text + std::string(2'500'000, 'y') + "\n\nlast";
}

TEST(LineStream, GivesTheLinesThatLineReaderGives) {
  const std::string text = longText();
  std::istringstream in(text);
  ByteSource source(in);
  LineStream stream(source);
  LineReader reader(text);
  while (const auto expected = reader.next()) {
    const auto line = stream.next();
    ASSERT_TRUE(line);
    ASSERT_EQ(*line, *expected);
    ASSERT_EQ(stream.number(), reader.number());
    ASSERT_EQ(stream.offset(), reader.offset());
  }
  EXPECT_FALSE(stream.next());
}

TEST(LineStream, BeginsWhereItIsTold) {
  std::istringstream in("head\none\ntwo\n");
  ByteSource source(in);
  LineStream lines(source, 5);
  EXPECT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.next(), "two");
  EXPECT_EQ(lines.next(), std::nullopt);
}

TEST(ByteStream, TakesAndSkipsAcrossItsBlocks) {
  std::string bytes(10'000'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(i % 251);
  std::istringstream in(bytes);
  ByteSource source(in);
  ByteStream stream(source, 7);
  std::size_t place = 7;
  for (const std::size_t count : {3U, 4'200'000U, 1U, 999'999U}) {
    const char* taken = stream.take(count);
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(std::string_view(taken, count), std::string_view(bytes).substr(place, count));
    place += count;
    stream.skip(100'001);
    place += 100'001;
    EXPECT_EQ(stream.left(), bytes.size() - place);
  }
}

TEST(ByteStream, NoticesThatAFileBecameShorter) {
  std::istringstream in(std::string(100, 'a'));
  ByteSource source(in);
  ByteStream stream(source, 0);
  in.str(std::string(50, 'a'));
  EXPECT_EQ(stream.take(60), nullptr);
}

} // namespace
} // namespace espalier
