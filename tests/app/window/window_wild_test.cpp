// Events at random: whatever is pressed, clicked, dragged and typed, the window goes on, and undo
// and redo lead to the same plant. ESPALIER_EVENTS=100000 runs it for long,
// ESPALIER_SEED=7 with other events, ESPALIER_TRACE=FILE lists them as they come.
#include "app/window/frame/action_set.h"
#include "core/project/project.h"
#include "tests/app/window/window_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QUndoStack>
#include <QWheelEvent>

#include <array>
#include <fstream>
#include <random>

namespace espalier {
namespace {

class WildEventsTest : public test::WindowTest {
protected:
  WildEventsTest() {
    if (const char* trace = std::getenv("ESPALIER_TRACE"); trace != nullptr) trace_.open(trace);
    QDesktopServices::setUrlHandler("file", &receiver_, "none"); // opens no other program
    answerLater();
  }
  ~WildEventsTest() override { QDesktopServices::unsetUrlHandler("file"); }

  static int number(const char* variable, int otherwise) {
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::atoi(text);
  }

  /// In [0, count).
  int any(std::size_t count) {
    return std::uniform_int_distribution<int>(0, static_cast<int>(count) - 1)(random_);
  }
  bool once(int in) { return any(static_cast<std::size_t>(in)) == 0; }
  template <class List> auto& anyOf(List& list) {
    return list[static_cast<decltype(list.size())>(any(static_cast<std::size_t>(list.size())))];
  }

  void act();

private:
  void note(const QString& what) {
    if (trace_.is_open()) trace_ << what.toStdString() << std::endl;
  }
  static QString nameOf(const QWidget& widget) {
    return QString::fromLatin1(widget.metaObject()->className()) + ' ' + widget.objectName();
  }
  QPoint placeIn(const QWidget& widget) {
    return {any(static_cast<std::size_t>(std::max(widget.width(), 1))),
            any(static_cast<std::size_t>(std::max(widget.height(), 1)))};
  }
  Qt::KeyboardModifiers modifiers() {
    constexpr auto all = std::to_array<Qt::KeyboardModifiers>(
        {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
         Qt::ControlModifier, Qt::AltModifier, Qt::ControlModifier | Qt::ShiftModifier});
    return anyOf(all);
  }
  void press(QWidget& widget);
  void clickOn(QWidget& widget, const QPoint& place);
  void dragOn(QWidget& widget);
  void turnWheel(QWidget& widget);
  void trigger();
  void openFile();
  /// What runs an event loop of its own, a dialog or a menu, is answered from within it. An answer
  /// may open the next: each comes by a timer of its own.
  void answerLater() {
    QTimer::singleShot(15, &receiver_, [this] {
      answerLater();
      answerWhatIsOpen();
    });
  }
  void answerWhatIsOpen();
  void answerDialog(QDialog& dialog);
  QWidget& anyWidget();

  std::mt19937 random_{static_cast<unsigned>(number("ESPALIER_SEED", 1))};
  std::ofstream trace_;
  QObject receiver_;
  int tries_ = 0; // of one dialog
  QWidget* asked_ = nullptr;
};

void WildEventsTest::press(QWidget& widget) {
  constexpr auto others = std::to_array<int>(
      {Qt::Key_Return, Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Up, Qt::Key_Down,
       Qt::Key_Left, Qt::Key_Right, Qt::Key_Tab, Qt::Key_Space, Qt::Key_Home, Qt::Key_End,
       Qt::Key_F4, Qt::Key_F9, Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Period, Qt::Key_Comma});
  const int key = once(3) ? anyOf(others) : once(3) ? Qt::Key_0 + any(10) : Qt::Key_A + any(26);
  const Qt::KeyboardModifiers with = modifiers();
  const bool ends = with.testFlag(Qt::ControlModifier) && key == Qt::Key_Q;
  if (ends) return;
  note(QStringLiteral("key %1 with %2 on %3").arg(key).arg(int(with)).arg(nameOf(widget)));
  QTest::keyClick(&widget, static_cast<Qt::Key>(key), with);
}

void WildEventsTest::clickOn(QWidget& widget, const QPoint& place) {
  constexpr auto buttons =
      std::to_array<Qt::MouseButton>({Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                      Qt::LeftButton, Qt::RightButton, Qt::MiddleButton});
  const Qt::MouseButton button = anyOf(buttons);
  const Qt::KeyboardModifiers with = modifiers();
  note(QStringLiteral("click %1 at %2,%3 on %4")
           .arg(int(button))
           .arg(place.x())
           .arg(place.y())
           .arg(nameOf(widget)));
  if (once(8))
    QTest::mouseDClick(&widget, button, with, place);
  else
    QTest::mouseClick(&widget, button, with, place);
}

void WildEventsTest::dragOn(QWidget& widget) {
  constexpr auto buttons =
      std::to_array<Qt::MouseButton>({Qt::LeftButton, Qt::LeftButton, Qt::RightButton});
  const Qt::MouseButton button = anyOf(buttons);
  const Qt::KeyboardModifiers with = modifiers();
  QPoint place = placeIn(widget);
  note(QStringLiteral("drag %1 from %2,%3 on %4")
           .arg(int(button))
           .arg(place.x())
           .arg(place.y())
           .arg(nameOf(widget)));
  QTest::mousePress(&widget, button, with, place);
  for (int i = any(6); i >= 0; --i) {
    place += QPoint(any(81) - 40, any(81) - 40);
    QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, button,
                     with);
    QApplication::sendEvent(&widget, &move);
    if (once(5)) press(widget);
  }
  if (!once(12)) QTest::mouseRelease(&widget, button, with, place); // else it never comes
}

void WildEventsTest::turnWheel(QWidget& widget) {
  const QPoint place = placeIn(widget);
  note("wheel on " + nameOf(widget));
  QWheelEvent wheel(place, widget.mapToGlobal(place), {}, {0, once(2) ? 120 : -120}, Qt::NoButton,
                    modifiers(), Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &wheel);
}

void WildEventsTest::trigger() {
  QAction* action = anyOf(window().actionSet().all());
  if (!action->isEnabled() || action->objectName() == "quit") return;
  note("command " + action->objectName());
  action->trigger();
}

void WildEventsTest::openFile() {
  const auto names = std::to_array<QString>({"scan.xyz", "fork.mtg", "cut.mtg", "none.las"});
  const QString& name = anyOf(names);
  note("open " + name);
  window().open({path(name)});
}

QWidget& WildEventsTest::anyWidget() {
  if (once(2)) return view();
  QList<QWidget*> seen;
  for (QWidget* widget : window().findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled() && widget->window() == &window())
      seen.append(widget);
  return seen.isEmpty() ? view() : *anyOf(seen);
}

void WildEventsTest::answerDialog(QDialog& dialog) {
  const bool isOver = ++tries_ > 20;
  if (auto* files = qobject_cast<QFileDialog*>(&dialog)) { // no keys: they could remove files
    note("file dialog");
    if (isOver || once(2)) return files->reject();
    files->setDirectory(path(""));
    files->selectFile(path(QStringLiteral("written_%1").arg(any(5))));
    QMetaObject::invokeMethod(files, "accept");
    return;
  }
  if (isOver) return dialog.reject();
  QList<QWidget*> seen;
  for (QWidget* widget : dialog.findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled()) seen.append(widget);
  if (seen.isEmpty() || once(12)) return dialog.reject();
  QWidget& widget = *anyOf(seen);
  if (once(2))
    clickOn(widget, widget.rect().center());
  else
    press(widget);
}

void WildEventsTest::answerWhatIsOpen() {
  if (QWidget* menu = QApplication::activePopupWidget()) {
    note("popup " + nameOf(*menu));
    if (once(3) || ++tries_ > 20)
      menu->close();
    else
      QTest::keyClick(menu, once(2) ? Qt::Key_Down : once(2) ? Qt::Key_Right : Qt::Key_Return);
    return;
  }
  auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
  if (dialog != asked_) tries_ = 0;
  asked_ = dialog;
  if (dialog != nullptr) answerDialog(*dialog);
}

void WildEventsTest::act() {
  if (QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr)
    return answerWhatIsOpen();
  QWidget& widget = anyWidget();
  const int what = any(100);
  if (what < 35)
    press(widget);
  else if (what < 60)
    clickOn(widget, placeIn(widget));
  else if (what < 72)
    dragOn(widget);
  else if (what < 80)
    turnWheel(widget);
  else if (what < 98)
    trigger();
  else if (what < 99)
    openFile();
  else
    QTest::qWait(any(200));
  for (QWidget* other : QApplication::topLevelWidgets()) // dialogs that block nothing pile up
    if (other != &window() && other->isVisible() && qobject_cast<QDialog*>(other) && once(10))
      other->close();
}

TEST_F(WildEventsTest, NeverEndTheWindowNorBreakItsHistory) {
  writeScan("scan.xyz");
  writeFork("fork.mtg");
  QFile cut(path("cut.mtg"));
  ASSERT_TRUE(cut.open(QIODevice::WriteOnly));
  cut.write("CODE:\tFORM-A\nCLASSES:\nSYMBOL\tSCALE\n");
  cut.close();
  open({path("scan.xyz"), path("fork.mtg")});
  const int events = number("ESPALIER_EVENTS", 400);
  for (int i = 0; i < events; ++i) {
    act();
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    if (!window().isVisible()) window().show();
    if (i % 1000 == 999) std::cerr << i + 1 << " events" << std::endl;
  }
  window().jobs().cancel();
  waitForJob();
  for (int i = 0;
       i < 50 && (QApplication::activeModalWidget() || QApplication::activePopupWidget()); ++i)
    QTest::qWait(20);
  QUndoStack& steps = document().undoStack();
  const Skeleton plant = document().skeleton();
  const int at = steps.index();
  steps.setIndex(0);
  steps.setIndex(steps.count());
  steps.setIndex(at);
  EXPECT_EQ(document().skeleton(), plant) << "undo and redo make another plant";
}

} // namespace
} // namespace espalier
