#pragma once

#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"

#include <QLabel>
#include <QTest>

#include <algorithm>

namespace espalier::test {

/// The fork, whose stretches are the trunk (root and top) and each of the three shoots.
struct ReviewWindowTest : WindowTest {
  void openFork() { open({writeFork("fork.mtg")}); }

  /// As a reviewer presses it: Enter once the view has come to what it marks.
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    if (key == Qt::Key_Return && modifiers == Qt::NoModifier) waitForView();
    WindowTest::key(key, modifiers);
  }

  NodeId shoot() { return nodeAt({1, 0, 2}); }
  const ReviewMark& markOf(NodeId id) { return document().skeleton()[id].review; }
  std::vector<NodeId> chosen() { return document().selection().nodes(); }
  bool isDrawn(NodeId id) {
    return std::ranges::count(view().nodesInside(QRectF(view().rect()), Depth::through), id) > 0;
  }
  [[nodiscard]] bool waitForStop() {
    return QTest::qWaitFor([&] { return label("review_place").contains(" left"); }, patience);
  }
  QString label(const QString& name) { return find<QLabel>(name).text(); }
  [[nodiscard]] bool waitForLabel(const QString& name, const QString& text) {
    return QTest::qWaitFor([&] { return label(name) == text; }, patience);
  }
};

} // namespace espalier::test
