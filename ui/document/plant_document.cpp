#include "ui/document/plant_document.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"

#include <QDateTime>
#include <QRandomGenerator>
#include <QUndoCommand>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace espalier {
namespace {

/// The changes of several steps, one after the other, as one: from the first state of each node to
/// the one it has now.
SkeletonDelta joined(const SkeletonDelta& steps, const Skeleton& now) {
  SkeletonDelta result;
  std::unordered_set<std::uint32_t> seen;
  for (const SkeletonDelta::Change& change : steps.changes) {
    if (!seen.insert(static_cast<std::uint32_t>(change.id)).second) continue;
    std::optional<Node> after;
    if (now.contains(change.id)) after = now[change.id];
    if (change.before != after) result.changes.push_back({change.id, change.before, after});
  }
  return result;
}

/// Contracted points of a scan as those of one that has grown: see PlantDocument::growScan(). Steps
/// that shared theirs do so still.
class GrownContracted {
public:
  using Positions = std::shared_ptr<const Eigen::Matrix3Xf>;

  GrownContracted(const PointCloud& before, const PointCloud& now)
      : shift_((before.origin() - now.origin()).cast<float>()), now_(now) {}

  [[nodiscard]] Positions of(const Positions& before) {
    if (!before) return nullptr;
    Positions& grown = made_[before.get()];
    if (grown) return grown;
    auto made = std::make_shared<Eigen::Matrix3Xf>(now_.positions());
    made->leftCols(before->cols()) = before->colwise() + shift_;
    grown = std::move(made);
    return grown;
  }

private:
  Eigen::Vector3f shift_; // of what places are counted from
  const PointCloud& now_;
  std::unordered_map<const Eigen::Matrix3Xf*, Positions> made_;
};

/// Drawn from so many that none comes twice, not even in copies of a project.
StepId newStepId() {
  return StepId{QRandomGenerator::global()->generate64() >> 1}; // integers of SQLite have a sign
}

} // namespace

/// The one kind of undo step.
class PlantDocument::EditSkeleton final : public QUndoCommand {
public:
  /// pre: the delta is applied already, or the document is restoring
  EditSkeleton(PlantDocument& document, HistoryStep step, Gesture gesture,
               std::optional<ContractedChange> contracted = std::nullopt)
      : QUndoCommand(QString::fromStdString(step.text)), document_(document),
        step_(std::move(step)), gesture_(gesture), contracted_(std::move(contracted)) {}

  [[nodiscard]] int id() const override { return gesture_.id(); }
  [[nodiscard]] const HistoryStep& step() const { return step_; }

  void redo() override { // QUndoStack::push calls it once for the edit that was made already
    if (contracted_) document_.applyContracted(contracted_->after);
    if (step_.envelope) document_.applyEnvelope(step_.envelope->after);
    document_.applyOrgans(step_.organs);
    if (!document_.isRestoring_) {
      if (isNew_)
        document_.announce(step_.delta);
      else
        document_.apply(step_.delta);
      document_.setLeftOut(document_.leftOut_ ^ step_.points);
    }
    isNew_ = false;
  }

  void undo() override {
    if (contracted_) document_.applyContracted(contracted_->before);
    if (step_.envelope) document_.applyEnvelope(step_.envelope->before);
    document_.applyOrgans(step_.organs);
    if (document_.isRestoring_) return;
    document_.apply(step_.delta.inverse());
    document_.setLeftOut(document_.leftOut_ ^ step_.points);
    if (document_.isCanceling_) setObsolete(true);
  }

  bool mergeWith(const QUndoCommand* next) override { // called for equal ids only
    const HistoryStep& added = static_cast<const EditSkeleton*>(next)->step_;
    step_.id = added.id; // what it was before is no step any more
    step_.delta = step_.delta.then(added.delta);
    step_.points = step_.points ^ added.points;
    step_.organs = step_.organs ^ added.organs;
    if (added.envelope) goOnTo(added);
    setObsolete(isNothing()); // dragged back to where it was
    return true;
  }

  void growContracted(GrownContracted& grown) {
    if (contracted_) contracted_ = {grown.of(contracted_->before), grown.of(contracted_->after)};
  }

  /// Another scan has come: this step has none of its points any more.
  void forgetPoints() {
    step_.id = newStepId();
    step_.points = {};
    step_.organs = {};
    setObsolete(isNothing());
  }

private:
  [[nodiscard]] bool isNothing() const {
    return step_.delta.isEmpty() && step_.points.isEmpty() && step_.organs.isEmpty() &&
           !step_.envelope;
  }
  /// The envelope is chosen further, and named by what it is last.
  void goOnTo(const HistoryStep& next) {
    step_.envelope->after = next.envelope->after;
    if (step_.envelope->after == step_.envelope->before) step_.envelope.reset();
    step_.text = next.text;
    setText(QString::fromStdString(next.text));
  }

  PlantDocument& document_;
  HistoryStep step_;
  Gesture gesture_;
  std::optional<ContractedChange> contracted_; // if the step replaces them
  bool isNew_ = true;
};

PlantDocument::PlantDocument(QObject* parent) : QObject(parent) {
  connect(&undoStack_, &QUndoStack::cleanChanged, this, &PlantDocument::titleChanged);
}

PlantDocument::~PlantDocument() {
  undoStack_.disconnect(this); // it clears itself when members of this are gone
}

void PlantDocument::edit(const QString& text, const std::function<void(SkeletonEditor&)>& change,
                         Gesture gesture) {
  requireEditable();
  SkeletonEditor editor(structure_.skeleton);
  change(editor); // if it throws, the editor rolls back
  SkeletonDelta delta = editor.commit();
  if (delta.isEmpty()) return; // a click that moved nothing is no step
  push(text, {.delta = std::move(delta)}, gesture);
}

void PlantDocument::leaveOut(const QString& text, const PointSet& points) {
  requireWritable();
  if (points != leftOut_) push(text, {.points = points ^ leftOut_});
}

void PlantDocument::setOrgans(const QString& text, const PointSet& points,
                              std::optional<Organ> organ) {
  requireWritable();
  const OrganMarks change = organs_.with(points, organ) ^ organs_;
  if (!change.isEmpty()) push(text, {.organs = change});
}

StepId PlantDocument::reconstruct(const QString& text, const Skeleton& skeleton,
                                  std::shared_ptr<const Eigen::Matrix3Xf> contracted) {
  SkeletonEditor editor(structure_.skeleton);
  replaceSkeleton(editor, skeleton);
  return push(text, {.delta = editor.commit(),
                     .contracted = ContractedChange{contracted_, std::move(contracted)}});
}

void PlantDocument::contract(const QString& text,
                             std::shared_ptr<const Eigen::Matrix3Xf> contracted) {
  requireWritable();
  push(text, {.contracted = ContractedChange{contracted_, std::move(contracted)}});
}

void PlantDocument::setEnvelope(const QString& text, const std::string& envelope, Gesture gesture) {
  if (envelope == envelope_) return;
  if (isReadOnly()) return applyEnvelope(envelope);
  push(text, {.envelope = EnvelopeChange{.before = envelope_, .after = envelope}}, gesture);
}

void PlantDocument::openEnvelope(const std::string& envelope) {
  for (int i = 0; i < undoStack_.count(); ++i)
    if (step(i).envelope) return;
  applyEnvelope(envelope);
}

void PlantDocument::cancel(Gesture gesture) {
  const int last = undoStack_.index() - 1;
  if (gesture.isNone() || last < 0 || undoStack_.command(last)->id() != gesture.id()) return;
  isCanceling_ = true;
  undoStack_.undo();
  isCanceling_ = false;
}

void PlantDocument::goTo(int index) {
  if (index == undoStack_.index()) return;
  requireEditable();
  jump_ = Jump{std::abs(index - undoStack_.index()), {}, contracted_, envelope_, organs_};
  undoStack_.setIndex(index);
  jump_.reset();
}

StepId PlantDocument::contractedStep() const {
  for (int i = undoStack_.index(); i-- > 0;)
    if (step(i).replacesContracted) return step(i).id;
  return {};
}

PlantScale PlantDocument::scale() const {
  if (!scan_) return {};
  return {.spacing = scan_->spacing(),
          .height = scan_->height(up_),
          .thickness = scan_->wood().thickness,
          .scatter = scan_->wood().scatter};
}

void PlantDocument::setScan(std::unique_ptr<const Scan> scan, const QString& path) {
  pointSelection_.clear();
  forgetPoints();
  setRoot(std::nullopt);
  replaceScan(std::move(scan), path);
}

void PlantDocument::setFoundScan(std::unique_ptr<const Scan> scan, const QString& path) {
  replaceScan(std::move(scan), path);
}

void PlantDocument::growScan(std::unique_ptr<const Scan> scan, const QString& path) {
  const std::shared_ptr<const PointCloud> before = scan_->cloud();
  GrownContracted grown(*before, *scan->cloud());
  for (int i = 0; i < undoStack_.count(); ++i)                   // as in forgetPoints()
    const_cast<EditSkeleton&>(command(i)).growContracted(grown); // NOLINT
  contracted_ = grown.of(contracted_);
  leftOut_ =
      leftOut_ | (PointSet::firstOf(scan->cloud()->size()) - PointSet::firstOf(before->size()));
  scan_ = std::make_unique<const Scan>(scan->leavingOut(leftOut_));
  scanPath_ = path;
  emit scanChanged();
  emit leftOutChanged();
  emit contractedChanged();
  emit titleChanged();
}

void PlantDocument::replaceScan(std::unique_ptr<const Scan> scan, const QString& path) {
  const bool hadContracted = contracted_ != nullptr;
  scan_ = std::move(scan);
  if (scan_ && !leftOut_.isEmpty())
    scan_ = std::make_unique<const Scan>(scan_->leavingOut(leftOut_));
  scanPath_ = path;
  contracted_.reset();
  if (hadContracted) emit contractedChanged();
  emit scanChanged();
  emit titleChanged();
}

void PlantDocument::forgetPoints() {
  for (int i = 0; i < undoStack_.count(); ++i) {
    if (step(i).points.isEmpty() && step(i).organs.isEmpty()) continue;
    opened_ = std::min(opened_, i);
    // The stack hands its commands out to look at; they are this document's own.
    const_cast<EditSkeleton&>(command(i)).forgetPoints(); // NOLINT
  }
  setLeftOut({});
  applyOrgans(organs_); // by themselves: none
}

void PlantDocument::setLeftOut(const PointSet& points) {
  if (points == leftOut_) return;
  leftOut_ = points;
  if (scan_) scan_ = std::make_unique<const Scan>(scan_->leavingOut(leftOut_));
  pointSelection_.set(pointSelection_.points() - leftOut_);
  emit leftOutChanged();
}

void PlantDocument::setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions) {
  contracted_ = std::move(positions);
  emit contractedChanged();
}

void PlantDocument::setUnit(LengthUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  emit unitChanged();
}

void PlantDocument::setUp(UpAxis up) {
  if (up == up_) return;
  up_ = up;
  emit upChanged();
}

void PlantDocument::setRoot(const std::optional<Eigen::Vector3d>& root) {
  if (root == root_) return;
  root_ = root;
  emit rootChanged();
}

void PlantDocument::openSkeleton(Skeleton skeleton, const QString& path) {
  openStructure({std::move(skeleton)}, path);
}

void PlantDocument::openStructure(Structure structure, const QString& path) {
  selection_.clear();
  undoStack_.clear(); // of the skeleton that is there still: who hears of it may look at both
  structure_ = std::move(structure);
  filePath_ = path;
  opened_ = 0;
  emit skeletonReplaced();
  emit titleChanged();
}

void PlantDocument::openHistory(History history, std::shared_ptr<const MtgFrame> frame,
                                const QString& path, const ContractedPoints& contracted) {
  openStructure({std::move(history.skeleton), std::move(frame)}, path);
  setLeftOut(history.leftOut);
  applyOrgans(history.organs ^ organs_);
  const auto madeBy = [&](StepId step) {
    return step == contracted.step ? contracted.positions : nullptr;
  };
  isRestoring_ = true;
  const auto before = std::exchange(contracted_, madeBy({}));
  const std::string envelopeBefore = envelope_;
  const std::optional<std::string> envelope = envelopeAfter(history);
  opened_ = static_cast<int>(history.steps.size());
  for (HistoryStep& step : history.steps) {
    std::optional<ContractedChange> change;
    if (step.replacesContracted) change = {contracted_, madeBy(step.id)};
    undoStack_.push(new EditSkeleton(*this, std::move(step), {}, std::move(change)));
  }
  undoStack_.setIndex(static_cast<int>(history.position));
  isRestoring_ = false;
  if (contracted_ != before) emit contractedChanged();
  envelope_ = envelope.value_or(envelopeBefore);
  if (envelope_ != envelopeBefore) emit envelopeChanged();
}

void PlantDocument::setReadOnly(const QString& why) {
  if (why == readOnly_) return;
  readOnly_ = why;
  emit readOnlyChanged();
  emit titleChanged();
}

void PlantDocument::requireWritable() const {
  if (isReadOnly()) throw Error(readOnly_.toStdString());
}

void PlantDocument::requireEditable() const {
  requireWritable();
  if (isHeld()) throw Error(held_.toStdString());
}

void PlantDocument::setSaving(Saving saving) {
  if (saving == saving_) return;
  saving_ = saving;
  emit titleChanged();
}

void PlantDocument::markSaved(const QString& path) {
  filePath_ = path;
  undoStack_.setClean();
  emit titleChanged();
}

void PlantDocument::clear() {
  setScan(nullptr, {});
  openSkeleton({}, {});
  setUnit(LengthUnit::unknown);
  setUp(UpAxis::z);
}

History PlantDocument::history() const {
  History history{.skeleton = skeleton(), .leftOut = leftOut_, .organs = organs_};
  for (int i = 0; i < undoStack_.count(); ++i)
    history.steps.push_back(step(i));
  history.position = static_cast<std::size_t>(undoStack_.index());
  return history;
}

bool PlantDocument::isDone(StepId id) const {
  for (int i = 0; i < undoStack_.index(); ++i)
    if (step(i).id == id) return true;
  return false;
}

const HistoryStep& PlantDocument::step(int index) const {
  return command(index).step();
}

const PlantDocument::EditSkeleton& PlantDocument::command(int index) const {
  return *static_cast<const EditSkeleton*>(undoStack_.command(index));
}

StepId PlantDocument::push(const QString& text, StepContent content, Gesture gesture) {
  const StepId id = newStepId();
  HistoryStep step{.id = id,
                   .text = text.toStdString(),
                   .author = author_.toStdString(),
                   .time = QDateTime::currentMSecsSinceEpoch(),
                   .delta = std::move(content.delta),
                   .points = std::move(content.points),
                   .replacesContracted = content.contracted.has_value(),
                   .envelope = std::move(content.envelope),
                   .organs = std::move(content.organs)};
  opened_ = std::min(opened_, undoStack_.index()); // those undone are dropped
  undoStack_.push(                                 // which owns it
      new EditSkeleton(*this, std::move(step), gesture, std::move(content.contracted)));
  return id;
}

void PlantDocument::apply(const SkeletonDelta& delta) {
  delta.apply(structure_.skeleton);
  if (!jump_) return announce(delta);
  std::ranges::copy(delta.changes, std::back_inserter(jump_->changes.changes));
  if (--jump_->left > 0) return;
  if (contracted_ != jump_->contractedBefore) emit contractedChanged();
  if (envelope_ != jump_->envelopeBefore) emit envelopeChanged();
  if (organs_ != jump_->organsBefore) emit organsChanged();
  const SkeletonDelta all = joined(jump_->changes, structure_.skeleton);
  if (!all.isEmpty()) announce(all);
}

void PlantDocument::applyContracted(const std::shared_ptr<const Eigen::Matrix3Xf>& positions) {
  if (jump_ || isRestoring_)
    contracted_ = positions; // announced at the end
  else
    setContracted(positions);
}

void PlantDocument::applyEnvelope(const std::string& envelope) {
  if (envelope == envelope_) return;
  envelope_ = envelope;
  if (!jump_ && !isRestoring_) emit envelopeChanged(); // else at the end
}

void PlantDocument::applyOrgans(const OrganMarks& change) {
  if (change.isEmpty() || isRestoring_) return; // what is restored has them already
  organs_ = organs_ ^ change;
  if (!jump_) emit organsChanged(); // else at the end
}

void PlantDocument::announce(const SkeletonDelta& delta) {
  if (delta.isEmpty()) return; // a step of points
  emit skeletonEdited(delta);
  selection_.keepThoseIn(structure_.skeleton);
}

} // namespace espalier
