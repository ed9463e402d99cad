#include "app/report/pdf_report.h"
#include "app/window/review/findings_flow.h"
#include "core/io/formats.h"
#include "core/project/seal.h"
#include "tests/app/report/reported_plants.h"
#include "tests/app/report/whole_seal.h"
#include "tests/app/window/project_fixture.h"
#include "ui/dialogs/sign_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTranslator>

namespace espalier {
namespace {

struct SealWindowTest : test::ProjectWindowTest {
  void openAndReview() {
    open({writeFork("fork.mtg")});
    key(Qt::Key_Period);
    for (int stretch = 0; stretch < 4; ++stretch)
      key(Qt::Key_Return);
    view().frameAll();
    waitForView();
  }
  void beginToSign() {
    action("sign_structure").trigger();
    waitForJob();
  }
  void sign(const QString& reason = {}) {
    answer(
        [reason](QDialog& dialog) {
          auto* signer = dialog.findChild<QLineEdit*>("signer");
          signer->selectAll();
          QTest::keyClicks(signer, "Anna");
          QTest::keyClicks(dialog.findChild<QLineEdit*>("reason"), reason);
          press("Sign")(dialog);
        },
        [this] { beginToSign(); });
  }
  /// All that the dialog says, before it is left.
  QString asked() {
    QString text;
    answer(
        [&](QDialog& dialog) {
          for (auto* label : dialog.findChildren<QLabel*>())
            text += label->text() + "\n";
          dialog.reject();
        },
        [this] { beginToSign(); });
    return text;
  }
  void dragTheShoot() {
    const QPoint place = placeOf(nodeAt({1, 0, 2}));
    drag(place, place + QPoint(30, 20));
  }
  QString seal() { return find<QLabel>("seal").text(); }
  [[nodiscard]] bool isIntact() { return seal().startsWith("✓ Signed by Anna on "); }
  [[nodiscard]] bool isBroken() { return seal().startsWith("✗ Seal broken"); }
};

TEST_F(SealWindowTest, TheDialogHasRoomForAllItsLines) {
  SignDialog dialog(test::wholeSeal(), LengthUnit::meter, "Anna", &window());
  dialog.show();
  QApplication::processEvents();
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    if (!label->wordWrap()) continue;
    EXPECT_GE(label->height(), label->heightForWidth(label->width()))
        << label->text().toStdString();
  }
}

TEST_F(SealWindowTest, IsRefusedUntilAllIsReviewed) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_Period);
  key(Qt::Key_Return);
  expectNoDialog([this] { action("sign_structure").trigger(); });
  EXPECT_EQ(message(), "3 of 5 nodes are not reviewed: Ctrl+. goes to the next");
  EXPECT_EQ(seal(), "Not signed yet. A project keeps the seal, a file does not.");
}

TEST_F(SealWindowTest, BreaksByAnEditOnceAndIsMendedByUndo) {
  openAndReview();
  saveProject("fork.espalier");
  sign();
  ASSERT_TRUE(isIntact()) << seal().toStdString();
  dragTheShoot();
  EXPECT_TRUE(isBroken());
  EXPECT_TRUE(message().startsWith("This breaks the seal of Anna on "));
  ASSERT_TRUE(window().banner().isVisible());
  clickButton("dismiss");
  document().selection().set({nodeAt({0, 0, 1})});
  key(Qt::Key_A); // a thicker trunk
  EXPECT_FALSE(window().banner().isVisible()) << "it is reported once";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(isBroken());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(isIntact());
}

TEST_F(SealWindowTest, IsMendedByTheBannerHoweverMuchWasEdited) {
  openAndReview();
  saveProject("fork.espalier");
  sign();
  const int steps = document().undoStack().index();
  dragTheShoot();
  document().selection().set({nodeAt({0, 0, 1})});
  key(Qt::Key_A);
  EXPECT_EQ(document().undoStack().index(), steps + 2);
  clickButton("banner_action");
  EXPECT_TRUE(isIntact());
  EXPECT_EQ(document().undoStack().index(), steps);
  EXPECT_TRUE(document().undoStack().canRedo());
}

TEST_F(SealWindowTest, TheBannerLeavesWhenTheSealHoldsAgain) {
  openAndReview();
  saveProject("fork.espalier");
  sign();
  dragTheShoot();
  ASSERT_TRUE(window().banner().isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(SealWindowTest, HoldsAgainOnceAMarkIsUndone) {
  openAndReview();
  saveProject("fork.espalier");
  sign();
  const QString before = seal();
  const Skeleton structure = document().skeleton();
  document().selection().set({nodeAt({1, 0, 2})});
  for (const Qt::KeyboardModifier with : {Qt::NoModifier, Qt::ShiftModifier}) {
    key(with == Qt::NoModifier ? Qt::Key_Backspace : Qt::Key_Return, with); // to do, doubtful
    EXPECT_TRUE(isBroken());
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(seal(), before);
    EXPECT_EQ(document().skeleton(), structure) << "with who has reviewed it";
  }
}

TEST_F(SealWindowTest, RedoLeadsBackToItFromBeforeItWasSigned) {
  openAndReview();
  const QString file = saveProject("fork.espalier");
  sign();
  const QString before = seal();
  const int steps = document().undoStack().index();
  key(Qt::Key_Z, Qt::ControlModifier); // the last mark before it was signed
  EXPECT_TRUE(seal().startsWith("✗ Undone to before it was signed by Anna on "))
      << seal().toStdString();
  EXPECT_TRUE(message().startsWith("This goes back to before the seal of Anna on "));
  EXPECT_EQ(find<QPushButton>("banner_action").text(), "Redo");
  clickButton("banner_action");
  EXPECT_EQ(seal(), before);
  EXPECT_EQ(document().undoStack().index(), steps);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  restart();
  open({file});
  EXPECT_TRUE(seal().startsWith("✗ Undone to before"));
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(seal(), before);
}

TEST_F(SealWindowTest, AfterAnEditBeforeItNothingLeadsBack) {
  openAndReview();
  saveProject("fork.espalier");
  sign();
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(window().banner().isVisible());
  document().selection().set({nodeAt({0, 0, 1})});
  key(Qt::Key_A); // a thicker trunk: nothing can be redone any more
  EXPECT_TRUE(isBroken());
  EXPECT_TRUE(message().startsWith("The seal of Anna on ")) << message().toStdString();
  EXPECT_TRUE(message().endsWith(" is lost: what was signed can no longer be redone"));
  for (const auto* button : window().banner().findChildren<QPushButton*>())
    EXPECT_TRUE(button->isHidden() || button->text() == "Dismiss") << "nothing leads back";
  clickButton("dismiss");
  key(Qt::Key_A);
  EXPECT_FALSE(window().banner().isVisible()) << "it is reported once";
}

TEST_F(SealWindowTest, IsKeptInTheProject) {
  openAndReview();
  const QString file = saveProject("fork.espalier");
  sign();
  const QString before = seal();
  restart();
  open({file});
  EXPECT_EQ(seal(), before);
  document().selection().set({nodeAt({0, 0, 1})});
  key(Qt::Key_A);
  restart();
  open({file});
  EXPECT_TRUE(isBroken());
  EXPECT_FALSE(window().banner().isVisible()) << "it broke in another session";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(seal(), before);
  action("new_plant").trigger();
  EXPECT_FALSE(isIntact());
}

TEST_F(SealWindowTest, SaysWhoWhenAndWhatWasCorrected) {
  open({writeFork("fork.mtg")});
  dragTheShoot();
  key(Qt::Key_Period);
  for (int stretch = 0; stretch < 4; ++stretch)
    key(Qt::Key_Return);
  const QString asked = this->asked();
  EXPECT_TRUE(asked.contains("5 nodes"));
  EXPECT_TRUE(asked.contains("1 edit; nodes: 1 moved"));
  EXPECT_FALSE(isIntact()) << "it was not signed";
  sign();
  EXPECT_TRUE(seal().contains("Corrections: 1 edit; nodes: 1 moved"));
  EXPECT_EQ(find<QLineEdit>("reviewer").text(), "Anna") << "who signs is the reviewer";
  EXPECT_TRUE(message().contains("Only a project keeps the seal"));
}

TEST_F(SealWindowTest, OverOpenFindingsAsksWhyAndKeepsTheAnswer) {
  openAndReview();
  const QString file = saveProject("fork.espalier");
  document().edit("Fold back", [&](SkeletonEditor& editor) { // and two successors
    editor.add({.position = {0, 0, 0.5}, .radius = 0.01, .parent = NodeId{1}});
  });
  action("select_all").trigger();
  action("mark_all_selected").trigger();
  const auto signIsOffered = [](QDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>())
      if (button->text().remove('&') == "Sign") return button->isEnabled();
    return false;
  };
  answer(
      [&](QDialog& dialog) {
        EXPECT_EQ(dialog.focusWidget(), dialog.findChild<QLineEdit*>("reason"));
        QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
        EXPECT_EQ(dialog.focusWidget(), dialog.findChild<QLineEdit*>("signer"));
        dialog.findChild<QLineEdit*>("signer")->setText("Anna");
        EXPECT_FALSE(signIsOffered(dialog)) << "no reason is given";
        const auto* missing = dialog.findChild<QLabel*>("sign_missing");
        EXPECT_EQ(missing->text(), "To sign, type why findings are left open");
        dialog.findChild<QLineEdit*>("reason")->setText("a fold that is there");
        EXPECT_TRUE(signIsOffered(dialog));
        EXPECT_EQ(missing->text(), "");
        dialog.reject();
      },
      [this] { beginToSign(); });
  EXPECT_TRUE(asked().contains(" open ("));
  sign("a fold that is there");
  ASSERT_TRUE(isIntact()) << seal().toStdString();
  EXPECT_TRUE(seal().contains("Findings: ")) << seal().toStdString();
  restart();
  const Seal kept = sealFrom(Project::open(toPath(file), Access::readOnly).document("seal"));
  ASSERT_TRUE(kept.state);
  EXPECT_EQ(kept.state->reason, "a fold that is there");
  EXPECT_GE(kept.state->openFindings(), 1U);
}

TEST_F(SealWindowTest, IgnoredFindingsAreNoneThatAreOpen) {
  openAndReview();
  document().edit("Fold back", [&](SkeletonEditor& editor) {
    editor.add({.position = {0, 0, 0.5}, .radius = 0.01, .parent = NodeId{1}});
  });
  action("select_all").trigger();
  action("mark_all_selected").trigger();
  action("next_finding").trigger();
  for (int i = 0; i < 9; ++i)
    action("ignore_finding").trigger();
  const QString text = asked();
  EXPECT_TRUE(text.contains("none is open; ")) << text.toStdString();
}

// Points of the branches of the scan, of which the trunk has none.
TEST_F(SealWindowTest, StatesHowManyPointsWereIgnoredAsNoWood) {
  Skeleton trunk;
  const NodeId foot = trunk.add({.position = {0, 0, 0}, .radius = 0.05});
  trunk.add({.position = {0, 0, 2}, .radius = 0.05, .parent = foot});
  writeStructure(toPath(path("trunk.mtg")), trunk);
  open({writeScan("plant.xyz"), path("trunk.mtg")});
  action("select_all").trigger();
  action("mark_all_selected").trigger();
  EXPECT_FALSE(asked().contains("ignored as no wood"));
  key(Qt::Key_F8);
  const auto& findings = window().part<FindingsFlow>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return findings.isAllChecked(); }, patience));
  auto& kinds = find<QComboBox>("findings_kind");
  const int bare = kinds.findText("Bare twigs (", Qt::MatchStartsWith);
  ASSERT_GE(bare, 0);
  kinds.setCurrentIndex(bare);
  emit kinds.activated(bare);
  const PointSet& points = document().pointSelection().points();
  key(Qt::Key_F4);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !points.isEmpty(); }, patience));
  const std::size_t selected = points.size();
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_EQ(findings.ignored().size(), 1U);
  const std::size_t ignored = findings.ignored().front().points.size();
  EXPECT_EQ(ignored, selected);
  const QString text = asked();
  EXPECT_TRUE(text.contains("; at 1 place ignored as no wood: " + formatCount(ignored) + " ("))
      << text.toStdString();
}

TEST_F(SealWindowTest, StatesHowMuchWasMarkedInBulkAndHowItAgreesWithWhatWasOpened) {
  openAndReview();
  EXPECT_TRUE(asked().contains("Agreement with what was opened"));
  EXPECT_TRUE(asked().contains("F 1.000 within ")) << asked().toStdString();
  EXPECT_FALSE(asked().contains("Marked in bulk"));
  action("select_all").trigger();
  key(Qt::Key_Backspace); // all to do
  action("mark_all_selected").trigger();
  EXPECT_TRUE(asked().contains("Marked in bulk")) << asked().toStdString();
}

TEST_F(SealWindowTest, StatesHowItAgreesWithTheReferenceAndWhatPointsHaveNoWood) {
  const QString file = writeFork("fork.mtg");
  open({writeScan("scan.xyz"), file});
  key(Qt::Key_Period);
  action("select_all").trigger();
  action("mark_all_selected").trigger();
  answer(chooseFile(file), [this] { action("load_reference").trigger(); });
  waitForJob();
  const QString text = asked();
  EXPECT_TRUE(text.contains("Agreement with fork.mtg")) << text.toStdString();
  EXPECT_TRUE(text.contains("Points without wood"));
}

TEST_F(SealWindowTest, HasRoomForTheFrenchCertificateOnOnePage) {
  QTranslator french;
  ASSERT_TRUE(french.load("espalier_fr", ":/translations"));
  QApplication::installTranslator(&french);
  const Report certificate = test::crowdedCertificate();
  const QByteArray pdf = pdfOf(certificate);
  QApplication::removeTranslator(&french);
  EXPECT_TRUE(certificate.sections.front().title.startsWith("Signé")) << "in French";
  EXPECT_EQ(test::pagesOf(pdf), 1);
}

TEST_F(SealWindowTest, HasACertificateOfOnePage) {
  openAndReview();
  EXPECT_FALSE(action("export_certificate").isEnabled());
  saveProject("fork.espalier");
  sign();
  EXPECT_EQ(find<QPushButton>("banner_action").text(), "Export Certificate…");
  const QString file = path("fork.certificate.pdf");
  answer(chooseFile(file), [this] { clickButton("banner_action"); });
  EXPECT_TRUE(QTest::qWaitFor([&] { return message().startsWith("Wrote fork.certificate.pdf"); },
                              patience));
  waitForJob(); // it ends a moment after its message, and nothing is edited meanwhile
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  EXPECT_EQ(written.read(4), "%PDF");
  dragTheShoot();
  EXPECT_FALSE(action("export_certificate").isEnabled()) << "a broken seal has none";
}

TEST_F(SealWindowTest, IsExportedAsAFileBesideTheStructure) {
  openAndReview();
  EXPECT_FALSE(action("export_seal").isEnabled());
  sign();
  const QString file = path("fork.seal.json");
  answer(chooseFile(file), [this] { action("export_seal").trigger(); });
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const Seal exported = sealFrom(written.readAll().toStdString());
  EXPECT_EQ(exported.author, "Anna");
  EXPECT_EQ(exported.nodes, 5U);
  dragTheShoot();
  EXPECT_FALSE(action("export_seal").isEnabled()) << "a broken seal says nothing";
}

TEST_F(SealWindowTest, ThatCannotBeReadIsReportedAndLeftAlone) {
  openAndReview();
  const QString file = saveProject("fork.espalier");
  action("close_plant").trigger();
  Project::open(toPath(file), Access::readWrite).setDocument("seal", "{nonsense");
  open({file});
  EXPECT_EQ(message(), "The seal of this structure cannot be read: sign it again");
  EXPECT_EQ(seal(), "Not signed yet.");
}

} // namespace
} // namespace espalier
