#include "app/window/edit_flow.h"

#include "app/window/align/registration_flow.h"
#include "app/window/edit/editing.h"
#include "app/window/files/project_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/ignoring_steps.h"
#include "app/window/preview/preview_flow.h"
#include "app/window/review/asking_flow.h"
#include "app/window/view/shown_flow.h"
#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QApplication>

#include <cstddef>
#include <unordered_set>
#include <utility>

namespace espalier {

EditFlow::EditFlow(PlantDocument& document, ActionSet& actions)
    : document_(document), actions_(actions) {
  actions_.beginSection(tr("Edit"));
  addHistory();
  actions_.add({.id = "select_all",
                .text = tr("Select &All"),
                .help = tr("Selects all nodes but the hidden ones"),
                .keys = QKeySequence::SelectAll,
                .menu = "select/all"},
               [this] { document_.selection().set(later_->shown.shownNodes()); });
  actions_.add({.id = "leave",
                .text = tr("Leave"),
                .help = tr("Leaves the gesture, the tool, or the selection"),
                .keys = Qt::Key_Escape,
                .menu = "edit/leave"},
               [this] { leave(); });
}

void EditFlow::join(const Later& later) {
  later_.emplace(later);
  connect(&later.registration, &RegistrationFlow::changed, this, &EditFlow::refreshHistory);
  connect(&later.ignoring, &IgnoringSteps::changed, this, &EditFlow::refreshHistory);
  connect(&later.preview, &PreviewFlow::changed, this, &EditFlow::refreshHistory);
  connect(actions_["compare_alone"], &QAction::toggled, this, &EditFlow::refreshHistory);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &EditFlow::noteStep);
}

void EditFlow::addHistory() {
  QUndoStack& stack = document_.undoStack();
  QAction* undo = actions_.add({.id = "undo",
                                .text = tr("&Undo"),
                                .help = tr("Takes the last edit back"),
                                .icon = "undo",
                                .keys = QKeySequence(Qt::CTRL | Qt::Key_Z),
                                .menu = "edit/history",
                                .inPalette = tr("Undo")}, // not found by what it undoes
                               [this] { this->undo(); });
  QAction* redo = actions_.add({.id = "redo",
                                .text = tr("&Redo"),
                                .help = tr("Makes the edit again"),
                                .icon = "redo",
                                .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                                .menu = "edit/history",
                                .inPalette = tr("Redo")},
                               [this] { this->redo(); });
  redo->setShortcuts({redo->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  undo->setEnabled(false);
  redo->setEnabled(false);
  for (auto signal : {&QUndoStack::canUndoChanged, &QUndoStack::canRedoChanged})
    connect(&stack, signal, this, &EditFlow::refreshHistory);
  for (auto signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged})
    connect(&stack, signal, this, &EditFlow::refreshHistory);
}

void EditFlow::refreshHistory() {
  const QUndoStack& stack = document_.undoStack();
  const bool isRegistering = later_ && later_->registration.isActive();
  const bool undoesIgnoring = later_ && later_->ignoring.canUndo();
  const bool redoesIgnoring = later_ && later_->ignoring.canRedo();
  QAction* undo = actions_["undo"];
  QAction* redo = actions_["redo"];
  undo->setEnabled(isRegistering ? later_->registration.hasWork()
                                 : stack.canUndo() || undoesIgnoring);
  redo->setEnabled(!isRegistering && (stack.canRedo() || redoesIgnoring));
  const QString undone = undoesIgnoring ? later_->ignoring.undoText() : stack.undoText();
  const QString redone = redoesIgnoring ? later_->ignoring.redoText() : stack.redoText();
  const QString drop = tr("Drop the &Preview");
  undo->setText(!undoesIgnoring && endsPreview(stack.index() - 1) ? drop
                : undone.isEmpty()                                ? tr("&Undo")
                                                                  : tr("&Undo: %1").arg(undone));
  redo->setText(!redoesIgnoring && endsPreview(stack.index()) ? drop
                : redone.isEmpty()                            ? tr("&Redo")
                                                              : tr("&Redo: %1").arg(redone));
}

void EditFlow::undo() {
  if (later_->registration.isActive()) return later_->registration.removeLast();
  Editing& editing = later_->editing;
  if (!editing.isPending() && later_->asking.isRestShown()) return later_->asking.stopAsking();
  if (!editing.isPending() && later_->ignoring.canUndo()) return later_->ignoring.undo();
  if (editing.isPending() || !endsPreview(document_.undoStack().index() - 1) ||
      !later_->preview.drop())
    editing.undo();
}

void EditFlow::redo() {
  Editing& editing = later_->editing;
  if (!editing.isPending() && later_->ignoring.canRedo()) return later_->ignoring.redo();
  if (editing.isPending() || !endsPreview(document_.undoStack().index()) || !later_->preview.drop())
    editing.redo();
}

/// A step of a plant that is behind a preview drops that first: one sees what is undone.
bool EditFlow::endsPreview(int step) const {
  const bool isThere = step >= 0 && step < document_.undoStack().count();
  return isThere && document_.isHeld() && !document_.step(step).delta.isEmpty();
}

void EditFlow::leave() {
  PlantView& view = later_->editing.activeView();
  const QWidget* at = QApplication::focusWidget();
  const bool isInPanel = at != nullptr && view.isVisible() && !view.isAncestorOf(at) && at != &view;
  if (view.isVisible()) view.setFocus(); // from whatever field: Enter there means something else
  if (later_->registration.isActive()) return later_->registration.escape();
  if (!later_->editing.isPending() && later_->asking.isShowing())
    return later_->asking.stopAsking();
  const bool isPending = later_->editing.isPending();
  if (!isPending && later_->dismissesMessage()) return;
  if (!isPending && (later_->preview.drop() || isInPanel)) return; // the selection stays
  later_->editing.escape();
}

void EditFlow::noteStep(int index) {
  const QUndoStack& stack = document_.undoStack();
  const int before = std::exchange(step_, index);
  if (later_->editing.isBusy() || later_->projects.isLoading())
    return; // a drag notes what it does itself
  if (index == before - 1 && index < stack.count()) {
    selectWhereUndone(document_.step(index).delta);
    emit noted(tr("Undone: %1").arg(stack.text(index)));
  } else if (index == before + 1)
    emit noted(index < stack.count() ? tr("Redone: %1").arg(stack.text(index - 1))
                                     : stack.text(index - 1));
}

/// Where nothing is selected any more, as what was came or went: keys go on from there.
void EditFlow::selectWhereUndone(const SkeletonDelta& undone) {
  if (!document_.selection().isEmpty()) return;
  std::unordered_set<std::size_t> pieces; // of wood that is back, or gone
  for (const SkeletonDelta::Change& change : undone.changes)
    if (change.before.has_value() != change.after.has_value()) pieces.insert(indexOf(change.id));
  std::optional<NodeId> place;
  for (const SkeletonDelta::Change& change : undone.changes) {
    if (!pieces.contains(indexOf(change.id))) continue;
    const bool isBack = change.before.has_value();
    const std::optional<NodeId>& parent = (isBack ? change.before : change.after)->parent;
    if (parent && pieces.contains(indexOf(*parent))) continue;
    if (!parent || place) return; // a whole plant, or several pieces
    place = isBack ? change.id : *parent;
  }
  if (place && document_.skeleton().contains(*place)) document_.selection().set({*place});
}

} // namespace espalier
