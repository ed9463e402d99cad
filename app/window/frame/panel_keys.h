#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

#include <functional>

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

/// Scrolls all that it lies in so that one sees it.
void bringIntoSight(QWidget& field);

/// Gives the keyboard to the next of the window that takes keys, or the one before, in the order in
/// which one reads them: panel by panel from left to right, past those that lie behind a tab. What
/// scrolls is one of them where it has no fields.
/// @return false: there is none
bool giveKeysOn(QWidget& window, bool isNext);

/// Keys of what has the keyboard, in a window in which most keys are commands: Enter presses the
/// button that one came to by keys, letters choose in a list of choices that one came to so, and
/// Undo passes by a field in which nothing was typed. After a click they go on meaning what they do
/// in the view. While a preview waits for an answer, Enter in a list or on choices accepts it.
class PanelKeys : public QObject {
public:
  /// @param hasPreview  whether one waits for an answer
  PanelKeys(QMainWindow* window, std::function<bool()> hasPreview);

private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  [[nodiscard]] bool isIn(QWidget* widget) const;
  [[nodiscard]] bool acceptsByEnter(QWidget* widget) const;

  QMainWindow& window_;
  std::function<bool()> hasPreview_;
  QPointer<QWidget> clicked_; // that has the keyboard by a click
};

} // namespace espalier
