#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

class QDockWidget;
class QMainWindow;

namespace espalier {

/// The panel that a widget is in; null: none.
[[nodiscard]] QDockWidget* dockOf(QWidget* widget);
/// Whether one sees it: it is shown, and does not lie behind another's tab.
[[nodiscard]] bool isInFront(const QDockWidget& dock);
/// Whether Tab leads to it in what is seen. What scrolls takes the keyboard, too, but one does not
/// see it, and fields come into sight by themselves.
[[nodiscard]] bool takesKeys(const QWidget& widget);

/// Gives the keyboard to the next of the window that takes keys, or the one before, in the order in
/// which one reads them: panel by panel from left to right, past those that lie behind a tab. What
/// scrolls is one of them where it has no fields.
/// @return false: there is none
bool giveKeysOn(QWidget& window, bool isNext);

/// Keys of what has the keyboard, in a window in which most keys are commands: Enter presses the
/// button that one came to by keys, and Undo passes by a field in which nothing was typed. After a
/// click on a button Enter goes on meaning what it does in the view.
class PanelKeys : public QObject {
public:
  explicit PanelKeys(QMainWindow* window);

private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  [[nodiscard]] bool pressesByEnter(QWidget* widget) const;

  QMainWindow& window_;
  QPointer<QWidget> clicked_; // that has the keyboard by a click
};

} // namespace espalier
