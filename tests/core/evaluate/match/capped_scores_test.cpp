#include "core/base/error.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/capped_scores.h"
#include "core/evaluate/registration/registration.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stop_token>

namespace espalier {
namespace {

CappedScore scoreWithin(double distance, const Skeleton& result, const Skeleton& reference) {
  return cappedScores(result, reference, {.distances = {distance}, .step = 0.05}).front();
}

TEST(CappedScores, AllowPairsUpToTheDistance) {
  const Skeleton shifted = test::shifted(test::stick(5), {0.5, 0, 0});
  const auto scores =
      cappedScores(shifted, test::stick(5), {.distances = {0.4, 0.6}, .step = 0.05});
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].matched, 0U);
  EXPECT_EQ(scores[0].geometric, 0);
  EXPECT_EQ(scores[0].structural, 0);
  EXPECT_EQ(scores[1].matched, 1U);
  EXPECT_EQ(scores[1].geometric, 1);
  EXPECT_EQ(scores[1].structuralOfAll, 1);
}

// The upper three of four lie one from the whole, at its foot.
TEST(CappedScores, CountAStickWithoutThePartThatASpurCutsOff) {
  Skeleton spurred = test::stick(5);
  spurred.add({.position = {0.1, 0, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  EXPECT_EQ(scoreWithin(0.9, spurred, test::stick(5)).matched, 0U);
  const CappedScore score = scoreWithin(1.01, spurred, test::stick(5));
  EXPECT_EQ(score.matched, 1U);
  EXPECT_NEAR(score.geometric, (3 + 4) / 8.1, 1e-12);
  EXPECT_NEAR(score.mapping, 2.0 / 4, 1e-12);
}

// The cost of a pair, 3, is below both lengths together, but above twice the reference's.
TEST(CappedScores, DoNotLetALongResultPayForItself) {
  const Skeleton longer = test::stick(5, 1);      // 4 long
  const Skeleton reference = test::stick(2, 1.0); // 1 long
  EXPECT_EQ(authorsComparison(longer, reference).matches.size(), 1U);
  EXPECT_EQ(scoreWithin(100, longer, reference).matched, 0U);
}

TEST(CappedScores, CountAMissingArmAgainstTheStructure) {
  Skeleton missing = test::fork(3);
  missing.erase(NodeId{4});
  const CappedScore score = scoreWithin(0.1, missing, test::fork(3));
  EXPECT_EQ(score.structural, 1);
  EXPECT_EQ(score.structuralOfAll, 3.0 / 4);
  EXPECT_EQ(authorsComparison(missing, test::fork(3)).structuralOfAll, 3.0 / 4);
}

TEST(CappedScores, OfAPlantWithItselfArePerfect) {
  Skeleton bare; // its first segment is the root alone: it has no length
  const NodeId root = bare.add({});
  bare.add({.position = {1, 0, 0}, .parent = root});
  bare.add({.position = {0, 1, 0}, .parent = root, .edge = EdgeType::branching});
  for (const Skeleton& plant : {test::bush(), bare})
    for (const CappedScore& score : cappedScores(plant, plant)) {
      EXPECT_EQ(score.mapping, 1);
      EXPECT_EQ(score.geometric, 1);
      EXPECT_EQ(score.structural, 1);
      EXPECT_EQ(score.structuralOfAll, 1);
    }
}

TEST(CappedScores, DoNotDependOnWhereNodesLieAlongAnEdge) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.05);
  const CappedScore coarse = scoreWithin(0.2, result, reference);
  const CappedScore fine = scoreWithin(0.2, test::withMiddleNodes(result), reference);
  EXPECT_EQ(fine.matched, coarse.matched);
  EXPECT_NEAR(fine.geometric, coarse.geometric, 1e-9);
  EXPECT_EQ(fine.structuralOfAll, coarse.structuralOfAll);
}

TEST(CappedScores, DoNotDependOnTheFrame) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.05);
  const auto motion = test::motion(1.2, {30, -20, 5});
  const CappedScore here = scoreWithin(0.2, result, reference);
  const CappedScore there = scoreWithin(0.2, moved(result, motion), moved(reference, motion));
  EXPECT_EQ(there.matched, here.matched);
  EXPECT_NEAR(there.geometric, here.geometric, 1e-9);
}

TEST(CappedScores, FallWithNoise) {
  const Skeleton plant = test::bush();
  double before = 1;
  for (const double sigma : {0.02, 0.05, 0.1, 0.2}) {
    const double geometric = scoreWithin(0.15, test::jittered(plant, sigma), plant).geometric;
    EXPECT_LE(geometric, before) << sigma;
    before = geometric;
  }
  EXPECT_LT(before, 0.1);
}

// The noise is three median edges: nothing is where it was, and the authors' index is 0.99.
TEST(CappedScores, SeeTheNoiseThatTheAuthorsIndexHides) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton plant = test::readTabStructure(expert);
  const Skeleton noisy = test::jittered(plant, 3 * 44.4);
  EXPECT_GT(authorsComparison(noisy, plant).geometric, 0.98);
  for (const CappedScore& score : cappedScores(noisy, plant))
    EXPECT_LT(score.geometric, 0.01) << score.distance;
}

TEST(CappedScores, RefuseWhatHasNothingToCompareAndDistancesThatAreNone) {
  const Skeleton stick = test::stick(3);
  EXPECT_THROW((void)cappedScores({}, stick), Error);
  EXPECT_THROW((void)cappedScores(stick, {}), Error);
  EXPECT_THROW((void)cappedScores(stick, stick, {.distances = {1, 0}}), Error);
  EXPECT_THROW(
      (void)cappedScores(stick, stick, {.distances = {std::numeric_limits<double>::quiet_NaN()}}),
      Error);
}

TEST(CappedScores, StopWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      (void)cappedScores(test::fork(3), test::fork(3), {}, Progress(source.get_token(), {})),
      Cancelled);
}

} // namespace
} // namespace espalier
