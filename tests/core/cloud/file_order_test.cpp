#include "core/cloud/file_order.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Points that a file lists from far to near, so that they stand elsewhere in memory.
PointCloud scattered() {
  RawPoints raw;
  for (int i = 0; i < 40; ++i) {
    raw.positions.emplace_back((i * 17) % 40, (i * 7) % 40, (i * 29) % 40);
    raw.colors.push_back({static_cast<std::uint8_t>(i), 0, 0});
    raw.intensities.push_back(static_cast<float>(i));
    raw.stationOf.push_back(static_cast<StationIndex>(i % 2));
  }
  raw.stations = {{.name = "north", .scanner = {}}, {.name = "south", .scanner = {}}};
  return PointCloud(std::move(raw));
}

TEST(FileOrder, SortsThePointsWithAllTheyHaveAsTheFileListsThem) {
  const PointCloud cloud = scattered();
  const PointCloud sorted = sortedAsInFile(cloud);
  ASSERT_EQ(sorted.size(), 40);
  EXPECT_EQ(sorted.origin(), cloud.origin());
  EXPECT_EQ(sorted.stations(), cloud.stations());
  for (int i = 0; i < 40; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LT(
        (sorted.position(i) - Eigen::Vector3d((i * 17) % 40, (i * 7) % 40, (i * 29) % 40)).norm(),
        1e-5);
    EXPECT_EQ(sorted.colors()[at][0], i);
    EXPECT_EQ(sorted.intensities()[at], static_cast<float>(i));
    EXPECT_EQ(sorted.stationOf(i), at % 2);
    EXPECT_EQ(sorted.fileOrder()[at], at);
  }
}

TEST(FileOrder, StopsWhenAsked) {
  RawPoints raw;
  for (int i = 0; i < 50'000; ++i)
    raw.positions.emplace_back((i * 17) % 41, (i * 7) % 43, (i * 29) % 47);
  const PointCloud cloud(std::move(raw));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)pointsInFileOrder(cloud, Progress(stop.get_token(), {})), Cancelled);
}

TEST(FileOrder, ListsPointsByTheirColumn) {
  const PointCloud cloud = scattered();
  const PointCloud listed = listedByColumn(cloud);
  EXPECT_EQ(listed.positions(), cloud.positions());
  EXPECT_EQ(listed.colors(), cloud.colors());
  EXPECT_NE(listed.fileOrder(), cloud.fileOrder());
  EXPECT_EQ(pointsInFileOrder(listed).front(), 0);
  EXPECT_EQ(sortedAsInFile(listed).positions(), cloud.positions());
}

} // namespace
} // namespace espalier
