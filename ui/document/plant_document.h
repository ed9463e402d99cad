#pragma once

#include "core/graph/find_root.h"
#include "core/mtg/structure.h"
#include "core/pipeline/option_table.h"
#include "core/project/contracted_points.h"
#include "core/project/history.h"
#include "core/skeleton/skeleton_delta.h"
#include "ui/document/gesture.h"
#include "ui/document/length_unit.h"
#include "ui/document/point_selection.h"
#include "ui/document/scan.h"
#include "ui/document/selection.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// One plant at work: its scan, its contracted points, its skeleton, and the history of its edits.
///
/// All edits of the GUI pass through edit() and come back as one delta each: undo, redo and every
/// view read that delta. The scan never changes; a step may set points of it aside, which then take
/// part in nothing until they are brought back. Contracted points belong to the step of the
/// reconstruction they led to: undo brings back those before. Steps share them, none copies them.
class PlantDocument : public QObject {
  Q_OBJECT

public:
  explicit PlantDocument(QObject* parent = nullptr);
  ~PlantDocument() override;

  [[nodiscard]] const Scan* scan() const { return scan_.get(); } // null: none
  [[nodiscard]] PlantScale scale() const; // that rules of options follow; no scan: PlantScale()
  [[nodiscard]] const std::shared_ptr<const Eigen::Matrix3Xf>& contracted() const {
    return contracted_; // null: none; 3 x N, as the positions of the scan
  }
  [[nodiscard]] const Skeleton& skeleton() const { return structure_.skeleton; }
  /// The skeleton, and the MTG that it was read from, into which edits go back.
  [[nodiscard]] const Structure& structure() const { return structure_; }
  /// The points that are set aside; kept also while the scan itself is not found.
  [[nodiscard]] const PointSet& leftOut() const { return leftOut_; }
  /// Organs of points that were set by hand; likewise.
  [[nodiscard]] const OrganMarks& organs() const { return organs_; }
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] PointSelection& pointSelection() { return pointSelection_; }
  [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }
  [[nodiscard]] const QUndoStack& undoStack() const { return undoStack_; }
  [[nodiscard]] LengthUnit unit() const { return unit_; }
  /// The axis of the file that points up.
  [[nodiscard]] UpAxis up() const { return up_; }
  /// Where the plant is to be rooted, as chosen, [L] in the frame of the file; none: where the scan
  /// is lowest.
  [[nodiscard]] const std::optional<Eigen::Vector3d>& root() const { return root_; }
  [[nodiscard]] bool isModified() const {
    return saving_ == Saving::byHand ? !undoStack_.isClean() : saving_ == Saving::failing;
  }
  [[nodiscard]] bool isEmpty() const { return !scan_ && structure_.skeleton.isEmpty(); }

  /// Where the skeleton was read from or saved to; empty if neither.
  [[nodiscard]] const QString& filePath() const { return filePath_; }
  [[nodiscard]] const QString& scanPath() const { return scanPath_; }

  /// Edits the skeleton, as one undo step named `text`; edits of one gesture become one step. An
  /// edit that changes nothing is no step. If `change` throws, nothing has changed.
  /// @throws Error as requireEditable()
  void edit(const QString& text, const std::function<void(SkeletonEditor&)>& change,
            Gesture gesture = {});

  /// Sets exactly these points aside, as one undo step named `text`; no step if they are already.
  /// @throws Error as requireWritable()
  void leaveOut(const QString& text, const PointSet& points);

  /// Sets the organ of points by hand, or lets it be found again, as one undo step named `text`; no
  /// step if it is so already.
  /// @throws Error as requireWritable()
  void setOrgans(const QString& text, const PointSet& points, std::optional<Organ> organ);

  /// Replaces the skeleton and the contracted points it was made from, as one undo step.
  StepId reconstruct(const QString& text, const Skeleton& skeleton,
                     std::shared_ptr<const Eigen::Matrix3Xf> contracted);

  /// Replaces the contracted points alone, as one undo step.
  /// @throws Error as requireWritable()
  void contract(const QString& text, std::shared_ptr<const Eigen::Matrix3Xf> contracted);

  /// The step done that the contracted points are from; 0 if none replaced them.
  [[nodiscard]] StepId contractedStep() const;

  /// The crown envelope, as a text of the window; empty: none is chosen.
  [[nodiscard]] const std::string& envelope() const { return envelope_; }
  /// Replaces it, as one undo step named `text`; no step if it is that already. Of a plant that is
  /// read-only it is another to look at, without a step.
  void setEnvelope(const QString& text, const std::string& envelope, Gesture gesture = {});
  /// The one that is kept beside the plant: where steps changed it, it follows from these.
  void openEnvelope(const std::string& envelope);

  /// Takes back what the gesture has edited so far, and forgets it.
  void cancel(Gesture gesture);

  /// Undoes or redoes until the first `index` steps are done. Views are notified of it as one
  /// change, however many steps that are. Time O(changes of these steps). pre: 0 <= index <= steps
  /// @throws Error as requireEditable()
  void goTo(int index);

  /// Another scan: drops contracted points, and what was set aside, and the root, of the one
  /// before.
  void setScan(std::unique_ptr<const Scan> scan, const QString& path);
  /// The scan that the steps are of, which was not at hand: what was set aside stays so.
  void setFoundScan(std::unique_ptr<const Scan> scan, const QString& path);
  /// A scan that has the points of the one before in their columns, and behind them others, which
  /// are set aside before the first step and in all. Contracted points, of all steps, get those
  /// others where they were scanned. pre: there is a scan
  void growScan(std::unique_ptr<const Scan> scan, const QString& path);
  void setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions);
  void setUnit(LengthUnit unit);
  void setUp(UpAxis up);
  void setRoot(const std::optional<Eigen::Vector3d>& root);

  /// Shows another structure, read from `path`. It has no history yet.
  void openStructure(Structure structure, const QString& path);
  void openSkeleton(Skeleton skeleton, const QString& path); // the same without an MTG
  /// The same with its history: steps that are not done can be redone. Of the contracted points,
  /// only `contracted` are at hand: other steps that replaced them show none.
  /// pre: each step fits where it stands
  void openHistory(History history, std::shared_ptr<const MtgFrame> frame, const QString& path,
                   const ContractedPoints& contracted = {});
  /// The skeleton as it is now stands in `path`.
  void markSaved(const QString& path);
  /// Why nothing may be edited, for people; empty: it may.
  void setReadOnly(const QString& why);
  [[nodiscard]] bool isReadOnly() const { return !readOnly_.isEmpty(); }
  /// @throws Error why nothing may be edited
  void requireWritable() const;
  /// Why the skeleton is not to be edited for now, for people, as it is not what one sees; empty:
  /// it may. Points can be set aside meanwhile, and the plant made anew.
  void setHeld(const QString& why) { held_ = why; }
  [[nodiscard]] bool isHeld() const { return !held_.isEmpty(); }
  /// @throws Error as requireWritable(), or why the skeleton is held
  void requireEditable() const;

  /// As it happens: no edit is ever unsaved. Failing: it should be so, but the last could not be.
  enum class Saving : std::uint8_t { byHand, asItHappens, failing };
  void setSaving(Saving saving);
  void setAuthor(const QString& author) { author_ = author; } // of the edits to come
  /// A new, empty document.
  void clear();

  /// The steps of the undo stack, to be kept elsewhere.
  [[nodiscard]] History history() const;
  [[nodiscard]] const HistoryStep& step(int index) const; // pre: 0 <= index < undoStack().count()
  /// How many steps from the first on came with the file, and are still there.
  [[nodiscard]] int openedSteps() const { return std::min(opened_, undoStack_.count()); }
  [[nodiscard]] bool isDone(StepId id) const; // O(steps)

signals:
  void skeletonEdited(const espalier::SkeletonDelta& delta);
  void skeletonReplaced(); // by that of a file: not an edit
  void scanChanged();
  void leftOutChanged(); // which points are set aside
  void organsChanged();  // those that were set by hand
  void contractedChanged();
  void envelopeChanged();
  void unitChanged();
  void upChanged();
  void rootChanged(); // the place that is chosen for it
  void readOnlyChanged();
  void titleChanged(); // file, scan or modified

private:
  class EditSkeleton;
  struct ContractedChange {
    std::shared_ptr<const Eigen::Matrix3Xf> before;
    std::shared_ptr<const Eigen::Matrix3Xf> after;
  };
  struct Jump {            // of goTo()
    int left = 0;          // steps to go
    SkeletonDelta changes; // of those behind, one after the other
    std::shared_ptr<const Eigen::Matrix3Xf> contractedBefore;
    std::string envelopeBefore;
    OrganMarks organsBefore;
  };
  struct StepContent { // what one step changes
    SkeletonDelta delta = {};
    PointSet points = {};
    std::optional<ContractedChange> contracted = {};
    std::optional<EnvelopeChange> envelope = {};
    OrganMarks organs = {};
  };
  [[nodiscard]] const EditSkeleton& command(int index) const;
  StepId push(const QString& text, StepContent content, Gesture gesture = {});
  void apply(const SkeletonDelta& delta);
  void replaceScan(std::unique_ptr<const Scan> scan, const QString& path);
  void forgetPoints();
  void setLeftOut(const PointSet& points);
  void announce(const SkeletonDelta& delta);
  void applyContracted(const std::shared_ptr<const Eigen::Matrix3Xf>& positions);
  void applyEnvelope(const std::string& envelope);
  void applyOrgans(const OrganMarks& change);

  std::unique_ptr<const Scan> scan_;
  std::shared_ptr<const Eigen::Matrix3Xf> contracted_;
  Structure structure_;
  PointSet leftOut_;
  OrganMarks organs_;
  std::string envelope_;
  Selection selection_;
  PointSelection pointSelection_;
  QUndoStack undoStack_;
  LengthUnit unit_ = LengthUnit::unknown;
  UpAxis up_ = UpAxis::z;
  std::optional<Eigen::Vector3d> root_;
  QString filePath_;
  QString scanPath_;
  QString author_;
  QString readOnly_;         // why
  QString held_;             // likewise
  std::optional<Jump> jump_; // none: not in goTo()
  int opened_ = 0; // steps at the beginning that came with the file, if they are there yet
  Saving saving_ = Saving::byHand;
  bool isCanceling_ = false; // the step undone now is to be forgotten
  bool isRestoring_ = false; // steps of a file become commands: nothing is done to the skeleton
};

} // namespace espalier
