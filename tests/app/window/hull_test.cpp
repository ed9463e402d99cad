#include "core/io/formats.h"
#include "core/mtg/feature_edits.h"
#include "core/surface/subtree_hulls.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QTest>
#include <QUndoStack>

namespace espalier {
namespace {

/// Convex hulls of branches, in the real window: the fork over a scan of a trunk and three
/// branches.
struct HullTest : test::ProjectWindowTest {
  void openBoth() { open({writeScan("plant.xyz"), writeFork("fork.mtg")}); }
  [[nodiscard]] NodeId shoot() { return nodeAt({1, 0, 2}); }
  [[nodiscard]] std::vector<NodeId> wrapped() {
    return nodesWithFeature(document().skeleton(), "hull_volume");
  }
  /// The volume that a node has as its feature.
  double volumeOf(NodeId id) {
    for (const Entity& entity : document().skeleton()[id].entities)
      for (const FeatureValue& value : entity.values)
        if (value.feature == "hull_volume") return std::stod(value.text);
    return 0;
  }
  void wrap(NodeId id) {
    document().selection().set({id});
    key(Qt::Key_V, Qt::ShiftModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return wrapped() == std::vector{id}; }, patience))
        << window().statusLine().shownText().toStdString();
  }
  /// How many pixels of the view differ from what it was.
  static int difference(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        if (a.pixel(x, y) != b.pixel(x, y)) ++count;
    return count;
  }
};

TEST_F(HullTest, WrapsWhatABranchCarriesAndKeepsItsVolume) {
  openBoth();
  document().selection().set({shoot()});
  const QImage before = view().picture({400, 400});
  wrap(shoot());
  EXPECT_EQ(document().undoStack().undoText(), "Convex hull of branch");
  const Scan& scan = *document().scan();
  const PointDistances distances(scan.cloud(), scan.spacing(), document().skeleton());
  const auto hulls = subtreeHulls(distances, document().skeleton(), {shoot()});
  ASSERT_TRUE(hulls.front());
  EXPECT_NEAR(volumeOf(shoot()), hulls.front()->volume, 1e-6 * hulls.front()->volume);
  EXPECT_GT(difference(before, view().picture({400, 400})), 500) << "it is to be seen";
  document().undoStack().undo();
  EXPECT_TRUE(wrapped().empty());
  EXPECT_TRUE(QTest::qWaitFor([&] { return view().picture({400, 400}) == before; }, patience));
}

TEST_F(HullTest, IsTakenOffAgain) {
  openBoth();
  wrap(shoot());
  action("remove_hull").trigger();
  EXPECT_TRUE(wrapped().empty());
  EXPECT_EQ(document().undoStack().undoText(), "Remove convex hull");
  action("remove_hull").trigger();
  EXPECT_TRUE(window().statusLine().shownText().contains("has no convex hull"))
      << window().statusLine().shownText().toStdString();
  EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(HullTest, ABranchSelectedAsAWholeHasOneHull) {
  openBoth();
  const NodeId top = nodeAt({0, 0, 1});
  std::vector<NodeId> all = document().skeleton().children(top);
  all.push_back(top);
  document().selection().set(all);
  key(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return wrapped() == std::vector{top}; }, patience));
}

TEST_F(HullTest, FollowsTheEditsOfThePlant) {
  openBoth();
  wrap(shoot());
  const QImage before = view().picture({400, 400});
  const double volume = volumeOf(shoot());
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(shoot(), Eigen::Vector3d(0.7, 0, 1.6));
  });
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return difference(before, view().picture({400, 400})) > 100;
      },
      patience));
  EXPECT_EQ(volumeOf(nodeAt({0.7, 0, 1.6})), volume) << "kept until it is asked for again";
}

TEST_F(HullTest, IsThereAgainInASavedFile) {
  openBoth();
  wrap(shoot());
  const double volume = volumeOf(shoot());
  action("save").trigger();
  restart();
  open({path("plant.xyz"), path("fork.mtg")});
  EXPECT_EQ(wrapped(), std::vector{shoot()});
  EXPECT_NEAR(volumeOf(shoot()), volume, 1e-6 * volume);
}

TEST_F(HullTest, WrapsABranchOfAPlantWithoutAnyUnits) {
  open({writeScan("plant.xyz")});
  action("reconstruct").trigger();
  waitForJob();
  ASSERT_FALSE(document().skeleton().isEmpty());
  const NodeId root = document().skeleton().roots().front();
  wrap(root);
  EXPECT_GT(volumeOf(root), 0.1) << "a trunk of 2 m, and branches 0.7 m to three sides";
}

TEST_F(HullTest, WithoutPointsThereIsNothingToWrap) {
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(action("wrap_hull").isEnabled());
  EXPECT_TRUE(action("remove_hull").isEnabled());
}

} // namespace
} // namespace espalier
