#include "core/evaluate/match/type_agreement.h"
#include "core/skeleton/edits.h"
#include "tests/core/evaluate/differences/differing_plants.h"
#include "tests/core/evaluate/evaluate_plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

// Cohen's example in words: of 50 both say yes of 20 and no of 15; one alone says yes of 5, of 10.
TEST(TypeAgreement, IsCorrectedForChance) {
  const TypeAgreement agreement{
      .bothContinue = 15, .bothBranch = 20, .resultBranches = 5, .referenceBranches = 10};
  EXPECT_DOUBLE_EQ(agreement.observed(), 0.7);
  EXPECT_NEAR(agreement.kappa(), 0.4, 1e-12); // chance: 0.5 * 0.6 + 0.5 * 0.4
}

TEST(TypeAgreement, IsOneForThePlantItselfAndWhereThereIsNothingToCompare) {
  const Skeleton bush = test::bush();
  EXPECT_DOUBLE_EQ(typeAgreement(authorsComparison(bush, bush), bush, bush).kappa(), 1);
  EXPECT_DOUBLE_EQ(TypeAgreement().kappa(), 1);
  EXPECT_DOUBLE_EQ(TypeAgreement{.bothBranch = 3}.kappa(), 1);
}

// Two segments are attached to the fork: the upper trunk, which continues, and the branch.
TEST(TypeAgreement, SeesWhenTheBranchIsTakenForTheAxis) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton swapped = test::edited(plant, [first = branch[0]](SkeletonEditor& editor) {
    setEdgeType(editor, first, EdgeType::successor);
  });
  const AuthorsComparison compared = authorsComparison(swapped, plant, {.boxDistance = 1});
  const TypeAgreement agreement = typeAgreement(compared, swapped, plant);
  EXPECT_EQ(agreement.count(), 2U) << "the segment of the root has no edge";
  EXPECT_EQ(agreement.resultBranches, 1U);
  EXPECT_EQ(agreement.referenceBranches, 1U);
  EXPECT_DOUBLE_EQ(agreement.kappa(), -1);
}

} // namespace
} // namespace espalier
