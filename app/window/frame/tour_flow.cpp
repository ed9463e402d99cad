#include "app/window/frame/tour_flow.h"

#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/tour_hint.h"

#include <QAction>
#include <QSettings>
#include <QWidget>

namespace espalier {
namespace {

constexpr auto shownKey = "tour/was_shown";
constexpr int steps = 3;

} // namespace

TourFlow::TourFlow(const Parts& parts) : parts_(parts), hint_(new TourHint(&parts.window)) {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("Help"));
  actions.add({.id = "tour",
               .text = tr("Tour in Three Steps"),
               .help = tr("Shows where the skeleton is found, what is in doubt, and how to sign"),
               .icon = "info"},
              [this] {
                isAwaited_ = parts_.document.scan() == nullptr;
                if (isAwaited_)
                  parts_.actions["sample_plant"]->trigger();
                else
                  begin();
              });
  connect(hint_, &TourHint::nextAsked, this, [this] { goTo(step_ + 1); });
  connect(hint_, &TourHint::leaveAsked, this, &TourFlow::leave);
  connect(actions["leave"], &QAction::triggered, this, &TourFlow::leave);
  // Who does what a hint says needs it no longer.
  const auto goOnWithSkeleton = [this] {
    if (step_ == 1 && !parts_.document.skeleton().isEmpty()) goTo(2);
  };
  connect(&parts_.document, &PlantDocument::skeletonReplaced, this, [this, goOnWithSkeleton] {
    if (step_ > 1 && parts_.document.skeleton().isEmpty()) return goTo(1); // of another plant
    goOnWithSkeleton();
  });
  connect(&parts_.document, &PlantDocument::skeletonEdited, this, goOnWithSkeleton);
  for (const char* id : {"ask_doubts", "next_finding"})
    connect(actions[id], &QAction::triggered, this, [this] {
      if (step_ == 2) goTo(3);
    });
  for (const char* id : {"show_review", "sign_structure"})
    connect(actions[id], &QAction::triggered, this, [this] {
      if (step_ == 3) leave();
    });
}

void TourFlow::setPlantShown(bool isShown) {
  if (!isShown) return leave();
  if (parts_.document.scan() == nullptr || step_ > 0) return;
  if (isAwaited_ || !parts_.settings.value(shownKey, false).toBool()) begin();
}

void TourFlow::begin() {
  isAwaited_ = false;
  parts_.settings.setValue(shownKey, true);
  goTo(parts_.document.skeleton().isEmpty() ? 1 : 2);
}

void TourFlow::goTo(int step) {
  if (step > steps) return leave();
  step_ = step;
  const QString title = tr("Step %1 of %2").arg(step).arg(steps);
  const QString next = step == steps ? tr("Done") : tr("Next");
  const auto named = [this](const char* name) { return parts_.window.findChild<QWidget*>(name); };
  if (step == 1)
    hint_->showText(title,
                    tr("Find the skeleton: press Reconstruct, or %1.").arg(keysOf("reconstruct")),
                    next, named("reconstruct_button"));
  else if (step == 2)
    hint_->showText(title,
                    tr("Look at what is in doubt: %1 asks about what the program is not sure of, "
                       "%2 goes to places that look wrong.")
                        .arg(keysOf("ask_doubts"), keysOf("next_finding")),
                    next, named("inspector"));
  else
    hint_->showText(title,
                    tr("Sign: %1 opens the review. It shows the plant part by part; Enter marks "
                       "what is right. Sign Structure… then seals it.")
                        .arg(keysOf("show_review")),
                    next, named("inspector"));
}

void TourFlow::leave() {
  step_ = 0;
  hint_->hide();
}

QString TourFlow::keysOf(const char* action) const {
  return parts_.actions[action]->shortcut().toString(QKeySequence::NativeText);
}

} // namespace espalier
