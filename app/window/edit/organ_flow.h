#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/pipeline_options.h"
#include "ui/jobs/job_slot.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QMenu;

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;
class SelectPointsTool;

/// What the points of the scan lie on: wood, petioles, blades or needles. It is found where someone
/// wants to see it, as a job of its own, and corrected by hand: each correction is a step of the
/// history, which the steps Leaves and Blades take.
class OrganFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    ActionSet& actions;
    Editing& editing;
    SelectPointsTool& tool;
    std::function<PipelineOptions()> options; // of the next reconstruction
  };
  explicit OrganFlow(const Parts& parts);

  /// Whether they are to be found; once more if that was canceled, or something else was set aside.
  void setWanted(bool isWanted);
  /// By point of the scan, its place in allOrgans; not a number: not known. Null: nothing is.
  [[nodiscard]] std::shared_ptr<const std::vector<float>> now() const;
  [[nodiscard]] JobSlot& job() { return job_; } // that finds them
  void giveUp();                                // until they are wanted once more

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override { job_.cancel(); }
  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString count() const override; // of those set by hand

signals:
  void changed();

private:
  using Found = std::vector<std::optional<Organ>>; // by point

  void addActions();
  void choose(std::optional<Organ> organ);
  void set(const PointSet& points, std::optional<Organ> organ);
  void paint(std::optional<Organ> organ);
  void endStroke();
  void forget();
  void find();
  void fillContextMenu(QMenu& menu) const;
  void refreshEnabled();

  Parts parts_;
  std::shared_ptr<const Found> found_; // by the program; null: not known
  bool isWanted_ = false;
  bool isCanceled_ = false; // by the user: not found again until they are wanted once more
  bool isEnabled_ = true;
  std::optional<Organ> painting_; // what points become that are selected next
  JobSlot job_;
};

} // namespace espalier
