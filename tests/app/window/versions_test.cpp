#include "app/window/evaluate/evaluation_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "tests/app/window/project_fixture.h"

#include <QCheckBox>
#include <QInputDialog>
#include <QMenu>
#include <QRegularExpression>
#include <QTest>

namespace espalier {
namespace {

struct VersionsWindowTest : test::ProjectWindowTest {
  void name(const QString& name) {
    answer(
        [&](QDialog& dialog) {
          dynamic_cast<QInputDialog&>(dialog).setTextValue(name);
          dialog.accept();
        },
        [this] { action("name_version").trigger(); });
  }
  /// The texts of the list, of which the one that begins so is chosen; empty: none is.
  QStringList compareWith(const QString& beginning) {
    QStringList texts;
    answer(
        [&](QDialog& dialog) {
          auto& input = dynamic_cast<QInputDialog&>(dialog);
          texts = input.comboBoxItems();
          const QStringList found = texts.filter(QRegularExpression("^" + beginning));
          if (beginning.isEmpty() || found.isEmpty()) return dialog.reject();
          input.setTextValue(found.front());
          dialog.accept();
        },
        [this] { action("compare_version").trigger(); });
    return texts;
  }
  [[nodiscard]] const ReferenceFlow& reference() { return window().part<ReferenceFlow>(); }
  [[nodiscard]] const EvaluationFlow& evaluation() { return window().part<EvaluationFlow>(); }
  [[nodiscard]] bool waitUntilCompared() {
    return QTest::qWaitFor([this] { return evaluation().isUpToDate(); }, patience);
  }
  void removeShoot() {
    const NodeId shoot = nodeAt({1, 0, 2});
    document().edit("Remove", [=](SkeletonEditor& editor) { editor.erase(shoot); });
  }
  void openAnew(const QString& file) {
    window().close();
    restart();
    open({file});
  }
};

TEST_F(VersionsWindowTest, OnlyAProjectKeepsThem) {
  open({writeFork("fork.mtg")});
  expectNoDialog([this] { action("name_version").trigger(); });
  EXPECT_EQ(message(), "Only a project keeps versions: save the plant as one first");
}

TEST_F(VersionsWindowTest, GivesBackAPieceOfANamedStateAsOneStep) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("fork.espalier");
  name("before pruning");
  const Skeleton before = document().skeleton();
  removeShoot();
  openAnew(file);
  ASSERT_EQ(document().skeleton().size(), 4U);
  EXPECT_TRUE(compareWith("before pruning").front().startsWith("before pruning · "));
  EXPECT_EQ(reference().name(), "before pruning");
  EXPECT_EQ(*reference().skeleton(), before);
  ASSERT_TRUE(waitUntilCompared());
  const int steps = document().undoStack().count();
  key(Qt::Key_F3);
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton().size(), 5U);
  EXPECT_EQ(document().skeleton()[nodeAt({1, 0, 2})].position, Eigen::Vector3d(1, 0, 2));
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton().size(), 4U);
}

TEST_F(VersionsWindowTest, GivesBackWhatTheStateSaysOfThePiece) {
  open({writeFork("fork.mtg")});
  saveProject("fork.espalier");
  const NodeId shoot = nodeAt({1, 0, 2});
  document().edit("Comment", [=](SkeletonEditor& editor) {
    editor.setReview(
        shoot, {.state = ReviewState::reviewed, .comment = "a dead twig", .reviewer = "Anna"});
  });
  name("before pruning");
  removeShoot();
  (void)compareWith("before pruning");
  ASSERT_TRUE(waitUntilCompared());
  key(Qt::Key_F3);
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton()[nodeAt({1, 0, 2})].review,
            (ReviewMark{.comment = "a dead twig"}));
  EXPECT_TRUE(document().undoStack().undoText().endsWith("of “before pruning”"))
      << document().undoStack().undoText().toStdString();
}

TEST_F(VersionsWindowTest, GiveTheReferenceBackThatTheyStoodInThePlaceOf) {
  const QString expert = writeFork("expert.mtg");
  open({writeFork("fork.mtg")});
  const QString file = saveProject("fork.espalier");
  name("first");
  removeShoot();
  answer(chooseFile(expert), [this] { action("load_reference").trigger(); });
  waitForJob();
  (void)compareWith("first");
  (void)compareWith("what was opened");
  ASSERT_TRUE(reference().isVersion());
  openAnew(file);
  ASSERT_TRUE(reference().isVersion());
  action("remove_reference").trigger();
  EXPECT_EQ(reference().name(), "expert.mtg");
  EXPECT_FALSE(reference().isVersion());
  action("remove_reference").trigger();
  EXPECT_EQ(reference().skeleton(), nullptr);
}

TEST_F(VersionsWindowTest, ComparesWhereBothLie) {
  open({writeFork("fork.mtg")});
  saveProject("fork.espalier");
  name("first");
  document().edit("Move", [](SkeletonEditor& editor) {
    for (const NodeId id : editor.skeleton().ids())
      editor.setPosition(id, editor.skeleton()[id].position + Eigen::Vector3d(3, 0, 0));
  });
  (void)compareWith("first");
  ASSERT_TRUE(waitUntilCompared());
  EXPECT_TRUE(evaluation().evaluation()->motion.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_EQ(evaluation().evaluation()->score.f(), 0) << "all of it was moved";
  EXPECT_FALSE(find<QCheckBox>("evaluation_laid").isVisible());
}

TEST_F(VersionsWindowTest, ListsTheEndOfEachDayAndTheBeginning) {
  History history{.skeleton = test::fork(3)};
  constexpr std::int64_t day = std::int64_t{24} * 3600 * 1000; // [ms]
  for (int i = 0; i < 4; ++i) {
    SkeletonEditor editor(history.skeleton);
    editor.setPosition(test::forkTop, {0, 0, 2.0 + i});
    history.steps.push_back({.id = StepId{static_cast<std::uint64_t>(i + 1)},
                             .text = "Move",
                             .author = "Anna",
                             .time = 1'700'000'000'000 + i / 2 * day,
                             .delta = editor.commit()});
  }
  history.position = 4;
  (void)Project::create(toPath(path("old.espalier")), history);
  open({path("old.espalier")});
  const QStringList texts = compareWith("the end of ");
  ASSERT_EQ(texts.size(), 2) << texts.join(" | ").toStdString();
  EXPECT_TRUE(texts[0].startsWith("the end of ") && texts[0].contains(" · Anna, "));
  EXPECT_EQ(texts[1], "what was opened, before any edit");
  ASSERT_NE(reference().skeleton(), nullptr);
  EXPECT_EQ((*reference().skeleton())[test::forkTop].position.z(), 3) << "the second step";
  (void)compareWith("what was opened");
  EXPECT_EQ((*reference().skeleton())[test::forkTop].position,
            test::fork(3)[test::forkTop].position);
}

TEST_F(VersionsWindowTest, GoIntoAProjectThatIsSavedElsewhereButNotIntoAnotherPlant) {
  open({writeFork("fork.mtg")});
  saveProject("fork.espalier");
  name("first");
  const QString other = saveProject("other.espalier");
  EXPECT_EQ(Project::open(toPath(other), Access::readOnly).versions().value.size(), 1U);
  document().undoStack().setClean();
  open({path("fork.mtg")});
  const QString next = saveProject("next.espalier");
  EXPECT_TRUE(Project::open(toPath(next), Access::readOnly).versions().value.empty());
}

TEST_F(VersionsWindowTest, AreRemovedByTheMenuAndKeptAgain) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("fork.espalier");
  name("first");
  auto& menu = find<QMenu>("remove_version");
  emit menu.aboutToShow();
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_TRUE(menu.actions().front()->text().startsWith("first · "));
  menu.actions().front()->trigger();
  const auto versions = [&] {
    return Project::open(toPath(file), Access::readOnly).versions().value.size();
  };
  EXPECT_EQ(versions(), 0U);
  clickButton("banner_action");
  EXPECT_EQ(versions(), 1U);
}

TEST_F(VersionsWindowTest, AreListedForRemovalWithTheNewestFirst) {
  open({writeFork("fork.mtg")});
  saveProject("fork.espalier");
  name("stem & crown");
  QTest::qWait(2); // [ms], which is how exactly they know their time
  name("last");
  auto& menu = find<QMenu>("remove_version");
  const auto texts = [&] {
    emit menu.aboutToShow();
    QStringList names;
    for (const QAction* each : menu.actions())
      names.append(each->text().section(" · ", 0, 0));
    return names;
  };
  EXPECT_EQ(texts(), QStringList({"last", "stem && crown"}));
  menu.actions().back()->trigger();
  clickButton("banner_action");
  EXPECT_EQ(texts(), QStringList({"last", "stem && crown"})) << "where it was";
}

TEST_F(VersionsWindowTest, RefusesANameThatIsThere) {
  open({writeFork("fork.mtg")});
  saveProject("fork.espalier");
  name("first");
  name("first");
  EXPECT_EQ(message(), "There is a version 'first' already: choose another name");
}

TEST_F(VersionsWindowTest, SaysThatThereIsNoOtherState) {
  open({writeFork("fork.mtg")});
  expectNoDialog([this] { action("compare_version").trigger(); });
  EXPECT_EQ(message(),
            "There is no other state of this plant yet: name this version before you go on");
}

TEST_F(VersionsWindowTest, ComeBackAsTheReferenceWithTheProject) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("fork.espalier");
  name("a/b");
  (void)compareWith("a/b");
  openAnew(file);
  EXPECT_EQ(reference().name(), "a/b");
  EXPECT_TRUE(reference().isVersion());
}

} // namespace
} // namespace espalier
