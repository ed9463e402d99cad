#include "app/window/review/review_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/review/expected_errors_flow.h"
#include "app/window/review/looked_at.h"
#include "core/base/error.h"
#include "core/skeleton/review_coverage.h"
#include "ui/document/plant_document.h"
#include "ui/panels/review_panel.h"
#include "ui/tools/node_edits.h"
#include "ui/view/plant_view.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

bool takesEnter(QWidget* widget) {
  return qobject_cast<QLineEdit*>(widget) != nullptr ||
         qobject_cast<QAbstractSpinBox*>(widget) != nullptr;
}

bool isEnter(const QEvent& event) {
  if (event.type() != QEvent::ShortcutOverride) return false;
  const int key = static_cast<const QKeyEvent&>(event).key();
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

QString nothingToCommentOn() {
  return ReviewFlow::tr(
      "nothing is selected to comment on: put the pointer on a node, or select some");
}

} // namespace

ReviewFlow::ReviewFlow(const Parts& parts, QAction* sign)
    : parts_(parts),
      reviewer_(parts.settings.value("author", qEnvironmentVariable("USER")).toString()) {
  parts_.actions.beginSection(tr("Review"));
  addWalkActions();
  addMarkActions();
  makePanel(sign);
  parts_.actions.place("review/walk", [this](QMenu& menu) {
    menu.addActions(walks_);
    menu.addAction(parts_.actions["riskiest_first"]);
    menu.addSeparator();
    menu.addActions(marks_);
  });
  parts_.actions.place("review/walk", {"", "sign_structure", "export_certificate", "export_seal",
                                       "", "show_review"});
  connectParts();
  refreshEnabled();
  showPlace();
}

void ReviewFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refreshEnabled();
}

void ReviewFlow::setInGesture(bool isInGesture) {
  if (isInGesture == isInGesture_) return;
  isInGesture_ = isInGesture;
  refreshEnabled();
}

void ReviewFlow::setEnterTaken(bool isTaken) {
  if (isTaken == isEnterTaken_) return;
  isEnterTaken_ = isTaken;
  refreshEnabled();
}

void ReviewFlow::setReviewer(const QString& name) {
  panel_->setReviewer(name);
  if (name == reviewer_) return;
  reviewer_ = name;
  parts_.settings.setValue("author", name);
  parts_.document.setAuthor(name);
  emit reviewerChanged(name);
}

void ReviewFlow::addWalkActions() {
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, WalkTo to,
                          WalkDirection direction = WalkDirection::forward) {
    walks_.append(parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys},
                                     [this, to, direction] { step(to, direction); }));
  };
  add("next_stretch", tr("Next Stop"),
      tr("Walks on: along the trunk, then branch by branch with its twigs, or by expected error"),
      Qt::Key_Period, WalkTo::anyStop);
  add("previous_stretch", tr("Previous Stop"), tr("Walks back"), Qt::Key_Comma, WalkTo::anyStop,
      WalkDirection::backward);
  add("next_not_reviewed", tr("Next Not Reviewed"), tr("Walks on to what is to do or doubtful"),
      QKeySequence(Qt::CTRL | Qt::Key_Period), WalkTo::notReviewed);
  add("next_open_end", tr("Next Open End"), tr("Walks on to an apex that is not reviewed"),
      Qt::Key_O, WalkTo::openEnd);
  add("next_branching", tr("Next Branching"), tr("Walks on to a branching that is not reviewed"),
      Qt::Key_B, WalkTo::branching);
  QAction* byError = parts_.actions.add(
      {.id = "riskiest_first",
       .text = tr("Riskiest First"),
       .help = tr("Walks by expected error, most first, in place of along the plant"),
       .keys = QKeySequence(Qt::SHIFT | Qt::Key_F9),
       .isCheckable = true},
      [this] { chooseOrder(parts_.actions["riskiest_first"]->isChecked()); });
  byError->setChecked(parts_.settings.value("review/riskiest_first", false).toBool());
  order_ = byError->isChecked() ? WalkOrder::byExpectedError : WalkOrder::alongPlant;
}

void ReviewFlow::addMarkActions() {
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, const std::function<void()>& act) {
    marks_.append(parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys}, act));
    marks_.last()->setAutoRepeat(false); // a key held down marks once
  };
  add("mark_reviewed", tr("Mark Reviewed and Go On"),
      tr("What is selected and seen is right; shows the next stop that is to do. While nothing is "
         "selected, or the panel is not in front, it marks nothing and only shows that stop"),
      Qt::Key_Enter, [this] { markReviewed(); });
  add("mark_doubtful", tr("Mark Doubtful"),
      tr("What is selected needs another look; with the panel in front, shows the next stop that "
         "is to do"),
      QKeySequence(Qt::SHIFT | Qt::Key_Enter), [this] { markDoubtful(); });
  add("mark_to_do", tr("Mark To Do"), tr("What is selected is to be reviewed again"),
      Qt::Key_Backspace, [this] {
        requireToMark();
        mark(ReviewState::toDo, parts_.document.selection().nodes());
      });
  add("mark_all_selected", tr("Mark All Selected Reviewed"),
      tr("Marks all nodes selected that are to do, seen or not; doubtful ones stay so"), {},
      [this] { markAllSelected(); });
  add("comment", tr("Comment"),
      tr("A remark on what is selected, else on the node under the pointer"), Qt::Key_K,
      [this] { beginComment(); });
}

void ReviewFlow::makePanel(QAction* sign) {
  const auto at = [this](const char* id) { return parts_.actions[id]; };
  panel_ = new ReviewPanel(parts_.document, {.previous = at("previous_stretch"),
                                             .next = at("next_stretch"),
                                             .openEnd = at("next_open_end"),
                                             .branching = at("next_branching"),
                                             .riskiestFirst = at("riskiest_first"),
                                             .reviewed = at("mark_reviewed"),
                                             .doubtful = at("mark_doubtful"),
                                             .toDo = at("mark_to_do"),
                                             .sign = sign});
  panel_->setReviewer(reviewer_);
  dock_ = addDock(new PanelDock({parts_.actions, parts_.settings, parts_.window},
                                {.id = "review",
                                 .title = tr("Review"),
                                 .text = tr("Review Panel"),
                                 .help = tr("Shows or hides this panel"),
                                 .keys = Qt::Key_F9,
                                 .manual = "review.md"},
                                besideThePlant, panel_, this));
}

void ReviewFlow::connectParts() {
  PlantDocument& document = parts_.document;
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::readOnlyChanged})
    connect(&document, signal, this, &ReviewFlow::refreshEnabled);
  connect(&document, &PlantDocument::skeletonEdited, this, &ReviewFlow::refreshEnabled);
  again_.setSingleShot(true);
  again_.setInterval(100); // [ms]: a drag is described when it rests
  connect(&again_, &QTimer::timeout, this, &ReviewFlow::describeAgain);
  connect(&document, &PlantDocument::skeletonEdited, &again_, qOverload<>(&QTimer::start));
  connect(&parts_.errors, &ExpectedErrorsFlow::changed, &again_, qOverload<>(&QTimer::start));
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    at_.clear();
    atPoints_.clear();
    doubted_.clear();
    awaited_.reset();
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&document, signal, this, [this] { // points have other numbers
      atPoints_.clear();
      awaited_.reset();
      showPlace();
    });
  connect(dock_, &PanelDock::shown, &parts_.errors, &ExpectedErrorsFlow::setWanted);
  connect(&parts_.errors, &ExpectedErrorsFlow::changed, this, &ReviewFlow::goOnWaiting);
  connect(&document.selection(), &Selection::changed, this, [this] {
    isDoubtAskedFor_ = false;
    awaited_.reset();
    if (!parts_.document.selection().isEmpty()) atPoints_.clear();
    showPlace();
    refreshEnabled();
  });
  connect(panel_, &ReviewPanel::reviewerTyped, this, &ReviewFlow::setReviewer);
  connect(panel_, &ReviewPanel::commentTyped, this, [this](const QString& text) {
    const auto act = [&] {
      comment(text);
      return true;
    };
    parts_.actions.guarded(act, Refusal::inBanner);
  });
  connect(panel_, &ReviewPanel::leaveRequested, &parts_.view, qOverload<>(&QWidget::setFocus));
  connect(panel_, &ReviewPanel::axisChosen, this, [this](const Axis& axis) {
    at_.clear();
    parts_.document.selection().set(axis);
    if (const QString note = frame(axis); !note.isEmpty()) emit noted(note);
  });
  // Enter in a field takes what is typed there, and marks nothing.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, QWidget* now) {
    if (before != nullptr) before->removeEventFilter(this);
    if (now != nullptr && takesEnter(now)) now->installEventFilter(this);
  });
}

bool ReviewFlow::eventFilter(QObject* watched, QEvent* event) {
  if (!isEnter(*event)) return QObject::eventFilter(watched, event);
  event->accept();
  return true;
}

void ReviewFlow::markReviewed() {
  // Enter also accepts previews: one Enter too many must not review what nobody looks at.
  if (parts_.looksAtQuestion()) return;
  if (!dock_->isInFront()) return step(WalkTo::toDo);
  if (isAtPoints()) return takePoints();
  if (parts_.document.selection().isEmpty()) return step(WalkTo::toDo);
  const std::vector<NodeId> nodes = parts_.document.selection().nodes();
  requireOneLook(parts_.document.skeleton(), nodes, parts_.actions);
  const QString unseen = unseenText({.skeleton = parts_.document.skeleton(),
                                     .hidden = parts_.hidden(),
                                     .views = {&parts_.view, &parts_.editing.activeView()}},
                                    nodes);
  if (!unseen.isEmpty()) {
    const QString note = frame(nodes);
    emit noted(withKeys(tr("Nothing is marked yet, as %1: now it is shown, and {mark_reviewed} "
                           "marks it"),
                        parts_.actions)
                   .arg(unseen) +
               (note.isEmpty() ? note : QStringLiteral("   ") + note));
    return;
  }
  const std::vector<NodeId> toDo = selected(ReviewState::toDo);
  const std::vector<NodeId> doubtful = selected(ReviewState::doubtful);
  const bool takesDoubtBack = toDo.empty() && !doubtful.empty();
  if (takesDoubtBack && !std::exchange(isDoubtAskedFor_, false)) return askForDoubt(doubtful);
  mark(ReviewState::reviewed, takesDoubtBack ? doubtful : toDo);
  goOnAfter(takesDoubtBack);
}

void ReviewFlow::markDoubtful() {
  if (isAtPoints() && dock_->isInFront()) {
    doubted_.insert(doubted_.end(), atPoints_.begin(), atPoints_.end());
    return goOnAfter(false);
  }
  requireToMark();
  mark(ReviewState::doubtful, parts_.document.selection().nodes());
  if (dock_->isInFront()) goOnAfter(false); // else it is noted in passing
}

void ReviewFlow::markAllSelected() {
  requireToMark();
  const std::vector<NodeId> nodes = selected(ReviewState::toDo);
  if (nodes.empty())
    throw Error(
        tr("nothing that is selected is to do: it is reviewed or doubtful already").toStdString());
  dock_->bringToFront();
  mark(ReviewState::reviewed, nodes);
}

/// Of what is selected, what is in a state.
std::vector<NodeId> ReviewFlow::selected(ReviewState state) const {
  std::vector<NodeId> nodes = parts_.document.selection().nodes();
  std::erase_if(nodes,
                [&](NodeId id) { return parts_.document.skeleton()[id].review.state != state; });
  return nodes;
}

/// Says whose doubt Enter would take back, and why it was: the next Enter does so.
void ReviewFlow::askForDoubt(const std::vector<NodeId>& doubtful) {
  const ReviewMark& mark = parts_.document.skeleton()[doubtful.front()].review;
  QString whose = QString::fromStdString(mark.reviewer);
  if (!mark.comment.empty())
    whose += (whose.isEmpty() ? "" : ": ") + QString::fromStdString(mark.comment);
  QString text = (doubtful.size() == 1 ? tr("%1 is doubtful") : tr("%1 are doubtful"))
                     .arg(nodeNames(doubtful));
  if (!whose.isEmpty()) text += QString(" (%1)").arg(whose);
  text += (doubtful.size() == 1 ? tr(": %1 once more takes that back and marks it reviewed")
                                : tr(": %1 once more takes that back and marks them reviewed"))
              .arg(parts_.actions["mark_reviewed"]->shortcut().toString(QKeySequence::NativeText));
  text[0] = text[0].toUpper();
  isDoubtAskedFor_ = true;
  emit noted(text);
}

void ReviewFlow::mark(ReviewState state, const std::vector<NodeId>& nodes) {
  const QString text = state == ReviewState::reviewed   ? tr("Mark %1 reviewed")
                       : state == ReviewState::doubtful ? tr("Mark %1 doubtful")
                                                        : tr("Mark %1 to do");
  parts_.document.edit(text.arg(nodeNames(nodes)), [&](SkeletonEditor& editor) {
    for (const NodeId id : nodes) {
      ReviewMark mark = editor.skeleton()[id].review;
      if (mark.state == state) continue; // whoever looked first stays named
      mark.state = state;
      mark.reviewer = state == ReviewState::toDo ? std::string() : reviewer_.toStdString();
      editor.setReview(id, std::move(mark));
    }
  });
}

/// The field has the keyboard even where there is nothing to comment on: what is typed on is no
/// command then.
void ReviewFlow::beginComment() {
  Selection& selection = parts_.document.selection();
  const std::optional<NodeId> under = parts_.editing.nodeUnder();
  if (selection.isEmpty() && under) selection.set({*under});
  dock_->bringToFront();
  panel_->focusComment();
  requireChosen(nothingToCommentOn());
}

void ReviewFlow::comment(const QString& text) {
  requireChosen(nothingToCommentOn());
  const std::vector<NodeId> nodes = parts_.document.selection().nodes();
  parts_.document.edit(tr("Comment on %1").arg(nodeNames(nodes)), [&](SkeletonEditor& editor) {
    for (const NodeId id : nodes) {
      ReviewMark mark = editor.skeleton()[id].review;
      mark.comment = text.trimmed().toStdString();
      editor.setReview(id, std::move(mark));
    }
  });
}

void ReviewFlow::requireChosen(const QString& why) const {
  parts_.document.requireEditable();
  if (parts_.document.selection().isEmpty()) throw Error(why.toStdString());
}

void ReviewFlow::requireToMark() const {
  requireChosen(withKeys(
      tr("nothing is selected to mark: select nodes, or press {next_stretch} to walk to a stop"),
      parts_.actions));
}

void ReviewFlow::showPlace() {
  const std::vector<NodeId>& nodes = parts_.document.selection().nodes();
  QString text = nodes.empty() ? tr("Press . to walk") : nodeNames(nodes);
  if (!nodes.empty()) text[0] = text[0].toUpper();
  const bool isOnWalk = !nodes.empty() && nodes == at_;
  if (isOnWalk || isAtPoints())
    panel_->showPlace(placeText_, whyText_);
  else
    panel_->showPlace(text);
  if (isOnWalk)
    parts_.view.setFaded(nodes);
  else if (isFading_)
    parts_.view.setFaded(std::nullopt);
  isFading_ = isOnWalk;
}

void ReviewFlow::refreshEnabled() {
  const bool hasNodes = !parts_.document.skeleton().isEmpty();
  for (QAction* walk : walks_)
    walk->setEnabled(isEnabled_ && hasNodes);
  for (QAction* mark : marks_)
    mark->setEnabled(isEnabled_ && !isInGesture_ && hasNodes && !parts_.document.isReadOnly());
  if (isEnterTaken_) parts_.actions["mark_reviewed"]->setEnabled(false);
  const std::size_t chosen = parts_.document.selection().nodes().size();
  parts_.actions["mark_all_selected"]->setText(
      chosen > 1 ? tr("Mark All %1 Selected Reviewed").arg(formatCount(chosen))
                 : tr("Mark All Selected Reviewed"));
}

} // namespace espalier
