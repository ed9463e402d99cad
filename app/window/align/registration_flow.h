#pragma once

#include "app/window/align/scan_registration.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "ui/document/tool_input.h"
#include "ui/jobs/job_slot.h"
#include "ui/view/shown_scan.h"

#include <QPointF>

#include <functional>
#include <memory>
#include <optional>

namespace espalier {

class Editing;
class FileFlow;
class PlantDocument;
class PlantView;
class ProjectFlow;
class RegistrationPanel;

/// Lays another scan of the plant on the open one: by targets that are clicked in both, then by
/// their points; and joins the two. Nothing of the plant changes before that. While it goes on, the
/// mouse picks targets, and the plant is not edited.
class RegistrationFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobSlot& jobs;
    Editing& editing;
    ProjectFlow& projects;
    FileFlow& files;
    PanelDock::Parts window;
  };
  explicit RegistrationFlow(const Parts& parts);

  /// Reads another scan, as a job, and begins.
  /// @throws Error if there is no scan to lay it on, or a job is running
  void begin(const QString& path);
  [[nodiscard]] bool isActive() const { return other_ != nullptr; }
  [[nodiscard]] bool hasWork() const { return isActive() && registration_.hasWork(); }
  void removeLast(); // the place, pair or fit by points that came last
  void escape();     // drops a place that waits for its other, else leaves

  /// Writes both scans into one file, as a job, which becomes the scan of the plant as one step.
  /// @throws Error if that cannot be
  void join(const QString& path);
  /// Writes a structure of the other scan, moved with it, as a job.
  /// @throws Error if that cannot be
  void moveStructure(const QString& from, const QString& to);

  void setEnabled(bool isEnabled) override;
  void setPlantShown(bool isShown) override;
  [[nodiscard]] QString hint() const override;
  [[nodiscard]] bool mayClose() override { return mayLose(); }
  [[nodiscard]] bool mayLose(); // asks, if there are targets or a fit that are not joined yet

signals:
  void begun();
  void ended();
  void changed(); // whether it goes on, or what could be taken back

private:
  void addActions(); // registration_actions.cpp
  void chooseScan(); // likewise
  void chooseJoined();
  void chooseStructure();
  void takeScan(LoadedFiles files);
  bool handle(const ToolInput& input);
  void click(const Pick& pick);
  [[nodiscard]] std::optional<Eigen::Vector3d> placeOf(const Pick& pick) const;
  void findSphere(const Eigen::Vector3d& place);
  void add(const Eigen::Vector3d& place);
  void fit();
  void colorByDistance();
  void change(const std::function<void()>& act); // of the registration; shows it
  void leave();                                  // asks if there is work to lose
  void end();
  void show();
  void refreshActions();
  [[nodiscard]] QString nextText() const;
  [[nodiscard]] QString warning() const;
  [[nodiscard]] QString partsText() const;
  [[nodiscard]] Foreground foreground() const;
  [[nodiscard]] QString name() const; // of the file of the other scan
  void openMoved(const QString& path, const Structure& structure);

  Parts parts_;
  RegistrationPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  JobSlot sphere_;
  JobSlot distances_;
  std::shared_ptr<const Scan> other_; // null: nothing is registered
  QString path_;                      // of it
  bool isPart_ = false;               // of its file
  ScanRegistration registration_;
  std::optional<PointValues> values_;           // that its points are colored by
  std::optional<Eigen::Isometry3d> lastMotion_; // of the scan that was joined last
  std::optional<QPointF> press_;                // of the mouse, until it is a drag
  bool isEnabled_ = true;
};

} // namespace espalier
