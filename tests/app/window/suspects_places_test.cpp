// In the list of what may be wrong nothing moves under the pointer.
#include "tests/app/window/suspects_fixture.h"

#include <QApplication>
#include <QScrollBar>
#include <QStyleHints>
#include <QTreeView>

namespace espalier {
namespace {

using test::SuspectsTest;

// A question comes up at once: the second click must not land on one of its answers.
TEST_F(SuspectsTest, ADoubleClickOnADoubtAnswersNothing) {
  auto& list = find<QTreeView>("findings_list");
  const auto clickOn = [&](const QPoint& place) { // wherever that is by then
    QWidget* under = panel().childAt(panel().mapFromGlobal(place));
    if (under == nullptr) under = &panel();
    QTest::mouseClick(under, Qt::LeftButton, {}, under->mapFromGlobal(place));
  };
  const int steps = document().undoStack().index();
  const std::size_t all = doubts().size();
  int clicked = 0;
  for (std::size_t row = 0; row < rows().size(); ++row) {
    const QRect box = list.visualRect(list.model()->index(static_cast<int>(row), 0));
    if (!rows()[row].isDoubt() || !list.viewport()->rect().contains(box)) continue;
    const QPoint place = list.viewport()->mapToGlobal(box.center());
    clickOn(place);
    ASSERT_TRUE(isAsked());
    QApplication::processEvents(); // the question takes its place
    clickOn(place);
    EXPECT_EQ(document().undoStack().index(), steps);
    ++clicked;
    key(Qt::Key_Escape);
    QTest::qWait(QGuiApplication::styleHints()->mouseDoubleClickInterval());
  }
  EXPECT_GE(clicked, 2);
  EXPECT_EQ(doubts().size(), all);
}

// However quickly one goes through them, and a question is among them.
TEST_F(SuspectsTest, ClicksOnTheArrowGoOnAndAnswerNothing) {
  auto& button = find<QWidget>("findings_next");
  const QPoint next = button.mapToGlobal(button.rect().center());
  const int steps = document().undoStack().index();
  bool wasAsked = false;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    QWidget* under = window().childAt(window().mapFromGlobal(next));
    ASSERT_NE(under, nullptr);
    QTest::mouseClick(under, Qt::LeftButton, {}, under->mapFromGlobal(next));
    QApplication::processEvents();
    EXPECT_EQ(panel().current(), i);
    wasAsked = wasAsked || isAsked();
  }
  EXPECT_TRUE(wasAsked);
  EXPECT_EQ(document().undoStack().index(), steps);
}

// The expected agreement and what is being looked for are known later.
TEST_F(SuspectsTest, WhatIsKnownLaterMovesNothingUnderThePointer) {
  const QString text = QString("Known a little later. ").repeated(9);
  const auto places = [&] {
    QApplication::processEvents();
    std::vector<QRect> all;
    for (const char* name : {"findings_kind", "findings_place", "findings_next", "findings_ignore"})
      all.emplace_back(find<QWidget>(name).mapTo(&window(), QPoint()), find<QWidget>(name).size());
    auto& list = find<QTreeView>("findings_list");
    all.emplace_back(list.viewport()->mapTo(&window(), QPoint()),
                     QSize(0, list.visualRect(list.model()->index(0, 0)).height()));
    return all;
  };
  panel().showAgreement({}, true);
  panel().showNote({});
  const auto before = places();
  panel().showAgreement(text, true);
  EXPECT_EQ(places(), before);
  panel().showNote(text);
  EXPECT_EQ(places(), before);
  go(first(true)); // a question comes up
  EXPECT_EQ(places(), before);
}

TEST_F(SuspectsTest, TheListStaysInPlaceWhereNothingIsOfItsKind) {
  choose(kinds(), "Thick on thin");
  const auto& list = find<QTreeView>("findings_list");
  const auto listUnderFields = [&] {
    QApplication::processEvents();
    return list.mapTo(&panel(), QPoint()).y() - kinds().mapTo(&panel(), QPoint()).y();
  };
  const int before = listUnderFields();
  document().undoStack().undo(); // nothing is thick on thin now
  ASSERT_TRUE(QTest::qWaitFor([&] { return rows().empty(); }, patience));
  EXPECT_TRUE(list.isVisible());
  EXPECT_EQ(listUnderFields(), before);
}

TEST_F(SuspectsTest, AnotherKindIsShownFromItsFirstRow) {
  auto& list = find<QTreeView>("findings_list");
  list.scrollToBottom();
  ASSERT_GT(list.verticalScrollBar()->value(), 0);
  choose(places(), "Whole plant");
  EXPECT_EQ(list.verticalScrollBar()->value(), 0);
}

} // namespace
} // namespace espalier
