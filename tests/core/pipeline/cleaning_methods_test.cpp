#include "core/base/shown_message.h"
#include "core/pipeline/cleaning.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A row of 200 points 1 apart, one point 40 beside it, which was scanned twice, and one beyond.
std::shared_ptr<const PointCloud> rowWithStrays() {
  RawPoints raw;
  for (int i = 0; i < 200; ++i)
    raw.positions.emplace_back(i, 0, 0);
  raw.positions.emplace_back(100, 40, 0);
  raw.positions.emplace_back(100, 40, 0);
  raw.positions.emplace_back(20, -30, 0);
  return std::make_shared<const PointCloud>(std::move(raw));
}

const Method& isolatedPoints() {
  static const Method method = [] {
    for (const CleaningMethod& cleaning : cleaningMethods())
      if (cleaning.method->name == "isolated_points") return *cleaning.method;
    return Method();
  }();
  return method;
}

const std::vector<double> near10 = {2, 10}; // neighbors, distance

std::vector<Vector3d> placesOf(const PointSet& points, const PointCloud& cloud) {
  std::vector<Vector3d> places;
  for (const Eigen::Index point : points.points())
    places.push_back(cloud.position(point));
  std::ranges::sort(places, {}, [](const Vector3d& place) { return place.y(); });
  return places;
}

TEST(CleaningMethods, ListsAllMethodsThatLeaveSomethingOut) {
  ASSERT_FALSE(cleaningMethods().empty());
  for (const CleaningMethod& cleaning : cleaningMethods()) {
    EXPECT_EQ(cleaning.step->makes, StepResult::cleaned);
    EXPECT_NE(cleaning.method->name, "none");
  }
}

TEST(CleaningMethods, FindsWhatAMethodLeavesOutWithThoseAtItsPlace) {
  const auto cloud = rowWithStrays();
  const PointSet found = leftOutBy(isolatedPoints(), near10, cloud, {}).value;
  EXPECT_EQ(placesOf(found, *cloud),
            (std::vector{Vector3d(20, -30, 0), Vector3d(100, 40, 0), Vector3d(100, 40, 0)}));
}

TEST(CleaningMethods, FindsNothingAmongWhatIsSetAside) {
  const auto cloud = rowWithStrays();
  const PointSet found = leftOutBy(isolatedPoints(), near10, cloud, {}).value;
  EXPECT_TRUE(leftOutBy(isolatedPoints(), near10, cloud, {.leftOut = found}).value.isEmpty());
}

TEST(CleaningMethods, SayWhyTheyCanFindNothing) {
  const auto all = cleaningMethods();
  const auto greenness = std::ranges::find_if(
      all, [](const CleaningMethod& each) { return each.method->name == "greenness"; });
  ASSERT_NE(greenness, all.end());
  const auto found = leftOutBy(*greenness->method, {-1, 0.1}, rowWithStrays(), {});
  EXPECT_TRUE(found.value.isEmpty());
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_EQ(inEnglish(found.notes[0]), "the points have no colors, so all of them are kept");
}

TEST(CleaningMethods, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)leftOutBy(isolatedPoints(), near10, rowWithStrays(), {},
                               Progress(stop.get_token(), {})),
               Cancelled);
}

} // namespace
} // namespace espalier
