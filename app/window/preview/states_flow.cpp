#include "app/window/preview/states_flow.h"

#include "app/report/comparison_colors.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/preview/options_text.h"
#include "app/window/preview/reconstruct_flow.h"
#include "app/window/view/two_views_flow.h"
#include "core/base/error.h"
#include "core/evaluate/differences/with_missed.h"
#include "ui/document/plant_document.h"
#include "ui/panels/blend_bar.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>
#include <QGridLayout>

#include <utility>

namespace espalier {
namespace {

constexpr double differing = 3; // point spacings: what is farther apart differs

} // namespace

StatesFlow::StatesFlow(const Parts& parts) : parts_(parts), arrangements_(new QActionGroup(this)) {
  addActions();
  makeBar();
  connect(&parts_.preview, &PreviewFlow::changed, this, [this] {
    if (kept_ && areReplaced_ != replacesPoints()) showA();
    arrange();
    colorDifferences();
  });
  connect(parts_.actions["two_views"], &QAction::toggled, this, [this](bool areTwo) {
    if (!areTwo && arrangement_ == Arrangement::twoViews)
      parts_.actions["compare_alone"]->trigger();
    arrange();
  });
  connect(&parts_.view, &PlantView::dividerMoved, this, [this](double at) { divider_ = at; });
  connect(&parts_.document, &PlantDocument::scanChanged, this, &StatesFlow::forgetA);
}

void StatesFlow::addActions() {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("Preview"));
  actions.add({.id = "keep_as_a",
               .text = tr("Keep as A"),
               .help = tr("Keeps what is shown, to compare it with what comes next"),
               .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
               .menu = "preview/kept"},
              [this] { keepAsA(); });
  actions.add({.id = "forget_a",
               .text = tr("Forget A"),
               .help = tr("Compares with the plant as it is again"),
               .menu = "preview/kept"},
              [this] { forgetA(); });
  const auto add = [&](Arrangement arrangement, Command command) {
    command.isCheckable = true;
    command.menu = "preview/compare";
    QAction* action = actions.add(command, [this, arrangement] {
      if (arrangement == arrangement_ && arrangement != Arrangement::preview)
        return parts_.actions["compare_alone"]->trigger(); // once more: as before
      arrangement_ = arrangement;
      QAction* twoViews = parts_.actions["two_views"];
      if (arrangement == Arrangement::twoViews) {
        hasOpenedSecond_ = hasOpenedSecond_ || !twoViews->isChecked();
        twoViews->setChecked(true);
        parts_.actions["link_same"]->trigger();
      } else if (std::exchange(hasOpenedSecond_, false)) {
        twoViews->setChecked(false);
      }
      arrange();
    });
    arrangements_->addAction(action);
  };
  add(Arrangement::preview, {.id = "compare_alone",
                             .text = tr("Preview Alone"),
                             .help = tr("Shows the preview in place of the plant")});
  add(Arrangement::divided, {.id = "compare_divided",
                             .text = tr("Divided View"),
                             .help = tr("Shows A, or the plant, left of a divider and the preview "
                                        "right of it"),
                             .keys = QKeySequence(Qt::CTRL | Qt::Key_9)});
  add(Arrangement::twoViews, {.id = "compare_two_views",
                              .text = tr("Side by Side"),
                              .help = tr("Shows A, or the plant, in one view and the preview in "
                                         "another that moves with it")});
  actions["compare_alone"]->setChecked(true);
  QAction* color = actions.add({.id = "color_state_differences",
                                .text = tr("Color What Differs"),
                                .help = tr("Colors the preview by where it differs from A, or from "
                                           "the plant, and adds what it lacks"),
                                .isCheckable = true,
                                .menu = "preview/compare"},
                               {});
  connect(color, &QAction::toggled, this, &StatesFlow::colorDifferences);
  QAction* blend = actions.add({.id = "blend_points",
                                .text = tr("Blend Points"),
                                .help = tr("Moves points between where they were scanned and where "
                                           "contraction puts them"),
                                .keys = QKeySequence(Qt::CTRL | Qt::Key_7),
                                .isCheckable = true,
                                .menu = "preview/points"},
                               {});
  actions.place("view/points", {"blend_points"});
  connect(blend, &QAction::toggled, this, &StatesFlow::blend);
}

void StatesFlow::makeBar() {
  auto* layers = static_cast<QGridLayout*>(parts_.center.layout());
  bar_ = new BlendBar(&parts_.center);
  bar_->hide();
  layers->addWidget(bar_, 2, 0);
  connect(bar_, &BlendBar::changed, this, &StatesFlow::blend);
  connect(bar_, &BlendBar::closeRequested, this,
          [this] { parts_.actions["blend_points"]->setChecked(false); });
}

void StatesFlow::setPlantShown(bool isShown) {
  isPlantShown_ = isShown;
  blend();
}

void StatesFlow::blend() {
  const bool isOn = parts_.actions["blend_points"]->isChecked();
  bar_->setVisible(isOn && isPlantShown_);
  bar_->raise();
  parts_.view.setBlend(isOn ? std::optional(bar_->blend()) : std::nullopt);
  parts_.view.setDisplacementsShown(isOn && bar_->showsDisplacements());
}

Outcome StatesFlow::plant() const {
  PipelineOptions options = parts_.reconstruct.used();
  options.leftOut = parts_.document.leftOut();
  return {.options = options,
          .contracted = parts_.document.contracted(),
          .scanned = nullptr,
          .skeleton = std::make_shared<const Skeleton>(parts_.document.skeleton()),
          .within = std::nullopt,
          .quality = nullptr};
}

void StatesFlow::keepAsA() {
  if (parts_.document.scan() == nullptr)
    throw Error(tr("there is no scan: open one first").toStdString());
  const std::optional<Outcome>& shown = parts_.preview.shown();
  if (shown && (shown->within || parts_.preview.isBusy()))
    throw Error(tr("the preview is not of the whole scan yet: wait a moment").toStdString());
  keep(shown ? *shown : plant());
  emit noted(withKeys(tr("Kept as A: change a step   {compare_divided} compare in a divided view"),
                      parts_.actions));
}

void StatesFlow::keep(const Outcome& outcome) {
  kept_ = outcome;
  showA();
  arrange();
  colorDifferences();
  emit changed();
}

void StatesFlow::forgetA() {
  if (!kept_) return;
  kept_.reset();
  parts_.view.setState(Side::left, std::nullopt);
  arrange();
  colorDifferences();
  emit changed();
}

bool StatesFlow::replacesPoints() const {
  return parts_.preview.shown() && parts_.preview.movesPoints();
}

void StatesFlow::showA() {
  areReplaced_ = replacesPoints();
  const QString change =
      changeText({}, kept_->options, parts_.document.scale(), symbol(parts_.document.unit()));
  PlantState state = kept_->shownAs(tr("A · %1").arg(change.isEmpty() ? tr("Default") : change));
  state.replacesPoints = areReplaced_;
  parts_.view.setState(Side::left, state);
}

void StatesFlow::arrange() {
  holdPlant();
  const bool isCompared = parts_.preview.shown() || kept_;
  PlantView* second = parts_.twoViews.second();
  switch (isCompared ? arrangement_ : Arrangement::preview) {
  case Arrangement::preview:
    parts_.view.setDivider(isCompared ? 0 : 1); // A shows beside something only
    break;
  case Arrangement::divided:
    parts_.view.setDivider(divider_);
    break;
  case Arrangement::twoViews:
    parts_.view.setDivider(1);
    if (second != nullptr) second->setDivider(0);
    return;
  }
  if (second != nullptr) second->setDivider(parts_.view.divider());
}

/// The plant is not edited while nothing of it is drawn.
void StatesFlow::holdPlant() {
  const bool isCovered = parts_.preview.shown() && parts_.preview.isOther() &&
                         (kept_ || arrangement_ == Arrangement::preview);
  if (!isCovered) return parts_.document.setHeld({});
  const QAction& make = *parts_.actions["reconstruct"];
  const QString keys = make.shortcut().toString(QKeySequence::NativeText);
  parts_.document.setHeld(tr("this is a preview: %1 makes it the skeleton, Esc drops it")
                              .arg(keys.isEmpty() ? QString(make.text()).remove('&') : keys));
}

void StatesFlow::colorDifferences() {
  const std::optional<Outcome>& shown = parts_.preview.shown();
  const bool areWanted = parts_.actions["color_state_differences"]->isChecked() && shown &&
                         !shown->within && !shown->skeleton->isEmpty();
  const std::shared_ptr<const Skeleton> before = !areWanted ? nullptr
                                                 : kept_    ? kept_->skeleton
                                                            : plant().skeleton;
  if (before == nullptr || before->isEmpty()) {
    differences_.cancel();
    parts_.preview.setDrawn(std::nullopt);
    return;
  }
  differences_.start(
      [now = shown->skeleton, before,
       tolerance = differing * parts_.document.scan()->spacing()](const Progress& progress) {
        return withMissed(*now, *before, differences(*now, *before, tolerance, progress));
      },
      [this](WithMissed both) {
        NodeColors colors = comparisonColors(both.kinds, kept_ ? tr("A") : tr("the plant"));
        parts_.preview.setDrawn(PreviewFlow::Drawn{std::move(both.skeleton), std::move(colors)});
      });
}

} // namespace espalier
