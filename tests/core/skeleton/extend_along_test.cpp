#include "core/skeleton/extend_along.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr ExtendOptions options = {.step = 0.3, .reach = 0.08};

std::optional<Vector3d> extend(const Eigen::Matrix3Xf& points, const Vector3d& from,
                               const Vector3d& direction) {
  return extendAlong(SpatialIndex(points), points, from, direction, options);
}

Eigen::Matrix3Xf pole() {
  return test::cylinder({0, 0, 0}, {0, 0, 1}, 0.04, 0.01);
}

TEST(ExtendAlong, GoesOneStepAlongThePoints) {
  const auto place = extend(pole(), {0, 0, 0.2}, {0, 0, 1});
  ASSERT_TRUE(place);
  EXPECT_LT((*place - Vector3d(0, 0, 0.5)).norm(), 0.03);
}

TEST(ExtendAlong, TurnsIntoTheWood) {
  const auto place = extend(pole(), {0, 0, 0.2}, {0.3, 0, 1});
  ASSERT_TRUE(place);
  EXPECT_LT(place->head<2>().norm(), 0.04);
  EXPECT_GT(place->z(), 0.4);
}

// A ring of radius 1 about the y axis: a step from its side is an arc of that length.
TEST(ExtendAlong, FollowsABend) {
  Eigen::Matrix3Xf ring(3, 2000);
  for (Eigen::Index i = 0; i < ring.cols(); ++i) {
    const auto turn = static_cast<float>(i) * 0.0062831853F;
    const auto around = static_cast<float>(i);
    const float across = 1 + 0.02F * std::cos(around);
    ring.col(i) << across * std::cos(turn), 0.02F * std::sin(around), across * std::sin(turn);
  }
  Vector3d place(1, 0, 0);
  Vector3d direction(0, 0, 1);
  for (int i = 0; i < 5; ++i) { // Space, again and again
    const auto next = extend(ring, place, direction);
    ASSERT_TRUE(next);
    EXPECT_NEAR(next->norm(), 1, 0.05);
    direction = *next - place;
    place = *next;
  }
  EXPECT_NEAR(std::atan2(place.z(), place.x()), 1.5, 0.1); // 5 * 0.3
}

TEST(ExtendAlong, StopsWhereThePointsEnd) {
  const auto place = extend(pole(), {0, 0, 0.85}, {0, 0, 1});
  ASSERT_TRUE(place);
  EXPECT_LT(place->z(), 1.08);
  EXPECT_GT(place->z(), 0.92);
}

TEST(ExtendAlong, FindsNothingBeyondTheEnd) {
  EXPECT_FALSE(extend(pole(), {0, 0, 1.05}, {0, 0, 1}));
  EXPECT_FALSE(extend(pole(), {0.5, 0, 0.5}, {1, 0, 0}));
}

TEST(ExtendAlong, FindsNothingWithoutPoints) {
  EXPECT_FALSE(extend(Eigen::Matrix3Xf(3, 0), {0, 0, 0}, {0, 0, 1}));
}

} // namespace
} // namespace espalier
