#include "core/evaluate/traits/wood_amounts.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// A trunk of 3 from radius 2 to 1, on whose top a branch of 4 stands with radius 0.5.
Skeleton plant() {
  Skeleton skeleton;
  const NodeId root = skeleton.add({.position = {0, 0, 0}, .radius = 2});
  const NodeId top = skeleton.add({.position = {0, 0, 3}, .radius = 1, .parent = root});
  skeleton.add({.position = {4, 0, 3}, .radius = 0.5, .parent = top, .edge = EdgeType::branching});
  return skeleton;
}

TEST(WoodAmounts, AreThoseOfTruncatedCones) {
  const WoodAmounts amounts = woodAmounts(plant(), {});
  EXPECT_EQ(amounts.whole.edges, 2U);
  EXPECT_DOUBLE_EQ(amounts.whole.length, 7);
  EXPECT_DOUBLE_EQ(amounts.whole.volume,
                   std::numbers::pi / 3 * 3 * (4 + 2 + 1) + std::numbers::pi * 0.25 * 4);
  EXPECT_DOUBLE_EQ(amounts.whole.area,
                   std::numbers::pi * 3 * std::sqrt(10.0) + 2 * std::numbers::pi * 0.5 * 4);
}

TEST(WoodAmounts, HaveAnIntervalWhereRadiiHave) {
  Skeleton wood = plant();
  EXPECT_FALSE(volumeInterval(wood)) << "of radii nothing is known of";
  EXPECT_DOUBLE_EQ(volumeOfUnknownError(wood), 1);
  for (const NodeId id : wood.ids())
    wood.setRadius(id, wood[id].radius, {RadiusSource::measured, 0.5F, 2});
  const double volume = woodAmounts(wood, {}).whole.volume;
  const auto interval = volumeInterval(wood);
  ASSERT_TRUE(interval);
  EXPECT_EQ(volumeOfUnknownError(wood), 0);
  EXPECT_NEAR(interval->least, volume * std::pow(0.25, 0.8), 1e-9);
  EXPECT_NEAR(interval->most, volume * std::pow(4, 0.8), 1e-9);
}

TEST(WoodAmounts, TakeRadiiSetByHandAsTheyAre) {
  Skeleton wood = plant();
  wood.setRadius(NodeId{2}, 0.5, {RadiusSource::measured, 0.5F, 2});
  EXPECT_FALSE(volumeInterval(wood)) << "most of the wood is of unknown radii";
  const double trunk = std::numbers::pi / 3 * 3 * (4 + 2 + 1);
  const double volume = woodAmounts(wood, {}).whole.volume;
  EXPECT_NEAR(volumeOfUnknownError(wood), trunk / volume, 1e-12);
  for (const NodeId id : {NodeId{0}, NodeId{1}})
    wood.setRadius(id, wood[id].radius, {.source = RadiusSource::byHand});
  const auto interval = volumeInterval(wood);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->least,
              volume * std::pow((trunk + std::numbers::pi * 0.0625 * 4) / volume, 0.8), 1e-9);
}

TEST(WoodAmounts, CountByOrderAndByRadius) {
  const WoodAmounts amounts = woodAmounts(plant(), {0.5, 1});
  ASSERT_EQ(amounts.byOrder.size(), 2U);
  EXPECT_DOUBLE_EQ(amounts.byOrder[0].length, 3);
  EXPECT_DOUBLE_EQ(amounts.byOrder[1].length, 4);
  ASSERT_EQ(amounts.byRadius.size(), 3U);
  EXPECT_EQ(amounts.byRadius[0].edges, 1U) << "a limit belongs to the class below";
  EXPECT_EQ(amounts.byRadius[1].edges, 0U);
  EXPECT_EQ(amounts.byRadius[2].edges, 1U);
}

TEST(WoodAmounts, OfClassesAddUpToTheWhole) {
  const Skeleton bush = test::simulatedTree().truth;
  const WoodAmounts amounts = woodAmounts(bush, radiusLimits(bush));
  for (const auto& classes : {amounts.byOrder, amounts.byRadius}) {
    WoodAmount sum;
    for (const WoodAmount& each : classes) {
      sum.length += each.length;
      sum.area += each.area;
      sum.volume += each.volume;
    }
    EXPECT_NEAR(sum.length, amounts.whole.length, 1e-9);
    EXPECT_NEAR(sum.area, amounts.whole.area, 1e-9);
    EXPECT_NEAR(sum.volume, amounts.whole.volume, 1e-9);
  }
}

TEST(WoodAmounts, WithoutRadiiAreLengths) {
  Skeleton bare = plant();
  for (const NodeId id : bare.ids())
    bare.setRadius(id, 0);
  EXPECT_TRUE(radiusLimits(bare).empty());
  const WoodAmounts amounts = woodAmounts(bare, {});
  EXPECT_EQ(amounts.whole.volume, 0);
  EXPECT_DOUBLE_EQ(amounts.whole.length, 7);
  EXPECT_EQ(woodAmounts({}, {}).whole.edges, 0U);
}

TEST(RadiusLimits, HalveDownFromTheThickest) {
  EXPECT_EQ(radiusLimits(plant()), (std::vector{0.0625, 0.125, 0.25, 0.5, 1.0}));
}

} // namespace
} // namespace espalier
