#include "core/evaluate/match/edit_table.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

/// A stick of 5 nodes with a spur on the node at a height of 2.
Skeleton spurred() {
  Skeleton skeleton = test::stick(5);
  skeleton.add({.position = {0.1, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  return skeleton;
}

std::vector<std::vector<std::string>> table(const Skeleton& result, const Skeleton& reference,
                                            const EditOptions& options) {
  return editTable(editComparison(result, reference, options), result, reference);
}

TEST(EditTable, ListsWhatIsMatchedAndWhatIsRemoved) {
  const auto rows = table(spurred(), test::stick(5), {.unit = EditUnit::node});
  ASSERT_EQ(rows.size(), 7U); // the heading, 5 nodes and the spur
  EXPECT_THAT(rows[0],
              ElementsAre("edit", "result", "result_x", "result_y", "result_z", "reference",
                          "reference_x", "reference_y", "reference_z", "cost"));
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_EQ(rows[i][0], "matched");
    EXPECT_EQ(rows[i][1], rows[i][5]) << "no other node has as many above it";
    EXPECT_EQ(rows[i][9], "0");
  }
  EXPECT_THAT(rows[6], ElementsAre("removed", "5", "0.1", "0", "2", "", "", "", "", ""));
  const auto back = table(test::stick(5), spurred(), {.unit = EditUnit::node});
  EXPECT_THAT(back[6], ElementsAre("inserted", "", "", "", "", "5", "0.1", "0", "2", ""));
}

TEST(EditTable, ListsMergedAndSplitPaths) {
  const EditOptions options{.cost = EditCost::length, .mergesPaths = true};
  const auto merged = table(spurred(), test::stick(5), options);
  ASSERT_EQ(merged.size(), 3U);
  EXPECT_EQ(merged[1][0], "merged");
  EXPECT_EQ(merged[1][4], "4") << "the tip of the upper part";
  EXPECT_EQ(merged[1][8], "4");
  EXPECT_EQ(merged[2][0], "removed");
  EXPECT_EQ(table(test::stick(5), spurred(), options)[1][0], "split");
}

} // namespace
} // namespace espalier
