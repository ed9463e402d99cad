#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <stop_token>

namespace espalier {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(EvenSamples, LieAmidEqualStretches) {
  std::vector<double> heights;
  for (const EvenSample& sample : evenSamples(test::stick(3, 1.5), 1))
    heights.push_back(sample.position.z());
  EXPECT_THAT(heights, ElementsAre(0.5, 1.5, 2.5));
}

TEST(EvenSamples, TakeALargerStepRatherThanTooMany) {
  EXPECT_EQ(evenSamples(test::stick(5), 1e-9, 100).size(), 100U);
}

TEST(EvenSamples, OfWhatHasNoLengthAreNone) {
  EXPECT_THAT(evenSamples({}, 1), IsEmpty());
  EXPECT_THAT(evenSamples(test::stick(1), 1), IsEmpty());
  EXPECT_THAT(evenSamples(test::stick(3, 0), 1), IsEmpty());
}

TEST(EvenSamples, DoNotMoveWhenNodesAreAdded) {
  const auto before = evenSamples(test::bush(), 0.03);
  const auto after = evenSamples(test::withMiddleNodes(test::bush()), 0.03);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR((before[i].position - after[i].position).norm(), 0, 1e-9);
}

// A stick of 10 that leaves the other by 0.3 in its upper half: edges are 1, 0.1 is the finest.
TEST(ToleranceCurve, ReturnsHowMuchIsFarOffAndHowFar) {
  Skeleton bent = test::stick(11);
  const NodeId side = bent.add({.position = {0.3, 0, 5}, .parent = NodeId{5}});
  bent.reparent(NodeId{6}, side, EdgeType::successor);
  for (std::uint32_t i = 6; i <= 10; ++i)
    bent.setPosition(NodeId{i}, {0.3, 0, static_cast<double>(i)});
  const auto curve = toleranceCurve(bent, test::stick(11), {.step = 0.001});
  EXPECT_EQ(curve.scores.front().distance, 0.1);
  EXPECT_NEAR(curve.toReference.farShare, 5.2 / 10.3, 1e-3) << "and most of the step aside";
  EXPECT_NEAR(curve.toReference.farMean, (5 * 0.3 + 0.2 * 0.2) / 5.2, 1e-3);
  const DistanceSummary same = toleranceCurve(test::stick(11), test::stick(11)).toReference;
  EXPECT_EQ(same.farShare, 0);
  EXPECT_EQ(same.farMean, 0);
}

TEST(ToleranceCurve, OfParallelSticksIsAStepAtTheirDistance) {
  const Skeleton stick = test::stick(5);
  const auto curve =
      toleranceCurve(test::shifted(stick, {0.5, 0, 0}), stick, {.distances = {0.4, 0.5, 0.6}});
  EXPECT_EQ(curve.scores[0].f(), 0);
  EXPECT_EQ(curve.scores[1].f(), 1);
  EXPECT_EQ(curve.scores[2].f(), 1);
  EXPECT_NEAR(curve.toReference.mean, 0.5, 1e-12);
  EXPECT_NEAR(curve.toResult.mean, 0.5, 1e-12);
  EXPECT_EQ(curve.toReference.percentile95, 0.5);
}

// Half of the long stick lies on the short one; beyond, distances rise evenly to 4.
TEST(ToleranceCurve, OfAStickOfHalfTheLengthIsKnownOnPaper) {
  const auto curve = toleranceCurve(test::stick(5), test::stick(9), {{0, 1, 2}, 0.01});
  for (const ToleranceScore& score : curve.scores) {
    EXPECT_EQ(score.precision, 1);
    EXPECT_NEAR(score.recall, (4 + score.distance) / 8, 2e-3);
  }
  EXPECT_NEAR(curve.scores[0].f(), 2.0 / 3, 1e-3);
  EXPECT_EQ(curve.toReference.mean, 0);
  EXPECT_NEAR(curve.toResult.mean, 1, 1e-3);
  EXPECT_NEAR(curve.toResult.percentile95, 0.9 * 4, 0.02);
}

TEST(ToleranceCurve, CountsAMissingArm) {
  Skeleton missing = test::fork(3);
  missing.erase(NodeId{4});
  const auto curve = toleranceCurve(missing, test::fork(3), {.distances = {1e-9}, .step = 1e-3});
  const double arm = std::sqrt(2.0);
  EXPECT_EQ(curve.scores[0].precision, 1);
  EXPECT_NEAR(curve.scores[0].recall, (1 + 2 * arm) / (1 + 3 * arm), 1e-3);
}

TEST(ToleranceCurve, SwapsItsSidesWithThePlants) {
  const Skeleton bush = test::bush();
  const Skeleton other = test::jittered(bush, 0.1);
  const ToleranceOptions options{.distances = {0.05, 0.1}, .step = 0.05};
  const auto there = toleranceCurve(other, bush, options);
  const auto back = toleranceCurve(bush, other, options);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(there.scores[i].precision, back.scores[i].recall);
    EXPECT_EQ(there.scores[i].f(), back.scores[i].f());
  }
  EXPECT_EQ(there.toReference.mean, back.toResult.mean);
}

TEST(ToleranceCurve, OfAPlantWithItselfIsPerfect) {
  const auto curve = toleranceCurve(test::bush(), test::bush());
  for (const ToleranceScore& score : curve.scores)
    EXPECT_EQ(score.f(), 1);
  EXPECT_NEAR(curve.toResult.percentile95, 0, 1e-12);
}

TEST(ToleranceCurve, FallsWithNoise) {
  const Skeleton bush = test::bush();
  double last = 1;
  for (const double sigma : {0.05, 0.1, 0.2, 0.4}) {
    const auto curve = toleranceCurve(test::jittered(bush, sigma), bush, {.distances = {0.05}});
    EXPECT_LT(curve.scores[0].f(), last - 0.02);
    last = curve.scores[0].f();
  }
}

TEST(ToleranceCurve, DoesNotDependOnUnitMotionOrNodes) {
  const Skeleton bush = test::bush();
  const Skeleton other = test::jittered(bush, 0.1);
  const auto curve = toleranceCurve(other, bush, {.distances = {0.1}, .step = 0.02});
  const auto expectSame = [&](const ToleranceCurve& again, double factor) {
    EXPECT_NEAR(again.scores[0].precision, curve.scores[0].precision, 1e-3);
    EXPECT_NEAR(again.scores[0].recall, curve.scores[0].recall, 1e-3);
    EXPECT_NEAR(again.toReference.mean, factor * curve.toReference.mean, factor * 1e-6);
  };
  expectSame(toleranceCurve(test::scaled(other, 1000), test::scaled(bush, 1000), {{100}, 20}),
             1000);
  expectSame(
      toleranceCurve(test::withMiddleNodes(other), test::withMiddleNodes(bush), {{0.1}, 0.02}), 1);
  const Eigen::Isometry3d motion = test::motion(1, {5e5, -2e6, 300}); // as far as UTM goes
  expectSame(toleranceCurve(moved(other, motion), moved(bush, motion), {{0.1}, 0.02}), 1);
}

TEST(ToleranceCurve, IsTheSameOnAnyNumberOfThreads) {
  const Skeleton other = test::jittered(test::bush(), 0.1);
  const auto many = toleranceCurve(other, test::bush());
  const ThreadLimit one(1);
  const auto single = toleranceCurve(other, test::bush());
  EXPECT_EQ(single.toReference.mean, many.toReference.mean);
  EXPECT_EQ(single.scores[0].f(), many.scores[0].f());
}

TEST(ToleranceCurve, ChoosesRoundTolerancesOfTheReference) {
  EXPECT_THAT(defaultTolerances(test::stick(5, 44.4)), ElementsAre(5, 10, 20, 50));
  EXPECT_THAT(defaultTolerances(test::stick(5, 0.0444)),
              ElementsAre(DoubleNear(0.005, 1e-15), DoubleNear(0.01, 1e-15),
                          DoubleNear(0.02, 1e-15), DoubleNear(0.05, 1e-15)));
  EXPECT_THAT(defaultTolerances(test::stick(5, 9 * 0.97)), ElementsAre(1, 2, 4, 10));
}

TEST(ToleranceCurve, RefusesWhatHasNothingToCompare) {
  const Skeleton stick = test::stick(3);
  Skeleton broken = stick;
  broken.setPosition(NodeId{1}, {0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_THROW((void)toleranceCurve({}, stick), Error);
  EXPECT_THROW((void)toleranceCurve(stick, {}), Error);
  EXPECT_THROW((void)toleranceCurve(stick, test::stick(4, 0)), Error);
  EXPECT_THROW((void)toleranceCurve(broken, stick), Error);
  EXPECT_THROW((void)toleranceCurve(stick, stick, {.distances = {-1}}), Error);
}

TEST(ToleranceCurve, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      (void)toleranceCurve(test::fork(3), test::fork(3), {}, Progress(source.get_token(), {})),
      Cancelled);
}

// Figures found by others with distances between samples 5 mm apart, which are up to a few tenths
// of a millimeter longer than distances to edges: scores here may be that much better.
TEST(ToleranceCurve, FindsTheKnownScoresOfTheAuthorsAutomaticResult) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton reference = test::readTabStructure(expert);
  const Skeleton result = test::readTabStructure(automatic);
  const auto curve =
      toleranceCurve(moved(result, registration(result, reference).motion), reference);
  EXPECT_EQ(curve.step, 5);
  EXPECT_NEAR(curve.scores[0].f(), 0.610, 0.02); // at 5 mm, where tenths count
  EXPECT_NEAR(curve.scores[1].f(), 0.785, 0.006);
  EXPECT_NEAR(curve.scores[2].f(), 0.912, 0.004);
  EXPECT_NEAR(curve.scores[3].f(), 0.979, 0.002);
  EXPECT_NEAR(curve.toResult.mean, 6.2, 0.5);
  EXPECT_NEAR(curve.toReference.mean, 10.3, 0.5);
  EXPECT_NEAR(curve.toResult.percentile95, 20.1, 0.8);
  EXPECT_NEAR(curve.toReference.percentile95, 40.6, 0.8);
}

} // namespace
} // namespace espalier
