#include "app/window/frame/panel_focus.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/panel_keys.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>
#include <ranges>
#include <tuple>

namespace espalier {
namespace {

bool hasRows(const QWidget& widget) {
  const auto* list = qobject_cast<const QAbstractItemView*>(&widget);
  return list != nullptr && list->model() != nullptr && list->model()->rowCount() > 0;
}

/// The list of a panel that has one, else the field that had the keyboard last, else the topmost.
/// Null: it has none now.
QWidget* firstField(const QDockWidget& dock) {
  QWidget* first = nullptr;
  const auto place = [&dock](const QWidget* field) {
    const QPoint at = field->mapTo(&dock, QPoint());
    return std::tuple(at.y(), at.x());
  };
  for (QWidget* field : dock.findChildren<QWidget*>()) {
    if (!takesKeys(*field)) continue;
    if (hasRows(*field)) return field;
    if (first == nullptr || place(field) < place(first)) first = field;
  }
  QWidget* const last = dock.focusWidget();
  return last != nullptr && takesKeys(*last) ? last : first;
}

} // namespace

PanelFocus::PanelFocus(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("View"));
  parts_.actions.add({.id = "go_to_panel",
                      .text = tr("Go to Panel"),
                      .help = tr("Gives the keyboard to the panel that was used last, once more to "
                                 "the next one; Esc gives it back to the plant"),
                      .keys = QKeySequence(Qt::SHIFT | Qt::Key_Escape),
                      .menu = "panels/layout"},
                     [this] { goOn(); });
  for (auto* dock : parts_.window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
    follow(*dock);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (QDockWidget* dock = dockOf(now)) noteUsed(*dock);
    const QDockWidget* before = in_;
    in_ = dockOf(now);
    if (in_ != before) emit hintChanged();
  });
}

void PanelFocus::follow(QDockWidget& dock) {
  used_.push_back(&dock);
  connect(&dock, &QDockWidget::visibilityChanged, this, [this, &dock](bool isShown) {
    if (isShown) return noteUsed(dock);
    const QWidget* at = QApplication::focusWidget();
    const bool isThere = parts_.window.isVisible() && !parts_.window.isMinimized();
    if (isThere && at != nullptr && dock.isAncestorOf(at)) parts_.toPlant();
  });
}

void PanelFocus::noteUsed(QDockWidget& dock) {
  const auto at = std::ranges::find(used_, &dock);
  if (at != used_.end()) std::rotate(at, at + 1, used_.end());
}

QString PanelFocus::furtherHint() const {
  if (in_ == nullptr) return {};
  // While a preview waits for an answer, Esc drops it first.
  if (parts_.hasPreview()) return withKeys(tr("{go_to_panel} next panel"), parts_.actions);
  return withKeys(tr("{leave} back to the plant   {go_to_panel} next panel"), parts_.actions);
}

std::vector<QDockWidget*> PanelFocus::docksInFront() const {
  std::vector<QDockWidget*> docks;
  for (QDockWidget* dock : used_)
    if (isInFront(*dock) && firstField(*dock) != nullptr) docks.push_back(dock);
  const auto place = [](const QDockWidget* dock) {
    const QPoint at = dock->mapToGlobal(QPoint());
    return std::tuple(at.x(), at.y());
  };
  std::ranges::sort(docks, {}, place);
  return docks;
}

void PanelFocus::goOn() {
  const std::vector<QDockWidget*> docks = docksInFront();
  if (docks.empty()) {
    emit noted(tr("No panel is shown that takes keys: View > Panels shows one"));
    return;
  }
  const auto isListed = [&docks](const QDockWidget* dock) {
    return std::ranges::find(docks, dock) != docks.end();
  };
  QDockWidget* const here = dockOf(QApplication::focusWidget());
  QDockWidget* next = nullptr;
  if (isListed(here)) {
    const auto after = std::ranges::find(docks, here) + 1;
    next = after == docks.end() ? docks.front() : *after;
  } else
    next = *std::ranges::find_if(std::views::reverse(used_), isListed);
  QWidget* const field = firstField(*next);
  next->activateWindow(); // it may float
  field->setFocus(Qt::TabFocusReason);
  bringIntoSight(*field);
}

} // namespace espalier
