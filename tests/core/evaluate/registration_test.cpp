#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/authors_comparison.h"
#include "core/evaluate/registration.h"
#include "core/evaluate/shift_votes.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace espalier {
namespace {

void expectNear(const Eigen::Vector3d& found, const Eigen::Vector3d& expected, double tolerance) {
  EXPECT_NEAR((found - expected).norm(), 0, tolerance)
      << found.transpose() << " instead of " << expected.transpose();
}

/// `plant` without a fifth of its twigs, and with as many spurs.
Skeleton withErrors(Skeleton plant) {
  Random random(21);
  for (const NodeId id : plant.ids()) {
    if (!plant.children(id).empty()) continue;
    NodeId at = id;
    for (int i = 0; i < 4 && random.uniform() < 0.2 && plant.children(at).empty(); ++i) {
      const NodeId below = *plant[at].parent;
      plant.erase(at);
      at = below;
    }
    if (random.uniform() < 0.2)
      plant.add({.position = plant[at].position + 0.5 * random.direction(),
                 .parent = at,
                 .edge = EdgeType::branching});
  }
  return plant;
}

TEST(Registration, LeavesAnEqualPlantWhereItIs) {
  const auto found = registration(test::bush(), test::bush());
  EXPECT_EQ(found.shift, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(found.motion.matrix(), Eigen::Isometry3d::Identity().matrix());
  EXPECT_NEAR(found.residualBefore, 0, 1e-12);
}

TEST(Registration, TakesBackAShiftOfAnySize) {
  const Skeleton bush = test::bush();
  for (const double size : {1e-4, 0.01, 0.3, 1.0, 40.0, 1e6}) {
    const Eigen::Vector3d shift = size * Eigen::Vector3d(0.48, -0.6, 0.64);
    const auto found = registration(test::shifted(bush, -shift), bush);
    expectNear(found.shift, shift, 1e-6 + 1e-12 * size);
    EXPECT_LT(found.residualAfter, 1e-6 + 1e-12 * size);
    EXPECT_LE(found.residualAfter, found.residualBefore);
  }
}

TEST(Registration, TakesAMotionThatIsGivenAndMeasuresIt) {
  const Skeleton bush = test::bush();
  const Eigen::Isometry3d aside(Eigen::Translation3d(0.3, 0, 0));
  const Registration found = registration(bush, bush, {.motion = aside});
  EXPECT_TRUE(found.isGiven);
  EXPECT_TRUE(found.motion.isApprox(aside));
  expectNear(found.shift, {0.3, 0, 0}, 1e-12);
  EXPECT_NEAR(found.residualBefore, 0, 1e-12);
  EXPECT_GT(found.residualAfter, 0.05) << "though it makes it worse";
  EXPECT_FALSE(registration(bush, bush).isGiven);
}

TEST(Registration, IsNotPulledByWhatOneOfTheTwoLacks) {
  const Skeleton bush = test::bush();
  const Eigen::Vector3d shift(0.3, 0.4, -0.6);
  const auto found = registration(test::shifted(withErrors(bush), -shift), bush);
  expectNear(found.shift, shift, 0.005);
}

TEST(Registration, FindsTheMiddleOfNoise) {
  const Skeleton bush = test::bush();
  const Eigen::Vector3d shift(0.3, 0.4, -0.6);
  const auto found = registration(test::shifted(test::jittered(bush, 0.05), -shift), bush);
  expectNear(found.shift, shift, 0.02);
}

TEST(Registration, SlidesAStickAlongItself) {
  const auto found = registration(test::shifted(test::stick(11), {0, 0, 0.9}), test::stick(11));
  expectNear(found.shift, {0, 0, -0.9}, 1e-6);
}

TEST(Registration, TurnsWhereAsked) {
  const Skeleton bush = test::bush();
  const Eigen::Isometry3d motion = test::motion(0.1, {0.2, -0.3, 0.1});
  const auto found = registration(moved(bush, motion.inverse()), bush, {.rotates = true});
  EXPECT_NEAR((found.motion.matrix() - motion.matrix()).norm(), 0, 1e-6);
  const auto shiftOnly = registration(moved(bush, motion.inverse()), bush);
  EXPECT_EQ(shiftOnly.motion.linear(), Eigen::Matrix3d::Identity());
  EXPECT_GT(shiftOnly.residualAfter, found.residualAfter);
}

TEST(Registration, TurnsWithBothPlantsAndScalesWithTheUnit) {
  const Skeleton bush = test::bush();
  const Skeleton result = test::shifted(withErrors(bush), {0.3, 0.1, -0.2});
  const auto found = registration(result, bush);
  const Eigen::Isometry3d motion = test::motion(1, {3, 4, 5});
  const auto turned = registration(moved(result, motion), moved(bush, motion));
  expectNear(turned.shift, motion.linear() * found.shift, 1e-3);
  const auto scaled = registration(test::scaled(result, 1024), test::scaled(bush, 1024));
  expectNear(scaled.shift, 1024 * found.shift, 1e-6);
}

TEST(Registration, IsTheSameOnAnyNumberOfThreads) {
  const Skeleton result = test::shifted(test::jittered(test::bush(), 0.05), {0.1, 0.2, 0.3});
  const auto many = registration(result, test::bush());
  const ThreadLimit one(1);
  EXPECT_EQ(registration(result, test::bush()).shift, many.shift);
}

TEST(Registration, OfTwoUnrelatedPlantsMakesNothingWorse) {
  const auto found = registration(test::fork(5), test::bush());
  EXPECT_LE(found.residualAfter, found.residualBefore);
  EXPECT_TRUE(found.motion.matrix().allFinite());
}

TEST(Registration, RefusesWhatHasNothingToCompare) {
  EXPECT_THROW((void)registration({}, test::stick(3)), Error);
  EXPECT_THROW((void)registration(test::stick(3), test::stick(1)), Error);
}

TEST(Registration, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      (void)registration(test::fork(3), test::fork(3), {}, Progress(source.get_token(), {})),
      Cancelled);
}

TEST(VotedShift, IsTheOneThatMostPairsAgreeOn) {
  const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {5, 1, 0}, {2, 7, 3}};
  std::vector<Eigen::Vector3d> others = {{9, 9, 9}, {-4, 2, 2}};
  for (const Eigen::Vector3d& place : places)
    others.emplace_back(place + Eigen::Vector3d(1, 2, 0));
  const auto shift = votedShift(places, others, {0, 0, 0}, 4, 0.1);
  ASSERT_TRUE(shift);
  expectNear(*shift, {1, 2, 0}, 1e-12);
  EXPECT_FALSE(votedShift(places, others, {100, 0, 0}, 4, 0.1));
  EXPECT_FALSE(votedShift({}, others, {0, 0, 0}, 4, 0.1));
}

TEST(Registration, FindsTheShiftOfTheAuthorsAutomaticResult) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton reference = test::readTabStructure(expert);
  const Skeleton result = test::readTabStructure(automatic);
  const auto found = registration(result, reference);
  expectNear(found.shift, {-0.7, 3.3, 49.3}, 0.5);
  const auto comparison = authorsComparison(moved(result, found.motion), reference);
  EXPECT_NEAR(comparison.geometric, 0.902, 0.001);
  EXPECT_NEAR(comparison.structural, 0.819, 0.002);
}

TEST(Registration, LeavesALaterRevisionInTheSameFrameWhereItIs) {
  ESPALIER_SHARED_FILE(later, "puu1/expert_later_revision.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const auto found = registration(test::readTabStructure(later), test::readTabStructure(expert));
  expectNear(found.shift, {0, 0, 0}, 0.1);
}

} // namespace
} // namespace espalier
