#include "core/cloud/repeated_points.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Three places along x: one point at the first, four at the second, two at the third.
PointCloud threePlaces() {
  return PointCloud(RawPoints{
      .positions = {{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}});
}

TEST(RepeatedPoints, AreAllButOneOfEachPlace) {
  EXPECT_EQ(repeatedPoints(threePlaces()), PointSet::of({2, 3, 4, 6}));
  EXPECT_TRUE(repeatedPoints(PointCloud()).isEmpty());
}

TEST(RepeatedPoints, CountByTheFirstThatIsNotSetAside) {
  EXPECT_EQ(repeatedPoints(threePlaces(), PointSet::of({1, 3})), PointSet::of({4, 6}));
  EXPECT_EQ(repeatedPoints(threePlaces(), PointSet::of({1, 2, 3, 4, 5})), PointSet());
}

TEST(RepeatedPoints, TakeTheValueOfTheOneThatCounts) {
  std::vector<int> values = {10, -1, 20, -1, -1, 30, -1}; // the first of its place is set aside
  const auto counts = [](Eigen::Index point) { return point == 0 || point == 2 || point == 5; };
  forEachRepeated(threePlaces(), counts, [&](Eigen::Index point, Eigen::Index before) {
    values[static_cast<std::size_t>(point)] = values[static_cast<std::size_t>(before)];
  });
  EXPECT_EQ(values, (std::vector<int>{10, -1, 20, 20, 20, 30, 30}));
}

} // namespace
} // namespace espalier
