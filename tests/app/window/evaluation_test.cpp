#include "app/window/evaluate/evaluation_text.h"
#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/evaluate/registration/registration.h"
#include "tests/app/window/evaluation_fixture.h"
#include "tests/ui/view/pictures.h"
#include "ui/document/difference_look.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/status_line.h"
#include "ui/plots/plot_view.h"
#include "ui/view/palette.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QRegularExpression>
#include <QToolButton>
#include <QUndoStack>

namespace espalier {
namespace {

using test::EvaluationWindowTest;

const auto nothing = [](SkeletonEditor&) {};

TEST_F(EvaluationWindowTest, ShowsThePlantByItselfUntilThereIsAReference) {
  open({write("plant.mtg", plant())});
  EXPECT_FALSE(find<QDockWidget>("evaluation").isVisible());
  key(Qt::Key_F5);
  EXPECT_TRUE(find<QDockWidget>("evaluation").isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return find<QLabel>("traits_title").isVisible(); }, patience))
      << "what is known of it by itself";
  answer(chooseFile(write("expert.mtg", plant())), [this] { clickButton("evaluation_load"); });
  waitForJob();
  EXPECT_TRUE(waitForScores());
  EXPECT_FALSE(find<QLabel>("traits_title").isVisible());
  EXPECT_EQ(find<QLabel>("evaluation_title").text(), "expert.mtg");
}

TEST_F(EvaluationWindowTest, GivesThePlantItselfAllThatCanBeReached) {
  compare(nothing);
  EXPECT_TRUE(find<QDockWidget>("evaluation").isVisible()) << "what was loaded is shown";
  for (const char* name : {"f", "precision", "recall", "tips", "branchings", "mapping", "geometric",
                           "capped_geometric", "structural", "structural_of_all", "edge_kappa"})
    EXPECT_EQ(score(name), "1.000") << name;
  EXPECT_EQ(score("edits"), "0");
  EXPECT_EQ(score("work"), "none");
  EXPECT_EQ(errors(), "0 errors");
  key(Qt::Key_F3);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Nothing differs"));
}

// Scores of a run would depend on the plant before otherwise.
TEST_F(EvaluationWindowTest, LaysTheReferenceAnewAfterAReconstruction) {
  const auto reconstruct = [&](double radius) {
    PipelineOptions options;
    options.settings["contract"]["radius"] = fixedAt(radius);
    window().findChild<PipelinePanel*>()->setOptions(options);
    key(Qt::Key_R, Qt::ControlModifier);
    waitForJob();
  };
  open({writeScan("scan.xyz")});
  reconstruct(0.03);
  const Eigen::Isometry3d elsewhere(Eigen::Translation3d(0.2, 0, 0));
  const QString reference =
      write("expert.mtg", moved(test::withoutEntities(document().skeleton()), elsewhere));
  reconstruct(0.08);
  load(reference);
  const Eigen::Vector3d before = evaluation()->shift;
  reconstruct(0.1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return evaluation()->shift != before; }, patience));
  ASSERT_TRUE(waitForScores());
  const Eigen::Vector3d found = evaluation()->shift;
  auto& laid = find<QCheckBox>("evaluation_laid");
  for (const bool isOn : {false, true}) {
    laid.setChecked(isOn);
    ASSERT_TRUE(waitForScores());
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return evaluation()->shift == found; }, patience));
}

TEST_F(EvaluationWindowTest, SaysThatThereIsNoErrorToAcceptOrIgnore) {
  open({write("plant.mtg", plant())});
  for (const Qt::Key pressed : {Qt::Key_Return, Qt::Key_F3}) {
    key(pressed, Qt::ControlModifier);
    EXPECT_EQ(window().banner().text(), "Nothing has been compared yet: load a reference first");
    find<QWidget>("message_banner").hide();
  }
  answer(chooseFile(write("expert.mtg", plant())), [this] { action("load_reference").trigger(); });
  waitForJob();
  ASSERT_TRUE(waitForScores());
  for (const Qt::Key pressed : {Qt::Key_Return, Qt::Key_F3}) {
    key(pressed, Qt::ControlModifier);
    EXPECT_EQ(window().banner().text(), "Nothing differs from the reference within the tolerance");
    find<QWidget>("message_banner").hide();
  }
  for (const auto* button : find<QWidget>("differences_panel").findChildren<QToolButton*>()) {
    const bool isOfOne = button->text() == "Accept" || button->text() == "Ignore";
    EXPECT_FALSE(isOfOne && button->isEnabled()) << button->text().toStdString();
  }
}

TEST_F(EvaluationWindowTest, ListsWhatIsMissedAndFarInGroups) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  EXPECT_GT(score("missed_length").toDouble(), 0.1);
  EXPECT_EQ(score("invented_length"), "0.000");
  EXPECT_EQ(score("missed_connections"), "0.000");
  EXPECT_GT(score("barcode").toDouble(), 0.05);
  EXPECT_EQ(score("far_plant"), "0.000");
  EXPECT_GT(score("far_reference").toDouble(), 0.1);
  EXPECT_GT(score("substantial_to_result").split(QChar(0x202f)).front().toDouble(), 0.1);
  EXPECT_EQ(score("concordance"), "1.000");
  EXPECT_EQ(score("radius_root_mean_square"), formatLength(0, document().unit(), 3));
  EXPECT_EQ(score("radius_arc_0"), QStringLiteral("–")) << "there is no scan";
  EXPECT_EQ(score("wrong"), "0");
  for (const QLabel* label : window().findChildren<QLabel*>()) {
    if (!label->objectName().startsWith("score_") || label->objectName() == "score_stems") continue;
    EXPECT_FALSE(label->toolTip().isEmpty()) << label->objectName().toStdString();
  }
}

TEST_F(EvaluationWindowTest, ShowsTheLeadingScoresWithoutScrolling) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  for (const char* key : {"f", "geometric", "structural"}) {
    const auto& large = find<QLabel>(QString("leading_") + key);
    EXPECT_EQ(large.text(), score(key)) << key;
    EXPECT_FALSE(large.visibleRegion().isEmpty()) << key;
  }
  document().edit("Remove", [](SkeletonEditor& editor) { removeSubtree(editor, shoot(1)); });
  EXPECT_FALSE(find<QLabel>("leading_f").isEnabled()) << "stale until it is fresh";
  ASSERT_TRUE(waitForScores());
  EXPECT_TRUE(find<QLabel>("leading_f").isEnabled());
  EXPECT_EQ(find<QLabel>("leading_f").text(), score("f"));
}

TEST_F(EvaluationWindowTest, SaysBetweenWhichValuesAScoreLies) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  const QRegularExpression form("95 % interval: ([0-9.]+) to ([0-9.]+)");
  for (const char* name : {"f", "precision", "recall", "geometric"}) {
    const auto found = form.match(find<QLabel>(QString("score_") + name).toolTip());
    ASSERT_TRUE(found.hasMatch()) << name;
    EXPECT_LE(found.captured(1).toDouble(), score(name).toDouble()) << name;
    EXPECT_GE(found.captured(2).toDouble(), score(name).toDouble()) << name;
  }
  const auto recall = form.match(find<QLabel>("score_recall").toolTip());
  EXPECT_LT(recall.captured(1), recall.captured(2)) << "one shoot of three is missing";
  EXPECT_EQ(find<QLabel>("leading_f").toolTip(), find<QLabel>("score_f").toolTip());
  EXPECT_FALSE(find<QLabel>("score_tips").toolTip().contains("interval"));
}

TEST_F(EvaluationWindowTest, ShowsDiametersAtBreastHeightOnceTheUnitIsKnown) {
  compare([](SkeletonEditor& editor) {
    for (const NodeId id : editor.skeleton().ids())
      editor.setRadius(id, 0.015);
  });
  document().setUnit(LengthUnit::unknown);
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(score("dbh"), QStringLiteral("–"));
  EXPECT_TRUE(find<QLabel>("score_stems").isVisibleTo(&window()));
  EXPECT_TRUE(score("stems").contains("the unit of the lengths is not known"));
  document().setUnit(LengthUnit::meter);
  ASSERT_TRUE(waitForScores());
  EXPECT_FALSE(find<QLabel>("score_stems").isVisibleTo(&window()));
  EXPECT_EQ(score("dbh"), formatLength(0.03, LengthUnit::meter, 3)) << "the stem is 2 high";
  EXPECT_EQ(score("dbh_error"), formatLength(0.01, LengthUnit::meter, 3));
  document().setUnit(LengthUnit::millimeter);
  ASSERT_TRUE(waitForScores());
  EXPECT_TRUE(score("stems").contains("does not rise that high"));
}

TEST_F(EvaluationWindowTest, MeasuresByTheToleranceThatIsChosen) {
  // One shoot, of four parts of equal length but for its steepness, lies 0.2 to the side.
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  auto& tolerance = find<QDoubleSpinBox>("evaluation_tolerance");
  const double usual = tolerance.value();
  EXPECT_GT(usual, 0);
  const double length = 1 + 3 * std::sqrt(2.0); // of the reference
  EXPECT_NEAR(score("recall").toDouble(), 1 - (std::sqrt(2.0) - usual) / length, 0.03);
  EXPECT_EQ(score("precision"), "1.000");
  tolerance.setValue(3);
  EXPECT_EQ(find<QLabel>("score_f").property("role"), "quiet") << "until it is compared";
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(score("recall"), "1.000");
  auto& plot = find<PlotView>("tolerance_plot");
  QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.rect().center());
  EXPECT_LT(tolerance.value(), 6);
  EXPECT_NE(tolerance.value(), 3);
}

TEST_F(EvaluationWindowTest, ColorsBothSkeletonsByWhatDiffers) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -1, 0.5});
  });
  EXPECT_TRUE(action("node_color_comparison").isChecked());
  view().frameAll();
  waitForView();
  const auto count = [&](Difference difference) {
    return test::countPixels(view().picture({600, 450}), colorOf(difference), 24);
  };
  const int missed = count(Difference::missed);
  const int invented = count(Difference::invented);
  EXPECT_GT(missed, 100) << "legend and line";
  EXPECT_GT(invented, 100);
  key(Qt::Key_6, Qt::ControlModifier);
  EXPECT_LT(count(Difference::missed), missed) << "the layer of the reference";
  EXPECT_EQ(count(Difference::invented), invented);
  key(Qt::Key_6, Qt::ControlModifier);
  action("remove_reference").trigger();
  EXPECT_TRUE(action("node_color_none").isChecked());
  EXPECT_FALSE(action("node_color_comparison").isVisible());
  EXPECT_EQ(count(Difference::missed), 0);
}

TEST_F(EvaluationWindowTest, FollowsEditsAndUndo) {
  compare(nothing);
  document().edit("Remove", [](SkeletonEditor& editor) { removeSubtree(editor, shoot(1)); });
  EXPECT_EQ(find<QLabel>("score_f").property("role"), "quiet") << "stale until it is fresh";
  EXPECT_TRUE(waitForErrors(1));
  ASSERT_TRUE(waitForScores());
  EXPECT_LT(score("recall").toDouble(), 0.8);
  EXPECT_TRUE(score("work").startsWith("1 edit, "));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitForErrors(0));
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(score("recall"), "1.000");
}

TEST_F(EvaluationWindowTest, LaysTheReferenceOnThePlantUnlessItIsToLieWhereItLay) {
  Skeleton off = plant();
  for (const NodeId id : off.ids())
    off.setPosition(id, off[id].position + Eigen::Vector3d(0, 0.05, 0.1));
  open({write("plant.mtg", plant())});
  load(write("expert.mtg", off));
  EXPECT_EQ(score("f"), "1.000");
  EXPECT_TRUE(find<QLabel>("evaluation_warnings").text().contains("files lie 0.112"))
      << find<QLabel>("evaluation_warnings").text().toStdString();
  QTest::mouseClick(&find<QCheckBox>("evaluation_laid"), Qt::LeftButton, {}, QPoint(8, 8));
  ASSERT_TRUE(waitForScores());
  EXPECT_LT(score("f").toDouble(), 0.9);
  EXPECT_FALSE(find<QLabel>("evaluation_warnings").text().contains("they were"));
  EXPECT_EQ(find<QLabel>("evaluation_shift").text(), "");
}

TEST_F(EvaluationWindowTest, KeysGoFromErrorToErrorTheLongestFirst) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -0.5, 0.5});
  });
  ASSERT_TRUE(waitForErrors(2));
  EXPECT_EQ(kind(0), "Missed");
  EXPECT_EQ(kind(1), "Invented");
  key(Qt::Key_F3);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(0));
  EXPECT_TRUE(document().selection().isEmpty()) << "it is of the reference";
  EXPECT_EQ(action("accept_reference").text(), "Add to Plant");
  const QString said = window().statusLine().shownText();
  EXPECT_TRUE(said.startsWith("Missed, ")) << said.toStdString();
  EXPECT_TRUE(said.endsWith(": Ctrl+Enter adds it   Ctrl+F3 ignores it")) << said.toStdString();
  waitForView();
  const auto end = view().project({std::cos(4 * M_PI / 3), std::sin(4 * M_PI / 3), 2});
  ASSERT_TRUE(end);
  EXPECT_TRUE(view().rect().contains(end->toPoint()));
  key(Qt::Key_F3);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(1));
  EXPECT_EQ(document().selection().nodes().size(), 1U);
  EXPECT_EQ(action("accept_reference").text(), "Remove from Plant");
  EXPECT_TRUE(window().statusLine().shownText().contains("Ctrl+Enter removes it"));
  key(Qt::Key_F3);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(0)) << "after the last comes the first";
  key(Qt::Key_F3, Qt::ShiftModifier);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(1));
  EXPECT_EQ(document().undoStack().count(), 0) << "to look is no edit";
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                    list().visualItemRect(list().topLevelItem(0)).center());
  EXPECT_TRUE(document().selection().isEmpty());
}

TEST_F(EvaluationWindowTest, FliesToWhatTheArrowKeysComeTo) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -0.5, 0.5});
  });
  ASSERT_TRUE(waitForErrors(2));
  list().setCurrentItem(list().topLevelItem(0));
  list().setFocus(); // arrows step from node to node where the view has the keyboard
  const Eigen::Vector3d before = view().camera().pivot;
  QTest::keyClick(&list(), Qt::Key_Down);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(1));
  EXPECT_EQ(document().selection().nodes().size(), 1U);
  EXPECT_FALSE(view().camera().pivot.isApprox(before));
  QTest::keyClick(&list(), Qt::Key_Up);
  EXPECT_TRUE(document().selection().isEmpty()) << "it is of the reference";
}

TEST_F(EvaluationWindowTest, DrawsWhereTheReferenceAttachesWhatIsWronglyAttached) {
  compare([](SkeletonEditor& editor) { reparentNode(editor, shoot(1), NodeId{3}); });
  ASSERT_TRUE(waitForErrors(1));
  EXPECT_EQ(kind(0), "Wrongly attached");
  key(Qt::Key_F3);
  document().selection().clear();
  view().frame({Eigen::Vector3d(-0.2, -0.2, 0.9), Eigen::Vector3d(0.2, 0.2, 1.2)});
  const auto marked = [this] {
    return test::countPixels(view().picture({600, 450}), colorOf(Difference::wronglyAttached), 24);
  };
  const int before = marked();
  key(Qt::Key_6, Qt::ControlModifier);
  EXPECT_GT(before, marked() + 300) << "cross, path, arrows and ring, beside the plant itself";
}

TEST_F(EvaluationWindowTest, FindsTheShiftAgainAsThePlantIsMovedPieceByPiece) {
  compare(nothing);
  EXPECT_TRUE(find<QLabel>("evaluation_shift").text().startsWith("moved by"));
  for (const std::uint32_t first : {0U, 14U, 28U})
    document().edit("Move", [=](SkeletonEditor& editor) {
      for (std::uint32_t i = first; i < std::min(first + 14, 41U); ++i)
        editor.setPosition(NodeId{i},
                           editor.skeleton()[NodeId{i}].position + Eigen::Vector3d(0.3, 0, 0));
    });
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(score("f"), "1.000");
  EXPECT_TRUE(find<QLabel>("evaluation_warnings").text().contains("files lie 0.3"))
      << find<QLabel>("evaluation_warnings").text().toStdString();
}

TEST_F(EvaluationWindowTest, SaysAboveTheScoresThatUnitsDiffer) {
  compare(nothing);
  auto& warnings = find<QLabel>("evaluation_warnings");
  EXPECT_FALSE(warnings.isVisible());
  Skeleton inMillimeters = plant();
  for (const NodeId id : inMillimeters.ids())
    inMillimeters.setPosition(id, 1000 * inMillimeters[id].position);
  load(write("expert_mm.mtg", inMillimeters));
  EXPECT_TRUE(warnings.isVisible());
  EXPECT_TRUE(warnings.text().contains("1000 times as small as the reference"))
      << warnings.text().toStdString();
  load(write("expert.mtg", plant()));
  EXPECT_FALSE(warnings.isVisible());
}

TEST_F(EvaluationWindowTest, AcceptsErrorByErrorEachAsOneStep) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -0.5, 0.5});
    reparentNode(editor, shoot(1), NodeId{3});
  });
  ASSERT_TRUE(waitForErrors(3));
  const Skeleton before = document().skeleton();
  for (int steps = 1; steps <= 3; ++steps) {
    key(Qt::Key_F3);
    key(Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(document().undoStack().count(), steps);
    EXPECT_TRUE(waitForErrors(3 - steps));
    ASSERT_TRUE(waitForScores());
  }
  EXPECT_TRUE(isPlantTheReference());
  EXPECT_EQ(score("f"), "1.000");
  const QString name = document().undoStack().text(0);
  EXPECT_TRUE(name.contains("reference")) << name.toStdString();
  for (int i = 0; i < 3; ++i)
    key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton(), before);
}

TEST_F(EvaluationWindowTest, GoesOnBehindWhatWasAccepted) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -0.5, 0.5});
    addChild(editor, NodeId{7}, {0, -0.4, 0.7});
  });
  ASSERT_TRUE(waitForErrors(3));
  const QString second = list().topLevelItem(1)->text(1);
  key(Qt::Key_F3);
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(errors(), "2 errors") << "at once";
  key(Qt::Key_F3);
  EXPECT_EQ(list().currentItem()->text(1), second) << "none is passed over";
}

TEST_F(EvaluationWindowTest, RefusesAPartThatHasBeenEditedSince) {
  compare([](SkeletonEditor& editor) { addChild(editor, NodeId{5}, {0, -0.5, 0.5}); });
  ASSERT_TRUE(waitForErrors(1));
  key(Qt::Key_F3);
  const NodeId spur = document().selection().nodes().front();
  document().edit("Remove", [=](SkeletonEditor& editor) { removeNode(editor, spur); });
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().count(), 1);
  EXPECT_TRUE(message().contains("has been edited since it was compared"));
}

TEST_F(EvaluationWindowTest, IgnoredErrorsLeaveTheListAndAreKeptInTheProject) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(2));
    addChild(editor, NodeId{5}, {0, -0.5, 0.5});
  });
  ASSERT_TRUE(waitForErrors(2));
  key(Qt::Key_F3);
  key(Qt::Key_F3, Qt::ControlModifier);
  EXPECT_EQ(errors(), "1 error");
  EXPECT_EQ(find<QToolButton>("differences_ignored").text(), "1 ignored");
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Ignored: "));
  const QString file = saveProject("plant.espalier");
  window().close();
  restart();
  open({file});
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(errors(), "1 error");
  auto& shown = find<QToolButton>("differences_ignored");
  QTest::mouseClick(&shown, Qt::LeftButton);
  const QTreeWidgetItem* item = list().topLevelItem(1);
  EXPECT_FALSE(item->isHidden());
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(item).center());
  EXPECT_EQ(action("ignore_error").text(), "Show Error Again");
  key(Qt::Key_F3, Qt::ControlModifier);
  EXPECT_EQ(errors(), "2 errors");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(errors(), "1 error");
  EXPECT_EQ(window().statusLine().shownText(), "Undone: Show an error again");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(errors(), "2 errors");
}

TEST_F(EvaluationWindowTest, WhatIsIgnoredAgainstOneReferenceIsShownAgainstAnother) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  ASSERT_TRUE(waitForErrors(1));
  const QString file = saveProject("plant.espalier");
  key(Qt::Key_F3);
  key(Qt::Key_F3, Qt::ControlModifier);
  EXPECT_EQ(errors(), "0 errors");
  load(write("second.mtg", plant()));
  EXPECT_TRUE(waitForErrors(1)) << "nobody has ignored it";
  window().close();
  restart();
  open({file});
  ASSERT_TRUE(waitForScores());
  EXPECT_TRUE(waitForErrors(1));
  load(path("expert.mtg"));
  EXPECT_TRUE(waitForErrors(0)) << "the project knows what was ignored";
}

TEST_F(EvaluationWindowTest, IsWrittenByAWindowThatGoesAtOnce) {
  compare([](SkeletonEditor& editor) { removeSubtree(editor, shoot(2)); });
  ASSERT_TRUE(waitForErrors(1));
  const QString file = saveProject("plant.espalier");
  key(Qt::Key_F3);
  key(Qt::Key_F3, Qt::ControlModifier);
  restart(); // within the pause before what is new is written
  open({file});
  ASSERT_TRUE(waitForScores());
  EXPECT_EQ(errors(), "0 errors");
}

TEST(EvaluationText, ComesBackAsItWas) {
  const EvaluationText text{
      .tolerance = 0.25,
      .isLaid = false,
      .turns = false,
      .edit = {.unit = EditUnit::axis, .cost = EditCost::shape, .mergesPaths = true},
      .ignored = {{.kind = Difference::invented, .nodes = {}, .at = {1, 2.5, -3}}},
      .ignoredOf = {
          {"/home/ä/expert.mtg", {{.kind = Difference::missed, .nodes = {}, .at = {0, 0, 7}}}}}};
  EXPECT_EQ(evaluationFrom(textOf(text)), text);
  const EvaluationText before = evaluationFrom(R"({"tolerance": 0.25, "laid": false})");
  EXPECT_TRUE(before.turns) << "of a project that was written before there were turns";
  EXPECT_EQ(before.edit, EditOptions());
  EXPECT_EQ(textOf(EvaluationText()), "");
  EXPECT_EQ(evaluationFrom(""), EvaluationText());
}

TEST(EvaluationText, IsRefusedIfItIsNone) {
  for (const char* text :
       {"nonsense", "{}", R"({"tolerance": "a", "laid": true})",
        R"({"tolerance": -1, "laid": true})", R"({"tolerance": 1, "laid": true, "turned": 3})",
        R"({"tolerance": 1, "laid": true, "edit_cost": "shap"})",
        R"({"tolerance": 1, "laid": true, "ignored": [{"kind": "matched", "at": [0, 0, 0]}]})",
        R"({"tolerance": 1, "laid": true, "ignored": [{"kind": "missed", "at": [0, 0]}]})"})
    EXPECT_THROW(static_cast<void>(evaluationFrom(text)), Error) << text;
}

} // namespace
} // namespace espalier
