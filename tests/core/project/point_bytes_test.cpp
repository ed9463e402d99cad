#include "core/base/error.h"
#include "core/project/point_bytes.h"

#include <gtest/gtest.h>

#include <limits>

namespace espalier {
namespace {

PointCloud coloredCloud() {
  RawPoints raw;
  for (int i = 0; i < 50; ++i) {
    raw.positions.emplace_back(500'000 + i * 7 % 11, 4'800'000 + i * 5 % 13, i * 0.25);
    raw.colors.push_back({static_cast<std::uint8_t>(i), 2, 3});
    raw.intensities.push_back(static_cast<float>(i) / 50);
  }
  return PointCloud(raw);
}

void expectSame(const PointCloud& a, const PointCloud& b) {
  EXPECT_EQ(a.positions(), b.positions());
  EXPECT_EQ(a.origin(), b.origin());
  EXPECT_EQ(a.colors(), b.colors());
  EXPECT_EQ(a.intensities(), b.intensities());
  EXPECT_EQ(a.fileOrder(), b.fileOrder());
}

TEST(PointBytes, OfACloudReadBackToTheSame) {
  const PointCloud cloud = coloredCloud();
  expectSame(cloudFrom(bytesOf(cloud)), cloud);
  expectSame(cloudFrom(bytesOf(PointCloud())), PointCloud());
}

TEST(PointBytes, KeepStations) {
  RawPoints raw;
  for (int i = 0; i < 50; ++i) {
    raw.positions.emplace_back(i, i * i % 7, 0);
    raw.stationOf.push_back(static_cast<StationIndex>(i % 2));
  }
  raw.stations = {{"north", Eigen::Vector3d(1, 2, 3)}, {"", {}}};
  const PointCloud cloud(std::move(raw));
  const std::string bytes = bytesOf(cloud);
  const PointCloud read = cloudFrom(bytes);
  expectSame(read, cloud);
  EXPECT_EQ(read.stations(), cloud.stations());
  EXPECT_EQ(read.stationOf(), cloud.stationOf());
  const std::size_t before = 3 * 8 + 3 * 8 + 50 * (12 + 4);
  for (std::size_t size = before + 1; size < bytes.size(); ++size)
    ASSERT_THROW((void)cloudFrom(bytes.substr(0, size)), Error) << size;
}

TEST(PointBytes, OfPositionsReadBackToTheSame) {
  const Eigen::Matrix3Xf positions = coloredCloud().positions();
  EXPECT_EQ(positionsFrom(bytesOf(positions)), positions);
}

TEST(PointBytes, ThatWereCutOrLengthenedAreAnError) {
  const std::string bytes = bytesOf(coloredCloud());
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    ASSERT_THROW((void)cloudFrom(bytes.substr(0, size)), Error) << size;
  EXPECT_THROW((void)cloudFrom(bytes + "x"), Error);
  EXPECT_THROW((void)positionsFrom("12345"), Error);
}

TEST(PointBytes, ThatAnnounceMorePointsThanTheyHoldAreAnError) {
  std::string bytes = bytesOf(coloredCloud());
  bytes[7] = 0x7F; // the highest byte of the count
  EXPECT_THROW((void)cloudFrom(bytes), Error);
}

TEST(PointBytes, OfPointsThatAreNotFiniteAreAnError) {
  Eigen::Matrix3Xf positions = coloredCloud().positions();
  positions(1, 4) = std::numeric_limits<float>::infinity();
  EXPECT_THROW((void)positionsFrom(bytesOf(positions)), Error);
}

} // namespace
} // namespace espalier
