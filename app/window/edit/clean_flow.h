#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "core/cloud/point_set.h"
#include "ui/jobs/job_slot.h"
#include "ui/tools/point_question.h"

#include <QString>

namespace espalier {

class CleanPanel;
class PlantDocument;
class PointsFlow;

/// Finds points that are not of the plant, by the methods of cleaning or by clicks on a pole, a
/// wire or a plant. What is found is selected, and set aside as one step.
class CleanFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PointsFlow& points;
    PanelDock::Parts window;
  };
  explicit CleanFlow(const Parts& parts);

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override;

private:
  void makePanel();
  void find();
  void answer(const PointQuestion& question, const PointAnswer& answer);
  void keepName(const QString& name);
  void refreshScale();
  void refreshSelected();
  void refreshAside();
  void forget();
  [[nodiscard]] QString nameOfFound() const; // empty: the selection is another by now

  Parts parts_;
  CleanPanel* panel_ = nullptr;
  PointSet found_;    // last, by a method or clicks
  QString foundName_; // what it is
  QString failure_;   // why there is nothing, until something else is selected
  JobSlot job_{parts_.queue, JobPriority::asked};
};

} // namespace espalier
