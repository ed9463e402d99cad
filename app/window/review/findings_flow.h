#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "core/base/spatial_index.h"
#include "core/project/history.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace espalier {

class CheckForm;
class PlantDocument;
struct PointsNow;

/// The checks of the plant, with their limits, their findings, and which of these are ignored.
///
/// The skeleton is checked a moment after an edit, a large one and the scan against it as a job,
/// which a later edit replaces. Nothing is checked while nobody wants it.
class FindingsFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    ScanDistances& distances;
    QWidget& window;
  };
  explicit FindingsFlow(const Parts& parts);

  void setWanted(bool isWanted);
  void checkNow(); // what an edit has put off
  [[nodiscard]] bool isAllChecked() const;
  [[nodiscard]] CheckForm& checks() const { return *checks_; } // to be shown by who lists findings

  /// Those that are not ignored, as they were last found.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] const std::vector<Finding>& ignored() const { return shownIgnored_; }
  [[nodiscard]] bool isIgnored(const Finding& finding) const;
  void ignore(const Finding& finding);
  void stopIgnoring(const Finding& finding);
  /// Whether the points of findings are, by their number, those of the distances of now.
  [[nodiscard]] bool arePointsOfNow() const;
  [[nodiscard]] bool isBusy() const override; // the findings are not of the plant as it is

  /// How far from the wood points are unexplained at the usual sensitivity [L], and the sensitivity
  /// that is set, of all checks.
  [[nodiscard]] double usualReach() const;
  [[nodiscard]] double sensitivity() const;
  [[nodiscard]] CheckOptions limits() const; // at that sensitivity
  void setSensitivity(double sensitivity);   // kept in the project

signals:
  void changed(); // what is found or ignored
  void checked(); // a job ended
  void limitsChanged();

private:
  struct Indexed { // what finds the points of a scan; the index refers to the cloud
    std::shared_ptr<const PointCloud> cloud;
    SpatialIndex index;
  };
  struct Report { // of a finding, as it was reported first
    Finding finding;
    StepId step; // done last then: once it is undone, the report is none
  };
  struct Found {                                         // by a job
    std::optional<std::vector<Finding>> ofSkeleton = {}; // none: it is checked at once
    std::vector<Finding> ofScan = {};
    std::vector<Report> reportsOfSkeleton = {}; // as of now
    std::vector<Report> reportsOfScan = {};
    std::shared_ptr<const Indexed> indexed; // null: there is no scan
  };
  /// @param text  what is ignored, as JSON; empty: nothing
  /// @throws Error if it is no such text; nothing is ignored then
  void show(const std::string& text);
  void showLimits(const std::string& text); // the same of what the user set of the checks
  void checkAnew();                         // by other limits
  void connectParts();

  /// Adds to what the checks find what was reported and is mostly still so, and takes over what is
  /// reported from now on.
  /// @param step    that is done last
  /// @param weaker  what they find at twice the sensitivity, asked for where something is gone
  static void keepStillSo(std::vector<Finding>& now, std::vector<Report>& reports, StepId step,
                          const std::function<std::vector<Finding>()>& weaker,
                          const PointsNow* points = nullptr);
  void forgetUndone(); // reports

  void later();
  void refresh();
  void startJob();
  void take(Found found);
  [[nodiscard]] double spacing() const; // between points [L]; 0: there is no scan
  void list();                          // what was found last, without what is gone
  void noteOpen(); // how many are open, for what shows the project without checking it

  Parts parts_;
  CheckForm* checks_;
  bool isWanted_ = false;
  QTimer timer_;
  JobSlot job_{parts_.queue, JobPriority::background};
  bool isJobOutdated_ = false;
  bool isCheckedAtOnce_ = true;
  bool isScanChecked_ = false; // against the skeleton of now
  std::shared_ptr<const Indexed> indexed_;
  mutable std::optional<double> unit_; // of lengths of the checks [L]; none: to be found anew
  std::vector<Finding> ofSkeleton_;
  std::vector<Finding> ofScan_;
  std::vector<Report> reportsOfSkeleton_; // while what they are of lasts
  std::vector<Report> reportsOfScan_;
  std::vector<Finding> findings_;
  std::vector<Finding> shownIgnored_; // that are still found
  std::vector<Finding> ignored_;      // all that one has ignored
  std::string openNote_;              // how many were open when all was checked last; empty: never
};

} // namespace espalier
