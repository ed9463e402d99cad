#include "core/evaluate/safer_indices.h"
#include "tests/core/evaluate/differing_plants.h"
#include "tests/core/evaluate/evaluate_plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(SaferIndices, AreOneForThePlantItself) {
  const AuthorsComparison same = authorsComparison(test::bush(), test::bush());
  EXPECT_DOUBLE_EQ(geometricIndexWithin(same, 0), 1);
  EXPECT_DOUBLE_EQ(structuralIndexOfAll(same), 1);
}

// Three segments of 5, 5 and 4; without the branch, the trunk is one of 10.
TEST(SaferIndices, CountWhatIsNotMatched) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton moved = test::edited(plant, [top = branch.back()](SkeletonEditor& editor) {
    editor.setPosition(top, {4, 0, 7});
  });
  const AuthorsComparison comparison = authorsComparison(moved, plant, {.boxDistance = 5});
  EXPECT_DOUBLE_EQ(comparison.geometric, 1);
  const double branchLength = comparison.resultSegments.back().length;
  EXPECT_DOUBLE_EQ(geometricIndexWithin(comparison, 1), 20 / (24 + branchLength))
      << "the branch ends 2 away";
  EXPECT_DOUBLE_EQ(geometricIndexWithin(comparison, 2), 1);
  const Skeleton pruned = test::edited(
      plant, [first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  const AuthorsComparison lacking = authorsComparison(pruned, plant, {.boxDistance = 5});
  EXPECT_DOUBLE_EQ(lacking.structural, 1) << "over the one match";
  EXPECT_DOUBLE_EQ(structuralIndexOfAll(lacking), 1.0 / 3);
}

} // namespace
} // namespace espalier
