#include "core/base/error.h"
#include "core/evaluate/match/architecture_agreement.h"
#include "core/evaluate/registration/registration.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace espalier {
namespace {

ArchitectureAgreement agreement(const Skeleton& result, const Skeleton& reference,
                                double distance = 0.1) {
  return architectureAgreement(result, reference, authorsComparison(result, reference), distance,
                               0.001);
}

TEST(ArchitectureAgreement, OfAPlantWithItselfIsPerfect) {
  const auto agreed = agreement(test::bush(), test::bush());
  EXPECT_EQ(agreed.compared, 1);
  EXPECT_EQ(agreed.sameOrder, 1);
  EXPECT_EQ(agreed.sameAxis, 1);
  EXPECT_EQ(agreed.types.observed(), 1);
  EXPECT_GT(agreed.types.count(), 100U);
  ASSERT_EQ(agreed.byOrder.size(), 3U);
  EXPECT_EQ(agreed.byOrder[2].same, 1);
}

// The other arm continues the trunk: the trunk alone has the same order; the arms, which are longer
// than the trunk, are the axes that stand for each other.
TEST(ArchitectureAgreement, SeesThatAnotherArmContinues) {
  const Skeleton reference = test::fork(2);
  Skeleton result = reference;
  result.setEdge(NodeId{2}, EdgeType::branching);
  result.setEdge(NodeId{3}, EdgeType::successor);
  const auto agreed = agreement(result, reference, 0.0005); // sharper than where the arms meet
  const double arm = std::sqrt(2.0);
  EXPECT_NEAR(agreed.compared, 1, 1e-9);
  EXPECT_NEAR(agreed.sameOrder, 1 / (1 + 2 * arm), 0.002);
  EXPECT_NEAR(agreed.sameAxis, 2 * arm / (1 + 2 * arm), 0.002);
  EXPECT_EQ(agreed.types.count(), 2U);
  EXPECT_EQ(agreed.types.observed(), 0);
  ASSERT_EQ(agreed.byOrder.size(), 2U);
  EXPECT_NEAR(agreed.byOrder[0].length, 1 + arm, 0.01);
  EXPECT_NEAR(agreed.byOrder[0].same, 1 / (1 + arm), 0.002);
  EXPECT_NEAR(agreed.byOrder[1].same, 0, 0.002);
}

// Of a trunk whose upper half is an axis of its own in the result, half is the same axis.
TEST(ArchitectureAgreement, SeesAnAxisThatIsCutInTwo) {
  Skeleton cut = test::stick(5);
  cut.setEdge(NodeId{3}, EdgeType::branching);
  const auto agreed = agreement(cut, test::stick(5));
  EXPECT_NEAR(agreed.sameAxis, 0.5, 0.002);
  EXPECT_NEAR(agreed.sameOrder, 0.5, 0.002);
}

TEST(ArchitectureAgreement, OfDisjointPlantsComparesNothing) {
  const auto agreed = agreement(test::shifted(test::fork(2), {500, 0, 0}), test::fork(2));
  EXPECT_EQ(agreed.compared, 0);
  EXPECT_EQ(agreed.sameOrder, 1);
  EXPECT_EQ(agreed.sameAxis, 1);
  EXPECT_EQ(agreed.types.count(), 0U);
}

TEST(ArchitectureAgreement, DependsNeitherOnNodesWithinEdgesNorOnTheFrame) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.03);
  const AuthorsComparison matches = authorsComparison(result, reference);
  const auto agreed = architectureAgreement(result, reference, matches, 0.2, 0.05);
  const Skeleton fineResult = test::withMiddleNodes(result);
  const auto fine = architectureAgreement(fineResult, reference,
                                          authorsComparison(fineResult, reference), 0.2, 0.05);
  EXPECT_NEAR(fine.sameOrder, agreed.sameOrder, 1e-3);
  EXPECT_NEAR(fine.sameAxis, agreed.sameAxis, 1e-3);
  const auto motion = test::motion(0.7, {3, 4, 5});
  const auto there =
      architectureAgreement(moved(result, motion), moved(reference, motion), matches, 0.2, 0.05);
  EXPECT_NEAR(there.sameOrder, agreed.sameOrder, 1e-3);
  EXPECT_NEAR(there.compared, agreed.compared, 1e-3);
}

TEST(ArchitectureAgreement, RefusesNothingAndStopsWhenAsked) {
  const Skeleton fork = test::fork(2);
  const AuthorsComparison matches = authorsComparison(fork, fork);
  EXPECT_THROW((void)architectureAgreement({}, fork, matches, 1, 1), Error);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      (void)architectureAgreement(fork, fork, matches, 1, 0.1, Progress(source.get_token(), {})),
      Cancelled);
}

} // namespace
} // namespace espalier
