#pragma once

#include "app/report/choice_record.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "app/window/preview/judged_state.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/judge_table.h"

#include <QStringList>
#include <QTimer>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace espalier {

class EvaluationFlow;
class HistogramView;
class PlantDocument;
class PlantView;
class PreviewFlow;
class ReconstructFlow;
class ReferenceFlow;
class StatesFlow;

/// The numbers by which the plant, what was kept as A, and the preview are judged, side by side,
/// and how they are distributed over the points: a range marked in the histogram selects its
/// points.
class JudgeFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    ReconstructFlow& reconstruct;
    PreviewFlow& preview;
    StatesFlow& states;
    ReferenceFlow& reference;
    EvaluationFlow& evaluation;
    PanelDock::Parts window;
  };
  explicit JudgeFlow(const Parts& parts);
  ~JudgeFlow() override;

  void setDark(bool isDark);
  /// What is compared, with a picture of each state; no states: nothing is judged.
  [[nodiscard]] ChoiceRecord record() const;
  [[nodiscard]] bool isBusy() const override { return job_.isBusy() || timer_.isActive(); }

private:
  /// What stands in a column of the table.
  struct State {
    QString name;
    bool isPreview;
    Outcome outcome;
    Judgment judgment = {};
    std::vector<float> values = {}; // of what the histogram shows
  };
  QWidget* makePanel();
  void judgeLater();
  void judge();
  void chooseKind();
  void show();
  void showAllRows(); // as far as there is room
  void showHistogram();
  void showLegend(); // below the histogram: what it shows
  [[nodiscard]] bool hasMedian() const;
  void brush(double from, double to);
  [[nodiscard]] std::vector<State> states() const;
  [[nodiscard]] std::vector<JudgeRow> rows() const;
  [[nodiscard]] Distributed kind() const;

  Parts parts_;
  PanelDock* dock_;
  JudgeTable* table_;
  QComboBox* kind_;
  HistogramView* histogram_;
  QLabel* note_;
  std::vector<State> shown_;
  bool isCurrent_ = false;       // what is shown: of the states as they are
  bool areValuesComing_ = false; // of another kind than was shown
  QTimer timer_;                 // many changes are judged at once
  JobSlot job_{parts_.queue, JobPriority::asked};
};

} // namespace espalier
