#include "app/window/frame/ignoring_steps.h"

#include "app/window/frame/last_step.h"
#include "ui/document/plant_document.h"

#include <algorithm>
#include <set>
#include <utility>

namespace espalier {

IgnoringSteps::IgnoringSteps(PlantDocument& document) : document_(document) {
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, &IgnoringSteps::follow);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::leftOutChanged}) // points have other numbers
    connect(&document, signal, this, &IgnoringSteps::forget);
}

bool IgnoringSteps::isAtPlace(const std::vector<Placed>& steps) const {
  return !steps.empty() && steps.back().after == lastStepOf(document_);
}

void IgnoringSteps::add(Step step) {
  undone_.clear();
  done_.push_back({lastStepOf(document_), std::move(step)});
  emit changed();
}

void IgnoringSteps::undo() {
  Placed last = std::move(done_.back());
  done_.pop_back();
  last.step.undo();
  const QString text = last.step.text;
  undone_.push_back(std::move(last));
  emit changed();
  emit noted(tr("Undone: %1").arg(text));
}

void IgnoringSteps::redo() {
  Placed next = std::move(undone_.back());
  undone_.pop_back();
  next.step.redo();
  const QString text = next.step.text;
  done_.push_back(std::move(next));
  emit changed();
  emit noted(tr("Redone: %1").arg(text));
}

/// A new step of the plant ends what could be made again; of what was beside steps that are gone
/// nothing is undone.
void IgnoringSteps::follow(int index) {
  const int before = std::exchange(index_, index);
  const bool isNew = index == before + 1 && lastStepOf(document_) != next_;
  const int count = document_.undoStack().count();
  next_ = index < count ? document_.step(index).id : StepId{};
  if (isNew) undone_.clear();
  if (done_.empty() && undone_.empty()) return;
  std::set<StepId> there{StepId{}};
  for (int i = 0; i < count; ++i)
    there.insert(document_.step(i).id);
  for (auto* steps : {&done_, &undone_})
    std::erase_if(*steps, [&](const Placed& one) { return !there.contains(one.after); });
  emit changed();
}

void IgnoringSteps::forget() {
  done_.clear();
  undone_.clear();
  emit changed();
}

} // namespace espalier
