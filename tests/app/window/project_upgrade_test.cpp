#include "tests/app/window/project_fixture.h"
#include "tests/support/older_project.h"
#include "ui/panels/step_form.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

namespace espalier {
namespace {

struct ProjectUpgradeTest : test::ProjectWindowTest {
  void reviewAll() {
    document().edit("Review", [](SkeletonEditor& editor) {
      for (const NodeId id : editor.skeleton().ids())
        editor.setReview(id, {ReviewState::reviewed, "fine", "Emil"});
    });
  }
  void sign() {
    answer(
        [](QDialog& dialog) {
          auto* signer = dialog.findChild<QLineEdit*>("signer");
          signer->selectAll();
          QTest::keyClicks(signer, "Anna");
          dialog.findChild<QLineEdit*>("reason")->setText("as reconstructed");
          press("Sign")(dialog);
        },
        [this] {
          action("sign_structure").trigger();
          waitForJob();
        });
  }
  void openAnew(const QString& file) {
    window().close();
    restart();
    open({file});
  }
  [[nodiscard]] bool isSigned() {
    return find<QLabel>("seal").text().startsWith("✓ Signed by Anna on ");
  }
  [[nodiscard]] StepForm::State stateOfLastStep() {
    return dynamic_cast<StepForm&>(find<QWidget>("step_radius")).state();
  }
  /// What version 0.1 knew of the history.
  [[nodiscard]] History historyWithoutIds() {
    History history = document().history();
    for (HistoryStep& step : history.steps) {
      step.id = {};
      step.replacesContracted = false;
    }
    return history;
  }
};

TEST_F(ProjectUpgradeTest, OpensAPlantOfVersion01AsItWasLeft) {
  open({writeScan("plant.xyz")});
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  reviewAll();
  sign();
  document().edit("Radius", [](SkeletonEditor& editor) {
    editor.setRadius(editor.skeleton().roots().front(), 0.2);
  });
  document().undoStack().undo();
  ASSERT_TRUE(isSigned());
  const QString today = saveProject("today.espalier");
  const History history = historyWithoutIds();
  ASSERT_EQ(history.position + 1, history.steps.size());
  window().close();
  restart();
  const QString older = path("older.espalier");
  test::writeAsVersion01(toPath(today), toPath(older));
  open({older});
  const auto expectAll = [&](const char* when) {
    SCOPED_TRACE(when);
    EXPECT_EQ(historyWithoutIds(), history);
    EXPECT_NE(document().contracted(), nullptr);
    EXPECT_EQ(stateOfLastStep(), StepForm::State::done);
    EXPECT_TRUE(isSigned());
  };
  expectAll("once it is opened");
  document().goTo(0);
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_EQ(document().contracted(), nullptr);
  EXPECT_EQ(stateOfLastStep(), StepForm::State::idle);
  document().goTo(static_cast<int>(history.position));
  expectAll("after undo and redo");
  openAnew(older);
  expectAll("when it is opened again");
}

} // namespace
} // namespace espalier
