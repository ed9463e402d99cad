#include "app/window/frame/action_set.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QPushButton>
#include <QToolButton>

#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <vector>

namespace espalier {
namespace {

/// What a skeleton is whatever the ids: per node its place, and that of its parent, in 0.1 mm.
using Record = std::tuple<std::vector<long>, std::vector<long>, EdgeType, long>;

std::vector<long> rounded(const Eigen::Vector3d& place) {
  return {std::lround(place.x() * 1e4), std::lround(place.y() * 1e4), std::lround(place.z() * 1e4)};
}

std::vector<Record> recordsOf(const Skeleton& skeleton) {
  std::vector<Record> records;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    records.emplace_back(
        rounded(node.position),
        node.parent ? rounded(skeleton[*node.parent].position) : std::vector<long>{},
        node.parent ? node.edge : EdgeType::successor, std::lround(node.radius * 1e4));
  }
  std::ranges::sort(records);
  return records;
}

struct WholeWay : test::WindowTest {
  /// Two apices that can be seen and picked.
  std::vector<NodeId> visibleApices() {
    std::vector<NodeId> found;
    for (const NodeId id : document().skeleton().ids()) {
      if (!document().skeleton().children(id).empty()) continue;
      const auto place = view().project(document().skeleton()[id].position);
      if (place && view().pick(place->toPoint()).node == id) found.push_back(id);
    }
    return found;
  }
};

// Open, cancel, reconstruct, select, drag, undo, redo, reparent, save, reopen, compare.
TEST_F(WholeWay, LeadsFromAScanToASkeletonSavedAndFoundAgain) {
  const QString scan = writeScan("plant.xyz");
  answer(chooseFile(scan), [this] { clickButton("open_button"); });
  waitForJob();
  waitForView();
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_TRUE(window().statusLine().counts().contains("pts"));
  EXPECT_TRUE(window().windowTitle().startsWith("plant.xyz"));

  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(window().jobs().isBusy());
  clickButton("cancel_job");
  waitForJob();
  EXPECT_TRUE(document().skeleton().isEmpty()) << "a canceled job leaves the plant as it was";
  EXPECT_FALSE(document().isModified());

  clickButton("reconstruct_button");
  waitForJob();
  waitForView();
  const Skeleton reconstructed = document().skeleton();
  ASSERT_GT(reconstructed.size(), 10U);
  EXPECT_EQ(reconstructed.roots().size(), 1U);
  EXPECT_TRUE(window().banner().text().contains("nodes reconstructed"));
  EXPECT_NE(document().contracted(), nullptr);

  const std::vector<NodeId> apices = visibleApices();
  ASSERT_GE(apices.size(), 2U);
  const NodeId moved = apices[0];
  click(placeOf(moved));
  EXPECT_EQ(document().selection().current(), moved);
  EXPECT_EQ(document().undoStack().count(), 1) << "a click is no edit";

  const QPoint from = placeOf(moved);
  const QPoint to = from + QPoint(30, -25);
  drag(from, to);
  const Skeleton dragged = document().skeleton();
  const QPointF now = view().project(dragged[moved].position).value();
  EXPECT_LT((now - to).manhattanLength(), 4);
  EXPECT_EQ(document().undoStack().undoText(), QString("Move node %1").arg(indexOf(moved)));
  EXPECT_TRUE(window().isWindowModified());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton(), reconstructed);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().skeleton(), dragged);

  hover(placeOf(apices[1]));
  document().selection().clear();
  key(Qt::Key_P);
  click(placeOf(moved));
  EXPECT_EQ(document().skeleton()[apices[1]].parent, moved);
  EXPECT_TRUE(action("tool_move").isChecked()) << "the tool ends by itself";

  const QString file = path("plant.mtg");
  answer(chooseFile(file), [this] { key(Qt::Key_S, Qt::ControlModifier); });
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(document().filePath(), file);

  const Skeleton saved = document().skeleton();
  restart();
  EXPECT_TRUE(document().isEmpty());
  open({scan, file});
  EXPECT_EQ(recordsOf(document().skeleton()), recordsOf(saved));
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(WholeWay, EditsTheNodeUnderThePointerByKeys) {
  open({writeFork("fork.mtg")});
  const Skeleton start = document().skeleton();
  const NodeId apex = visibleApices().front();
  const auto expectUndone = [&](const char* what) {
    EXPECT_NE(document().skeleton(), start) << what;
    EXPECT_EQ(document().undoStack().index(), 1) << what;
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().skeleton(), start) << what;
    document().selection().clear();
  };
  for (const auto& [keyCode, modifiers] : std::vector<std::pair<Qt::Key, Qt::KeyboardModifiers>>{
           {Qt::Key_N, Qt::NoModifier},
           {Qt::Key_E, Qt::NoModifier},
           {Qt::Key_A, Qt::NoModifier},
           {Qt::Key_Q, Qt::NoModifier},
           {Qt::Key_Delete, Qt::NoModifier},
           {Qt::Key_Delete, Qt::ShiftModifier}}) {
    hover({5, 5});
    hover(placeOf(apex));
    key(keyCode, modifiers);
    expectUndone(QKeySequence(keyCode).toString().toStdString().c_str());
  }
}

TEST_F(WholeWay, ReconstructingOverWorkByHandAsksFirst) {
  open({writeScan("scan.xyz")});
  const auto reconstruct = [this] {
    action("reconstruct").trigger();
    waitForJob();
  };
  reconstruct();
  const Skeleton first = document().skeleton();
  ASSERT_FALSE(first.isEmpty());
  reconstruct(); // nothing was done by hand
  EXPECT_EQ(document().undoStack().count(), 2);
  document().selection().set({visibleApices().front()});
  key(Qt::Key_Delete);
  const int steps = document().undoStack().count();
  reconstruct();
  EXPECT_EQ(document().undoStack().count(), steps) << "it asks";
  EXPECT_TRUE(window().banner().text().startsWith(
      "Reconstructing replaces the skeleton, with 1 edit by hand."))
      << window().banner().text().toStdString();
  EXPECT_EQ(find<QPushButton>("banner_other_action").text(), "Save Project As…");
  key(Qt::Key_Escape);
  EXPECT_FALSE(window().banner().isVisible()) << "it is closed unanswered";
  EXPECT_EQ(document().undoStack().count(), steps);
  reconstruct();
  EXPECT_TRUE(window().banner().isVisible());
  find<QToolButton>("run_to_radius").click();
  waitForJob();
  EXPECT_EQ(document().undoStack().count(), steps) << "it makes the skeleton, too";
  clickButton("banner_action");
  waitForJob();
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  reconstruct(); // of what was made anew nothing is by hand
  EXPECT_EQ(document().undoStack().count(), steps + 2);
}

TEST_F(WholeWay, ASamplePlantIsMadeOnceAndReconstructed) {
  clickButton("sample_button");
  waitForJob(); // grows it
  waitForJob(); // reads it
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_GT(document().scan()->cloud()->size(), 40'000);
  EXPECT_TRUE(QFile::exists(path("samples/sample_tree.mtg")));
  const QDateTime made = QFileInfo(path("samples/sample_tree.ply")).lastModified();
  action("reconstruct").trigger();
  waitForJob();
  EXPECT_GT(document().skeleton().size(), 100U);
  action("close_plant").trigger();
  EXPECT_EQ(document().scan(), nullptr);
  clickButton("sample_button");
  waitForJob();
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(QFileInfo(path("samples/sample_tree.ply")).lastModified(), made);
}

} // namespace
} // namespace espalier
