#include "core/base/quadratic.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(WholeQuadratic, AddsUpFeaturesAndTheirProducts) {
  const WholeQuadratic<2> sum{.constant = 1,
                              .weights = {2, 3},
                              .pairWeights = {5, 7, 11}, // of the first, of both, of the second
                              .least = {0, 10},
                              .most = {4, 30}};
  EXPECT_DOUBLE_EQ(sum.value({2, 20}), 1); // both in the middle: 0
  EXPECT_DOUBLE_EQ(sum.value({3, 25}), 1 + 0.5 * (2 + 3) + 0.25 * (5 + 7 + 11));
  EXPECT_DOUBLE_EQ(sum.value({0, 30}), 1 - 2 + 3 + 5 - 7 + 11);
}

TEST(WholeQuadratic, SaysNothingBeyondWhatWasSeen) {
  const WholeQuadratic<1> sum{.weights = {1}, .pairWeights = {1}, .least = {0}, .most = {1}};
  EXPECT_DOUBLE_EQ(sum.value({-5}), sum.value({0}));
  EXPECT_DOUBLE_EQ(sum.value({8}), sum.value({1}));
}

// A feature that was the same everywhere.
TEST(WholeQuadratic, TakesNoNoteOfWhatNeverDiffered) {
  const WholeQuadratic<1> sum{
      .constant = 2, .weights = {1}, .pairWeights = {1}, .least = {3}, .most = {3}};
  EXPECT_DOUBLE_EQ(sum.value({7}), 2);
}

} // namespace
} // namespace espalier
