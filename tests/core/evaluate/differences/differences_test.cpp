#include "core/base/error.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/differences/with_missed.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/evaluate/differences/differing_plants.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

constexpr double tolerance = 0.1;

std::size_t count(const Differences& found, Difference kind) {
  return static_cast<std::size_t>(std::ranges::count(found.parts, kind, &DifferingPart::kind));
}

TEST(Differences, FindsNoneInThePlantItself) {
  const Skeleton bush = test::bush();
  const Differences found = differences(bush, bush, tolerance);
  EXPECT_TRUE(found.parts.empty());
  EXPECT_EQ(found.missed, 0);
  EXPECT_EQ(found.invented, 0);
  EXPECT_NEAR(found.matchedInResult, found.matchedInReference, 1e-9);
}

TEST(Differences, AddWhatIsMissedToWhatIsDrawn) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  const WithMissed both = withMissed(result, plant, differences(result, plant, tolerance));
  ASSERT_EQ(both.skeleton.size(), result.size() + branch.size() + 1) << "and where it leaves";
  ASSERT_EQ(both.kinds.size(), both.skeleton.idEnd());
  EXPECT_EQ(both.skeleton.roots(), result.roots());
  double missed = 0;
  for (const NodeId id : both.skeleton.ids()) {
    const Node& node = both.skeleton[id];
    EXPECT_TRUE(indexOf(id) >= result.idEnd() || node == result[id]);
    if (node.parent && both.kinds[indexOf(id)] == Difference::missed)
      missed += (node.position - both.skeleton[*node.parent].position).norm();
  }
  EXPECT_DOUBLE_EQ(missed, 4);
  EXPECT_EQ(withMissed(plant, plant, differences(plant, plant, tolerance)).skeleton, plant);
}

TEST(Differences, ListsWhatIsMissedAndWhereItBelongs) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  const Differences found = differences(result, plant, tolerance);
  ASSERT_EQ(found.parts.size(), 1U);
  const DifferingPart& part = found.parts[0];
  EXPECT_EQ(part.kind, Difference::missed);
  EXPECT_THAT(part.nodes, ElementsAreArray(branch));
  EXPECT_DOUBLE_EQ(part.length, 4);
  EXPECT_EQ(part.host, trunk[5]);
  EXPECT_TRUE(part.place.isApprox(Eigen::Vector3d(0, 0, 5)));
  EXPECT_EQ(part.edge, EdgeType::branching);
  EXPECT_DOUBLE_EQ(found.missed, 4);
  EXPECT_DOUBLE_EQ(found.matchedInReference, 10);
  EXPECT_DOUBLE_EQ(found.matchedInResult, 10);
  EXPECT_EQ(found.ofReference[indexOf(branch[2])], Difference::missed);
  EXPECT_EQ(found.ofReference[indexOf(trunk[2])], Difference::matched);
}

TEST(Differences, ListsWhatIsInvented) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton reference = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  const Differences found = differences(plant, reference, tolerance);
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].kind, Difference::invented);
  EXPECT_THAT(found.parts[0].nodes, ElementsAreArray(branch));
  EXPECT_DOUBLE_EQ(found.invented, 4);
}

TEST(Differences, ListsTwigsOfOneNodeEachByItselfTheLongestFirst) {
  auto [plant, trunk, branch] = test::trunkAndBranch();
  const NodeId twig =
      plant.add({.position = {0, 2, 5}, .parent = trunk[5], .edge = EdgeType::branching});
  const Skeleton bare = test::stick(11);
  const Differences found = differences(bare, plant, tolerance);
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_DOUBLE_EQ(found.parts[0].length, 4);
  EXPECT_DOUBLE_EQ(found.parts[1].length, 2);
  EXPECT_THAT(found.parts[1].nodes, ElementsAre(twig));
}

TEST(Differences, ListsABranchThatIsAttachedElsewhere) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result =
      test::edited(plant, [&, first = branch[0], top = trunk[8]](SkeletonEditor& editor) {
        reparentNode(editor, first, top);
      });
  const Differences found = differences(result, plant, tolerance);
  ASSERT_EQ(count(found, Difference::wronglyAttached), 1U);
  EXPECT_EQ(count(found, Difference::invented), 0U) << "its first edge belongs to it";
  const DifferingPart& part = found.parts[0];
  EXPECT_EQ(part.kind, Difference::wronglyAttached);
  EXPECT_EQ(part.attached, branch[0]);
  EXPECT_THAT(part.nodes, ElementsAreArray(branch));
  EXPECT_NEAR(part.length, 3 + std::sqrt(10.0), 1e-9) << "with the edge that leads there";
  EXPECT_EQ(part.host, trunk[5]);
  EXPECT_TRUE(part.place.isApprox(Eigen::Vector3d(0, 0, 5)));
  EXPECT_EQ(part.edge, EdgeType::branching);
  EXPECT_EQ(found.ofResult[indexOf(branch[3])], Difference::wronglyAttached);
}

// An edge of ten thousand tolerances whose first half, or a little less of it, is near.
TEST(Differences, CountTheNearShareOfALongEdge) {
  Skeleton pole = test::stick(2, 1000);
  for (const double share : {0.5002, 0.4998}) {
    const Differences found = differences(pole, test::stick(2, 1000 * share), tolerance);
    EXPECT_EQ(found.ofResult[1], share > 0.5 ? Difference::matched : Difference::invented);
  }
  pole.add({.position = {0, 1000, 1000}, .parent = NodeId{1}});
  Skeleton comb = test::stick(2, 1000); // beside every second stretch of the other edge
  NodeId last{1};
  for (int i = 0; i < 100; ++i)
    last = comb.add({.position = {i / 2 % 2 == 0 ? 0.05 : 3, 10.0 * i, 1000}, .parent = last});
  EXPECT_EQ(differences(pole, comb, tolerance).ofResult[2], Difference::invented)
      << "49 %, for what crosses over is not near";
  EXPECT_EQ(differences(pole, comb, 4).ofResult[2], Difference::matched);
}

// Its new place is on the path down in the reference, too, but the trunk between is there.
TEST(Differences, ListsABranchThatIsAttachedFartherDown) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result =
      test::edited(plant, [&, first = branch[0], low = trunk[2]](SkeletonEditor& editor) {
        reparentNode(editor, first, low);
      });
  const Differences found = differences(result, plant, tolerance);
  EXPECT_EQ(count(found, Difference::invented), 0U);
  ASSERT_EQ(found.parts[0].kind, Difference::wronglyAttached);
  EXPECT_EQ(found.parts[0].attached, branch[0]);
  EXPECT_EQ(found.parts[0].host, trunk[5]);
}

TEST(Differences, CountsWhatLeadsToAWrongAttachmentAsPartOfIt) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant;
  const NodeId between = result.add({.position = {2, 2, 7}, .parent = trunk[8]});
  result.reparent(branch[0], between, EdgeType::successor);
  const Differences found = differences(result, plant, tolerance);
  ASSERT_EQ(count(found, Difference::wronglyAttached), 1U);
  EXPECT_EQ(found.parts[0].nodes.front(), between);
  EXPECT_EQ(found.parts[0].attached, branch[0]);
  EXPECT_EQ(count(found, Difference::invented), 0U);
}

TEST(Differences, ListsArmsThatWereExchangedWhereTheyCross) {
  const auto [plant, x, y] = test::crossingArms();
  const Skeleton result = test::edited(
      plant, [&, a = x[3], b = y[3]](SkeletonEditor& editor) { exchangeArms(editor, a, b); });
  EXPECT_TRUE(differences(plant, plant, tolerance).parts.empty());
  const Differences found = differences(result, plant, tolerance);
  ASSERT_EQ(found.parts.size(), 2U);
  const bool isXFirst = found.parts[0].attached == x[3];
  const DifferingPart& ofX = found.parts[isXFirst ? 0 : 1];
  const DifferingPart& ofY = found.parts[isXFirst ? 1 : 0];
  EXPECT_EQ(ofX.attached, x[3]);
  EXPECT_EQ(ofX.host, x[2]);
  EXPECT_EQ(ofY.attached, y[3]);
  EXPECT_EQ(ofY.host, y[2]);
}

TEST(Differences, ListsATreeThatIsAPartOfThePlant) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { cutOff(editor, first); });
  const Differences found = differences(result, plant, tolerance);
  ASSERT_EQ(count(found, Difference::wronglyAttached), 1U);
  const auto part =
      std::ranges::find(found.parts, Difference::wronglyAttached, &DifferingPart::kind);
  EXPECT_EQ(part->attached, branch[0]);
  EXPECT_EQ(part->host, trunk[5]);
}

TEST(Differences, AllowsAnAttachmentAFewTolerancesHigher) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result =
      test::edited(plant, [&, first = branch[0], top = trunk[6]](SkeletonEditor& editor) {
        const NodeId higher = splitEdge(editor, top, 0.35); // of the slack of 0.4
        reparentNode(editor, first, higher);
      });
  Skeleton thin = plant;
  for (const NodeId id : thin.ids())
    thin.setRadius(id, 0);
  EXPECT_EQ(count(differences(result, thin, tolerance), Difference::wronglyAttached), 0U);
  EXPECT_EQ(count(differences(result, thin, 0.05), Difference::wronglyAttached), 1U);
  EXPECT_EQ(count(differences(result, plant, 0.05), Difference::wronglyAttached), 0U)
      << "where on thick wood it sits, nobody knows";
}

TEST(Differences, DoesNotDependOnWhereNodesLieOrOnTheFrame) {
  const Skeleton bush = test::bush();
  EXPECT_TRUE(differences(test::withMiddleNodes(bush), bush, tolerance).parts.empty());
  EXPECT_TRUE(differences(bush, test::withMiddleNodes(bush), tolerance).parts.empty());
  const Skeleton result = test::jittered(bush, 0.1);
  const Differences found = differences(result, bush, tolerance);
  const Eigen::Isometry3d motion = test::motion(0.7, {5, -3, 20});
  const Differences there = differences(moved(result, motion), moved(bush, motion), tolerance);
  EXPECT_EQ(there.ofResult, found.ofResult);
  EXPECT_EQ(there.ofReference, found.ofReference);
  EXPECT_EQ(there.parts.size(), found.parts.size());
}

TEST(Differences, GrowWithNoiseAndAreNoneBelowTheTolerance) {
  const Skeleton bush = test::bush();
  EXPECT_TRUE(differences(test::jittered(bush, 0.01), bush, tolerance).parts.empty());
  double before = 0;
  for (const double sigma : {0.05, 0.1, 0.2}) {
    const Differences found = differences(test::jittered(bush, sigma), bush, tolerance);
    EXPECT_GT(found.missed + found.invented, before);
    before = found.missed + found.invented;
  }
}

TEST(Differences, ListsTwoPlantsThatAreApartAsTwo) {
  const Skeleton bush = test::bush();
  const Differences found = differences(test::shifted(bush, {100, 0, 0}), bush, tolerance);
  EXPECT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(count(found, Difference::wronglyAttached), 0U);
  EXPECT_EQ(found.matchedInResult, 0);
}

TEST(Differences, RefusesWhatCannotBeComparedAndStops) {
  const Skeleton bush = test::bush();
  EXPECT_THROW(static_cast<void>(differences({}, bush, tolerance)), Error);
  EXPECT_THROW(static_cast<void>(differences(bush, test::stick(1), tolerance)), Error);
  Skeleton broken = bush;
  broken.setPosition(NodeId{3}, {0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_THROW(static_cast<void>(differences(broken, bush, tolerance)), Error);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(differences(bush, bush, tolerance, progress));
  }));
}

// The lengths near each other are what the recall and precision of the tolerance curve measure.
TEST(Differences, AgreesWithTheRecallOfThePine) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton reference = readStructure(expert).value.skeleton;
  Skeleton result = readStructure(automatic).value.skeleton;
  result = moved(result, registration(result, reference).motion);
  const Differences found = differences(result, reference, 20);
  const ToleranceScore score =
      toleranceCurve(result, reference, {.distances = {20}}).scores.front();
  EXPECT_NEAR(found.matchedInReference / (found.matchedInReference + found.missed), score.recall,
              0.02);
  EXPECT_NEAR(found.matchedInResult / (found.matchedInResult + found.invented), score.precision,
              0.02);
}

} // namespace
} // namespace espalier
