#include "core/evaluate/traits/breast_height.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr double height = 1.3; // [L]

/// A stick from z = 0 to 10 whose radius falls evenly from 2 to 1: 1.87 at 1.3.
Skeleton stem(double thicker = 0) {
  Skeleton plant = test::stick(11);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 2 - plant[id].position.z() / 10 + thicker);
  return plant;
}

TEST(StemDiameters, AreMeasuredBetweenNodes) {
  const StemDiameters found = stemDiameters(stem(0.5), stem(), height);
  EXPECT_EQ(found.missing, "");
  EXPECT_NEAR(found.reference.value(), 2 * 1.87, 1e-12);
  EXPECT_NEAR(found.result.value(), 2 * 2.37, 1e-12);
  EXPECT_NEAR(found.error().value(), 1, 1e-12);
  EXPECT_NEAR(found.relativeError().value(), 0.5 / 1.87, 1e-12);
}

TEST(StemDiameters, AreAtOneHeightAboveTheFootOfTheReference) {
  Skeleton cut; // as where the scanner did not see the foot
  std::optional<NodeId> last;
  for (std::uint32_t i = 1; i < 11; ++i) {
    const Node node = stem()[NodeId{i}];
    last = cut.add({.position = node.position, .radius = node.radius, .parent = last});
  }
  EXPECT_NEAR(stemDiameters(cut, stem(), height).error().value(), 0, 1e-12);
  const Eigen::Vector3d up(0, 0, 100);
  EXPECT_NEAR(
      stemDiameters(test::shifted(cut, up), test::shifted(stem(), up), height).error().value(), 0,
      1e-12);
  EXPECT_EQ(stemDiameters(test::shifted(cut, {0, 0, 0.5}), stem(), height).missing,
            "the plant begins above breast height");
}

TEST(StemDiameters, SayWhyThereIsNone) {
  const auto missing = [](const Skeleton& result, const Skeleton& reference, double at = height) {
    const StemDiameters found = stemDiameters(result, reference, at);
    EXPECT_FALSE(found.error().has_value());
    return found.missing;
  };
  EXPECT_EQ(missing(stem(), stem(), 0), "the unit of the lengths is not known");
  EXPECT_EQ(missing(stem(), test::scaled(stem(), 0.1)),
            "the stem of the reference does not rise that high");
  EXPECT_EQ(missing(test::scaled(stem(), 0.1), stem()),
            "the stem of the plant does not rise that high");
  Skeleton thin = stem();
  thin.setRadius(NodeId{1}, 0);
  EXPECT_EQ(missing(thin, stem()), "the plant has no radius at breast height");
  EXPECT_TRUE(stemDiameters(thin, stem(), height).reference.has_value());
}

TEST(StemDiameters, AreOfTheStemOfTheLongestTreeAlone) {
  Skeleton plant = stem();
  plant.add({.position = {3, 0, 2}, .radius = 9, .parent = NodeId{0}, .edge = EdgeType::branching});
  EXPECT_NEAR(stemDiameters(plant, stem(), height).error().value(), 0, 1e-12);
  Skeleton two; // a shorter tree comes first
  const NodeId foot = two.add({.position = {5, 0, 0}, .radius = 7});
  two.add({.position = {5, 0, 3}, .radius = 7, .parent = foot});
  std::optional<NodeId> last;
  for (const NodeId id : stem().ids())
    last = two.add({.position = stem()[id].position, .radius = stem()[id].radius, .parent = last});
  EXPECT_NEAR(stemDiameters(two, stem(), height).error().value(), 0, 1e-12);
}

// A stem that sinks before it rises is measured where it first rises to the height.
TEST(StemDiameters, TakeTheFirstRise) {
  Skeleton crooked;
  NodeId last = crooked.add({.position = {0, 0, 0}, .radius = 1});
  last = crooked.add({.position = {0, 0, 1.3}, .radius = 2, .parent = last});
  last = crooked.add({.position = {1, 0, 1.3}, .radius = 3, .parent = last});
  crooked.add({.position = {1, 0, 3}, .radius = 4, .parent = last});
  EXPECT_EQ(stemDiameters(crooked, stem(), height).result, 4);
}

TEST(BreastHeight, IsOneLengthInAllUnits) {
  EXPECT_EQ(breastHeightIn("m"), 1.3);
  EXPECT_EQ(breastHeightIn("cm"), 130);
  EXPECT_EQ(breastHeightIn("mm"), 1300);
  EXPECT_EQ(breastHeightIn(""), 0);
  const StemDiameters inMillimeters =
      stemDiameters(test::scaled(stem(), 1000), test::scaled(stem(), 1000), 1300);
  EXPECT_NEAR(inMillimeters.result.value(), 2 * 1.87, 1e-9) << "scaled() leaves radii";
}

} // namespace
} // namespace espalier
