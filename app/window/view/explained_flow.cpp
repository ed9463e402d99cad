#include "app/window/view/explained_flow.h"

#include "app/window/edit/point_states.h"
#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/explained_bar.h"

#include <QAction>
#include <QGridLayout>
#include <QMainWindow>
#include <QSettings>

namespace espalier {

ExplainedFlow::ExplainedFlow(const Parts& parts) : parts_(parts) {
  QAction* action = parts_.actions.add(
      {.id = "hide_explained",
       .text = tr("Hide Explained Points"),
       .help = tr("Dims or hides the points near the skeleton: what is missing stands out"),
       .keys = QKeySequence(Qt::CTRL | Qt::Key_5),
       .isCheckable = true,
       .menu = "view/points"},
      {});
  connect(action, &QAction::toggled, this, &ExplainedFlow::turn);
  makeBar();
  timer_.setSingleShot(true);
  timer_.setInterval(15); // [ms]: many edits and moves of the slider are shown at once
  connect(&timer_, &QTimer::timeout, this, &ExplainedFlow::showStates);
  connect(&parts_.distances, &ScanDistances::changed, &timer_, qOverload<>(&QTimer::start));
  connect(&parts_.document, &PlantDocument::scanChanged, this, [this] { takeLimits(); });
  connect(&parts_.document, &PlantDocument::unitChanged, this, &ExplainedFlow::takeLimits);
}

void ExplainedFlow::setPlantShown(bool isShown) {
  isPlantShown_ = isShown;
  bar_->setVisible(isShown && parts_.actions["hide_explained"]->isChecked());
}

void ExplainedFlow::makeBar() {
  auto* layers = static_cast<QGridLayout*>(parts_.window.centralWidget()->layout());
  bar_ = new ExplainedBar(parts_.window.centralWidget());
  bar_->setHiding(parts_.settings.value("view/explained_hidden", false).toBool());
  bar_->hide();
  layers->addWidget(bar_, 1, 0);
  connect(bar_, &ExplainedBar::changed, this, [this] {
    parts_.settings.setValue("view/explained_hidden", bar_->isHiding());
    timer_.start();
  });
  connect(bar_, &ExplainedBar::sensitivityChosen, this, parts_.setSensitivity);
  connect(bar_, &ExplainedBar::closeRequested, this,
          [this] { parts_.actions["hide_explained"]->setChecked(false); });
}

void ExplainedFlow::turn(bool isOn) {
  parts_.distances.setWanted(ScanDistances::Use::explained, isOn);
  bar_->setVisible(isOn && isPlantShown_);
  bar_->raise();
  takeLimits();
  showStates();
}

void ExplainedFlow::takeLimits() {
  bar_->setLimits(parts_.usualReach(), parts_.sensitivity(), symbol(parts_.document.unit()));
  timer_.start();
}

void ExplainedFlow::showStates() {
  timer_.stop();
  const std::shared_ptr<const PointDistances> distances = parts_.distances.now();
  if (!distances || !parts_.actions["hide_explained"]->isChecked()) {
    parts_.states.setExplained(nullptr);
    bar_->showLeft(parts_.document.scan() == nullptr      ? tr("no scan")
                   : parts_.document.skeleton().isEmpty() ? tr("no skeleton")
                                                          : tr("measuring…"));
    return;
  }
  bar_->setLimits(parts_.usualReach(), parts_.sensitivity(), symbol(parts_.document.unit()));
  const PointState explained = bar_->isHiding() ? PointState::hidden : PointState::dim;
  const auto reach = static_cast<float>(bar_->distance());
  auto states = std::make_shared<std::vector<PointState>>();
  const std::vector<float> toSurface = parts_.distances.toSurface();
  states->reserve(toSurface.size());
  std::size_t left = 0;
  for (const float distance : toSurface) {
    const bool isLeft = distance > reach; // not what is set aside
    states->push_back(isLeft ? PointState::normal : explained);
    if (isLeft) ++left;
  }
  parts_.states.setExplained(std::move(states));
  const auto all = static_cast<double>(distances->toSurface().size());
  bar_->showLeft(tr("%1 left, %2 %")
                     .arg(formatCount(left))
                     .arg(100 * static_cast<double>(left) / std::max(all, 1.0), 0, 'f', 1));
}

} // namespace espalier
