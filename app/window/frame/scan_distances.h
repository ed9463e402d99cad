#pragma once

#include "app/window/frame/window_part.h"
#include "core/cloud/point_set.h"
#include "core/skeleton/point_distances.h"
#include "ui/jobs/job_slot.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace espalier {

class PlantDocument;

/// A cloud but for some of its points; the cloud itself if these are none.
[[nodiscard]] std::shared_ptr<const PointCloud>
pointsWithout(const std::shared_ptr<const PointCloud>& cloud, const PointSet& leftOut);

/// How far the points of the scan are from the skeleton of a document, as both are now. Points that
/// are set aside are not measured.
///
/// Nothing is measured while nobody wants it. A plant is measured as a job of its own, which blocks
/// nothing; an edit, unless it changes much of the plant, is taken in at once.
class ScanDistances : public WindowPart {
  Q_OBJECT

public:
  ScanDistances(PlantDocument& document, JobQueue& queue);

  enum class Use : std::uint8_t {
    findings,
    explained,
    hidden,
    nodeColors,
    pointColors,
    hulls,
    review,
    doubts
  };
  void setWanted(Use use, bool isWanted);

  /// Null: there is no scan or no skeleton, nobody wants them, or they are not ready.
  [[nodiscard]] std::shared_ptr<const PointDistances> now() const { return distances_; }
  /// The distances to the surface [L], one per point of the scan; not a number: set aside.
  /// pre: now() is not null. O(points)
  [[nodiscard]] std::vector<float> toSurface() const;
  /// Points that now() holds, by their number in the scan. pre: as toSurface()
  [[nodiscard]] PointSet inScan(const std::vector<Eigen::Index>& points) const;
  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }

signals:
  void changed();

private:
  void take(const SkeletonDelta& delta);
  void measureAnew();
  void start();

  PlantDocument& document_;
  std::set<Use> uses_;
  std::shared_ptr<PointDistances> distances_;
  PointSet leftOut_;                   // when they were measured
  std::optional<SkeletonDelta> since_; // edits since the job began; none: it has to begin again
  JobSlot job_;
};

} // namespace espalier
