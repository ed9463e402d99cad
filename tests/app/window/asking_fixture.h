#pragma once

#include "app/window/review/doubts_flow.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/app/window/window_fixture.h"
#include "ui/document/plant_document.h"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QToolButton>

namespace espalier::test {

/// The sample is reconstructed, and the program can ask about it.
class AskingTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().resize(1280, 800);
    openReconstructedSample();
  }

  void ask() {
    view().setFocus();
    key(Qt::Key_F2);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  }

  bool isAsked() { return action("answer_1").isEnabled(); }
  QString question() { return find<QLabel>("doubts_question").text(); }
  int doubts() { // once what follows an edit is done
    QTest::qWait(30);
    return static_cast<int>(found().doubts().size());
  }
  /// Points are left that have no wood.
  void removeBranches() {
    const Skeleton plant = document().skeleton();
    document().edit("Remove", [&](SkeletonEditor& editor) {
      int left = 5;
      for (const NodeId id : plant.ids()) {
        const std::size_t carried = downstream(plant, {id}).size();
        const bool isBranch = plant[id].edge == EdgeType::branching && carried > 5 && carried < 40;
        if (isBranch && editor.skeleton().contains(id) && left-- > 0) removeSubtree(editor, id);
      }
    });
  }
  [[nodiscard]] const DoubtsFlow& found() { return window().part<DoubtsFlow>(); }
  std::string answers() { return found().kept().front().text(); } // as a project keeps them
  /// Skips until a doubt of this kind is asked about, or of another.
  void skipTo(Doubt::Kind kind, bool isOfIt = true) {
    const bool isMissing = kind == Doubt::Kind::missing;
    for (int i = 0; i < 500; ++i) {
      const bool isAboutMissing = question().startsWith("Is there a branch");
      if ((isMissing
               ? isAboutMissing
               : question().startsWith(kind == Doubt::Kind::end ? "Is this" : "What")) == isOfIt)
        return;
      key(Qt::Key_Space);
    }
    FAIL() << "there is no such doubt";
  }
  QString firstAnswer() { return find<QToolButton>("answer_1_button").text(); }

  /// Answers "no wood" a few times: the odds of the wood that is left fall.
  void answerNoWood() {
    for (int i = 0; i < 8; ++i) {
      skipTo(Doubt::Kind::end);
      for (int k = 0; k < 4; ++k)
        if (find<QToolButton>(QString("answer_%1_button").arg(k + 1)).text().contains("no wood"))
          keyOnceDrawn(Qt::Key_1 + k);
      ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked() && !found().isBusy(); }, patience));
    }
  }

  std::size_t reviewed() {
    const Skeleton& plant = document().skeleton();
    std::size_t count = 0;
    for (const NodeId id : plant.ids())
      count += plant[id].review.state == ReviewState::reviewed;
    return count;
  }
};

} // namespace espalier::test
