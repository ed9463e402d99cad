#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/spatial_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <stop_token>

namespace espalier {
namespace {

Eigen::Matrix3Xf randomPoints(int count, std::uint64_t seed) {
  Random random(seed);
  Eigen::Matrix3Xf points(3, count);
  for (int i = 0; i < count; ++i)
    points.col(i) = random.direction().cast<float>();
  return points;
}

/// Points of a coarse grid: many are equally far from others, and many lie at one place.
Eigen::Matrix3Xf gridPoints(int count, std::uint64_t seed) {
  return (20 * randomPoints(count, seed)).array().round().matrix();
}

/// The same points in an order in which the next is often beside.
Eigen::Matrix3Xf sorted(const Eigen::Matrix3Xf& points) {
  std::vector<std::array<float, 3>> places;
  for (const auto& point : points.colwise())
    places.push_back({point[0], point[1], point[2]});
  std::ranges::sort(places);
  Eigen::Matrix3Xf result(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.col(i) = Eigen::Map<const Eigen::Vector3f>(places[static_cast<std::size_t>(i)].data());
  return result;
}

/// Squared distances of all points to `place`, sorted.
std::vector<float> sortedDistances(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& place) {
  std::vector<float> result;
  result.reserve(static_cast<std::size_t>(points.cols()));
  for (int i = 0; i < points.cols(); ++i)
    result.push_back((points.col(i) - place).squaredNorm());
  std::sort(result.begin(), result.end());
  return result;
}

TEST(SpatialIndex, FindsTheNearestPoints) {
  const Eigen::Matrix3Xf points = randomPoints(500, 1);
  const SpatialIndex index(points);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3f place = 0.9F * points.col(i);
    const std::vector<float> expected = sortedDistances(points, place);
    const std::vector<Neighbor> found = index.nearest(place, 10);
    ASSERT_EQ(found.size(), 10U);
    for (std::size_t j = 0; j < found.size(); ++j)
      EXPECT_FLOAT_EQ(found[j].squaredDistance, expected[j]);
  }
}

TEST(SpatialIndex, FindsAllPointsWithinARadius) {
  const Eigen::Matrix3Xf points = randomPoints(500, 2);
  const SpatialIndex index(points);
  for (int i = 0; i < 50; ++i) {
    const std::vector<float> all = sortedDistances(points, points.col(i));
    const auto expected = std::count_if(all.begin(), all.end(), [](float d) { return d < 0.16F; });
    EXPECT_EQ(index.within(points.col(i), 0.4F).size(), static_cast<std::size_t>(expected));
  }
}

TEST(SpatialIndex, PassesOverPoints) {
  const Eigen::Matrix3Xf points = randomPoints(500, 5);
  const SpatialIndex whole(points);
  std::vector<bool> isOdd(500, false);
  std::vector<Eigen::Index> even;
  for (Eigen::Index i = 0; i < 500; ++i) {
    isOdd[static_cast<std::size_t>(i)] = i % 2 == 1;
    if (i % 2 == 0) even.push_back(i);
  }
  const SpatialIndex index = whole.passingOver(isOdd);
  const Eigen::Matrix3Xf kept = points(Eigen::all, even);
  const SpatialIndex expected(kept);
  const auto accepts = [](Eigen::Index i) { return i % 3 == 0; };
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3f place = 0.9F * points.col(i);
    const auto found = index.nearest(place, 7);
    const auto nearest = expected.nearest(place, 7);
    ASSERT_EQ(found.size(), nearest.size());
    for (std::size_t j = 0; j < found.size(); ++j)
      EXPECT_EQ(found[j].index, 2 * nearest[j].index);
    EXPECT_EQ(index.within(place, 0.4F).size(), expected.within(place, 0.4F).size());
    const auto accepted = index.nearestIf(place, 3, accepts);
    ASSERT_TRUE(accepted);
    EXPECT_EQ(accepted->index % 6, 0);
  }
  EXPECT_EQ(index.nearest(points.col(1), 1000).size(), 250U) << "all there are";
  EXPECT_EQ(whole.nearest(points.col(1), 1)[0].index, 1) << "the whole index finds all";
  EXPECT_TRUE(whole.passingOver(std::vector<bool>(500, true)).nearest(points.col(1), 3).empty());
}

TEST(SpatialIndex, FindsTheNearestPointOfThoseAccepted) {
  const Eigen::Matrix3Xf points = randomPoints(500, 3);
  const SpatialIndex index(points);
  const auto isOdd = [](Eigen::Index i) { return i % 2 == 1; };
  for (int i = 0; i < 50; ++i) {
    float nearest = 4;
    for (int j = 1; j < points.cols(); j += 2)
      nearest = std::min(nearest, (points.col(j) - points.col(i)).squaredNorm());
    const auto found = index.nearestIf(points.col(i), 2, isOdd);
    ASSERT_TRUE(found && isOdd(found->index));
    EXPECT_FLOAT_EQ(found->squaredDistance, nearest);
  }
  EXPECT_FALSE(index.nearestIf(points.col(0), 2, [](Eigen::Index) { return false; }));
}

TEST(SpatialIndex, FindsTheOneNearestPoint) {
  const Eigen::Matrix3Xf points = randomPoints(500, 4);
  SpatialIndex index(points);
  const Eigen::Vector3f place(0.4F, 0.5F, 0.6F);
  const std::vector<Neighbor> two = index.nearest(place, 2);
  const auto one = index.nearestOne(place);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->index, two[0].index);
  EXPECT_EQ(one->squaredDistance, two[0].squaredDistance);
  EXPECT_FALSE(index.nearestOne(place, 0.99F * std::sqrt(one->squaredDistance)));
  std::vector<bool> passed(500, false);
  passed[static_cast<std::size_t>(one->index)] = true;
  EXPECT_EQ(index.passingOver(passed).nearestOne(place)->index, two[1].index);
  const Eigen::Matrix3Xf none(3, 0);
  EXPECT_FALSE(SpatialIndex(none).nearestOne(place));
}

TEST(SpatialIndex, ListsOthersOfEachPointWithoutItself) {
  const Eigen::Matrix3Xf points = randomPoints(300, 4);
  const NearestOthers others = SpatialIndex(points).nearestOthers(5);
  ASSERT_EQ(others.perPoint, 5);
  for (std::size_t i = 0; i < 300; ++i) {
    const auto begin = others.indices.begin() + static_cast<std::ptrdiff_t>(5 * i);
    const std::set<std::uint32_t> own(begin, begin + 5);
    EXPECT_EQ(own.size(), 5U);
    EXPECT_FALSE(own.contains(static_cast<std::uint32_t>(i)));
  }
}

// The list looks no farther than the points beside one let it; that must lose none.
TEST(SpatialIndex, ListsTheOthersThatASearchFromEachPointFinds) {
  for (const Eigen::Matrix3Xf& points :
       {randomPoints(2000, 6), sorted(randomPoints(20'000, 7)), sorted(gridPoints(20'000, 7))}) {
    const SpatialIndex index(points);
    const NearestOthers others = index.nearestOthers(9);
    std::vector<std::uint32_t> indices;
    std::vector<float> squaredDistances;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      std::vector<Neighbor> found = index.nearest(points.col(i), 10);
      std::erase_if(found, [&](const Neighbor& each) { return each.index == i; });
      found.resize(9, {}); // where ten more lie at its place, it is not among them
      for (const Neighbor& each : found) {
        indices.push_back(static_cast<std::uint32_t>(each.index));
        squaredDistances.push_back(each.squaredDistance);
      }
    }
    EXPECT_EQ(others.indices, indices);
    EXPECT_EQ(others.squaredDistances, squaredDistances);
  }
}

TEST(SpatialIndex, ReturnsHowFarTheOthersReach) {
  for (const Eigen::Matrix3Xf& points :
       {sorted(gridPoints(20'000, 7)), randomPoints(5, 7), randomPoints(1, 7)}) {
    const SpatialIndex index(points);
    const NearestOthers others = index.nearestOthers(9);
    std::vector<float> farthest(static_cast<std::size_t>(points.cols()), 0);
    const auto perPoint = static_cast<std::size_t>(others.perPoint);
    for (std::size_t i = 0; i < farthest.size() && perPoint > 0; ++i)
      farthest[i] = others.squaredDistances[(i + 1) * perPoint - 1];
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(index.squaredReaches(9), farthest) << threads;
    }
  }
}

TEST(SpatialIndex, IsTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = gridPoints(60'000, 8);
  const NearestOthers onAll = SpatialIndex(points).nearestOthers(9);
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    const NearestOthers others = SpatialIndex(points).nearestOthers(9);
    EXPECT_EQ(others.indices, onAll.indices) << threads;
    EXPECT_EQ(others.squaredDistances, onAll.squaredDistances) << threads;
  }
}

TEST(SpatialIndex, StopsBeingBuiltWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const Eigen::Matrix3Xf points = gridPoints(20'000, 9);
  EXPECT_THROW(SpatialIndex(points, Progress(source.get_token(), {})), Cancelled);
}

TEST(SpatialIndex, CopesWithCoincidentPoints) {
  const Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Zero(3, 100);
  const NearestOthers others = SpatialIndex(points).nearestOthers(5);
  for (std::size_t i = 0; i < others.indices.size(); ++i)
    EXPECT_NE(others.indices[i], static_cast<std::uint32_t>(i / 5));
}

TEST(SpatialIndex, GivesAllThereIsWhenAskedForMore) {
  const Eigen::Matrix3Xf points = randomPoints(3, 5);
  const SpatialIndex index(points);
  EXPECT_EQ(index.nearest(points.col(0), 9).size(), 3U);
  EXPECT_EQ(index.nearestOthers(9).perPoint, 2);
  const Eigen::Matrix3Xf none(3, 0);
  const SpatialIndex empty(none);
  EXPECT_TRUE(empty.nearest(Eigen::Vector3f::Zero(), 3).empty());
  EXPECT_TRUE(empty.within(Eigen::Vector3f::Zero(), 3).empty());
}

} // namespace
} // namespace espalier
