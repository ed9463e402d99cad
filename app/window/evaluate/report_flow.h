#pragma once

#include "app/report/comparison_report.h"
#include "app/window/files/report_maker.h"
#include "app/window/frame/panel_dock.h"
#include "core/evaluate/evaluation.h"

#include <QObject>
#include <QString>

#include <functional>

namespace espalier {

class JobSlot;
class PlantDocument;
class ReferenceFlow;

/// The command that writes a report of the comparison: measuring is a job, the pictures are drawn
/// one by one between what else the window does, and writing is a job again.
class ReportFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    ReferenceFlow& reference;
    PanelDock::Parts window;
    std::function<EvaluationOptions()> how; // the plant is compared now
  };
  explicit ReportFlow(Parts parts);

  void setIgnored(std::vector<DifferingPart> ignored) { ignored_ = std::move(ignored); }
  void setChoices(std::vector<ChoiceRecord> records) { choices_ = std::move(records); }
  void setMade(std::optional<PipelineOptions> options) { made_ = std::move(options); }
  void refresh(); // whether there is anything to report

  /// Measures, draws and writes to a file whose name says how.
  /// @throws Error if that cannot be, or a job is running
  void write(const QString& path);

signals:
  void noted(const QString& message);
  void written(const QString& path);

private:
  void choose();
  [[nodiscard]] ReportAbout about() const;

  Parts parts_;
  ReportMaker maker_;
  std::vector<ChoiceRecord> choices_;
  std::optional<PipelineOptions> made_; // what the plant was reconstructed with; none: not known
  std::vector<DifferingPart> ignored_;  // in the frame of the plant
};

} // namespace espalier
