#pragma once

#include "app/report/choice_record.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "app/window/preview/judged_state.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/sweep_card.h"

#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace espalier {

class EvaluationFlow;
class PipelinePanel;
class PlantDocument;
class PlantView;
class ReconstructFlow;
class ReferenceFlow;
class SweepStrip;

/// Runs the pipeline with a few values of one option, one after the other, and lays what came of
/// them side by side, each with its picture and its numbers. A click takes a value.
class SweepFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    PipelinePanel& pipeline;
    ReconstructFlow& reconstruct;
    ReferenceFlow& reference;
    EvaluationFlow& evaluation;
    PanelDock::Parts window;
  };
  explicit SweepFlow(const Parts& parts);
  ~SweepFlow() override;

  [[nodiscard]] const PanelDock& dock() const { return *dock_; }
  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override;
  /// What came of each value; no states: nothing was swept.
  [[nodiscard]] ChoiceRecord record() const;

signals:
  void taken(); // a value: the panel of the pipeline shows it

private:
  struct Trial {
    PipelineOptions options;
    SweepItem item = {};
    Judgment judgment = {};
    std::optional<Outcome> outcome = {};
  };
  QWidget* makePanel();
  void listOptions();
  void proposeRange();
  /// The options as they are, with a number for what is swept, even if that is its default.
  [[nodiscard]] PipelineOptions inUse() const;
  void start();
  void runNext();
  void finish(const Outcome& outcome, const Judgment& judgment);
  void showCards();
  [[nodiscard]] QString noteOnCards() const;
  void picture(Trial& trial) const;
  void pictureNext();
  void take(std::size_t index);

  Parts parts_;
  PanelDock* dock_;
  QComboBox* option_;
  QSpinBox* count_;
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  std::pair<double, double> proposed_; // as the fields show it
  QPushButton* run_;
  QLabel* note_;
  SweepStrip* strip_;
  std::vector<Trial> trials_;
  QString swept_; // the option that these are of, as people read it
  const Option* sweptOption_ = nullptr;
  std::string sweptStep_;
  std::size_t planned_ = 0; // how many there were to be
  std::size_t next_ = 0;
  QTimer seen_; // until the view rests: then the pictures follow it, one at a time
  std::size_t pictured_ = 0;
  JobSlot job_{parts_.queue, JobPriority::asked};
};

} // namespace espalier
