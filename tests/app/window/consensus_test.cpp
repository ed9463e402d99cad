#include "app/window/files/project_flow.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/evaluation_fixture.h"

#include <QTest>

namespace espalier {
namespace {

/// A plant of whose shoots the other expert has two, and each one that the other lacks.
struct ConsensusWindowTest : test::EvaluationWindowTest {
  static constexpr int shared = 11 + 2 * 10; // nodes
  void openBoth() {
    compare([](SkeletonEditor& editor) {
      removeSubtree(editor, shoot(1));
      NodeId last{5};
      for (int i = 1; i <= 6; ++i)
        last = editor.add({.position = {0.1 * i, 0, 0.5},
                           .radius = 0.01,
                           .parent = last,
                           .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
    });
  }
  void keepAgreed() {
    action("keep_agreed").trigger();
    waitForJob();
  }
};

TEST_F(ConsensusWindowTest, NeedsAReferenceAndAProject) {
  open({write("plant.mtg", plant())});
  expectNoDialog([this] { action("keep_agreed").trigger(); });
  EXPECT_EQ(
      message(),
      "Load what another expert has of this plant as the reference first (File > Load Reference)");
  load(write("expert.mtg", plant()));
  expectNoDialog([this] { action("keep_agreed").trigger(); });
  EXPECT_EQ(message(), "What you have is kept as a version, and only a project keeps versions: "
                       "save the plant as one first");
}

TEST_F(ConsensusWindowTest, LeavesWhatBothHaveAndTheRestIsDecidedFromBoth) {
  openBoth();
  saveProject("plant.espalier");
  const Skeleton before = document().skeleton();
  const int steps = document().undoStack().count();
  keepAgreed();
  EXPECT_EQ(document().skeleton().size(), std::size_t{shared});
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  EXPECT_TRUE(message().startsWith("What both agree on is kept: "));
  const auto& versions = window().part<ProjectFlow>().versions();
  ASSERT_EQ(versions.size(), 1U);
  EXPECT_EQ(versions.front().name, "Before agreement with expert.mtg");
  EXPECT_EQ(versions.front().skeleton, before);
  ASSERT_TRUE(waitForScores());
  key(Qt::Key_F3);
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton().size(), std::size_t{shared + 10}) << "the shoot of the other";
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton(), before);
}

TEST_F(ConsensusWindowTest, ChangesNothingWhereBothAreOne) {
  open({write("plant.mtg", plant())});
  load(write("expert.mtg", plant()));
  saveProject("plant.espalier");
  keepAgreed();
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(window().part<ProjectFlow>().versions().empty());
}

TEST_F(ConsensusWindowTest, RefusesAnotherPlant) {
  open({write("plant.mtg", plant())});
  Skeleton far = plant();
  for (const NodeId id : far.ids())
    far.setPosition(id, far[id].position + Eigen::Vector3d(50, 0, 0));
  answer(chooseFile(write("far.mtg", far)), [this] { action("load_reference").trigger(); });
  waitForJob();
  saveProject("plant.espalier");
  keepAgreed();
  EXPECT_EQ(message(),
            "far.mtg has none of the wood of this plant where it lies: show the evaluation (F5), "
            "which lays it on the plant, or check that both are of one scan");
  EXPECT_EQ(document().skeleton().size(), plant().size());
}

TEST_F(ConsensusWindowTest, RefusesAnotherUnit) {
  open({write("plant.mtg", plant())});
  Skeleton large = plant();
  for (const NodeId id : large.ids())
    large.setPosition(id, 1000 * large[id].position);
  answer(chooseFile(write("mm.mtg", large)), [this] { action("load_reference").trigger(); });
  waitForJob();
  saveProject("plant.espalier");
  action("keep_agreed").trigger();
  EXPECT_EQ(message(), "mm.mtg is far larger or smaller than this plant: both have to be in one "
                       "unit");
  EXPECT_EQ(document().undoStack().count(), 0);
}

} // namespace
} // namespace espalier
