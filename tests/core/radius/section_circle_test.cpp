#include "core/base/random.h"
#include "core/radius/section_circle.h"
#include "tests/core/radius/circle_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace espalier {
namespace {

CrossSection sectionOf(std::vector<Eigen::Vector2d> points) {
  return {.center = {0, 0, 0},
          .right = {1, 0, 0},
          .up = {0, 1, 0},
          .halfThickness = 1,
          .points = std::move(points),
          .others = {}};
}

/// `count` points evenly on an arc of a circle of radius 10, with noise across it.
std::vector<Eigen::Vector2d> arc(int count, double angle, double noise = 0,
                                 const Eigen::Vector2d& center = {0, 0}) {
  Random random(7);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double turn = angle * (i + 0.5) / count;
    const double radius = 10 + noise * random.normal();
    points.emplace_back(center + radius * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
  }
  return points;
}

NoRadius refusalOf(const CrossSection& section, RadiusMeasure measure) {
  const MeasuredCircle circle = measuredCircle(section, measure);
  EXPECT_TRUE(std::holds_alternative<NoRadius>(circle));
  return std::holds_alternative<NoRadius>(circle) ? std::get<NoRadius>(circle)
                                                  : NoRadius::noSection;
}

TEST(MeasuredCircle, IsTheCircleByAnyMeasureWhenAllIsEven) {
  const CrossSection section = sectionOf(arc(360, 2 * std::numbers::pi));
  for (const RadiusMeasure measure :
       {RadiusMeasure::mean, RadiusMeasure::maximum, RadiusMeasure::hull, RadiusMeasure::circle}) {
    const FittedCircle circle = test::circleOf(section, measure);
    EXPECT_NEAR(circle.radius, 10, 1e-3); // the hull has 360 corners
    EXPECT_LT(circle.center.norm(), 1e-9);
    EXPECT_LT(circle.error, 1e-3);
    EXPECT_EQ(circle.coverage, 1);
  }
}

// Seen from a place e off the center, distances run from r - e to r + e.
TEST(MeasuredCircle, StaysAboutTheNodeForMeanAndMaximum) {
  const CrossSection section = sectionOf(arc(720, 2 * std::numbers::pi, 0, {4, 0}));
  EXPECT_NEAR(test::circleOf(section, RadiusMeasure::maximum).radius, 14, 1e-3);
  // To second order in e / r the mean distance is r + e^2 / 4 r.
  EXPECT_NEAR(test::circleOf(section, RadiusMeasure::mean).radius, 10 + 16.0 / 40, 0.02);
  EXPECT_EQ(test::circleOf(section, RadiusMeasure::mean).center, Eigen::Vector2d(0, 0));
  for (const RadiusMeasure measure : {RadiusMeasure::hull, RadiusMeasure::circle}) {
    EXPECT_NEAR(test::circleOf(section, measure).radius, 10, 1e-3);
    EXPECT_LT((test::circleOf(section, measure).center - Eigen::Vector2d(4, 0)).norm(), 1e-6);
  }
}

TEST(MeasuredCircle, TakesTheHullOfASquareFromItsPerimeter) {
  std::vector<Eigen::Vector2d> square;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      square.emplace_back(5 + i, 2 + j); // 9 by 9, and filled
  const CrossSection section = sectionOf(square);
  const FittedCircle circle = test::circleOf(section, RadiusMeasure::hull);
  EXPECT_NEAR(circle.radius, 36 / (2 * std::numbers::pi), 1e-9);
  EXPECT_LT((circle.center - Eigen::Vector2d(9.5, 6.5)).norm(), 1e-9);
}

TEST(MeasuredCircle, FitsAHalfScannedStemAndRefusesItsHull) {
  const CrossSection section = sectionOf(arc(200, std::numbers::pi, 0.2));
  const FittedCircle circle = test::circleOf(section, RadiusMeasure::circle);
  EXPECT_NEAR(circle.radius, 10, 0.2);
  EXPECT_LT(circle.center.norm(), 0.3);
  EXPECT_NEAR(circle.error, 0.2, 0.05);
  EXPECT_NEAR(circle.coverage, 0.5, 1.0 / 16);
  EXPECT_EQ(refusalOf(section, RadiusMeasure::hull), NoRadius::oneSided);
}

TEST(MeasuredCircle, IsNotPulledByStrayPoints) {
  std::vector<Eigen::Vector2d> points = arc(120, 2 * std::numbers::pi, 0.1);
  Random random(3);
  for (int i = 0; i < 80; ++i) // 40 % of all, in a bunch beside the stem
    points.emplace_back(14 + random.normal(), 5 + random.normal());
  const FittedCircle circle = test::circleOf(sectionOf(points), RadiusMeasure::circle);
  EXPECT_NEAR(circle.radius, 10, 0.1);
  EXPECT_LT(circle.center.norm(), 0.1);
  EXPECT_LT(circle.error, 0.2);
}

TEST(MeasuredCircle, IsRefusedOnAShortArc) {
  const CrossSection section = sectionOf(arc(100, std::numbers::pi / 4, 0.01));
  EXPECT_EQ(refusalOf(section, RadiusMeasure::circle), NoRadius::oneSided);
}

// The wood lies beside the node: its far and near walls are seen within less than half a turn.
TEST(MeasuredCircle, IsNoMeanOrMaximumFromOutsideTheWood) {
  const CrossSection section = sectionOf(arc(300, 2 * std::numbers::pi, 0, {15, 0}));
  EXPECT_EQ(refusalOf(section, RadiusMeasure::mean), NoRadius::oneSided);
  EXPECT_EQ(refusalOf(section, RadiusMeasure::maximum), NoRadius::oneSided);
  EXPECT_NEAR(test::circleOf(section, RadiusMeasure::circle).radius, 10, 1e-6);
}

TEST(MeasuredCircle, IsTheMeanOfAHalfScannedStem) {
  EXPECT_NEAR(test::circleOf(sectionOf(arc(100, std::numbers::pi)), RadiusMeasure::mean).radius, 10,
              1e-9);
}

TEST(MeasuredCircle, IsRefusedForFewPoints) {
  EXPECT_EQ(refusalOf(sectionOf({}), RadiusMeasure::mean), NoRadius::fewPoints);
  for (const RadiusMeasure measure :
       {RadiusMeasure::mean, RadiusMeasure::maximum, RadiusMeasure::hull, RadiusMeasure::circle})
    EXPECT_EQ(refusalOf(sectionOf(arc(7, 2 * std::numbers::pi)), measure), NoRadius::fewPoints);
  EXPECT_NEAR(test::circleOf(sectionOf(arc(8, 2 * std::numbers::pi)), RadiusMeasure::circle).radius,
              10, 1e-9);
}

TEST(MeasuredCircle, IsRefusedForPointsOnALineOrInOnePlace) {
  std::vector<Eigen::Vector2d> line;
  for (int i = -20; i <= 20; ++i)
    line.emplace_back(i, 0);
  EXPECT_EQ(refusalOf(sectionOf(line), RadiusMeasure::circle), NoRadius::noCircle);
  EXPECT_EQ(refusalOf(sectionOf(line), RadiusMeasure::hull), NoRadius::noCircle);
  const std::vector<Eigen::Vector2d> same(20, Eigen::Vector2d(0, 0));
  for (const RadiusMeasure measure :
       {RadiusMeasure::mean, RadiusMeasure::maximum, RadiusMeasure::hull, RadiusMeasure::circle})
    EXPECT_EQ(refusalOf(sectionOf(same), measure), NoRadius::noCircle);
}

TEST(MeasuredCircle, IsTheSameEachTime) {
  const CrossSection section = sectionOf(arc(300, 2 * std::numbers::pi, 1));
  const FittedCircle first = test::circleOf(section, RadiusMeasure::circle);
  const FittedCircle second = test::circleOf(section, RadiusMeasure::circle);
  EXPECT_EQ(first.center, second.center);
  EXPECT_EQ(first.radius, second.radius);
}

} // namespace
} // namespace espalier
