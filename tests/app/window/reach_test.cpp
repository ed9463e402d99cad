// Whether all of the window can be reached by the keyboard, is named to a screen reader, and has a
// menu of its own.
#include "tests/app/window/read_entry.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTest>
#include <QTimer>

#include <gmock/gmock.h>
#include <set>

namespace espalier {
namespace {

using testing::Contains;
using testing::Not;

struct ReachTest : test::WindowTest {
  void openWithAllPanels() {
    open({writeScan("scan.xyz"), writeFork("fork.mtg")});
    for (const char* id : {"show_pipeline", "show_inspector", "show_review", "show_findings",
                           "show_history", "show_node_table", "show_clipping", "hide_explained"})
      if (!action(id).isChecked()) action(id).trigger();
    document().selection().set({test::forkTop});
    QCoreApplication::processEvents();
  }
  /// What Tab stops at, wherever it is: also in tabs that lie behind others.
  QList<QWidget*> stops() {
    QList<QWidget*> found;
    for (auto* widget : window().findChildren<QWidget*>())
      if ((widget->focusPolicy() & Qt::TabFocus) && widget->isEnabled() && !widget->isHidden() &&
          widget->focusProxy() == nullptr && widget->window() == &window() &&
          !window().banner().isAncestorOf(widget)) // which has nothing to say
        found.append(widget);
    return found;
  }
  static std::string nameOf(const QWidget* widget) {
    std::string name = widget->metaObject()->className();
    for (const QWidget* each = widget; each != nullptr; each = each->parentWidget())
      if (!each->objectName().isEmpty()) return name + " in " + each->objectName().toStdString();
    return name;
  }
  /// The texts of the menu that a right click opens.
  QStringList menuAt(const QPoint& place) {
    QStringList texts;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (menu == nullptr) return;
      for (const QAction* entry : menu->actions())
        texts.append(test::asRead(entry));
      menu->close();
    });
    timer.start(0);
    click(place, Qt::NoModifier, Qt::RightButton);
    return texts;
  }
};

/// The entries of a menu that is about to be shown, and of those within, that have a letter that
/// another has, too, or none, where the menu is short enough that words have letters for all.
QStringList withoutOwnLetter(QMenu& menu) {
  emit menu.aboutToShow();
  QStringList found, none;
  std::set<QChar> letters;
  for (const QAction* entry : menu.actions()) {
    if (entry->isSeparator() || !entry->isVisible() || entry->inherits("QWidgetAction")) continue;
    const qsizetype mark = entry->text().indexOf('&');
    if (mark < 0)
      none.append(menu.title() + " / " + entry->text());
    else if (!letters.insert(entry->text()[mark + 1].toUpper()).second)
      found.append(menu.title() + " / " + entry->text());
    if (entry->menu() != nullptr) found.append(withoutOwnLetter(*entry->menu()));
  }
  const bool isLong = letters.size() > 20; // of 26, and some are in few words
  return isLong ? found : found + none;
}

TEST_F(ReachTest, EachEntryOfAMenuHasALetterOfItsOwn) {
  openWithAllPanels();
  QStringList found;
  for (const QAction* title : window().menuBar()->actions())
    found.append(withoutOwnLetter(*title->menu()));
  EXPECT_EQ(found.join("\n").toStdString(), "");
}

TEST_F(ReachTest, EverythingWithTheKeyboardHasAName) {
  openWithAllPanels();
  const QList<QWidget*> all = stops();
  EXPECT_GT(all.size(), 30);
  for (QWidget* widget : all) {
    const QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(accessible, nullptr) << nameOf(widget);
    EXPECT_FALSE(accessible->text(QAccessible::Name).isEmpty()) << nameOf(widget);
  }
}

TEST_F(ReachTest, TabGoesThroughAllThatIsSeen) {
  openWithAllPanels();
  std::set<const QWidget*> left;
  for (const QWidget* widget : stops()) {
    const bool onlyScrolls = qobject_cast<const QScrollArea*>(widget) != nullptr; // its fields
    if (!onlyScrolls && widget->isVisible() && !widget->visibleRegion().isEmpty())
      left.insert(widget);
  }
  const std::size_t count = left.size();
  EXPECT_GT(count, 10U);
  view().setFocus();
  for (std::size_t i = 0; i < 4 * count && !left.empty(); ++i) {
    left.erase(QApplication::focusWidget());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  for (const QWidget* widget : left)
    ADD_FAILURE() << nameOf(widget) << " is not reached";
}

TEST_F(ReachTest, TheMenuOfAPointHasItsPlaceOnTop) {
  open({writeScan("scan.xyz")});
  const Eigen::Vector3d point = document().scan()->onPoints({0.05, 0, 0.5});
  const QPoint place = view().project(point).value().toPoint();
  ASSERT_TRUE(view().pick(place).point);
  const QStringList texts = menuAt(place);
  EXPECT_TRUE(texts.value(0).startsWith("Point at ")) << texts.value(0).toStdString();
  EXPECT_TRUE(texts.value(0).endsWith(" m"));
  EXPECT_THAT(texts, Contains(QString("Turn Around This")));
  EXPECT_THAT(texts, Contains(test::asRead(&action("hide_explained"))));
}

TEST_F(ReachTest, TheMenuOfEmptySpaceSaysSo) {
  open({writeFork("fork.mtg")});
  const QPoint corner(5, view().height() / 2);
  QStringList texts = menuAt(corner);
  EXPECT_EQ(texts.value(0), "Empty space");
  EXPECT_THAT(texts, Contains(test::asRead(&action("frame_all"))));
  EXPECT_THAT(texts, Not(Contains(QString("Turn Around This")))) << "there is nothing there";
  EXPECT_THAT(texts, Not(Contains(QString("Remove Node"))));
  document().selection().set({test::forkTop});
  texts = menuAt(corner);
  EXPECT_EQ(texts.value(0), "Empty space");
  EXPECT_THAT(texts, Contains(QString("Node %1").arg(indexOf(test::forkTop)))) << "a menu within";
}

} // namespace
} // namespace espalier
