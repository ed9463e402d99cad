#include "core/evaluate/registration/registration.h"
#include "core/simulate/plant_grower.h"
#include "tests/app/window/evaluation_fixture.h"
#include "tests/support/shared_data.h"
#include "ui/panels/message_banner.h"

#include <QCheckBox>
#include <QFile>
#include <QMenu>
#include <QToolButton>

#include <utility>

namespace espalier {
namespace {

using test::EvaluationWindowTest;

Skeleton turned(const Skeleton& plant, double degrees, const Eigen::Vector3d& axis) {
  return moved(plant, Eigen::Isometry3d(Eigen::AngleAxisd(degrees * M_PI / 180, axis)));
}

TEST_F(EvaluationWindowTest, TurnsTheReferenceOntoThePlantUnlessRefused) {
  Skeleton lopsided = plant();
  SkeletonEditor editor(lopsided);
  removeSubtree(editor, shoot(2));
  static_cast<void>(editor.commit());
  open({write("plant.mtg", lopsided)});
  for (const auto& [degrees, axis] : {std::pair(30.0, Eigen::Vector3d::UnitZ().eval()),
                                      {90.0, Eigen::Vector3d::UnitZ()},
                                      {180.0, Eigen::Vector3d::UnitZ()},
                                      {5.0, Eigen::Vector3d::UnitX()}}) {
    load(write("expert.mtg", turned(lopsided, degrees, axis)));
    EXPECT_EQ(score("f"), "1.000");
    EXPECT_EQ(score("geometric"), "1.000");
    EXPECT_EQ(score("structural"), "1.000");
    const auto& warnings = find<QLabel>("evaluation_warnings");
    const QString turn = "turned by " + QString::number(degrees, 'f', 1) + "°";
    EXPECT_TRUE(warnings.isVisible() && warnings.text().contains(turn))
        << warnings.text().toStdString();
    EXPECT_FALSE(warnings.text().contains('\n')) << "nothing else";
  }
  load(write("expert.mtg", turned(lopsided, 90, Eigen::Vector3d::UnitZ())));
  QTest::mouseClick(&find<QCheckBox>("evaluation_turns"), Qt::LeftButton, {}, QPoint(8, 8));
  ASSERT_TRUE(waitForScores());
  EXPECT_LT(score("f").toDouble(), 0.9);
  EXPECT_FALSE(find<QLabel>("evaluation_warnings").text().contains("turned"));
  QTest::mouseClick(&find<QCheckBox>("evaluation_laid"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_FALSE(find<QCheckBox>("evaluation_turns").isEnabled()) << "nothing is laid on anything";
  const QString file = saveProject("plant.espalier");
  window().close();
  restart();
  open({file});
  EXPECT_FALSE(find<QCheckBox>("evaluation_turns").isChecked()) << "the project keeps it";
}

TEST_F(EvaluationWindowTest, ScoresTheTurnedExpertOfThePineAsUnturned) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton pine = readStructure(expert).value.skeleton;
  open({QString::fromStdString(expert.string())});
  for (const auto& [degrees, axis] :
       {std::pair(30.0, Eigen::Vector3d::UnitZ().eval()), {5.0, Eigen::Vector3d::UnitX()}}) {
    load(write("turned.mtg", turned(pine, degrees, axis)));
    EXPECT_GE(score("geometric").toDouble(), 0.995);
    EXPECT_GE(score("structural").toDouble(), 0.995);
  }
}

TEST_F(EvaluationWindowTest, WarnsAboveTheScoresOfAnotherPlant) {
  open({write("plant.mtg", growPlant({.segments = 60}, 1))});
  load(write("other.mtg", growPlant({.segments = 60}, 2)));
  const QString warnings = find<QLabel>("evaluation_warnings").text();
  EXPECT_TRUE(warnings.contains("the two fit poorly")) << warnings.toStdString();
}

TEST_F(EvaluationWindowTest, CountsEditsAsIsChosen) {
  compare([](SkeletonEditor& editor) { // a spur cuts the stem in two
    const Eigen::Vector3d at = editor.skeleton()[NodeId{5}].position;
    addChild(editor, NodeId{5}, at + Eigen::Vector3d(0.15, 0, 0));
  });
  EXPECT_EQ(score("edits"), "2");
  EXPECT_EQ(score("edit_length"), QStringLiteral("–"));
  EXPECT_EQ(score("edits_removed"), "2");
  const auto choose = [this](const char* id) {
    action(id).trigger();
    EXPECT_EQ(find<QLabel>("score_f").property("role"), "quiet") << "until it is compared";
    ASSERT_TRUE(waitForScores());
  };
  choose("edit_merges");
  EXPECT_EQ(score("edits"), "1") << "the spur alone";
  EXPECT_EQ(score("edits_removed"), "1");
  choose("edit_cost_length");
  EXPECT_EQ(score("edits"), QStringLiteral("–"));
  EXPECT_EQ(score("edit_length"), formatLength(0.15, document().unit(), 3));
  choose("edit_unit_node");
  EXPECT_EQ(score("edits_removed"), "1");
  const auto& button = find<QToolButton>("evaluation_edits");
  EXPECT_TRUE(button.menu()->actions().contains(&action("edit_cost_length")));
  const QString file = saveProject("plant.espalier");
  window().close();
  restart();
  open({file});
  EXPECT_TRUE(action("edit_merges").isChecked()) << "the project keeps it";
  EXPECT_TRUE(action("edit_unit_node").isChecked());
  EXPECT_TRUE(action("edit_cost_length").isChecked());
}

TEST_F(EvaluationWindowTest, SavesTheEditMapping) {
  open({write("plant.mtg", plant())});
  action("save_edit_mapping").trigger();
  EXPECT_TRUE(window().banner().text().contains("no reference"));
  load(write("expert.mtg", plant()));
  const QString file = path("mapping.csv");
  answer(chooseFile(file), [this] { action("save_edit_mapping").trigger(); });
  QFile saved(file);
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  const QByteArray text = saved.readAll();
  EXPECT_TRUE(text.startsWith("edit,result,")) << text.constData();
  EXPECT_EQ(text.count("\nmatched,"), 4);
  EXPECT_FALSE(text.contains("removed,"));
}

TEST_F(EvaluationWindowTest, GoesThroughTheErrorsOfAnotherReferenceFromTheFirst) {
  compare([](SkeletonEditor& editor) {
    removeSubtree(editor, shoot(1));
    removeSubtree(editor, NodeId{static_cast<std::uint32_t>(indexOf(shoot(2)) + 4)});
  });
  ASSERT_TRUE(waitForErrors(2));
  const auto goOn = [this] {
    key(Qt::Key_F3);
    return list().indexOfTopLevelItem(list().currentItem());
  };
  EXPECT_EQ(goOn(), 0);
  EXPECT_EQ(goOn(), 1);
  load(write("second.mtg", plant()));
  ASSERT_TRUE(waitForErrors(2));
  EXPECT_EQ(goOn(), 0);
}

} // namespace
} // namespace espalier
