// What one has drawn or attached oneself is not asked about.
#include "tests/app/window/suspects_fixture.h"

namespace espalier {
namespace {

using test::SuspectsTest;

struct DoubtsByHandTest : SuspectsTest {
  [[nodiscard]] bool isAskedAbout(NodeId id, Doubt::Kind kind) {
    return std::ranges::any_of(doubts(), [&](const Doubt& doubt) {
      return doubt.kind == kind && std::ranges::find(doubt.nodes, id) != doubt.nodes.end();
    });
  }
  std::optional<Doubt> firstOf(Doubt::Kind kind) {
    const auto at = std::ranges::find(doubts(), kind, &Doubt::kind);
    return at == doubts().end() ? std::nullopt : std::optional(*at);
  }
};

TEST_F(DoubtsByHandTest, NotWhetherABranchThatWasDrawnIsWood) {
  const std::optional<Doubt> asked = firstOf(Doubt::Kind::end);
  ASSERT_TRUE(asked);
  const Skeleton before = document().skeleton();
  const double expected = window().part<DoubtsFlow>().expected()->wrong;
  document().edit("Remove", [&](SkeletonEditor& editor) { removeSubtree(editor, asked->node); });
  NodeId tip = *before[asked->node].parent;
  document().edit("Draw", [&](SkeletonEditor& editor) { // the same, by hand
    for (const NodeId id : asked->nodes) {
      Node node = before[id];
      node.parent = tip;
      tip = editor.add(node);
    }
  });
  ASSERT_TRUE(waitForAll());
  EXPECT_FALSE(isAskedAbout(tip, Doubt::Kind::end));
  EXPECT_LT(window().part<DoubtsFlow>().expected()->wrong, expected) << "it counts as right";
  document().undoStack().undo();
  document().undoStack().undo();
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(isAskedAbout(asked->node, Doubt::Kind::end));
}

TEST_F(DoubtsByHandTest, NotWhatABranchGrowsFromThatWasAttached) {
  const std::optional<Doubt> asked = firstOf(Doubt::Kind::attachment);
  ASSERT_TRUE(asked);
  const auto other =
      std::ranges::find(asked->alternatives, Alternative::Kind::attach, &Alternative::kind);
  ASSERT_NE(other, asked->alternatives.end());
  const NodeId bearer = *document().skeleton()[asked->node].parent;
  for (const NodeId onto : {*other->onto, bearer}) // and back: the plant is as it was
    document().edit("Reparent",
                    [&](SkeletonEditor& editor) { reparentNode(editor, asked->node, onto); });
  ASSERT_TRUE(waitForAll());
  EXPECT_FALSE(isAskedAbout(asked->node, Doubt::Kind::attachment));
  document().undoStack().undo();
  document().undoStack().undo();
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(isAskedAbout(asked->node, Doubt::Kind::attachment));
}

} // namespace
} // namespace espalier
