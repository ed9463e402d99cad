// The window on a screen of 1280 x 800, less what a desktop puts around it.
#include "tests/app/window/window_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <QTranslator>

namespace espalier {
namespace {

struct SmallScreenTest : test::WindowTest {
  void openPlant() {
    open({writeScan("plant.xyz")});
    action("reconstruct").trigger();
    waitForJob();
    resize();
  }
  void resize() {
    window().resize(1264, 752);
    QCoreApplication::processEvents();
  }
  QList<QDockWidget*> docks() {
    return window().findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
  }
  QList<QDockWidget*> showAll() {
    for (QDockWidget* dock : docks())
      action("show_" + dock->objectName()).setChecked(true);
    waitForJob();
    settle();
    return docks();
  }
  static void settle() {
    for (int i = 0; i < 10; ++i) // layouts follow their contents in events
      QCoreApplication::processEvents();
  }
  static QString textOf(const QRect& rect) {
    return QString("%1x%2 at %3, %4")
        .arg(rect.width())
        .arg(rect.height())
        .arg(rect.x())
        .arg(rect.y());
  }
  static bool isToBeUsed(const QWidget& widget) {
    return widget.isVisible() && (qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
                                  qobject_cast<const QComboBox*>(&widget) != nullptr ||
                                  qobject_cast<const QLineEdit*>(&widget) != nullptr);
  }
  /// All of it: of a field, ensureWidgetVisible() sees to the text cursor alone.
  static void scrollTo(const QWidget& widget, QScrollArea& area) {
    const QPoint middle = widget.mapTo(area.widget(), widget.rect().center());
    area.ensureVisible(middle.x(), middle.y(), widget.width() / 2 + 1, widget.height() / 2 + 1);
  }
  /// Of a dock, what cannot be seen whole, scroll as one may.
  static QStringList cutOff(QDockWidget& dock) {
    dock.raise();
    settle();
    QStringList found;
    for (QWidget* widget : dock.findChildren<QWidget*>()) {
      if (!isToBeUsed(*widget) || widget->parentWidget() == &dock) continue;
      const auto isWhole = [&] { // once what is found in the background is shown
        for (QWidget* around = widget->parentWidget(); around != &dock;
             around = around->parentWidget())
          if (auto* area = qobject_cast<QScrollArea*>(around)) scrollTo(*widget, *area);
        settle();
        return widget->visibleRegion().boundingRect() == widget->rect();
      };
      if (!QTest::qWaitFor(isWhole, 5'000))
        found.append(
            QString("%1: %2 %3, seen %4 of %5")
                .arg(dock.objectName(), widget->objectName(), widget->metaObject()->className(),
                     textOf(widget->visibleRegion().boundingRect()), textOf(widget->geometry())));
    }
    return found;
  }
};

TEST_F(SmallScreenTest, HasRoomForEachPanelByItself) {
  openPlant();
  for (QDockWidget* dock : docks()) {
    QAction& show = action("show_" + dock->objectName());
    const bool wasShown = show.isChecked();
    show.setChecked(true);
    waitForJob();
    EXPECT_EQ(cutOff(*dock).join(", ").toStdString(), "");
    if (!wasShown) show.setChecked(false);
  }
}

TEST_F(SmallScreenTest, HasRoomForAllPanelsTogether) {
  openPlant();
  for (QDockWidget* dock : showAll())
    EXPECT_EQ(cutOff(*dock).join(", ").toStdString(), "");
}

TEST_F(SmallScreenTest, CutsNoNameOfAPanelThatIsATab) {
  openPlant();
  static_cast<void>(showAll());
  int seen = 0;
  for (const QTabBar* bar :
       window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!bar->isVisible()) continue;
    EXPECT_EQ(bar->elideMode(), Qt::ElideNone);
    EXPECT_TRUE(bar->usesScrollButtons());
    for (int i = 0; i < bar->count(); ++i, ++seen)
      EXPECT_GE(bar->tabRect(i).width(), bar->fontMetrics().horizontalAdvance(bar->tabText(i)))
          << bar->tabText(i).toStdString();
  }
  EXPECT_GT(seen, 10);
}

TEST_F(SmallScreenTest, HasRoomForTheEvaluationInFrench) {
  QTranslator french;
  ASSERT_TRUE(french.load("espalier_fr", ":/translations"));
  QApplication::installTranslator(&french);
  restart();
  resize();
  const QString file = writeFork("fork.mtg");
  open({file});
  answer(chooseFile(file), [this] { action("load_reference").trigger(); });
  waitForJob();
  settle();
  auto& dock = find<QDockWidget>("evaluation");
  EXPECT_EQ(cutOff(dock).join(", "), QString());
  const auto* area = qobject_cast<QScrollArea*>(dock.widget());
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0);
  QApplication::removeTranslator(&french);
}

TEST_F(SmallScreenTest, HasRoomForTheSheetOfKeys) {
  for (const QSize size : {QSize(1264, 752), QSize(960, 600)}) {
    window().resize(size);
    action("shortcuts").trigger();
    settle();
    auto& sheet = find<QWidget>("shortcut_sheet");
    EXPECT_LE(sheet.width(), size.width());
    EXPECT_LE(sheet.height(), size.height());
    EXPECT_EQ(sheet.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
    delete &sheet;
  }
}

} // namespace
} // namespace espalier
