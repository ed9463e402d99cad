#include "core/evaluate/differences/reference_path.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/evaluate/differences/differing_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

constexpr double nearReference = 0.1;

TEST(ReferencePath, LeadsFromAPartToWhereItBelongs) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = // its second node on the trunk, high up, its first left where it was
      test::edited(plant, [&, second = branch[1], top = trunk[9]](SkeletonEditor& editor) {
        reparentNode(editor, second, top);
      });
  const Differences found = differences(result, plant, nearReference);
  const auto part =
      std::ranges::find(found.parts, Difference::wronglyAttached, &DifferingPart::kind);
  ASSERT_NE(part, found.parts.end());
  EXPECT_EQ(part->host, branch[0]);
  EXPECT_THAT(referencePath(found, plant, *part), ElementsAre(branch[1]));
  const Skeleton lacking = test::edited(plant, [&](SkeletonEditor& editor) {
    reparentNode(editor, branch[2], trunk[9]);
    removeSubtree(editor, branch[0]);
  });
  const Differences without = differences(lacking, plant, nearReference);
  const auto other =
      std::ranges::find(without.parts, Difference::wronglyAttached, &DifferingPart::kind);
  ASSERT_NE(other, without.parts.end());
  EXPECT_THAT(referencePath(without, plant, *other), ElementsAre(branch[2], branch[1]))
      << "down to what leaves the trunk";
  const Differences missing = differences(test::stick(11), plant, nearReference);
  EXPECT_TRUE(referencePath(missing, plant, missing.parts.front()).empty());
}

} // namespace
} // namespace espalier
