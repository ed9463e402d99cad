#include "ui/document/plant_document.h"

#include <QUndoCommand>

#include <utility>

namespace espalier {

/// The one kind of undo step.
class PlantDocument::EditSkeleton final : public QUndoCommand {
public:
  /// pre: `delta` is applied already
  EditSkeleton(PlantDocument& document, const QString& text, SkeletonDelta delta, Gesture gesture)
      : QUndoCommand(text), document_(document), delta_(std::move(delta)), gesture_(gesture) {}

  [[nodiscard]] int id() const override { return gesture_.id(); }

  void redo() override { // QUndoStack::push calls it once for the edit that was made already
    if (isNew_)
      document_.announce(delta_);
    else
      document_.apply(delta_);
    isNew_ = false;
  }

  void undo() override {
    document_.apply(delta_.inverse());
    if (document_.isCanceling_) setObsolete(true);
  }

  bool mergeWith(const QUndoCommand* next) override { // called for equal ids only
    delta_ = delta_.then(static_cast<const EditSkeleton*>(next)->delta_);
    setObsolete(delta_.isEmpty()); // dragged back to where it was
    return true;
  }

private:
  PlantDocument& document_;
  SkeletonDelta delta_;
  Gesture gesture_;
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
  SkeletonEditor editor(structure_.skeleton);
  change(editor); // if it throws, the editor rolls back
  SkeletonDelta delta = editor.commit();
  if (delta.isEmpty()) return; // a click that moved nothing is no step
  undoStack_.push(new EditSkeleton(*this, text, std::move(delta), gesture)); // the stack owns it
}

void PlantDocument::cancel(Gesture gesture) {
  const int last = undoStack_.index() - 1;
  if (gesture.isNone() || last < 0 || undoStack_.command(last)->id() != gesture.id()) return;
  isCanceling_ = true;
  undoStack_.undo();
  isCanceling_ = false;
}

void PlantDocument::setScan(std::unique_ptr<const Scan> scan, const QString& path) {
  const bool hadContracted = contracted_ != nullptr;
  scan_ = std::move(scan);
  scanPath_ = path;
  contracted_.reset();
  if (hadContracted) emit contractedChanged();
  emit scanChanged();
  emit titleChanged();
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

void PlantDocument::openSkeleton(Skeleton skeleton, const QString& path) {
  openStructure({std::move(skeleton)}, path);
}

void PlantDocument::openStructure(Structure structure, const QString& path) {
  selection_.clear();
  structure_ = std::move(structure);
  filePath_ = path;
  undoStack_.clear();
  emit skeletonReplaced();
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
}

void PlantDocument::apply(const SkeletonDelta& delta) {
  delta.apply(structure_.skeleton);
  announce(delta);
}

void PlantDocument::announce(const SkeletonDelta& delta) {
  emit skeletonEdited(delta);
  selection_.keepThoseIn(structure_.skeleton);
}

} // namespace espalier
