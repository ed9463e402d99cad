#include "app/window/review/asking_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/last_step.h"
#include "app/window/review/doubt_ghosts.h"
#include "core/base/error.h"
#include "ui/document/doubt_text.h"
#include "ui/document/length_unit.h"
#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QScopedValueRollback>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace espalier {
namespace {

constexpr int mostAnswers = 4;

/// Whether a change is of more of the wood than its radius.
bool changesCourse(SkeletonDelta::Change change) {
  if (change.before && change.after) change.before->radius = change.after->radius;
  return changesWood(change);
}

} // namespace

AskingFlow::AskingFlow(Parts parts) : parts_(std::move(parts)) {
  addActions();
  connectParts();
  refreshEnabled();
}

void AskingFlow::addActions() {
  parts_.actions.beginSection(tr("Doubts"));
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, const std::function<void()>& act) {
    QAction* action = parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys}, act);
    action->setAutoRepeat(false); // a key held down answers once
    return action;
  };
  add("ask_doubts", tr("Ask About Doubts"),
      tr("Goes to what the program is in doubt about, what matters most first, and asks"),
      Qt::Key_F2, [this] { isAsking_ ? skip() : begin(); });
  const std::array<QString, mostAnswers> texts = {tr("Answer 1"), tr("Answer 2"), tr("Answer 3"),
                                                  tr("Answer 4")};
  for (int i = 0; i < mostAnswers; ++i)
    answers_.append(add(("answer_" + std::to_string(i + 1)).c_str(), texts[std::size_t(i)],
                        tr("Takes the alternative with this number"), QKeySequence(Qt::Key_1 + i),
                        [this, i] { answer(static_cast<std::size_t>(i)); }));
  keys_ = answers_;
  keys_.append(add("answer_none", tr("None of These"),
                   tr("No alternative is right: marks the wood doubtful, to be corrected by hand"),
                   Qt::Key_0, [this] { answerNone(); }));
  const auto inViews = [this](QAction* action) { // buttons and fields have such keys of their own
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    parts_.window.centralWidget()->addAction(action);
    return action;
  };
  keys_.append(
      inViews(add("skip_doubt", tr("Skip Doubt"), tr("Goes on; it is asked again after all others"),
                  Qt::Key_Space, [this] { skip(); })));
  keys_.append(inViews(add("take_back_answer", tr("Take Back Answer"),
                           tr("Takes the last answer back, and asks again"), Qt::Key_Backspace,
                           [this] { takeBack(); })));
  keys_.append(add("stop_asking", tr("Stop Asking"), tr("Goes on without questions"), {},
                   [this] { stopAsking(); }));
  add("decide_rest", tr("Decide the Rest by Odds"),
      tr("Shows what the odds, as answers have taught, would change; once more makes it, as one "
         "step"),
      {}, [this] { decideRest(); });
  parts_.actions.place("review/doubts", {"ask_doubts", "decide_rest"});
  parts_.actions.place("review/doubts", [this](QMenu& menu) { // all of them would not fit a screen
    menu.addMenu(tr("Answer the Question"))->addActions(keys_);
  });
}

void AskingFlow::connectParts() {
  PlantDocument& document = parts_.document;
  editEnds_.setInterval(50); // [ms]
  connect(&editEnds_, &QTimer::timeout, this, &AskingFlow::takeEdit);
  connect(&parts_.distances, &ScanDistances::changed, this, [this] { // which points it is about
    const bool isAsOfNow = current_ && !editEnds_.isActive();
    if (isAsOfNow && isThere(*current_, parts_.document.skeleton())) draw();
  });
  connect(&document, &PlantDocument::skeletonEdited, this, &AskingFlow::noteEdit);
  connect(&document, &PlantDocument::unitChanged, this, [this] {
    if (current_) emit asked(current_, isByHand_);
  });
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::leftOutChanged})
    connect(&document, signal, this, [this] {
      stopAsking();
      skipped_.clear();
      asked_.clear();
      refreshEnabled();
    });
  connect(&document, &PlantDocument::readOnlyChanged, this, [this] {
    stopAsking();
    refreshEnabled();
  });
}

void AskingFlow::askOnlyAbout(std::function<bool(const Doubt&)> isAskedAbout) {
  isAskedAbout_ = std::move(isAskedAbout);
}

void AskingFlow::askAbout(const Doubt& doubt) {
  if (!isThere(doubt, parts_.document.skeleton())) return;
  if (!parts_.actions["ask_doubts"]->isEnabled()) return look(doubt);
  const auto act = [&] {
    const bool isPassed = isAsking_ && current_ && !isByHand_ && !isSame(*current_, doubt, 0);
    if (isPassed) skipped_.push_back(*current_); // an answer goes on from there, not back to it
    begin(doubt);
    return true;
  };
  parts_.actions.guarded(act, Refusal::inBanner);
}

void AskingFlow::setEnabled(bool isEnabled) {
  if (!isEnabled) stopAsking();
  isEnabled_ = isEnabled;
  refreshEnabled();
}

void AskingFlow::refreshEnabled() {
  const bool isPossible = isEnabled_ && parts_.document.scan() != nullptr &&
                          !parts_.document.skeleton().isEmpty() && !parts_.document.isReadOnly();
  parts_.actions["ask_doubts"]->setEnabled(isPossible);
  parts_.actions["decide_rest"]->setEnabled(isPossible && !parts_.doubts.doubts().empty());
  for (QAction* key : keys_)
    key->setEnabled(isAsking_ && isPossible);
  for (int i = 0; i < answers_.size(); ++i)
    answers_[i]->setEnabled(isAsking_ && isPossible && current_ && !isByHand_ &&
                            static_cast<std::size_t>(i) < current_->alternatives.size());
  parts_.actions["answer_none"]->setEnabled(isAsking_ && isPossible && current_ && !isByHand_);
}

void AskingFlow::begin(const std::optional<Doubt>& first) {
  if (parts_.document.scan() == nullptr)
    throw Error(tr("doubts follow from the points: open a scan first").toStdString());
  if (!parts_.doubts.hasSpacing())
    throw Error(tr("all points of the scan lie at one place: nothing follows from them that could "
                   "be asked about")
                    .toStdString());
  parts_.document.requireEditable();
  if (!isAsking_) {
    emit begun();
    isAsking_ = true;
    isRestShown_ = false;
    if (!first) skipped_.clear(); // else one goes through a list, and on from there
    selectedBefore_ = parts_.document.selection().nodes();
    selectedByIt_.clear();
    borrowKeys();
    parts_.doubts.setWanted(DoubtsFlow::Use::asking, true);
    parts_.doubts.findAgain();
    refreshEnabled();
  }
  if (first && isThere(*first, parts_.document.skeleton())) return goTo(*first);
  if (!first || !current_) goOn();
}

/// For doubts that are looked for.
void AskingFlow::wait() {
  current_.reset();
  isByHand_ = false;
  isAwaited_ = true;
  draw();
  emit asked(std::nullopt, false);
  refreshEnabled();
  emit hintChanged();
}

void AskingFlow::stopAsking() {
  if (!isAsking_ && !isRestShown_) return;
  if (std::exchange(isAsking_, false)) giveSelectionBack();
  if (current_ && !isByHand_) skipped_.push_back(*current_);
  isAwaited_ = false;
  isByHand_ = false;
  isRestShown_ = false;
  current_.reset();
  editEnds_.stop();
  parts_.doubts.setWanted(DoubtsFlow::Use::asking, false);
  giveKeysBack();
  draw();
  emit asked(std::nullopt, false);
  refreshEnabled();
  emit hintChanged();
}

/// Other actions on its keys are without them while it asks.
void AskingFlow::borrowKeys() {
  for (QAction* other : parts_.actions.all()) {
    if (keys_.contains(other)) continue;
    const QList<QKeySequence> had = other->shortcuts();
    QList<QKeySequence> left = had;
    for (const QAction* own : keys_)
      for (const QKeySequence& key : own->shortcuts())
        left.removeAll(key);
    if (left == had) continue;
    borrowed_.emplace_back(other, had);
    other->setShortcuts(left);
  }
}

void AskingFlow::giveKeysBack() {
  for (const auto& [action, keys] : borrowed_)
    if (action) action->setShortcuts(keys);
  borrowed_.clear();
}

/// What it has selected is not what one chose: the next key would act on it.
void AskingFlow::giveSelectionBack() {
  Selection& selection = parts_.document.selection();
  const bool isItsOwn = !selectedByIt_.empty() && selection.nodes() == selectedByIt_;
  if (!isItsOwn) return;
  std::erase_if(selectedBefore_,
                [this](NodeId id) { return !parts_.document.skeleton().contains(id); });
  selection.set(std::move(selectedBefore_));
  parts_.editing.actOnPointed();
}

bool AskingFlow::isSkipped(const Doubt& doubt) const {
  return std::ranges::any_of(skipped_, [&](const Doubt& one) { return isSame(one, doubt, 0); });
}

void AskingFlow::goOn() {
  const std::vector<Doubt>& doubts = parts_.doubts.doubts();
  const auto isNext = [this](const Doubt& one) { return !isSkipped(one) && isAskedAbout_(one); };
  auto next = std::ranges::find_if(doubts, isNext);
  if (next == doubts.end()) {
    skipped_.clear(); // all others were asked
    next = std::ranges::find_if(doubts, isNext);
  }
  if (next != doubts.end()) return goTo(*next);
  if (parts_.doubts.isBusy()) return wait();
  stopAsking();
  if (parts_.document.scan() == nullptr) return; // the plant is closed
  if (!parts_.doubts.failure().isEmpty())
    emit failed(failureText());
  else
    emit noted(parts_.doubts.doubts().empty() ? tr("Nothing is in doubt")
                                              : tr("Nothing that is listed is in doubt"));
}

void AskingFlow::goTo(const Doubt& doubt) {
  const Skeleton& skeleton = parts_.document.skeleton();
  current_ = doubt;
  taught_ = parts_.doubts.learnedOf(doubt);
  stepBefore_ = lastStepOf(parts_.document);
  foot_ = skeleton[doubt.node].parent;
  idEnd_ = skeleton.idEnd();
  editEnds_.stop();
  isByHand_ = false;
  isAwaited_ = false;
  isRestShown_ = false;
  draw();
  look(*current_);
  framesBefore_ = parts_.view.framesAtRest();
  sinceAsked_.start();
  emit asked(current_, false);
  refreshEnabled();
  emit hintChanged();
}

bool AskingFlow::lookAgain() {
  if (!isAsking_ || !current_) return false;
  look(*current_);
  return true;
}

void AskingFlow::draw() {
  const Skeleton& skeleton = parts_.document.skeleton();
  if (isRestShown_)
    return parts_.view.showGhosts(ghostsOfLikeliest(skeleton, parts_.doubts.decidedByOdds()));
  if (!current_ || isByHand_) return parts_.view.showGhosts({});
  std::vector<ShownGhost> ghosts = ghostsOf(skeleton, *current_);
  if (const std::shared_ptr<const PointDistances> distances = parts_.distances.now())
    ghosts.push_back(
        ghostOfPoints(skeleton, *current_, *distances, 4 * parts_.document.scale().spacing));
  parts_.view.showGhosts(std::move(ghosts));
}

/// Selects its wood, and goes to where most of it is seen, and the alternatives apart.
void AskingFlow::look(const Doubt& doubt) {
  const Skeleton& skeleton = parts_.document.skeleton();
  parts_.document.selection().set(doubt.nodes.empty() ? std::vector<NodeId>{doubt.node}
                                                      : doubt.nodes);
  selectedByIt_ = parts_.document.selection().nodes();
  parts_.editing.actOnSelected();
  const Sight sight = sightOf(skeleton, doubt);
  const Camera camera = parts_.view.cameraToSee(sight);
  QStringList notes;
  const QUndoStack& stack = parts_.document.undoStack();
  if (std::exchange(isEdited_, false) && stack.index() > 0 && !stack.canRedo())
    notes.append(stack.text(stack.index() - 1));
  if (const QString note = parts_.reveal(woodSeenWith(skeleton, doubt), sight.places, camera);
      !note.isEmpty())
    notes.append(note);
  parts_.view.flyTo(camera, focusOn(skeleton, sight));
  emit noted(notes.join(QStringLiteral(" · "))); // or what is asked is seen in the status line
}

bool AskingFlow::requireDrawn() {
  constexpr qint64 longest = 1000; // [ms]: no answer is refused for longer, whatever is drawn
  if (parts_.view.framesAtRest() != framesBefore_ || sinceAsked_.elapsed() > longest) return true;
  parts_.view.setCamera(parts_.view.camera());
  emit noted(tr("Not answered: the question was not drawn yet. Answer it now"));
  return false;
}

void AskingFlow::answer(std::size_t number) {
  if (!current_ || number >= current_->alternatives.size() || !requireDrawn()) return;
  const Doubt doubt = *current_;
  isEdited_ = false;
  {
    const QScopedValueRollback own(isOwnEdit_, true);
    parts_.doubts.answer(doubt, numbered(doubt)[number]);
  }
  asked_.push_back(doubt);
  current_.reset();
  goOn();
}

void AskingFlow::answerNone() {
  if (!current_ || !requireDrawn()) return;
  const QScopedValueRollback own(isOwnEdit_, true);
  parts_.doubts.answerNone(*current_);
  asked_.push_back(*current_);
  isByHand_ = true;
  draw();
  emit asked(current_, true);
  refreshEnabled();
  emit hintChanged();
}

void AskingFlow::skip() {
  isEdited_ = false;
  if (current_ && !isByHand_) skipped_.push_back(*current_);
  current_.reset();
  goOn();
}

void AskingFlow::takeBack() {
  isEdited_ = false;
  AnsweredDoubt last;
  {
    const QScopedValueRollback own(isOwnEdit_, true);
    last = parts_.doubts.takeBack();
  }
  const auto at = std::find_if(asked_.rbegin(), asked_.rend(),
                               [&](const Doubt& one) { return isAbout(last, one, 0); });
  const std::optional<Doubt> doubt = at != asked_.rend() ? std::optional(*at) : std::nullopt;
  if (doubt) asked_.erase(std::next(at).base(), asked_.end());
  current_.reset();
  if (doubt && isThere(*doubt, parts_.document.skeleton())) return goTo(*doubt);
  goOn();
}

/// Any edit of the wood that is asked about, of more than its radii, answers once it is done.
void AskingFlow::noteEdit(const SkeletonDelta& delta) {
  if (isRestShown_) stopAsking();
  if (!isAsking_ || isOwnEdit_ || !current_) return;
  isEdited_ = true;
  const bool isOfIt =
      std::ranges::any_of(delta.changes, [this](const SkeletonDelta::Change& change) {
        return changesCourse(change) &&
               std::ranges::find(current_->nodes, change.id) != current_->nodes.end();
      });
  if (!isOfIt && isThere(*current_, parts_.document.skeleton())) return;
  isWoodEdited_ = isOfIt || (isWoodEdited_ && editEnds_.isActive());
  parts_.view.showGhosts({}); // they are of the wood as it was
  for (QAction* answer : answers_)
    answer->setEnabled(false);
  editEnds_.start();
}

void AskingFlow::takeEdit() {
  if (parts_.editing.isBusy()) return; // in mid-drag
  editEnds_.stop();
  if (!current_) return;
  const QUndoStack& stack = parts_.document.undoStack();
  const bool isNewStep = stack.index() == stack.count() &&
                         lastStepOf(parts_.document) != stepBefore_ &&
                         parts_.document.isDone(lastStepOf(parts_.document));
  const bool isAnswer = isNewStep && isWoodEdited_ &&
                        (stepBefore_ == StepId{} || parts_.document.isDone(stepBefore_));
  if (isByHand_) return; // one goes on by a key
  const Doubt doubt = *current_;
  const bool wasWrong = isMadeOtherwise();
  current_.reset();
  if (isAnswer) {
    parts_.doubts.takeEdit(doubt, taught_, wasWrong);
    asked_.push_back(doubt);
  }
  goOn();
}

bool AskingFlow::isMadeOtherwise() const {
  const Skeleton& skeleton = parts_.document.skeleton();
  std::vector<NodeId> left = current_->nodes;
  std::erase_if(left, [&](NodeId id) { return !skeleton.contains(id); });
  if (2 * left.size() < current_->nodes.size() || left.empty()) return true;
  std::optional<NodeId> foot = skeleton[left.front()].parent;
  while (foot && indexOf(*foot) >= idEnd_) // nodes that were put between
    foot = skeleton[*foot].parent;
  return foot != foot_;
}

void AskingFlow::decideRest() {
  if (isAsking_) stopAsking();
  const std::size_t changes = parts_.doubts.decidedByOdds().size();
  if (changes == 0) {
    if (isRestShown_) stopAsking();
    emit noted(parts_.doubts.isBusy() ? tr("Looking for doubts…")
                                      : tr("The odds would change nothing of what is left"));
    return;
  }
  if (!isRestShown_) {
    emit begun();
    isRestShown_ = true;
    draw();
    parts_.view.frameAll();
    emit noted(changes == 1
                   ? tr("1 change is shown. To make it, choose Decide the Rest by Odds again; Esc "
                        "drops it")
                   : tr("%1 changes are shown. To make them, choose Decide the Rest by Odds again; "
                        "Esc drops them")
                         .arg(formatCount(changes)));
    emit hintChanged();
    return;
  }
  isRestShown_ = false;
  draw();
  emit hintChanged();
  const std::size_t made = parts_.doubts.decideRest();
  emit reported({.text = made == 1
                             ? tr("1 place is decided by its odds")
                             : tr("%1 places are decided by their odds").arg(formatCount(made)),
                 .isStep = true});
}

void AskingFlow::followDoubts() {
  refreshEnabled();
  if (isRestShown_) draw();
  if (!isAsking_ || isOwnEdit_) return;
  if (current_ && isByHand_ && !parts_.doubts.isAnswered(*current_)) return askAgain();
  if (editEnds_.isActive() || parts_.doubts.isBusy()) return;
  const bool isSettled = current_ && !isByHand_ && !parts_.doubts.isListed(*current_);
  if (isSettled || std::exchange(isAwaited_, false)) goOn(); // it was marked, or drawn by hand
}

void AskingFlow::askAgain() {
  std::erase_if(asked_, [this](const Doubt& one) { return isSame(one, *current_, 0); });
  const Doubt doubt = *current_;
  if (isThere(doubt, parts_.document.skeleton())) return goTo(doubt);
  current_.reset();
  goOn();
}

QString AskingFlow::failureText() const {
  return tr("The search for doubts did not end: %1.").arg(parts_.doubts.failure()) + ' ' +
         withKeys(tr("{ask_doubts} searches again"), parts_.actions);
}

QString AskingFlow::hint() const {
  if (isRestShown_)
    return withKeys(
        tr("Choose Decide the Rest by Odds again to make the changes   {leave} drops them"),
        parts_.actions);
  if (!isAsking_ || parts_.editing.isPending()) return {};
  if (isByHand_)
    return withKeys(tr("Correct it with any tool   {skip_doubt} goes on   {take_back_answer} takes "
                       "back   {leave} ends"),
                    parts_.actions);
  if (!current_) return withKeys(tr("Looking for doubts…   {leave} ends"), parts_.actions);
  QStringList parts;
  for (const std::size_t i : numbered(*current_))
    parts.append(
        QString("%1 %2").arg(parts.size() + 1).arg(textOf(*current_, current_->alternatives[i])));
  parts.append(withKeys(
      tr("{answer_none} none   {skip_doubt} skip   {take_back_answer} back   {leave} ends"),
      parts_.actions));
  return parts.join("   ");
}

} // namespace espalier
