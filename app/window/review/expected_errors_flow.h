#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "core/decide/error_ratings.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/review_stops.h"
#include "ui/jobs/job_slot.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

class PlantDocument;

/// Where errors are likely in the plant, as its points show: found by a job, and a moment after an
/// edit that moves or attaches anything by another. Meanwhile what was known stays. Nothing is
/// found while nobody wants it.
class ExpectedErrorsFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    ScanDistances& distances;
    std::function<CheckOptions()> limits; // of the checks
  };
  explicit ExpectedErrorsFlow(const Parts& parts);

  void setWanted(bool isWanted);
  /// Null: there is no scan or no skeleton, nobody wants them, or they are not found yet.
  [[nodiscard]] const ExpectedErrors* now() const {
    return errors_ && parts_.distances.now() ? &*errors_ : nullptr;
  }
  /// What now() rates the riskiest of some nodes by, in spacings of document.scale(). None: there
  /// is nothing of them in it, or no now().
  [[nodiscard]] std::optional<ErrorEvidence> riskiestOf(const std::vector<NodeId>& nodes) const;
  /// Those of the plant as it is are being found.
  [[nodiscard]] bool isBusy() const override;
  /// The points of a cluster of now(), by their number in the scan.
  [[nodiscard]] PointSet pointsOf(const Finding& cluster) const;
  /// The nodes whose wood is nearest to these.
  [[nodiscard]] std::vector<NodeId> nodesAt(const Finding& cluster) const;
  void findAnew(); // a moment later, as the plant or the limits are others

signals:
  void changed(); // or they cannot be found

private:
  void take(const SkeletonDelta& delta);
  void dropAll();
  void refresh();

  Parts parts_;
  QTimer timer_;
  std::optional<ExpectedErrors> errors_;
  ErrorRatings ratings_; // of errors_
  bool isWanted_ = false;
  bool isOutdated_ = true; // they are not of the plant as it is
  int changes_ = 0;        // of it
  JobSlot job_;
};

} // namespace espalier
