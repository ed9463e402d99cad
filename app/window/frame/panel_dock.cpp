#include "app/window/frame/panel_dock.h"

#include "app/window/frame/action_set.h"
#include "ui/document/manual_place.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr auto sideName = "side_of_panel";

/// A panel that scrolls where its dock is too small for it, instead of reaching beyond: below the
/// plant sideways, beside it up and down.
class PanelArea : public QScrollArea {
public:
  PanelArea(QWidget* panel, bool isBelow) : isBelow_(isBelow) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    if (!isBelow) setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(panel);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return isBelow_ || widget() == nullptr ? QScrollArea::sizeHint() : widget()->sizeHint();
  }
  [[nodiscard]] QSize minimumSizeHint() const override {
    const QSize least = QScrollArea::minimumSizeHint();
    if (widget() == nullptr) return least; // while the window closes
    const QSize panel = widget()->minimumSizeHint();
    if (isBelow_) return {least.width(), panel.height()};
    // A scroll bar lies on the right margin of the panel: it widens no dock.
    return {panel.width(), std::min(least.height(), panel.height())};
  }

protected:
  void resizeEvent(QResizeEvent* event) override {
    boundPanel();
    QScrollArea::resizeEvent(event);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
      boundPanel();
      updateGeometry();
    }
    return QScrollArea::eventFilter(watched, event);
  }

private:
  /// One with text that wraps would else be as high as it likes to be.
  void boundPanel() {
    if (widget() == nullptr) return;
    int least = widget()->minimumSizeHint().height();
    if (const QLayout* layout = widget()->layout();
        layout != nullptr && layout->hasHeightForWidth())
      least = std::max(least, layout->totalMinimumHeightForWidth(viewport()->width()));
    widget()->setMaximumHeight(std::max(viewport()->height(), least));
  }

  bool isBelow_;
};

} // namespace

PanelDock::PanelDock(const Parts& parts, const Name& name, const Place& place, QWidget* panel,
                     QObject* parent)
    : QObject(parent), parts_(parts), place_(place), action_("show_" + name.id),
      dock_(new QDockWidget(name.title, &parts.window)) {
  QAction* show = parts_.actions.add({.id = action_,
                                      .text = name.text,
                                      .help = name.help,
                                      .keys = name.keys,
                                      .isCheckable = true,
                                      .menu = name.menu},
                                     {});
  show->setChecked(parts_.settings.value("panels/" + action_, place_.isShown).toBool());
  connect(show, &QAction::toggled, this, [this](bool isShown) {
    if (!isShown && isBehind()) return bringToFront();
    parts_.settings.setValue("panels/" + action_, isShown);
    refresh();
  });
  dock_->setObjectName(name.id);
  setManualPlace(*dock_, name.manual);
  if (place_.isTab) dock_->setProperty(sideName, place_.side);
  const bool isBelow = place_.side == Qt::BottomDockWidgetArea;
  const bool scrolls = qobject_cast<QAbstractScrollArea*>(panel) != nullptr; // by itself
  dock_->setWidget(scrolls ? panel : new PanelArea(panel, isBelow));
  dock_->installEventFilter(this);
  this->place();
  dock_->hide();
}

void PanelDock::setPlantShown(bool isShown) {
  isPlantShown_ = isShown;
  refresh();
}

void PanelDock::bringToFront() {
  parts_.actions[action_]->setChecked(true);
  dock_->raise();
}

void PanelDock::growBy(int pixels) {
  if (pixels <= 0 || dock_->isFloating()) return;
  int tabs = 0; // which count as height of the dock here, and not there
  if (!parts_.window.tabifiedDockWidgets(dock_).isEmpty())
    for (const auto* bar :
         parts_.window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
      tabs = std::max(tabs, bar->height());
  const int most = std::max(dock_->height(), parts_.window.height() / 2);
  const int wanted = std::min(dock_->height() + pixels, most);
  parts_.window.resizeDocks({dock_}, {wanted + tabs}, Qt::Vertical);
}

void PanelDock::resetLayout() {
  dock_->hide();
  dock_->setFloating(false);
  place();
  parts_.actions[action_]->setChecked(place_.isShown);
  refresh();
  if (isShown()) takeSize();
}

bool PanelDock::isShown() const {
  return !dock_->isHidden();
}

bool PanelDock::isInFront() const {
  return isShown() && !dock_->visibleRegion().isEmpty();
}

bool PanelDock::isBehind() const {
  return isShown() && !parts_.window.tabifiedDockWidgets(dock_).isEmpty() && !isInFront();
}

bool PanelDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == dock_ && event->type() == QEvent::Close)
    parts_.actions[action_]->setChecked(false);
  return QObject::eventFilter(watched, event);
}

void PanelDock::place() {
  parts_.window.addDockWidget(place_.side, dock_);
  if (!place_.isTab) return;
  for (auto* other : parts_.window.findChildren<QDockWidget*>())
    if (other != dock_ && other->property(sideName) == dock_->property(sideName) &&
        !other->isFloating())
      return parts_.window.tabifyDockWidget(other, dock_);
}

void PanelDock::takeSize() {
  if (!place_.isTab) return;
  const bool isBelow = place_.side == Qt::BottomDockWidgetArea;
  parts_.window.resizeDocks({dock_}, {place_.size}, isBelow ? Qt::Vertical : Qt::Horizontal);
}

bool PanelDock::isAlone() const {
  return std::ranges::all_of(parts_.window.tabifiedDockWidgets(dock_), &QDockWidget::isHidden);
}

void PanelDock::refresh() {
  const bool isShown = (isPlantShown_ || !place_.isOfPlant) && parts_.actions[action_]->isChecked();
  const bool isNew = isShown && dock_->isHidden();
  dock_->setVisible(isShown);
  if (isNew) {
    const bool isSizeChosen = parts_.settings.contains("window/state");
    if (!isSizeChosen && isAlone()) takeSize();
    dock_->raise();
  }
  if (std::exchange(wasShown_, isShown) != isShown) emit shown(isShown);
}

} // namespace espalier
