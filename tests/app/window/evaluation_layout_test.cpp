#include "tests/app/window/evaluation_fixture.h"

#include <QDockWidget>
#include <QScrollArea>
#include <QToolButton>

namespace espalier {
namespace {

using test::EvaluationWindowTest;

TEST_F(EvaluationWindowTest, TheListOfErrorsKeepsItsWidthOnceThePlantIsEdited) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  ASSERT_TRUE(waitForErrors(1));
  const int before = list().width();
  const NodeId id = shoot(1);
  document().edit("Type", [=](SkeletonEditor& editor) {
    const bool isAxial = editor.skeleton()[id].edge == EdgeType::successor;
    setEdgeType(editor, id, isAxial ? EdgeType::branching : EdgeType::successor);
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return score("work").startsWith("1 edit, under a minute"); },
                              patience));
  QCoreApplication::processEvents();
  EXPECT_EQ(list().width(), before);
}

TEST_F(EvaluationWindowTest, AWarningCutsNothingBelowIt) {
  open({write("plant.mtg", plant())});
  Skeleton large = plant(); // as in mm
  for (const NodeId id : large.ids())
    large.setPosition(id, 1000 * large[id].position);
  answer(chooseFile(write("expert.mtg", large)), [this] { action("load_reference").trigger(); });
  waitForJob();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return find<QLabel>("evaluation_warnings").isVisible(); }, patience));
  QCoreApplication::processEvents();
  const auto& panel = find<QWidget>("evaluation_panel");
  EXPECT_LE(panel.height(), panel.parentWidget()->height());
}

TEST_F(EvaluationWindowTest, ALowPanelGrowsForWhatAReferenceBrings) {
  open({write("plant.mtg", plant())});
  key(Qt::Key_F5);
  auto& dock = find<QDockWidget>("evaluation");
  QCoreApplication::processEvents();
  window().resizeDocks({&dock}, {60}, Qt::Vertical);
  QCoreApplication::processEvents();
  answer(chooseFile(write("expert.mtg", plant())), [this] { action("load_reference").trigger(); });
  waitForJob();
  ASSERT_TRUE(waitForScores());
  QCoreApplication::processEvents();
  const auto& panel = find<QWidget>("evaluation_panel");
  EXPECT_GE(panel.parentWidget()->width(), panel.minimumSizeHint().width()) << "no scroll bar";
  EXPECT_GE(panel.parentWidget()->height(), panel.minimumSizeHint().height()) << "nothing is cut";
}

TEST_F(EvaluationWindowTest, NoRowIsSlicedAndNoButtonCut) {
  compare([](SkeletonEditor& editor) {
    for (std::uint32_t i = 1; i < 10; ++i) { // twigs that the reference lacks
      const Eigen::Vector3d at = editor.skeleton()[NodeId{i}].position;
      addChild(editor, NodeId{i}, at + Eigen::Vector3d(0.3, 0, 0));
    }
  });
  ASSERT_TRUE(waitForErrors(9));
  key(Qt::Key_F3);
  key(Qt::Key_F3, Qt::ControlModifier);
  key(Qt::Key_F3);
  ASSERT_TRUE(find<QToolButton>("differences_ignored").isVisible());
  for (const int height : {800, 810, 821}) {
    window().resize(1280, height);
    QCoreApplication::processEvents();
    EXPECT_EQ(list().viewport()->height() % list().sizeHintForRow(0), 0) << height;
    const auto& scores = find<QScrollArea>("evaluation_scores");
    EXPECT_GT(scores.viewport()->height(), 60);
    for (const auto* label : scores.widget()->findChildren<QLabel*>()) {
      const QRect place = label->geometry();
      EXPECT_TRUE(label->isHidden() || place.top() >= scores.viewport()->height() ||
                  place.bottom() < scores.viewport()->height())
          << height << ": " << label->text().toStdString();
    }
  }
  const auto& panel = find<QWidget>("evaluation_panel");
  for (const auto* button : find<QWidget>("differences_panel").findChildren<QToolButton*>()) {
    const QRect seen(button->mapTo(panel.parentWidget(), QPoint()), button->size());
    EXPECT_TRUE(panel.parentWidget()->rect().contains(seen)) << button->text().toStdString();
    EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
  }
}

} // namespace
} // namespace espalier
