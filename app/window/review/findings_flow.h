#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"

#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class FindingsPanel;
class PanelDock;
class PlantDocument;
class PlantView;

/// The checks of the plant: their findings in a panel, the walk to each, and the ignored ones.
///
/// The skeleton is checked a moment after an edit, a large one and the scan against it as a job,
/// which a later edit replaces. Nothing is checked while nobody looks.
class FindingsFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    ActionSet& actions;
    ScanDistances& distances;
    QSettings& settings;
    QMainWindow& window;
    Reveal reveal;
    std::function<void()> actOnSelected; // keys, whatever the pointer is on, until it moves
  };
  explicit FindingsFlow(const Parts& parts);

  /// Those that are not ignored, as they were last found.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] const std::vector<Finding>& ignored() const { return shownIgnored_; }
  [[nodiscard]] bool isIgnored(const Finding& finding) const;
  void ignore(const Finding& finding);        // that was looked at elsewhere
  [[nodiscard]] bool isBusy() const override; // the findings are not of the plant as it is

  /// How far from the wood points are unexplained at the usual sensitivity [L], and the sensitivity
  /// that is set, of all checks.
  [[nodiscard]] double usualReach() const;
  [[nodiscard]] double sensitivity() const;
  [[nodiscard]] CheckOptions limits() const; // at that sensitivity
  void setSensitivity(double sensitivity);   // kept in the project

signals:
  void limitsChanged();

private:
  struct Indexed { // what finds the points of a scan; the index refers to the cloud
    std::shared_ptr<const PointCloud> cloud;
    SpatialIndex index;
  };
  struct Found {                                         // by a job
    std::optional<std::vector<Finding>> ofSkeleton = {}; // none: it is checked at once
    std::vector<Finding> ofScan = {};
    std::vector<Finding> reportedOfSkeleton = {}; // as of now
    std::vector<Finding> reportedOfScan = {};
    std::shared_ptr<const Indexed> indexed; // null: there is no scan
  };
  void addActions();
  void makePanel();
  /// @param text  what is ignored, as JSON; empty: nothing
  /// @throws Error if it is no such text; nothing is ignored then
  void show(const std::string& text);
  void showLimits(const std::string& text); // the same of what the user set of the checks
  void checkAnew();                         // by other limits
  void connectParts();

  void later();
  void refresh();
  void startJob();
  void take(Found found);
  [[nodiscard]] double spacing() const; // between points [L]; 0: there is no scan
  [[nodiscard]] bool isAllChecked() const;
  void list();     // what was found last, without what is gone
  void noteOpen(); // how many are open, for what shows the project without checking it
  void step(int by);
  void noteNothing();
  void answer();
  void goTo(const Finding& finding);
  void showSentence();
  [[nodiscard]] QString sentenceOf(const Finding& finding) const;
  void toggleIgnored();
  void showAction();
  void selectAll();

  Parts parts_;
  FindingsPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  QTimer timer_;
  JobSlot job_{parts_.queue, JobPriority::background};
  bool isJobOutdated_ = false;
  bool isCheckedAtOnce_ = true;
  bool isAwaited_ = false;     // one has asked for findings before there were any
  int awaitedStep_ = 0;        // where to then: as of step(); 0: one only waits for the result
  bool isScanChecked_ = false; // against the skeleton of now
  std::shared_ptr<const Indexed> indexed_;
  mutable std::optional<double> unit_; // of lengths of the checks [L]; none: to be found anew
  std::vector<Finding> ofSkeleton_;
  std::vector<Finding> ofScan_;
  std::vector<Finding> reportedOfSkeleton_; // as they were reported first, while they last
  std::vector<Finding> reportedOfScan_;
  std::vector<Finding> findings_;
  std::vector<Finding> shownIgnored_; // that are still found
  std::vector<Finding> ignored_;      // all that one has ignored
  std::string openNote_;              // how many were open when all was checked last; empty: never
};

} // namespace espalier
