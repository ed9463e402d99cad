#include "core/base/error.h"
#include "core/evaluate/evaluation.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(Evaluation, LaysTheReferenceOnTheResultAndLeavesThatInPlace) {
  const Skeleton bush = test::bush();
  const Eigen::Vector3d shift(0.3, -0.2, 0.1);
  const Evaluation made = evaluate(bush, test::shifted(bush, shift));
  EXPECT_TRUE(made.shift.isApprox(-shift, 1e-6));
  EXPECT_TRUE(made.isShiftLarge);
  EXPECT_NEAR(made.score.f(), 1, 1e-9);
  EXPECT_TRUE(made.differences.parts.empty());
  for (const NodeId id : bush.ids())
    EXPECT_LT((made.reference[id].position - bush[id].position).norm(), 1e-6);
}

TEST(Evaluation, TakesAMotionThatWasFoundBeforeOrNone) {
  const Skeleton bush = test::bush();
  const Skeleton off = test::shifted(bush, {0, 0, 5});
  Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
  back.translation() = Eigen::Vector3d(0, 0, -5);
  EXPECT_NEAR(evaluate(bush, off, {.motion = back}).score.f(), 1, 1e-9);
  const Evaluation where = evaluate(bush, off, {.registers = false, .motion = back});
  EXPECT_LT(where.score.f(), 0.6);
  EXPECT_EQ(where.shift, Eigen::Vector3d::Zero());
  EXPECT_FALSE(where.isShiftLarge);
}

TEST(Evaluation, FindsTheMotionAgainOnceThePlantIsEdited) {
  const Skeleton bush = test::bush();
  const Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  const Skeleton moved = test::shifted(bush, {0.3, 0, 0.2});
  EXPECT_EQ(evaluate(moved, bush, {.motion = before}).shift, Eigen::Vector3d::Zero());
  const EvaluationOptions edited{.motion = before, .isResultEdited = true};
  EXPECT_TRUE(evaluate(moved, bush, edited).shift.isApprox(Eigen::Vector3d(0.3, 0, 0.2), 1e-6));
  const double little = defaultTolerances(bush).front() / 4;
  EXPECT_EQ(evaluate(test::shifted(bush, {little, 0, 0}), bush, edited).shift,
            Eigen::Vector3d::Zero())
      << "it does not tremble";
  EXPECT_EQ(evaluate(moved, bush, {.registers = false, .isResultEdited = true}).shift,
            Eigen::Vector3d::Zero());
}

TEST(Evaluation, TurnsTheReferenceOntoTheResultUnlessRefused) {
  const Skeleton bush = test::bush();
  Eigen::Isometry3d turn(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()));
  turn.pretranslate(Eigen::Vector3d(0.5, 0, 0));
  const Skeleton turned = moved(bush, turn);
  const Evaluation made = evaluate(bush, turned);
  EXPECT_NEAR(made.score.f(), 1, 1e-6);
  EXPECT_NEAR(made.comparison.authors.geometric, 1, 1e-6);
  EXPECT_TRUE(made.motion.isApprox(turn.inverse(), 1e-4));
  ASSERT_TRUE(made.registration);
  EXPECT_NEAR(made.registration->angle(), 2, 1e-4);
  EXPECT_TRUE(made.comparison.warnings.empty());
  const Evaluation refused = evaluate(bush, turned, {.turns = false});
  EXPECT_LT(refused.score.f(), 0.7);
  EXPECT_EQ(refused.registration->angle(), 0);
  ASSERT_EQ(refused.comparison.warnings.size(), 1U);
  EXPECT_LT(refused.registration->near, poorFit);
  EXPECT_NE(inEnglish(refused.comparison.warnings[0]).find("fit poorly"), std::string::npos);
  EXPECT_FALSE(evaluate(bush, turned, {.registers = false}).registration);
}

TEST(Evaluation, AnEditTurnsNothingToAnotherSide) {
  const Skeleton bush = test::bush();
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()));
  const Skeleton turned = moved(bush, turn);
  Skeleton edited = bush;
  for (const NodeId id : bush.ids())
    if (indexOf(id) > 0 && bush.children(id).empty() && indexOf(id) % 3 == 0) edited.erase(id);
  const Evaluation made =
      evaluate(edited, turned, {.motion = turn.inverse(), .isResultEdited = true});
  EXPECT_EQ(made.motion.matrix(), turn.inverse().matrix()) << "it does not tremble";
}

TEST(Evaluation, CountsEditsAsAsked) {
  const Skeleton bush = test::bush();
  Skeleton less = bush;
  for (const NodeId id : bush.ids())
    if (bush.children(id).empty() && indexOf(id) % 2 == 0) less.erase(id);
  const EditOptions asked{.unit = EditUnit::axis, .cost = EditCost::length, .mergesPaths = true};
  const Evaluation made = evaluate(less, bush, {.edit = asked});
  EXPECT_EQ(made.comparison.edit->options, asked);
  EXPECT_NEAR(made.comparison.edit->distance.distance,
              editComparison(less, bush, asked).distance.distance, 1e-9);
}

TEST(Evaluation, ScoresAtTheToleranceAndOverACurveThatRises) {
  const Skeleton bush = test::bush();
  const Evaluation usual = evaluate(test::jittered(bush, 0.1), bush);
  EXPECT_DOUBLE_EQ(usual.tolerance, defaultTolerances(bush)[1]);
  const Evaluation wide = evaluate(test::jittered(bush, 0.1), bush, {.tolerance = 1});
  EXPECT_DOUBLE_EQ(wide.tolerance, 1);
  EXPECT_DOUBLE_EQ(wide.differences.tolerance, 1);
  EXPECT_GT(wide.score.f(), usual.score.f());
  EXPECT_EQ(wide.curve.front().distance, 0);
  EXPECT_GE(wide.curve.back().distance, 2);
  for (std::size_t i = 1; i < wide.curve.size(); ++i)
    EXPECT_GE(wide.curve[i].f(), wide.curve[i - 1].f());
}

TEST(Evaluation, RefusesWhatCannotBeComparedAndStops) {
  const Skeleton bush = test::bush();
  EXPECT_THROW(static_cast<void>(evaluate({}, bush)), Error);
  EXPECT_THROW(static_cast<void>(evaluate(bush, {})), Error);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { static_cast<void>(evaluate(bush, bush, {}, progress)); }));
}

} // namespace
} // namespace espalier
