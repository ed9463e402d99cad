#include "ui/panels/coverage_text.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr auto reviewed = ReviewState::reviewed;
constexpr auto toDo = ReviewState::toDo;

/// Of a plant of 10 m, by length and nodes to do, doubtful and reviewed.
ReviewCoverage coverageOf(std::array<double, 3> length, std::array<std::size_t, 3> nodes) {
  return {.length = length, .nodes = nodes};
}

TEST(CoverageText, IsAHundredPercentOnlyWhereNothingIsLeft) {
  const ReviewCoverage all = coverageOf({0, 0, 10}, {0, 0, 100});
  EXPECT_EQ(percentText(all, reviewed, 1), "100.0");
  EXPECT_EQ(percentText(all, reviewed, 0), "100");
  const ReviewCoverage butRoot = coverageOf({0, 0, 10}, {1, 0, 99}); // which has no length
  EXPECT_EQ(percentText(butRoot, reviewed, 1), "99.9");
  EXPECT_EQ(percentText(butRoot, reviewed, 0), "99");
  const ReviewCoverage butTwig = coverageOf({0.0001, 0, 9.9999}, {1, 0, 99});
  EXPECT_EQ(percentText(butTwig, reviewed, 1), "99.9");
  EXPECT_EQ(percentText({}, reviewed, 1), "0.0");
}

TEST(CoverageText, IsNeverAboveTheShare) {
  EXPECT_EQ(percentText(coverageOf({5.001, 0, 4.999}, {50, 0, 50}), reviewed, 1), "49.9");
  EXPECT_EQ(percentText(coverageOf({5, 0, 5}, {50, 0, 50}), reviewed, 1), "50.0");
}

TEST(CoverageText, NamesNodesWhereTheirLengthDoesNotCount) {
  const auto left = [](double length, std::size_t nodes) {
    return amountText(coverageOf({length, 0, 10 - length}, {nodes, 0, 100 - nodes}), toDo,
                      LengthUnit::meter);
  };
  EXPECT_EQ(left(0, 1), "1 node");
  EXPECT_EQ(left(0.001, 3), "3 nodes");
  EXPECT_EQ(left(0.01, 3), formatLength(0.01, LengthUnit::meter, 3));
  EXPECT_EQ(amountText({.length = {}, .nodes = {1, 0, 0}}, toDo, LengthUnit::meter), "1 node");
  EXPECT_EQ(left(0, 0), formatLength(0, LengthUnit::meter, 3));
}

} // namespace
} // namespace espalier
