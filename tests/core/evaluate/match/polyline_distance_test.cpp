#include "core/evaluate/match/polyline_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

TEST(EvenPlaces, LieAtEqualStepsAndKeepBothEnds) {
  const Polyline places = evenPlaces({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}, 1.1); // 3 long: 3 parts
  ASSERT_EQ(places.size(), 4U);
  EXPECT_NEAR((places[1] - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((places[2] - Eigen::Vector3d(2, 0, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(places[3], Eigen::Vector3d(2, 1, 0));
}

TEST(EvenPlaces, DoNotDependOnVerticesAlongAnEdge) {
  const Polyline few = evenPlaces({{0, 0, 0}, {0, 0, 1}}, 0.25);
  const Polyline many =
      evenPlaces({{0, 0, 0}, {0, 0, 0.1}, {0, 0, 0.1}, {0, 0, 0.7}, {0, 0, 1}}, 0.25);
  ASSERT_EQ(few.size(), 5U);
  ASSERT_EQ(many.size(), 5U);
  for (std::size_t i = 0; i < few.size(); ++i)
    EXPECT_NEAR((few[i] - many[i]).norm(), 0, 1e-12);
}

TEST(EvenPlaces, OfAPlaceAreThatPlace) {
  EXPECT_EQ(evenPlaces({{1, 2, 3}}, 1).size(), 1U);
  EXPECT_EQ(evenPlaces({{1, 2, 3}, {1, 2, 3}}, 1).size(), 1U);
}

TEST(PolylineDistance, IsMeasuredBetweenVerticesToo) {
  const Polyline corner = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
  EXPECT_DOUBLE_EQ(farthestOf({{2, 1, 0}}, corner, 10), 1);
  EXPECT_DOUBLE_EQ(farthestOf({{2, 1, 0}, {7, 8, 0}}, corner, 10), 5) << "from the end";
  EXPECT_DOUBLE_EQ(farthestOf({{3, 4, 0}}, {{0, 0, 0}}, 10), 5) << "of a single place";
}

TEST(PolylineDistance, StopsOnceItIsAboveTheLimit) {
  EXPECT_GT(farthestOf({{0, 3, 0}, {0, 100, 0}}, {{0, 0, 0}, {1, 0, 0}}, 2), 2);
}

} // namespace
} // namespace espalier
