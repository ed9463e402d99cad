#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/registration/shift_votes.h"
#include "core/evaluate/study/perturbation.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/bounds.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <numbers>
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

constexpr double degree = std::numbers::pi / 180;

/// A turn about the middle of a plant, then a shift.
Eigen::Isometry3d turnOf(const Skeleton& plant, double degrees, const Eigen::Vector3d& axis,
                         const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  const Eigen::Vector3d middle = bounds(plant).center();
  return Eigen::Translation3d(middle + shift) * Eigen::AngleAxisd(degrees * degree, axis) *
         Eigen::Translation3d(-middle);
}

/// Finds what takes `motion` back, up to `tolerance` at the ends of the plant.
void expectBack(const Skeleton& result, const Skeleton& reference, const Eigen::Isometry3d& motion,
                double tolerance, const RegistrationOptions& options = {}) {
  const Registration found = registration(moved(result, motion), reference, options);
  const Eigen::AlignedBox3d box = bounds(reference);
  for (const Eigen::Vector3d& place : {box.min(), box.max()})
    EXPECT_NEAR((found.motion * motion * place - place).norm(), 0, tolerance)
        << "turned by " << found.angle() / degree << " degrees about " << found.axis().transpose();
}

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

TEST(Registration, TakesBackATurnByAnyAngleAboutTheUprightAxis) {
  for (const Skeleton& plant : {test::bush(), growPlant({.segments = 60}, 1)})
    for (const double degrees : {7.0, 30.0, 90.0, 180.0, 301.0})
      expectBack(plant, plant, turnOf(plant, degrees, up, {0.5, -0.3, 0.2}), 1e-4);
}

TEST(Registration, TakesBackATiltAboutAnyAxis) {
  const Skeleton bush = test::bush();
  for (const double degrees : {5.0, 10.0})
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.6, -0.8, 0)}) {
      expectBack(bush, bush, turnOf(bush, degrees, axis), 1e-4);
      expectBack(bush, bush, turnOf(bush, 200, up, {1, 0, 0}) * turnOf(bush, degrees, axis), 1e-4);
    }
}

TEST(Registration, TurnsAboutTheAxisThatPointsUp) {
  const Skeleton bush = test::placed(test::bush(), [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.z(), p.x(), p.y()}; // x is up
  });
  expectBack(bush, bush, turnOf(bush, 120, Eigen::Vector3d::UnitX()), 1e-4, {.up = UpAxis::x});
  const Skeleton other = test::placed(bush, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.z(), p.x(), p.y()}; // y is up
  });
  expectBack(other, other, turnOf(other, 120, Eigen::Vector3d::UnitY()), 1e-4, {.up = UpAxis::y});
}

TEST(Registration, ReturnsTheTurnAndTheShiftOfTheMiddle) {
  const Skeleton bush = test::bush();
  const Registration found = registration(moved(bush, turnOf(bush, -40, up, {0.2, 0, 0})), bush);
  EXPECT_NEAR(found.angle(), 40 * degree, 1e-4);
  expectNear(found.axis(), up, 1e-4);
  const Eigen::Isometry3d asReported = Eigen::Translation3d(found.middle + found.shift) *
                                       Eigen::AngleAxisd(found.angle(), found.axis()) *
                                       Eigen::Translation3d(-found.middle);
  EXPECT_TRUE(asReported.isApprox(found.motion, 1e-9));
  EXPECT_NEAR(found.near, 1, 1e-9);
}

TEST(Registration, ShiftsOnlyWhereTurnsAreRefused) {
  const Skeleton bush = test::bush();
  const auto found = registration(moved(bush, turnOf(bush, 30, up)), bush, {.turns = false});
  EXPECT_EQ(found.motion.linear(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(found.angle(), 0);
  EXPECT_EQ(found.axis(), Eigen::Vector3d(0, 0, 0));
  EXPECT_LT(found.near, poorFit) << "which is to be reported";
}

TEST(Registration, TurnsNoPlantToFitItsNoiseAndErrors) {
  const Skeleton bush = test::bush();
  for (const double noise : {0.02, 0.05, 0.1}) {
    const Skeleton result = test::jittered(withErrors(bush), noise);
    EXPECT_EQ(registration(test::shifted(result, {0.3, 0.2, 0}), bush).angle(), 0) << noise;
  }
}

TEST(Registration, FindsTheTurnOfAPlantWithErrors) {
  const Skeleton tree = growPlant({.segments = 150}, 3);
  Skeleton result = perturbed(tree, Perturbation::position, 0.3, 1);
  result = perturbed(result, Perturbation::prune, 0.3, 1);
  result = perturbed(result, Perturbation::spurs, 0.1, 1);
  const Eigen::Isometry3d tilt = turnOf(tree, 6, {0.8, 0.6, 0});
  expectBack(result, tree, turnOf(tree, 77, up, {0.5, 0.5, 0.2}) * tilt, 0.02); // of 4
}

TEST(Registration, LaysAPartWhereItBelongsOnceItIsTurned) {
  const Skeleton bush = test::bush();
  Skeleton part = bush; // without what lies to one side
  const std::vector<NodeId> ids = bush.ids();
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (part.children(*id).empty() && part[*id].position.x() > 0.2) part.erase(*id);
  ASSERT_LT(part.size(), 0.7 * static_cast<double>(bush.size()));
  expectBack(part, bush, turnOf(bush, 140, up, {0.4, 0, 0}), 0.02);
}

// Three shoots, evenly around: turns of 60, 180 and 300 degrees fit as well.
TEST(Registration, TakesTheLeastTurnOfASymmetricPlant) {
  const Skeleton fork = test::fork(3);
  EXPECT_EQ(registration(moved(fork, turnOf(fork, 120, up)), fork).angle(), 0)
      << "it fits as it is";
  const Registration found = registration(moved(fork, turnOf(fork, 180, up)), fork);
  EXPECT_NEAR(found.angle(), 60 * degree, 1e-4);
  EXPECT_NEAR(found.residualAfter, 0, 1e-4);
}

TEST(Registration, TurnsAnAlmostSymmetricPlantToTheBetterSide) {
  Skeleton fork = test::fork(3);
  const NodeId tip = fork.ids().back();
  const Eigen::Vector3d ahead = fork[tip].position - fork[test::forkTop].position;
  (void)fork.add({.position = fork[tip].position + ahead, .parent = tip});
  const Registration found = registration(moved(fork, turnOf(fork, 120, up)), fork);
  EXPECT_NEAR(found.angle(), 120 * degree, 1e-4);
  EXPECT_NEAR(found.residualAfter, 0, 1e-4);
}

TEST(Registration, ReportsThatAnotherPlantFitsPoorly) {
  const Skeleton tree = growPlant({.segments = 60}, 1);
  EXPECT_LT(registration(growPlant({.segments = 60}, 2), tree).near, poorFit);
  Skeleton pruned = perturbed(tree, Perturbation::prune, 0.4, 1);
  pruned = perturbed(pruned, Perturbation::position, 0.3, 1);
  EXPECT_GT(registration(pruned, tree).near, poorFit);
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
  const Skeleton turned = moved(result, turnOf(result, 50, up));
  const auto turnedMany = registration(turned, test::bush());
  EXPECT_GT(turnedMany.angle(), 0);
  const ThreadLimit one(1);
  EXPECT_EQ(registration(result, test::bush()).shift, many.shift);
  EXPECT_EQ(registration(turned, test::bush()).motion.matrix(), turnedMany.motion.matrix());
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

TEST(Registration, StopsWhileItLooksForATurn) {
  const Skeleton tree = growPlant({.segments = 60}, 1);
  const Skeleton turned = moved(tree, turnOf(tree, 90, up));
  std::stop_source source;
  const Progress progress(source.get_token(), [&](double fraction, std::string_view) {
    if (fraction > 0.5) source.request_stop();
  });
  EXPECT_THROW((void)registration(turned, tree, {}, progress), Cancelled);
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

/// G and T of a result once it is laid on a reference.
std::pair<double, double> indicesOf(const Skeleton& result, const Skeleton& reference) {
  const Registration found = registration(result, reference);
  const auto compared = authorsComparison(moved(result, found.motion), reference);
  return {compared.geometric, compared.structural};
}

// What the issue asks: as unturned to .005.
TEST(Registration, OfTheTurnedExpertOfThePineScoresAsUnturned) {
  ESPALIER_SHARED_FILE(automaticFile, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expertFile, "puu1/expert.mtg");
  const Skeleton expert = test::readTabStructure(expertFile);
  const Skeleton automatic = test::readTabStructure(automaticFile);
  EXPECT_EQ(registration(automatic, expert).angle(), 0) << "no turn but where it pays";
  const auto [geometric, structural] = indicesOf(automatic, expert);
  const auto turned = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(degrees * degree, axis));
  };
  for (const Eigen::Isometry3d& turn :
       {turned(30, up), turned(90, up), turned(180, up), turned(5, Eigen::Vector3d::UnitX())}) {
    const Skeleton reference = moved(expert, turn);
    const auto [ownG, ownT] = indicesOf(expert, reference);
    EXPECT_NEAR(ownG, 1, 0.005);
    EXPECT_NEAR(ownT, 1, 0.005);
    const auto [g, t] = indicesOf(automatic, reference);
    EXPECT_NEAR(g, geometric, 0.005);
    EXPECT_NEAR(t, structural, 0.005);
  }
}

} // namespace
} // namespace espalier
