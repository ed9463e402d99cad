#include "core/base/error.h"
#include "core/evaluate/match/edit_comparison.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace espalier {
namespace {

double distance(const Skeleton& result, const Skeleton& reference, EditCost cost,
                EditUnit unit = EditUnit::segment) {
  return editComparison(result, reference, {.unit = unit, .cost = cost}).distance.distance;
}

constexpr std::array allCosts = {EditCost::topology, EditCost::attributes, EditCost::length,
                                 EditCost::place, EditCost::shape};
constexpr std::array allUnits = {EditUnit::node, EditUnit::segment, EditUnit::axis};

TEST(EditComparison, OfAPlantWithItselfIsNothing) {
  for (const EditUnit unit : allUnits)
    for (const EditCost cost : allCosts) {
      const EditComparison same =
          editComparison(test::fork(3), test::fork(3), {.unit = unit, .cost = cost});
      EXPECT_EQ(same.distance.distance, 0);
      EXPECT_EQ(same.removed + same.inserted, 0U);
    }
}

TEST(EditComparison, CountsPartsOfTheScaleThatIsAsked) {
  Skeleton missing = test::fork(3);
  missing.erase(NodeId{4}); // an arm of one edge: one node, one segment, one axis
  for (const EditUnit unit : allUnits) {
    const EditComparison found = editComparison(missing, test::fork(3), {.unit = unit});
    EXPECT_EQ(found.distance.distance, 1) << static_cast<int>(unit);
    EXPECT_EQ(found.inserted, 1U);
    EXPECT_EQ(found.removed, 0U);
  }
  EXPECT_NEAR(distance(missing, test::fork(3), EditCost::length), std::sqrt(2.0), 1e-12);
}

TEST(EditComparison, SegmentsAndAxesDoNotDependOnTheSpacingOfNodes) {
  const Skeleton fork = test::fork(3);
  const Skeleton denser = test::withMiddleNodes(fork);
  for (const EditCost cost : {EditCost::topology, EditCost::length})
    for (const EditUnit unit : {EditUnit::segment, EditUnit::axis})
      EXPECT_NEAR(distance(denser, fork, cost, unit), 0, 1e-12);
  EXPECT_EQ(distance(denser, fork, EditCost::topology, EditUnit::node), 4) << "one on each edge";
}

TEST(EditComparison, OnlyPlaceAndShapeFeelAShift) {
  const Skeleton moved = test::shifted(test::fork(3), {0, 0, 0.25});
  for (const EditCost cost : {EditCost::topology, EditCost::attributes, EditCost::length})
    EXPECT_NEAR(distance(moved, test::fork(3), cost), 0, 1e-12);
  EXPECT_NEAR(distance(moved, test::fork(3), EditCost::place), 4 * 0.25, 1e-12);
  EXPECT_NEAR(distance(moved, test::fork(3), EditCost::shape), 4 * 0.25, 1e-12);
}

TEST(EditComparison, AttributesAreComparedInSharesOfTheirRange) {
  // Two sticks of lengths 4 and 8 in one direction: only the length differs, and by all its range.
  const EditOptions onlyLength{.cost = EditCost::attributes,
                               .lengthWeight = 1,
                               .radiusWeight = 0,
                               .orderWeight = 0,
                               .directionWeight = 0};
  const EditComparison found = editComparison(test::stick(5), test::stick(9), onlyLength);
  EXPECT_EQ(found.distance.distance, 2);
  EditOptions half = onlyLength;
  half.directionWeight = 1;
  EXPECT_EQ(editComparison(test::stick(5), test::stick(9), half).distance.distance, 1);
}

TEST(EditComparison, MergingUndoesTheCutOfASpur) {
  Skeleton spurred = test::stick(5);
  spurred.add({.position = {0.1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  EditOptions options{.cost = EditCost::length};
  EXPECT_NEAR(editComparison(spurred, test::stick(5), options).distance.distance, 2 + 2 + 0.1,
              1e-12); // the halves differ from the whole by half, one is left, and the spur
  options.mergesPaths = true;
  const EditComparison merged = editComparison(spurred, test::stick(5), options);
  EXPECT_NEAR(merged.distance.distance, 0.1, 1e-12);
  EXPECT_EQ(merged.removed, 1U);
  ASSERT_EQ(merged.distance.matches.size(), 1U);
  EXPECT_EQ(merged.distance.matches[0].first.size(), 2U);
  const EditComparison split = editComparison(test::stick(5), spurred, options);
  EXPECT_NEAR(split.distance.distance, 0.1, 1e-12);
  EXPECT_EQ(split.inserted, 1U);
}

// A spur cuts a stick in two: removing it is one edit, and makes one segment of the two again.
TEST(EditComparison, MergingCountsTheSpurAloneWhereOnlyTopologyCounts) {
  Skeleton spurred = test::stick(5);
  spurred.add({.position = {0.1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  EXPECT_EQ(editComparison(spurred, test::stick(5)).distance.distance, 2) << "the spur, and a half";
  const EditComparison merged = editComparison(spurred, test::stick(5), {.mergesPaths = true});
  EXPECT_EQ(merged.distance.distance, 1);
  EXPECT_EQ(merged.removed, 1U);
  ASSERT_EQ(merged.distance.matches.size(), 1U);
  EXPECT_EQ(merged.distance.matches[0].first.size(), 2U);
  EXPECT_EQ(editComparison(test::stick(5), spurred, {.mergesPaths = true}).distance.distance, 1);
  const Skeleton apart = test::fork(3); // nothing is cut: nothing changes
  EXPECT_EQ(editComparison(apart, test::fork(2), {.mergesPaths = true}).distance.distance,
            editComparison(apart, test::fork(2)).distance.distance);
}

TEST(EditComparison, MergingNeverMakesAnAxisThatIsTooManyFree) {
  Skeleton spurred = test::stick(5);
  spurred.add({.position = {0.1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  const EditOptions options{.unit = EditUnit::axis, .mergesPaths = true};
  EXPECT_EQ(editComparison(spurred, test::stick(5), options).distance.distance, 1);
}

TEST(EditComparison, MergingNeverCostsMore) {
  const Skeleton bush = test::bush();
  Skeleton spurred = bush;
  for (const NodeId id : bush.ids())
    if (indexOf(id) % 9 == 4)
      spurred.add({.position = bush[id].position + Eigen::Vector3d(0, 0.1, 0),
                   .parent = id,
                   .edge = EdgeType::branching});
  for (const EditUnit unit : allUnits)
    for (const EditCost cost : allCosts) {
      EditOptions options{.unit = unit, .cost = cost};
      const double plain = editComparison(spurred, bush, options).distance.distance;
      options.mergesPaths = true;
      const double merged = editComparison(spurred, bush, options).distance.distance;
      EXPECT_LE(merged, plain + 1e-9);
      EXPECT_TRUE(unit != EditUnit::segment || merged < 0.9 * plain) << merged << " of " << plain;
    }
}

TEST(EditComparison, RefusesWhatHasNoNodes) {
  EXPECT_THROW((void)editComparison({}, test::fork(3)), Error);
}

// METHOD's figures of the plant that the method's authors published.
TEST(EditComparison, OfThePublishedPine) {
  ESPALIER_SHARED_FILE(automaticFile, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expertFile, "puu1/expert.mtg");
  const Skeleton automatic = test::readTabStructure(automaticFile);
  const Skeleton expert = test::readTabStructure(expertFile);
  const EditComparison topology = editComparison(automatic, expert);
  EXPECT_EQ(topology.distance.distance, 1000);
  EXPECT_EQ(topology.distance.removingAll + topology.distance.insertingAll, 2622);
  EXPECT_EQ(topology.matched, 811U);
  const EditComparison length = editComparison(automatic, expert, {.cost = EditCost::length});
  EXPECT_NEAR(length.distance.distance, 147'871, 1);
  EXPECT_NEAR(length.distance.similarity(), 0.556, 5e-4);
  EXPECT_NEAR(distance(automatic, expert, EditCost::place), 208'719, 1);
}

} // namespace
} // namespace espalier
