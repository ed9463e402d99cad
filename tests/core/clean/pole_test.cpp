#include "core/base/random.h"
#include "core/clean/pole.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const PoleOptions poleOptions{
    .tolerance = 0.02, .mostRadius = 0.08, .reach = 0.3, .gap = 0.15, .leastLength = 1.0};

const Eigen::Vector3d poleFoot(0.5, 0, 0);
const Eigen::Vector3d poleTop(0.6, 0.1, 2);

/// A leaning pole beside a fork with a crown, of which it touches nothing.
Eigen::Matrix3Xf poleAndPlant() {
  Eigen::Matrix3Xf plant = test::forkCloud();
  plant.row(0).array() -= 1;
  return test::both(test::cylinder(poleFoot, poleTop, 0.05, 0.015), plant);
}

TEST(Pole, IsFoundAtAPlaceOnItWithAllOfItsPoints) {
  const Eigen::Matrix3Xf pole = test::cylinder(poleFoot, poleTop, 0.05, 0.015);
  const auto found =
      poleAt(poleAndPlant(), (poleFoot + poleTop) / 2 + Eigen::Vector3d(0.05, 0, 0), poleOptions);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->radius, 0.05, 0.004);
  EXPECT_LT((found->foot - poleFoot).norm(), 0.03);
  EXPECT_LT((found->top - poleTop).norm(), 0.03);
  EXPECT_LT(found->error, 0.01);
  EXPECT_GT(std::ssize(found->points), 0.99 * static_cast<double>(pole.cols()));
  for (const Eigen::Index point : found->points)
    EXPECT_LT(point, pole.cols()) << "none of the plant";
}

TEST(Pole, GoesOnOverAGapThatIsNotTooWide) {
  for (const double gap : {0.1, 0.5}) {
    const Eigen::Vector3d middle(0, 0, 1);
    const Eigen::Vector3d behind(0, 0, 1 + gap);
    const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, middle, 0.05, 0.015),
                                               test::cylinder(behind, {0, 0, 2}, 0.05, 0.015));
    const auto found = poleAt(points, {0.05, 0, 0.5}, poleOptions);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->top.z(), gap < 0.15 ? 2 : 1, 0.05) << gap;
  }
}

TEST(Pole, IsNoneWhereNothingIsRoundAndUpright) {
  Random random(3);
  Eigen::Matrix3Xf wall(3, 4000);
  for (Eigen::Index i = 0; i < wall.cols(); ++i)
    wall.col(i) = Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 0).cast<float>();
  EXPECT_FALSE(poleAt(wall, {0, 0, 0}, poleOptions)) << "a floor";
  EXPECT_FALSE(poleAt(poleAndPlant(), {5, 5, 5}, poleOptions)) << "nothing";
  EXPECT_FALSE(poleAt(Eigen::Matrix3Xf(3, 0), {0, 0, 0}, poleOptions));
  const Eigen::Matrix3Xf same = Eigen::Vector3f(1, 2, 3).replicate(1, 50);
  EXPECT_FALSE(poleAt(same, {1, 2, 3}, poleOptions));
}

TEST(Pole, IsSearchedForAndATrunkIsNone) {
  const std::vector<Pole> found = polesIn(poleAndPlant(), poleOptions);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT((found.front().foot - poleFoot).norm(), 0.03);
  EXPECT_TRUE(polesIn(Eigen::Matrix3Xf(3, 0), poleOptions).empty());
}

TEST(Pole, EndsFreeBelowATwig) {
  const Eigen::Vector3d up = (poleTop - poleFoot).normalized();
  const Eigen::Vector3d aside(0.2, 0, 0);
  for (const double radius : {0.004, 0.05}) { // a twig beside, or what goes on as thick
    const Eigen::Matrix3Xf above =
        test::cylinder(poleTop + 0.08 * up + aside, poleTop + 0.5 * up + aside, radius, 0.015);
    const std::size_t wanted = radius < 0.01 ? 1 : 0;
    EXPECT_EQ(polesIn(test::both(poleAndPlant(), above), poleOptions).size(), wanted) << radius;
  }
}

TEST(Pole, IsTheSameInAnotherUnit) {
  PoleOptions inMillimeters = poleOptions;
  for (Length PoleOptions::*length :
       {&PoleOptions::tolerance, &PoleOptions::mostRadius, &PoleOptions::reach, &PoleOptions::gap,
        &PoleOptions::leastLength})
    inMillimeters.*length = 1000 * (poleOptions.*length);
  const auto small = poleAt(poleAndPlant(), {0.55, 0.1, 1}, poleOptions);
  const auto large = poleAt(1000 * poleAndPlant(), {550, 100, 1000}, inMillimeters);
  ASSERT_TRUE(small && large);
  EXPECT_NEAR(large->radius / 1000, small->radius, 1e-4);
  EXPECT_EQ(large->points, small->points);
}

TEST(Pole, IsFoundInAScanThatLies) {
  const Eigen::Matrix3Xf points = poleAndPlant();
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).z() + 100, points.col(i).x(), points.col(i).y());
  const PointCloud cloud(std::move(raw));
  const PointSet found = polePointsAt(cloud, {}, UpAxis::x, {.spacing = 0.015, .height = 3},
                                      {101, 0.6, 0.05}, poleOptions);
  const auto pole = static_cast<double>(test::cylinder(poleFoot, poleTop, 0.05, 0.015).cols());
  EXPECT_NEAR(static_cast<double>(found.size()), pole, 0.01 * pole);
  EXPECT_TRUE(polePointsAt(cloud, found, UpAxis::x, {.spacing = 0.015, .height = 3},
                           {101, 0.6, 0.05}, poleOptions)
                  .isEmpty())
      << "what is left out is not looked at";
}

TEST(Pole, StopsWhenAsked) {
  const Eigen::Matrix3Xf points = poleAndPlant();
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)poleAt(points, {0.55, 0.1, 1}, poleOptions, progress);
  }));
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)polesIn(points, poleOptions, progress); }));
}

} // namespace
} // namespace espalier
