#pragma once

#include "app/window/frame/window_part.h"
#include "app/window/preview/shared_pipeline.h"
#include "core/cloud/ball.h"
#include "core/evaluate/study/contraction_quality.h"
#include "ui/jobs/job_slot.h"
#include "ui/view/plant_state.h"

#include <QTimer>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {

class ActionSet;
class Editing;
class PipelinePanel;
class PlantDocument;
class PlantView;
class ReconstructFlow;
class RegionPreviewer;

/// What options would make of a scan: nothing of the plant itself has changed.
struct Outcome {
  PipelineOptions options;
  std::shared_ptr<const Eigen::Matrix3Xf> contracted; // of the points it is of
  std::shared_ptr<const Eigen::Matrix3Xf> scanned;    // where these were; null: the whole scan
  std::vector<Eigen::Index> points = {};              // which these are; empty: all of it
  std::shared_ptr<const Skeleton> skeleton;           // may be empty yet
  std::optional<Ball> within;                         // what it is of; none: the whole scan
  std::shared_ptr<const ContractionQuality> quality;  // null: not judged yet

  [[nodiscard]] PlantState shownAs(const QString& name) const;
};

/// Shows what each change of a step would make while the knob still moves: first of a ball of
/// points where one looks, or where one has put it, then, once the hand rests, of the whole scan.
/// What is out of date is dropped, never waited for, but for what is nearly there: so a knob that
/// moves steadily shows something all the while.
class PreviewFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    PipelinePanel& pipeline;
    ActionSet& actions;
    Editing& editing;
    ReconstructFlow& reconstruct;
  };
  explicit PreviewFlow(const Parts& parts);
  ~PreviewFlow() override;

  [[nodiscard]] bool isLive() const;
  [[nodiscard]] bool isBusy() const override { return job_.isBusy() || rest_.isActive(); }
  /// What is shown in place of the plant; none: the plant itself.
  [[nodiscard]] const std::optional<Outcome>& shown() const { return shown_; }
  /// What it does otherwise than the plant was made, as it is written over it. pre: shown()
  [[nodiscard]] QString name() const;
  /// Whether a run with these options would make another plant. If not, the plant itself is drawn.
  /// pre: shown()
  [[nodiscard]] bool isOther() const;
  /// Whether contracted points are shown in place of those scanned: they are what changes.
  [[nodiscard]] bool movesPoints() const { return movesPoints_; }
  /// Another skeleton that is drawn in place of the one shown, with its colors.
  struct Drawn {
    Skeleton skeleton;
    NodeColors colors;
  };
  void setDrawn(std::optional<Drawn> drawn); // none: as usual
  [[nodiscard]] const std::optional<Drawn>& drawn() const { return drawn_; }

  void askAgain(); // other choices are shown, not by hand

  void keepChoices(); // what is chosen now is what drop() leads back to

  /// Takes the preview away, with the choices that led to it where it is other than the plant.
  /// Returns whether there was one.
  bool drop();
  void stop() override; // what is shown stays
  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString hint() const override;
  void clear(); // takes the preview away; the choices stay

signals:
  void changed(); // what is shown, or whether it still is to be completed

private:
  enum class Kind : std::uint8_t { contracted, reconstructed, whole }; // the first two of a ball
  void addActions();
  /// Whether something was asked for: a job that was stopped is busy until it ends, and makes
  /// nothing.
  [[nodiscard]] bool isComing() const;
  void goOn(); // after stop(), until the preview is of the whole scan
  void turn(bool isOn);
  /// @param movesPoints whether the change is one of the contraction, or of what comes before it
  void ask(bool movesPoints);
  void askFirst(); // no knob was turned yet
  /// Starts a job of this kind: at once, unless one of its kind is about to end.
  template <class Work, class Done> void begin(Kind kind, Work work, Done done) {
    if (running_ == kind && job_.isBusy())
      job_.startNext(std::move(work), std::move(done));
    else
      job_.start(std::move(work), std::move(done));
    running_ = kind;
  }
  void makePreviewer();
  void dropChoices();
  void askContracted();
  void askReconstructed();
  void askAll();
  void placeBall();
  [[nodiscard]] Eigen::Vector3d center() const;
  [[nodiscard]] PipelineOptions options() const;
  void show(const Outcome& outcome);
  void draw();
  [[nodiscard]] QString changeBetween(const PipelineOptions& before,
                                      const PipelineOptions& after) const;
  void forgetScan();

  Parts parts_;
  JobSlot job_{parts_.queue, JobPriority::hand};
  QTimer rest_;                                      // of the hand; then comes the whole
  std::shared_ptr<const RegionPreviewer> previewer_; // of the scan; null: not needed yet
  std::optional<Eigen::Vector3d> placed_;            // center of the ball; none: where one looks
  std::optional<Outcome> shown_;
  std::optional<Drawn> drawn_;
  PipelineOptions before_;    // the preview
  PipelineOptions previewed_; // root and up that `previewer_` is for
  bool hasFailed_ = false;    // what was asked for last: a message says why
  bool isDropping_ = false;
  bool isAll_ = false;         // what runs is of the whole scan
  bool isAllOwed_ = false;     // it comes once what runs is done
  Kind running_ = Kind::whole; // or what ran last
  bool movesPoints_ = false;   // what was changed last: then these are shown
};

} // namespace espalier
