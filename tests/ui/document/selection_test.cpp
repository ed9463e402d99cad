#include "tests/support/plants.h"
#include "ui/document/selection.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

TEST(Selection, TogglesNodesAndKeepsTheLastAsCurrent) {
  Selection selection;
  selection.toggle(NodeId{1});
  selection.toggle(NodeId{2});
  EXPECT_EQ(selection.current(), NodeId{2});
  selection.toggle(NodeId{2});
  EXPECT_THAT(selection.nodes(), ElementsAre(NodeId{1}));
  selection.clear();
  EXPECT_FALSE(selection.current());
}

TEST(Selection, ReportsOnlyChanges) {
  Selection selection;
  const QSignalSpy changes(&selection, &Selection::changed);
  selection.clear();
  selection.set({NodeId{1}});
  selection.set({NodeId{1}});
  selection.keepThoseIn(test::stick(2));
  EXPECT_EQ(changes.size(), 1);
}

TEST(Selection, HasEachNodeOnceAndKnowsWhichOnes) {
  Selection selection;
  selection.set({NodeId{4}, NodeId{9}, NodeId{4}});
  EXPECT_THAT(selection.nodes(), ElementsAre(NodeId{4}, NodeId{9}));
  selection.toggle(NodeId{2});
  selection.toggle(NodeId{9});
  selection.keepThoseIn(test::stick(3));
  EXPECT_THAT(selection.nodes(), ElementsAre(NodeId{2}));
  for (const int id : {0, 2, 4, 9, 1000})
    EXPECT_EQ(selection.contains(NodeId{static_cast<std::uint32_t>(id)}), id == 2) << id;
  selection.set({NodeId{1}});
  EXPECT_FALSE(selection.contains(NodeId{2}));
}

TEST(Selection, DropsNodesThatAreGone) {
  Selection selection;
  selection.set({NodeId{1}, NodeId{7}});
  selection.keepThoseIn(test::stick(2));
  EXPECT_THAT(selection.nodes(), ElementsAre(NodeId{1}));
}

} // namespace
} // namespace espalier
