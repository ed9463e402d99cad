#include "app/window/evaluate/error_walk.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/ignoring_steps.h"
#include "app/window/frame/key_hints.h"
#include "core/base/error.h"
#include "core/evaluate/differences/accept_reference.h"
#include "core/evaluate/differences/reference_path.h"
#include "core/skeleton/path_edits.h"
#include "ui/document/difference_look.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/differences_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// What accepting a part does, as an action and as a step of the history.
QString acceptText(const std::optional<DifferingPart>& part) {
  if (!part) return ErrorWalk::tr("Accept Reference");
  switch (part->kind) {
  case Difference::missed:
    return ErrorWalk::tr("Add to Plant");
  case Difference::invented:
    return ErrorWalk::tr("Remove from Plant");
  case Difference::wronglyAttached:
    return ErrorWalk::tr("Attach as Reference");
  case Difference::matched:
    break;
  }
  return {};
}

/// The same after its key.
QString acceptHint(Difference kind) {
  switch (kind) {
  case Difference::missed:
    return ErrorWalk::tr("adds it");
  case Difference::invented:
    return ErrorWalk::tr("removes it");
  case Difference::wronglyAttached:
    return ErrorWalk::tr("attaches it as the reference does");
  case Difference::matched:
    break;
  }
  return {};
}

/// The same on a button.
QString shortAcceptText(const std::optional<DifferingPart>& part) {
  if (!part) return ErrorWalk::tr("Accept");
  switch (part->kind) {
  case Difference::missed:
    return ErrorWalk::tr("Add");
  case Difference::invented:
    return ErrorWalk::tr("Remove");
  case Difference::wronglyAttached:
    return ErrorWalk::tr("Attach");
  case Difference::matched:
    break;
  }
  return {};
}

/// @param version  that is the reference; empty: it is another structure
QString stepText(const DifferingPart& part, const QString& length, const QString& version) {
  const bool isVersion = !version.isEmpty();
  switch (part.kind) {
  case Difference::missed:
    return isVersion ? ErrorWalk::tr("Add %1 of “%2”").arg(length, version)
                     : ErrorWalk::tr("Add %1 of the reference").arg(length);
  case Difference::invented:
    return isVersion ? ErrorWalk::tr("Remove %1 that “%2” lacks").arg(length, version)
                     : ErrorWalk::tr("Remove %1 that the reference lacks").arg(length);
  case Difference::wronglyAttached:
    return isVersion
               ? ErrorWalk::tr("Attach node %1 as in “%2”").arg(indexOf(part.attached)).arg(version)
               : ErrorWalk::tr("Attach node %1 as the reference").arg(indexOf(part.attached));
  case Difference::matched:
    break;
  }
  return {};
}

} // namespace

ErrorWalk::ErrorWalk(Parts parts) : parts_(std::move(parts)) {
  addActions();
  const auto at = [this](const char* id) { return parts_.actions[id]; };
  panel_ = new DifferencesPanel(parts_.document, {.previous = at("previous_error"),
                                                  .next = at("next_error"),
                                                  .accept = at("accept_reference"),
                                                  .ignore = at("ignore_error")});
  connect(panel_, &DifferencesPanel::chosen, this, &ErrorWalk::goTo);
  connect(panel_, &DifferencesPanel::currentChanged, this, &ErrorWalk::showActions);
  connect(&parts_.document, &PlantDocument::unitChanged, this, &ErrorWalk::list);
  // What was accepted and is undone comes back once it is compared again; not before.
  showActions();
}

QStringList ErrorWalk::menu() {
  return {"next_error", "previous_error", "accept_reference", "ignore_error"};
}

void ErrorWalk::addActions() {
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, const std::function<void()>& act) {
    return parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys}, act);
  };
  add("next_error", tr("Next Error"), tr("Goes on to where the plant differs from its reference"),
      Qt::Key_F3, [this] { step(1); });
  add("previous_error", tr("Previous Error"),
      tr("Goes back to where the plant differs from its reference"),
      QKeySequence(Qt::SHIFT | Qt::Key_F3), [this] { step(-1); });
  add("accept_reference", tr("Accept Reference"),
      tr("Makes the plant there what the reference is, as one step"),
      QKeySequence(Qt::CTRL | Qt::Key_Enter), [this] { accept(); });
  add("ignore_error", tr("Ignore Error"), tr("Leaves the error out of the list, or takes it back"),
      QKeySequence(Qt::CTRL | Qt::Key_F3), [this] { toggleIgnored(); });
}

void ErrorWalk::show(std::shared_ptr<const Evaluation> evaluation) {
  evaluation_ = std::move(evaluation);
  done_.clear();
  list();
  mark(panel_->current());
}

/// Shows where a part that is wrongly attached belongs.
void ErrorWalk::mark(const std::optional<DifferingPart>& part) {
  const Skeleton& plant = parts_.document.skeleton();
  if (!evaluation_ || !part || part->kind != Difference::wronglyAttached ||
      !plant.contains(part->attached))
    return parts_.view.showAttachment(std::nullopt);
  ShownAttachment shown{.wrong = {},
                        .right = {plant[part->attached].position},
                        .color = colorOf(part->kind),
                        .wrongLabel = tr("attached here"),
                        .rightLabel = tr("belongs here")};
  for (std::optional<NodeId> id = part->attached; id; id = plant[*id].parent) {
    shown.wrong.push_back(plant[*id].position);
    if (std::ranges::find(part->nodes, *id) == part->nodes.end()) break; // what it is attached to
  }
  for (const NodeId id : referencePath(evaluation_->differences, evaluation_->reference, *part))
    if (const auto parent = evaluation_->reference[id].parent)
      shown.right.push_back(evaluation_->reference[*parent].position);
  if (shown.right.size() > 1) shown.right.back() = part->place;
  parts_.view.showAttachment(shown);
}

void ErrorWalk::setIgnored(std::vector<DifferingPart> ignored) {
  ignored_ = std::move(ignored);
  list();
}

void ErrorWalk::list() {
  std::vector<DifferingPart> parts;
  std::vector<DifferingPart> ignored;
  if (evaluation_)
    for (const DifferingPart& part : evaluation_->differences.parts)
      if (std::ranges::find(done_, part) == done_.end())
        (isIgnored(part) ? ignored : parts).push_back(part);
  panel_->show(parts, ignored, evaluation_ ? evaluation_->tolerance : 0);
}

bool ErrorWalk::isIgnored(const DifferingPart& part) const {
  return std::ranges::any_of(ignored_, [&](const DifferingPart& other) {
    return isSame(other, part, evaluation_->tolerance);
  });
}

void ErrorWalk::step(int by) {
  emit shownAsked();
  if (!evaluation_) {
    emit noted(tr("Nothing has been compared yet"));
    return;
  }
  if (const std::optional<DifferingPart> part = panel_->step(by))
    goTo(*part);
  else
    emit noted(tr("Nothing differs from the reference within the tolerance"));
}

/// Selects what differs, in the plant or in the reference, and marks where the reference attaches
/// it; shows both with what is around them, from their best side.
void ErrorWalk::goTo(const DifferingPart& part) {
  const bool isOfReference = part.kind == Difference::missed;
  Eigen::AlignedBox3d box(part.at);
  Sight sight{.nodes = {}, .places = {part.at}};
  const auto select = [&](const Skeleton& skeleton, std::vector<NodeId> nodes) {
    std::erase_if(nodes, [&](NodeId id) { return !skeleton.contains(id); }); // edited since
    for (const NodeId id : nodes) {
      sight.places.push_back(skeleton[id].position);
      if (const auto parent = skeleton[id].parent)
        sight.places.push_back(skeleton[*parent].position);
    }
    for (const Eigen::Vector3d& place : sight.places)
      box.extend(place);
    return nodes;
  };
  parts_.document.selection().set(
      select(parts_.document.skeleton(), isOfReference ? std::vector<NodeId>() : part.nodes));
  const Skeleton& reference = evaluation_->reference;
  parts_.view.setReferenceSelection(
      select(reference, isOfReference ? part.nodes : std::vector<NodeId>()));
  static_cast<void>( // seen, but not selected: the plant is what is edited
      select(reference, referencePath(evaluation_->differences, reference, part)));
  mark(part);
  sight.nodes = parts_.document.selection().nodes();
  sight.margin = std::max(0.5 * box.diagonal().norm(), 2 * meanEdgeLength(evaluation_->reference));
  parts_.view.flyTo(parts_.view.cameraToSee(sight), focusOn(parts_.document.skeleton(), sight));
  const QString what =
      tr("%1, %2: ").arg(titleOf(part.kind), formatLength(part.length, parts_.document.unit(), 3));
  emit noted(what + withKeys(QStringLiteral("{accept_reference} %1   {ignore_error} %2")
                                 .arg(acceptHint(part.kind),
                                      isIgnored(part) ? tr("lists it again") : tr("ignores it")),
                             parts_.actions));
}

DifferingPart ErrorWalk::chosen() const {
  if (!evaluation_)
    throw Error(tr("nothing has been compared yet: load a reference first").toStdString());
  if (const std::optional<DifferingPart> part = panel_->current()) return *part;
  throw Error((panel_->isEmpty() ? tr("nothing differs from the reference within the tolerance")
                                 : tr("no error is chosen: click one, or go to the next"))
                  .toStdString());
}

void ErrorWalk::accept() {
  const DifferingPart part = chosen();
  parts_.jobs.requireIdle();
  if (parts_.editing.isPending()) parts_.editing.undo(); // leaves the gesture
  std::vector<NodeId> changed;
  const QString version = parts_.version();
  const QString text =
      stepText(part, formatLength(part.length, parts_.document.unit(), 3), version);
  const Copied copied = version.isEmpty() ? Copied::wood : Copied::all;
  parts_.document.edit(text, [&](SkeletonEditor& editor) {
    changed =
        acceptReference(editor, evaluation_->differences, evaluation_->reference, part, copied);
  });
  std::erase_if(changed, [&](NodeId id) { return !parts_.document.skeleton().contains(id); });
  parts_.document.selection().set(std::move(changed));
  parts_.view.setReferenceSelection({});
  parts_.view.showAttachment(std::nullopt);
  done_.push_back(part);
  list(); // without it; the rest follows once all is compared again
}

void ErrorWalk::toggleIgnored() {
  const DifferingPart part = chosen();
  const bool wasIgnored = isIgnored(part);
  const std::vector<DifferingPart> before = ignored_;
  if (wasIgnored)
    std::erase_if(ignored_, [&](const DifferingPart& other) {
      return isSame(other, part, evaluation_->tolerance);
    });
  else
    ignored_.push_back({.kind = part.kind, .nodes = {}, .at = part.at});
  parts_.ignoring.add({.text = wasIgnored ? tr("Show an error again") : tr("Ignore an error"),
                       .undo = [this, before] { ignoreOnly(before); },
                       .redo = [this, now = ignored_] { ignoreOnly(now); }});
  list();
  if (const auto next = wasIgnored ? std::nullopt : panel_->step(1)) goTo(*next);
  emit noted(wasIgnored ? tr("Listed again: %1").arg(titleOf(part.kind))
                        : tr("Ignored: %1. The button above the list shows what is ignored")
                              .arg(titleOf(part.kind)));
  emit ignoredChanged();
}

void ErrorWalk::ignoreOnly(const std::vector<DifferingPart>& parts) {
  setIgnored(parts);
  emit ignoredChanged();
}

/// The commands say what they will do.
void ErrorWalk::showActions() {
  const std::optional<DifferingPart> part = panel_->current();
  QAction* accept = parts_.actions["accept_reference"];
  accept->setText(acceptText(part));
  accept->setIconText(shortAcceptText(part));
  QAction* ignore = parts_.actions["ignore_error"];
  const bool isOut = part && isIgnored(*part);
  ignore->setText(isOut ? tr("Show Error Again") : tr("Ignore Error"));
  ignore->setIconText(isOut ? tr("Show Again") : tr("Ignore"));
}

} // namespace espalier
