#include "app/window/frame/panel_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace espalier {
namespace {

bool isPlainEnter(const QKeyEvent& press) {
  return (press.key() == Qt::Key_Return || press.key() == Qt::Key_Enter) &&
         !(press.modifiers() & ~Qt::KeypadModifier);
}

bool isTyped(const QKeyEvent& press) {
  constexpr auto ofActions = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  return !press.text().isEmpty() && press.text()[0].isPrint() && !(press.modifiers() & ofActions);
}

void pressNow(QAbstractButton& button) {
  auto* tool = qobject_cast<QToolButton*>(&button);
  const bool hasMenu = tool != nullptr && tool->menu() != nullptr;
  if (hasMenu && tool->popupMode() == QToolButton::InstantPopup) return tool->showMenu();
  button.click();
}

std::vector<QWidget*> shownIn(const QWidget& in) {
  std::vector<QWidget*> shown;
  for (QWidget* child : in.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (child->isVisible() && !child->isWindow()) shown.push_back(child);
  return shown;
}

/// Row by row, each from left to right.
void sortAsRead(std::vector<QWidget*>& widgets) {
  std::ranges::stable_sort(widgets, {}, &QWidget::y);
  for (auto row = widgets.begin(); row != widgets.end();) {
    const int bottom = (*row)->geometry().bottom();
    const auto end = std::find_if(row + 1, widgets.end(), [bottom](const QWidget* widget) {
      return widget->geometry().center().y() > bottom;
    });
    std::stable_sort(
        row, end, [](const QWidget* one, const QWidget* other) { return one->x() < other->x(); });
    row = end;
  }
}

/// One of several widgets, of which it passes the keyboard on to one.
bool isWhole(const QWidget& widget) {
  return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr ||
         qobject_cast<const QAbstractItemView*>(&widget) != nullptr ||
         qobject_cast<const QLineEdit*>(&widget) != nullptr;
}

/// A widget, if Tab leads to it, and those in it, in the order in which one reads them.
void addField(QWidget& widget, std::vector<QWidget*>& fields) {
  const auto* dock = qobject_cast<const QDockWidget*>(&widget);
  if (dock != nullptr && !isInFront(*dock)) return;
  if (takesKeys(widget) && widget.focusProxy() == nullptr) fields.push_back(&widget);
  if (isWhole(widget)) return;
  std::vector<QWidget*> within = shownIn(widget);
  sortAsRead(within);
  const std::size_t before = fields.size();
  for (QWidget* child : within)
    addField(*child, fields);
  const auto* scrolled = qobject_cast<const QScrollArea*>(&widget);
  const bool hasFields = fields.size() > before; // else keys scroll it
  if (scrolled != nullptr && !hasFields && (widget.focusPolicy() & Qt::TabFocus) != 0 &&
      scrolled->verticalScrollBar()->isVisible())
    fields.push_back(&widget);
}

/// The text of a field that has the keyboard; null: it is no such field.
const QLineEdit* textOf(const QObject* field) {
  if (qobject_cast<const QAbstractSpinBox*>(field) != nullptr)
    return field->findChild<const QLineEdit*>();
  return qobject_cast<const QLineEdit*>(field);
}

bool isOfHistory(const QKeyEvent& press) {
  return press.matches(QKeySequence::Undo) || press.matches(QKeySequence::Redo);
}

/// Nothing was typed here that the key would take back or make again.
bool passesBy(const QLineEdit& text, const QKeyEvent& press) {
  return press.matches(QKeySequence::Undo) ? !text.isUndoAvailable() : !text.isRedoAvailable();
}

} // namespace

QDockWidget* dockOf(QWidget* widget) {
  while (widget != nullptr && qobject_cast<QDockWidget*>(widget) == nullptr)
    widget = widget->parentWidget();
  return qobject_cast<QDockWidget*>(widget);
}

bool isInFront(const QDockWidget& dock) {
  return dock.isVisible() && !dock.visibleRegion().isEmpty();
}

bool takesKeys(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0 &&
         qobject_cast<const QScrollArea*>(&widget) == nullptr &&
         qobject_cast<const QDockWidget*>(&widget) == nullptr;
}

void bringIntoSight(QWidget& field) {
  for (QWidget* around = field.parentWidget(); around != nullptr; around = around->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(around)) area->ensureWidgetVisible(&field);
}

bool giveKeysOn(QWidget& window, bool isNext) {
  std::vector<QWidget*> panels = shownIn(window);
  std::ranges::stable_sort(panels, {}, [](const QWidget* one) {
    return std::pair(one->x(), one->y()); // one column after the other
  });
  std::vector<QWidget*> fields;
  for (QWidget* panel : panels)
    addField(*panel, fields);
  const auto here = std::ranges::find_if(fields, [](const QWidget* field) {
    return field->hasFocus() || field->isAncestorOf(QApplication::focusWidget());
  });
  if (fields.empty()) return false;
  const auto count = std::ssize(fields);
  const auto at = here - fields.begin(); // behind all of them, if it is none
  const auto next = isNext ? (at >= count - 1 ? 0 : at + 1) : (at + count - 1) % count;
  QWidget& field = *fields[static_cast<std::size_t>(next)];
  field.setFocus(isNext ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  bringIntoSight(field);
  return true;
}

PanelKeys::PanelKeys(QMainWindow* window, std::function<bool()> hasPreview)
    : QObject(window), window_(*window), hasPreview_(std::move(hasPreview)) {
  qApp->installEventFilter(this);
}

/// In the window, or a panel of it, and no dialog.
bool PanelKeys::isIn(QWidget* widget) const {
  const QWidget* in = widget;
  while (in != nullptr && in != &window_ && !qobject_cast<const QDialog*>(in))
    in = in->parentWidget(); // also of a panel that is a window of its own
  return in == &window_;
}

bool PanelKeys::acceptsByEnter(QWidget* widget) const {
  const bool isList = qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
                      qobject_cast<const QComboBox*>(widget) != nullptr;
  return isList && QApplication::activePopupWidget() == nullptr && isIn(widget) && hasPreview_();
}

bool PanelKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr) return false; // a window of the system
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason == Qt::PopupFocusReason || widget->window()->windowType() == Qt::Popup)
      return false; // choices that open and close leave the keyboard where it was
    if (reason == Qt::MouseFocusReason)
      clicked_ = widget;
    else if (widget != clicked_ || reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason)
      clicked_ = nullptr;
    return false;
  }
  const bool isOverride = event->type() == QEvent::ShortcutOverride;
  if (!isOverride && event->type() != QEvent::KeyPress) return false;
  const auto& press = *static_cast<QKeyEvent*>(event);
  if (isOverride && isOfHistory(press)) {
    const QLineEdit* text = textOf(watched);
    if (text == nullptr || !passesBy(*text, press)) return false;
    event->ignore(); // so that it is the command
    return true;
  }
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr) return false;
  if (isOverride && isPlainEnter(press) && acceptsByEnter(widget)) {
    event->ignore(); // so that it is the command
    return true;
  }
  if (widget == clicked_ || !isIn(widget)) return false;
  if (isOverride && isTyped(press) && qobject_cast<QComboBox*>(widget) != nullptr) {
    event->accept();
    return true;
  }
  if (!isPlainEnter(press)) return false;
  auto* button = qobject_cast<QAbstractButton*>(watched);
  if (button == nullptr && qobject_cast<QAbstractSlider*>(watched) == nullptr) return false;
  event->accept(); // an override: so that it comes as a press, before any action
  if (!isOverride && button != nullptr && !press.isAutoRepeat()) pressNow(*button);
  return true;
}

} // namespace espalier
