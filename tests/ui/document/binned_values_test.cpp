#include "ui/document/binned_values.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>

namespace espalier {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

/// 0, 1, ... count - 1
std::vector<float> upTo(int count) {
  std::vector<float> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 0.0F);
  return values;
}

TEST(BinnedValues, CountEachValueOnce) {
  const BinnedValues bins = binned(upTo(1000));
  EXPECT_EQ(bins.from, 0);
  EXPECT_EQ(bins.to, 999) << "nothing lies far beyond the others";
  EXPECT_EQ(std::accumulate(bins.counts.begin(), bins.counts.end(), std::size_t{0}), 1000U);
  EXPECT_EQ(bins.counts.size(), 20U) << "2 times the cube root";
  for (const std::size_t count : bins.counts)
    EXPECT_EQ(count, 50U);
}

TEST(BinnedValues, EndWhereOnlyTheLastTwoHundredthLieFarBeyond) {
  std::vector<float> values = upTo(996);
  values.insert(values.end(), 4, 1e6F);
  const BinnedValues bins = binned(values);
  EXPECT_EQ(bins.to, 995) << "the 99.5th percentile of 1000";
  EXPECT_EQ(bins.above, 4U);
  EXPECT_EQ(bins.greatest, 1e6);
}

// 0, 1, ... 99 999, mixed, and some values so far off that most of the others are one of its
// ranges.
TEST(BinnedValues, FindTheEndAmongManyValuesOfAnySize) {
  constexpr int count = 100'000;
  std::vector<float> values;
  for (std::int64_t i = 0; i < count; ++i)
    values.push_back(static_cast<float>(i * 7919 % count)); // 7919 is prime: each number once
  values.insert(values.end(), 100, 1e30F);
  const BinnedValues bins = binned(values);
  EXPECT_EQ(bins.to, 99'599) << "at 0.995 of 100 100";
  EXPECT_EQ(bins.above, 500U);
  const BinnedValues alike = binned(std::vector<float>(10'000, 5));
  EXPECT_EQ(alike.above + alike.below, 0U);
}

TEST(BinnedValues, CountWhatLiesOutsideARange) {
  const BinnedValues bins = binned(upTo(100), std::pair(10.0, 19.0));
  EXPECT_EQ(bins.below, 10U);
  EXPECT_EQ(bins.above, 80U);
  EXPECT_EQ(bins.counts, std::vector<std::size_t>(10, 1));
}

TEST(BinnedValues, LeaveOutWhatIsNoNumber) {
  const BinnedValues bins = binned(std::vector<float>{none, 1, endless, 2, -endless});
  EXPECT_EQ(bins.total, 2U);
  EXPECT_EQ(bins.missing, 3U);
  EXPECT_EQ(bins.least, 1);
  EXPECT_EQ(bins.greatest, 2);
  EXPECT_TRUE(binned(std::vector<float>{none, none}).isEmpty());
  EXPECT_EQ(binned(std::vector<float>{none, none}).missing, 2U);
  EXPECT_TRUE(binned({}).isEmpty());
}

TEST(BinnedValues, OfOneValueHaveAWidth) {
  for (const float value : {0.0F, 40.0F, -40.0F}) {
    const BinnedValues bins = binned(std::vector<float>(7, value));
    EXPECT_LT(bins.from, value);
    EXPECT_GT(bins.to, value);
    EXPECT_EQ(bins.below + bins.above, 0U);
  }
}

TEST(BinnedValues, OfAnotherSetAreInTheSameBins) {
  const BinnedValues bins = binned(upTo(1000));
  const BinnedValues others = binnedAs(bins, std::vector<float>{-5, 10, 60, 61, none, 2000});
  ASSERT_EQ(others.counts.size(), bins.counts.size());
  EXPECT_EQ(others.from, bins.from);
  EXPECT_EQ(others.counts[0], 1U);
  EXPECT_EQ(others.counts[1], 2U);
  EXPECT_EQ(others.below, 1U);
  EXPECT_EQ(others.above, 1U);
  EXPECT_EQ(others.missing, 1U);
}

} // namespace
} // namespace espalier
