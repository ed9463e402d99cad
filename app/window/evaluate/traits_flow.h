#pragma once

#include "app/report/plant_report.h"
#include "app/window/files/report_maker.h"
#include "app/window/frame/panel_dock.h"
#include "ui/jobs/job_slot.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <string>

namespace espalier {

class JobSlot;
class PlantDocument;
class TraitsPanel;

/// The plant by itself: its traits, shown while there is no reference, a moment after each edit;
/// its light, on demand; and a report of both.
class TraitsFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    PanelDock::Parts window;
  };
  explicit TraitsFlow(const Parts& parts);

  [[nodiscard]] TraitsPanel* panel() const { return panel_; } // whose parent owns it
  void setSeen(bool isSeen);                                  // else nothing is measured
  void refresh();                                             // what can be done
  void setEnvelope(std::optional<ReportedEnvelope> envelope); // for the report; none: none is drawn

  /// The density of the wood that the user gave, in kg/m³, as a project keeps it, and back; empty:
  /// none was given.
  /// @throws Error if it is no such text; none is given then
  [[nodiscard]] std::string densityText() const;
  void showDensity(const std::string& text);

  /// Measures, draws and writes to a file whose name says how.
  /// @throws Error if that cannot be, or a job is running
  void write(const QString& path);

signals:
  void densityChanged(); // by hand
  void noted(const QString& message);
  void written(const QString& path);

private:
  void takeEdit();
  void later();
  void measure();
  void show();
  void forget(const QString& why = {}); // there is nothing to measure
  void measureLight();
  void choose();
  [[nodiscard]] PlantMeasureOptions options() const;
  [[nodiscard]] PlantReportAbout about() const;

  Parts parts_;
  TraitsPanel* panel_ = nullptr;
  ReportMaker maker_;
  QTimer timer_;
  JobSlot job_{parts_.jobs.queue(), JobPriority::asked};
  bool isSeen_ = false;
  bool isFresh_ = false;
  std::optional<PlantMeasures> measures_; // without light
  std::optional<LightInterception> light_;
  bool isLightFresh_ = false;
  std::optional<ReportedEnvelope> envelope_;
  double density_ = 0;         // of the wood [kg/m³]; 0: not known
  std::uint64_t revision_ = 0; // grows with all that makes the measures old
};

} // namespace espalier
