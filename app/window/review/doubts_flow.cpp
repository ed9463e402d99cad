#include "app/window/review/doubts_flow.h"

#include "core/base/error.h"
#include "core/base/spatial_index.h"
#include "core/decide/error_ratings.h"
#include "core/doubt/find_doubts.h"
#include "core/graph/turn_upright.h"
#include "ui/document/doubt_text.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace espalier {
namespace {

constexpr auto keptName = "answered_doubts";

bool isReviewed(const Doubt& doubt, const Skeleton& skeleton) {
  return std::ranges::any_of(doubt.nodes, [&](NodeId id) {
    return skeleton.contains(id) && skeleton[id].review.state == ReviewState::reviewed;
  });
}

/// Whether its wood was drawn by hand, or attached by hand where it is.
bool isByHand(const Doubt& doubt, const MadeByHand& made) {
  const auto isDrawn = [&](NodeId id) { return made.isDrawn[indexOf(id)]; };
  if (doubt.kind == Doubt::Kind::missing) return false;
  if (doubt.kind == Doubt::Kind::end) return std::ranges::any_of(doubt.nodes, isDrawn);
  return isDrawn(doubt.node) || made.isAttached[indexOf(doubt.node)];
}

/// What an answer or a doubt is about, that is kept.
AnsweredDoubt keptOf(const Doubt& doubt) {
  AnsweredDoubt kept{.kind = doubt.kind, .node = doubt.node};
  const auto added =
      std::ranges::find(doubt.alternatives, Alternative::Kind::add, &Alternative::kind);
  if (added == doubt.alternatives.end()) return kept;
  std::tie(kept.foot, kept.tip) = *endsOfAdded(doubt);
  Eigen::AlignedBox3d box;
  for (const NodeId id : added->branch->part.ids())
    box.extend(added->branch->part[id].position);
  kept.box = {box.min(), box.max()};
  return kept;
}

} // namespace

DoubtsFlow::DoubtsFlow(const Parts& parts)
    : parts_(parts), job_(parts.queue, JobPriority::background, this) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &DoubtsFlow::refresh);
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, this, &DoubtsFlow::take);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::leftOutChanged, &PlantDocument::upChanged})
    connect(&document, signal, this, &DoubtsFlow::dropAll);
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    answered_.clear(); // a project shows its own once its skeleton is there
    learnAnew();
  });
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (!answered_.empty()) learnAnew(); // a step may be undone
  });
  connect(&parts_.distances, &ScanDistances::changed, this, [this] {
    if (!uses_.empty() && isOutdated_) timer_.start(0);
  });
  connect(&job_, &JobSlot::failed, this, [this](const QString& message) { failure_ = message; });
  connect(&job_, &JobSlot::finished, this, [this] {
    const bool isFoundAnew = std::exchange(isReplaced_, false);
    if (job_.isCanceled() && !isFoundAnew) failure_ = tr("it was stopped");
    emit changed();
  });
  keepInProject({.name = keptName,
                 .text = [this] { return textOf(answered_); },
                 .show =
                     [this](const std::string& text) {
                       answered_.clear();
                       learnAnew();
                       answered_ = answeredFrom(text);
                       learnAnew();
                     }});
}

void DoubtsFlow::setWanted(Use use, bool isWanted) {
  const bool wasWanted = !uses_.empty();
  if (isWanted)
    uses_.insert(use);
  else
    uses_.erase(use);
  if (wasWanted == !uses_.empty()) return;
  parts_.distances.setWanted(ScanDistances::Use::doubts, !uses_.empty());
  if (!uses_.empty() && isOutdated_) timer_.start(0);
}

bool DoubtsFlow::isBusy() const {
  return !uses_.empty() && isOutdated_ && failure_.isEmpty() && hasSpacing() &&
         !parts_.document.skeleton().isEmpty();
}

bool DoubtsFlow::hasSpacing() const {
  return parts_.document.scale().spacing > 0; // 0 also without a scan
}

void DoubtsFlow::findAgain() {
  if (failure_.isEmpty()) return;
  failure_.clear();
  isOutdated_ = true;
  timer_.start(0);
  emit changed();
}

void DoubtsFlow::take(const SkeletonDelta& delta) {
  std::vector<bool> isChanged(parts_.document.skeleton().idEnd(), false); // by id
  for (const SkeletonDelta::Change& change : delta.changes)
    if (changesWood(change) && indexOf(change.id) < isChanged.size())
      isChanged[indexOf(change.id)] = true;
  const auto isTouched = [&](const Doubt& doubt) {
    const auto at = [&](NodeId id) {
      return indexOf(id) < isChanged.size() && isChanged[indexOf(id)];
    };
    return at(doubt.node) || std::ranges::any_of(doubt.nodes, at);
  };
  if (std::ranges::any_of(delta.changes, changesWood)) {
    std::erase_if(found_, [&](const Doubt& doubt) {
      return isTouched(doubt) || !isThere(doubt, parts_.document.skeleton());
    });
    outdate();
  }
  list();
}

void DoubtsFlow::findAnew() {
  outdate();
  emit changed();
}

void DoubtsFlow::outdate() {
  isOutdated_ = true;
  failure_.clear();
  ++changes_;
  if (!uses_.empty()) timer_.start(100); // [ms]: a drag is looked at when it rests
}

void DoubtsFlow::dropAll() {
  found_.clear();
  ratings_.reset();
  isOutdated_ = true;
  failure_.clear();
  ++changes_;
  isReplaced_ = job_.isBusy();
  job_.cancel();
  if (!uses_.empty()) timer_.start(0);
  list();
}

void DoubtsFlow::refresh() {
  const std::shared_ptr<const PointDistances> distances = parts_.distances.now();
  if (uses_.empty() || !isOutdated_ || !distances || !hasSpacing()) return;
  failure_.clear();
  isReplaced_ = false;
  job_.start(
      tr("Looking for doubts"),
      [distances, skeleton = parts_.document.skeleton(), scale = parts_.document.scale(),
       limits = parts_.limits(),
       up = Eigen::Vector3d(turnUpright(parts_.document.up()).row(2).transpose())](
          const Progress& progress) {
        const SpatialIndex index(distances->cloud()->positions(), progress);
        return FoundDoubts{
            findDoubts(skeleton,
                       {.distances = *distances,
                        .index = index,
                        .scale = scale,
                        .up = up,
                        .limits = limits},
                       progress.part(0, 0.5)),
            errorRatings(skeleton, *distances, index, scale, up, progress.part(0.5, 1))};
      },
      [this, changes = changes_](FoundDoubts found) {
        ratings_ = std::move(found.ratings);
        found_ = std::move(found.doubts);
        std::erase_if(found_, [this](const Doubt& doubt) {
          return !isThere(doubt, parts_.document.skeleton());
        });
        isOutdated_ = changes != changes_; // it was edited meanwhile
        if (isOutdated_) timer_.start(0);
        list();
      });
}

/// What is still to be asked: neither answered, ignored, reviewed nor decided by hand. Wood that is
/// doubtful, as what would bear a missing branch may be, is asked about.
void DoubtsFlow::list() {
  const double spacing = parts_.document.scale().spacing;
  const Skeleton& skeleton = parts_.document.skeleton();
  if (ratings_) byHand_ = madeByHand(parts_.document);
  std::vector<Doubt> left;
  std::vector<Doubt> ignored;
  for (const Doubt& doubt : found_) {
    if (isReviewed(doubt, skeleton) || isByHand(doubt, byHand_)) continue;
    const auto answered = std::ranges::find_if(
        held_, [&](const AnsweredDoubt& one) { return isAbout(one, doubt, 4 * spacing); });
    if (answered == held_.end())
      left.push_back(doubt);
    else if (leavesOut(*answered))
      ignored.push_back(doubt);
  }
  doubts_ = learned_.adjusted(std::move(left), spacing);
  ignored_ = learned_.adjusted(std::move(ignored), spacing);
  emit changed();
}

void DoubtsFlow::ignore(const Doubt& doubt) {
  AnsweredDoubt ignored = keptOf(doubt);
  ignored.isIgnored = true;
  note(ignored, doubt);
}

std::vector<AnsweredDoubt> DoubtsFlow::stopIgnoring(const Doubt& doubt) {
  const double near = 4 * parts_.document.scale().spacing;
  std::vector<AnsweredDoubt> left, taken;
  for (AnsweredDoubt& one : answered_)
    (leavesOut(one) && isAbout(one, doubt, near) ? taken : left).push_back(std::move(one));
  answered_ = std::move(left);
  learnAnew();
  keepAnswers();
  return taken;
}

void DoubtsFlow::restore(const std::vector<AnsweredDoubt>& taken) {
  answered_.insert(answered_.end(), taken.begin(), taken.end());
  learnAnew();
  keepAnswers();
}

bool DoubtsFlow::isLeftOut(const Finding& finding) const {
  const double spacing = parts_.document.scale().spacing;
  return std::ranges::any_of(held_, [&](const AnsweredDoubt& one) {
    return leavesOut(one) && isAbout(one, finding, spacing);
  });
}

bool DoubtsFlow::isListed(const Doubt& doubt) const {
  const double near = 4 * parts_.document.scale().spacing;
  return std::ranges::any_of(doubts_, [&](const Doubt& one) { return isSame(one, doubt, near); });
}

bool DoubtsFlow::holds(const AnsweredDoubt& answered) const {
  return answered.step == StepId{} || parts_.document.isDone(answered.step);
}

void DoubtsFlow::learnAnew() {
  std::vector<AnsweredDoubt> held;
  std::vector<LearnedAnswer> answers;
  for (const AnsweredDoubt& answered : answered_) {
    if (!holds(answered)) continue;
    held.push_back(answered);
    if (!answered.isIgnored) answers.push_back(answered.learned);
  }
  if (held == held_) return;
  held_ = std::move(held);
  learned_ = LearnedOdds(std::move(answers));
  list();
}

LearnedAnswer DoubtsFlow::learnedOf(const Doubt& doubt) const {
  const auto fitted =
      std::ranges::find_if(found_, [&](const Doubt& other) { return isSame(doubt, other, 0); });
  return learnedFrom(fitted != found_.end() ? *fitted : doubt, false,
                     parts_.document.scale().spacing);
}

void DoubtsFlow::note(const Doubt& doubt, LearnedAnswer learned, bool wasWrong, StepId step) {
  AnsweredDoubt answered = keptOf(doubt);
  answered.learned = learned;
  answered.learned.wasWrong = wasWrong;
  answered.step = step;
  note(answered, doubt);
}

void DoubtsFlow::note(AnsweredDoubt answered, const Doubt& doubt) {
  const double near = 4 * parts_.document.scale().spacing;
  std::erase_if(answered_, [&](const AnsweredDoubt& before) { // undone, and answered otherwise now
    return leavesOut(before) ? isAbout(before, doubt, near)
                             : !holds(before) && isAbout(before, doubt, 0);
  });
  answered_.push_back(std::move(answered));
  learnAnew();
  keepAnswers();
}

void DoubtsFlow::keepAnswers() {
  emit keptChanged();
  parts_.writeNow(keptName);
}

StepId DoubtsFlow::editAs(const QString& text, const std::function<void(SkeletonEditor&)>& change) {
  PlantDocument& document = parts_.document;
  const int before = document.undoStack().index();
  document.edit(text, change);
  const int now = document.undoStack().index();
  return now > before ? document.step(now - 1).id : StepId{};
}

void DoubtsFlow::answer(const Doubt& asked, std::size_t alternative) {
  const Doubt doubt = asked; // an edit lists others
  const LearnedAnswer learned = learnedOf(doubt);
  parts_.document.requireEditable();
  const StepId step = editAs(tr("Answer: %1").arg(textOf(doubt, doubt.alternatives[alternative])),
                             [&](SkeletonEditor& editor) {
                               settle(editor, doubt, doubt.alternatives[alternative],
                                      parts_.reviewer().toStdString());
                             });
  note(doubt, learned, alternative != doubt.present, step);
}

void DoubtsFlow::answerNone(const Doubt& asked) {
  const Doubt doubt = asked;
  const LearnedAnswer learned = learnedOf(doubt);
  parts_.document.requireEditable();
  const StepId step = editAs(tr("Answer: none of these"), [&](SkeletonEditor& editor) {
    const std::vector<NodeId> bearer = {doubt.node};
    for (const NodeId id : doubt.nodes.empty() ? bearer : doubt.nodes)
      editor.setReview(id, {.state = ReviewState::doubtful,
                            .comment = editor.skeleton()[id].review.comment,
                            .reviewer = parts_.reviewer().toStdString()});
  });
  note(doubt, learned, true, step);
}

void DoubtsFlow::takeEdit(const Doubt& doubt, LearnedAnswer learned, bool wasWrong) {
  const int now = parts_.document.undoStack().index();
  note(doubt, learned, wasWrong, now > 0 ? parts_.document.step(now - 1).id : StepId{});
}

bool DoubtsFlow::isAnswered(const Doubt& doubt) const {
  return std::ranges::any_of(held_, [&](const AnsweredDoubt& answered) {
    return !answered.isIgnored && isAbout(answered, doubt, 0);
  });
}

SealedQuestions DoubtsFlow::questions() const {
  const auto isAnswer = [](const AnsweredDoubt& one) { return !one.isIgnored; };
  SealedQuestions questions{.answered =
                                static_cast<std::size_t>(std::ranges::count_if(held_, isAnswer))};
  if (isKnown()) questions.open = doubts_.size();
  return questions;
}

AnsweredDoubt DoubtsFlow::takeBack() {
  const auto at = std::find_if_not(held_.rbegin(), held_.rend(),
                                   [](const AnsweredDoubt& one) { return one.isIgnored; });
  if (at == held_.rend()) throw Error(tr("no answer is left to be taken back").toStdString());
  AnsweredDoubt last = *at;
  QUndoStack& stack = parts_.document.undoStack();
  if (last.step != StepId{}) {
    parts_.document.requireEditable();
    if (stack.index() == 0 || parts_.document.step(stack.index() - 1).id != last.step)
      throw Error(tr("other edits came after that answer: undo them first").toStdString());
    stack.undo(); // learns anew; redo answers again
  } else {
    std::erase(answered_, last);
    learnAnew();
  }
  list();
  keepAnswers();
  return last;
}

std::vector<Doubt> DoubtsFlow::decidedByOdds() const {
  Skeleton plant = parts_.document.skeleton();
  SkeletonEditor editor(plant);
  std::vector<Doubt> decided;
  for (const std::size_t i : decideByOdds(editor, doubts_))
    decided.push_back(doubts_[i]);
  return decided;
}

std::size_t DoubtsFlow::decideRest() {
  std::size_t changed = 0;
  const std::vector<Doubt> rest = doubts_;
  parts_.document.edit(tr("Decide by odds"), [&](SkeletonEditor& editor) {
    changed = decideByOdds(editor, rest).size();
  });
  return changed;
}

std::optional<ExpectedAgreement> DoubtsFlow::expected() const {
  const Skeleton& skeleton = parts_.document.skeleton();
  if (!ratings_ || ratings_->ofEdges.size() < skeleton.idEnd()) return std::nullopt;
  return expectedAgreement(skeleton, ratingsNow(), doubts_);
}

/// What was drawn by hand counts as right.
ErrorRatings DoubtsFlow::ratingsNow() const {
  ErrorRatings ratings = *ratings_;
  for (std::size_t i = 0; i < std::min(byHand_.isDrawn.size(), ratings.ofEdges.size()); ++i)
    if (byHand_.isDrawn[i]) ratings.ofEdges[i] = 0;
  return ratings;
}

std::size_t DoubtsFlow::answersFor(double share) const {
  return espalier::answersFor(share, parts_.document.skeleton(), ratingsNow(), doubts_);
}

} // namespace espalier
