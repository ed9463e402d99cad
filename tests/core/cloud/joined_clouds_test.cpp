#include "core/cloud/file_order.h"
#include "core/cloud/joined_clouds.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;

std::shared_ptr<const PointCloud> cloudOf(RawPoints raw) {
  return std::make_shared<const PointCloud>(std::move(raw));
}

RawPoints twoPoints() {
  RawPoints raw;
  raw.positions = {{1, 0, 0}, {3, 0, 0}};
  raw.colors = {{255, 0, 0}, {0, 255, 0}};
  raw.intensities = {1, 2};
  raw.stations = {{.name = "north", .scanner = Vector3d(10, 0, 0)}};
  return raw;
}

/// A quarter turn about z, then up by 5.
PlacedCloud turned(std::shared_ptr<const PointCloud> cloud) {
  return {.cloud = std::move(cloud),
          .motion = Eigen::Translation3d(0, 0, 5) *
                    Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ()) *
                    Eigen::Isometry3d::Identity(),
          .name = "b.ply"};
}

std::vector<Vector3d> placesOf(const PointCloud& cloud) {
  std::vector<Vector3d> places;
  for (const Eigen::Index point : pointsInFileOrder(cloud))
    places.push_back(cloud.position(point));
  return places;
}

TEST(JoinedClouds, HavePointsAndScannersInOneFrame) {
  const PointCloud all =
      joined({{.cloud = cloudOf(twoPoints()), .name = "a.ply"}, turned(cloudOf(twoPoints()))});
  const std::vector<Vector3d> places = placesOf(all);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_LT((places[0] - Vector3d(1, 0, 0)).norm(), 1e-6);
  EXPECT_LT((places[2] - Vector3d(0, 1, 5)).norm(), 1e-6);
  EXPECT_LT((places[3] - Vector3d(0, 3, 5)).norm(), 1e-6);
  ASSERT_EQ(all.stations().size(), 2U);
  EXPECT_EQ(all.stations()[0].scanner, Vector3d(10, 0, 0));
  EXPECT_LT((*all.stations()[1].scanner - Vector3d(0, 10, 5)).norm(), 1e-9);
}

TEST(JoinedClouds, KeepOfEachPointWhatAllHave) {
  const PointCloud all =
      joined({{.cloud = cloudOf(twoPoints()), .name = "a.ply"}, turned(cloudOf(twoPoints()))});
  const std::vector<Eigen::Index> order = pointsInFileOrder(all);
  std::vector<float> intensities;
  std::vector<std::size_t> stations;
  for (const Eigen::Index point : order) {
    intensities.push_back(all.intensities()[static_cast<std::size_t>(point)]);
    stations.push_back(all.stationOf(point));
  }
  EXPECT_THAT(intensities, ElementsAre(1, 2, 1, 2));
  EXPECT_THAT(stations, ElementsAre(0, 0, 1, 1));
  EXPECT_EQ(all.colors()[static_cast<std::size_t>(order[3])], (Color{0, 255, 0}));

  RawPoints bare = twoPoints();
  bare.colors.clear();
  const PointCloud partly =
      joined({{.cloud = cloudOf(twoPoints()), .name = {}}, turned(cloudOf(std::move(bare)))});
  EXPECT_TRUE(partly.colors().empty()) << "one has none";
  EXPECT_EQ(partly.intensities().size(), 4U);
}

TEST(JoinedClouds, AreStationsWhereNoneWereKnown) {
  RawPoints bare = twoPoints();
  bare.stations.clear();
  RawPoints both = twoPoints();
  both.stations.push_back({.name = "south", .scanner = {}});
  both.stationOf = {1, 0};
  const PointCloud all = joined(
      {{.cloud = cloudOf(std::move(bare)), .name = "a.ply"}, turned(cloudOf(std::move(both)))});
  ASSERT_EQ(all.stations().size(), 3U);
  EXPECT_EQ(all.stations()[0], (Station{.name = "a.ply", .scanner = {}}));
  EXPECT_EQ(all.stations()[2].name, "south");
  std::vector<std::size_t> stations;
  for (const Eigen::Index point : pointsInFileOrder(all))
    stations.push_back(all.stationOf(point));
  EXPECT_THAT(stations, ElementsAre(0, 0, 2, 1));
}

TEST(JoinedClouds, MayBeOneOrEmpty) {
  const PointCloud one = joined({turned(cloudOf(twoPoints()))});
  EXPECT_EQ(one.stations().size(), 1U);
  EXPECT_TRUE(one.stationOf().empty());
  EXPECT_TRUE(joined({}).isEmpty());
  EXPECT_TRUE(joined({{.cloud = cloudOf({}), .name = "a.ply"}}).isEmpty());
}

TEST(JoinedClouds, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(joined({turned(cloudOf(twoPoints()))}, progress));
  }));
}

} // namespace
} // namespace espalier
