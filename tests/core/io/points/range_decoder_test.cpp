
#include "core/base/random.h"
#include "core/io/points/integer_decoder.h"
#include "core/io/points/range_decoder.h"
#include "tests/core/io/points/range_encoder.h"

#include <gtest/gtest.h>

#include <limits>

namespace espalier {
namespace {

using namespace std::string_view_literals;

// Of 2^32 - 1, the first bit takes 4096 (2^32 / 2^13 - 1) = 0x7ffff000 for 0; what follows is
// for 1.
TEST(RangeDecoder, ReadsBitsThatWereWorkedOutByHand) {
  BitModel model;
  EXPECT_FALSE(RangeDecoder("\x7f\xff\xef\xff"sv).bit(model));
  model = {};
  EXPECT_TRUE(RangeDecoder("\x7f\xff\xf0\x00"sv).bit(model));
}

// Four symbols that are as likely take 8192 units of 2^32 / 2^15 - 1 = 0x1ffff each.
TEST(RangeDecoder, ReadsSymbolsThatWereWorkedOutByHand) {
  const auto symbolIn = [](std::string_view bytes) {
    SymbolModel model(4);
    return RangeDecoder(bytes).symbol(model);
  };
  EXPECT_EQ(symbolIn("\0\0\0\0"sv), 0U);
  EXPECT_EQ(symbolIn("\x3f\xff\xdf\xff"sv), 0U);
  EXPECT_EQ(symbolIn("\x3f\xff\xe0\0"sv), 1U);
  EXPECT_EQ(symbolIn("\x7f\xff\xc0\0"sv), 2U);
  EXPECT_EQ(symbolIn("\xff\xff\xff\xfe"sv), 3U);
}

// A byte without a model is the quotient of the value and 2^32 / 2^8 - 1.
TEST(RangeDecoder, ReadsPlainBitsThatWereWorkedOutByHand) {
  EXPECT_EQ(RangeDecoder("\x12\x34\x56\x78"sv).bits(4), 1U);
  EXPECT_EQ(RangeDecoder("\xab\xcd\xef\x01\0"sv).bits(8), 0xabU);
}

TEST(RangeDecoder, RefusesBytesThatNobodyWrote) {
  EXPECT_THROW(RangeDecoder("\0\0\0"sv), DamagedStream);
  EXPECT_THROW(RangeDecoder("\xff\xff\xff\xff"sv), DamagedStream);
  RangeDecoder tooShort("\0\0\0\0"sv);
  EXPECT_THROW((void)tooShort.bits(16), DamagedStream);
}

TEST(BitModel, LearnsHowLikelyAZeroIs) {
  BitModel model;
  EXPECT_EQ(model.zeroShare(), 4096U);
  for (int i = 0; i < 4; ++i)
    model.learn(false);
  EXPECT_EQ(model.zeroShare(), 8192U * 5 / 6); // five of six
  for (int i = 0; i < 100000; ++i)
    model.learn(true);
  EXPECT_GT(model.zeroShare(), 0U); // never impossible
  EXPECT_LT(model.zeroShare(), 8U);
}

TEST(SymbolModel, LearnsHowLikelyEachSymbolIs) {
  SymbolModel model(4);
  for (std::uint32_t i = 0; i < 4; ++i)
    EXPECT_EQ(model.start(i), 8192 * i);
  for (int i = 0; i < 5; ++i) // an update comes after (4 + 6) / 2
    model.learn(2);
  EXPECT_EQ(model.start(1), 32768U / 9); // one of nine
  EXPECT_EQ(model.start(2), 32768U * 2 / 9);
  EXPECT_EQ(model.start(3), 32768U * 8 / 9);
  for (int i = 0; i < 100000; ++i)
    model.learn(2);
  for (std::uint32_t i = 1; i < 4; ++i)
    EXPECT_GT(model.start(i), model.start(i - 1)); // never impossible
}

TEST(RangeDecoder, ReadsWhatAnEncoderWrote) {
  for (const std::uint32_t symbols : {2U, 3U, 16U, 33U, 256U, 516U, 2048U}) {
    Random random(symbols);
    test::RangeEncoder out;
    SymbolModel written(symbols);
    BitModel writtenBit;
    std::vector<std::uint32_t> values;
    for (int i = 0; i < 20000; ++i) {
      const auto value = static_cast<std::uint32_t>(random.below(1 + random.below(symbols)));
      values.push_back(value);
      out.symbol(written, value);
      out.bit(writtenBit, value == 0);
      if (i % 16 == 0) out.bits(1 + value % 32, value & ((2U << value % 32) - 1));
    }
    const std::string bytes = std::move(out).finish();
    RangeDecoder in(bytes);
    SymbolModel read(symbols);
    BitModel readBit;
    for (int i = 0; i < 20000; ++i) {
      const std::uint32_t value = values[static_cast<std::size_t>(i)];
      ASSERT_EQ(in.symbol(read), value);
      ASSERT_EQ(in.bit(readBit), value == 0);
      if (i % 16 > 0) continue;
      ASSERT_EQ(in.bits(1 + value % 32), value & ((2U << value % 32) - 1));
    }
  }
}

TEST(IntegerDecoder, ReadsWhatAnEncoderWrote) {
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  const std::vector<std::int32_t> edges = {0, 1, -1, 2, -2, 255, 256, 257, least, most};
  for (const std::uint32_t bits : {8U, 16U, 32U}) {
    test::RangeEncoder out;
    test::IntegerEncoder encoder(bits, 2);
    const auto fit = [&](std::int32_t value) {
      return bits == 32 ? value : value & ((1 << bits) - 1);
    };
    for (const std::int32_t prediction : edges)
      for (const std::int32_t value : edges)
        encoder.next(out, fit(prediction), fit(value), value < 0 ? 1 : 0);
    const std::string bytes = std::move(out).finish();
    RangeDecoder in(bytes);
    IntegerDecoder decoder(bits, 2);
    for (const std::int32_t prediction : edges)
      for (const std::int32_t value : edges)
        ASSERT_EQ(decoder.next(in, fit(prediction), value < 0 ? 1 : 0), fit(value));
  }
}

} // namespace
} // namespace espalier
