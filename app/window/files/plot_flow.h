#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "core/pipeline/cleaned_scan.h"
#include "ui/jobs/job_slot.h"

#include <QString>

#include <cstddef>
#include <functional>
#include <vector>

namespace espalier {

class PlantDocument;
class PlotPanel;

/// Cuts the open scan into the plants of a plot, and writes each as a project. The document stays
/// as it is: the points of a plant are selected, no more.
class PlotFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PanelDock::Parts window;
    std::function<PipelineOptions()> options;        // as the form has them
    std::function<void(const QString& folder)> list; // shows its plants as the worklist
  };
  explicit PlotFlow(Parts parts);

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override;

private:
  void makePanel();
  void find();
  void show(const CutPlot& cut);
  void showPlants();
  void select(std::size_t plant);
  void chooseFolder();
  /// @throws Error if there are no plants to write
  void write(const QString& folder);
  void forget();
  [[nodiscard]] PipelineOptions howToCut() const;

  Parts parts_;
  PlotPanel* panel_ = nullptr;
  std::vector<CutPlant> plants_; // found last
  QString words_;                // of what was found, or why nothing was
  JobSlot job_{parts_.queue, JobPriority::asked};
};

} // namespace espalier
