#pragma once

#include "core/cloud/ball.h"
#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// What the steps make of a part of a scan.
struct RegionPreview {
  std::vector<Eigen::Index> points; // columns of the cloud inside the ball, ascending; none of them
                                    // was set aside
  Eigen::Matrix3Xf contracted;      // of these, about the origin of the cloud
  Skeleton skeleton;                // frame of the file, what of it lies in the ball
};

/// Shows at once, for a part of a scan, what other options of the steps would make of it.
///
/// Values are those that the rules give for the whole scan. The steps see a margin of points around
/// the ball: twice the greatest length among the options of the contraction, and twice as far as
/// smoothing looks, but no more than half the radius of the ball, or 20 point spacings if that is
/// more. So contractions that look no farther give the same places as in a run on the whole scan:
/// geodesic centroids, adaptive geodesic centroids, sections, and means of balls; one Laplacian
/// step and symmetry axes nearly so. Those that solve for all points at once, follow paths to the
/// root or draw samples (implicit Laplacian, along paths, L1 medial) give what they would for that
/// part alone.
///
/// What is expensive and of the whole scan is computed when it is first needed, and kept: an index
/// of its points, those that cleaning leaves out (for the last few choices), how dense they lie,
/// and how far they are from the root along the plant. May be used from several threads.
class RegionPreviewer {
public:
  /// @param leftOut, up, root as in PipelineOptions, whose own are not looked at
  explicit RegionPreviewer(std::shared_ptr<const PointCloud> cloud, const PointSet& leftOut,
                           const PlantScale& scale, UpAxis up = UpAxis::z,
                           const std::optional<Eigen::Vector3d>& root = {});
  ~RegionPreviewer();
  RegionPreviewer(RegionPreviewer&&) noexcept;
  RegionPreviewer& operator=(RegionPreviewer&&) noexcept;

  /// Cleaned and contracted; the skeleton stays empty.
  /// @throws Error     if an option is unknown or out of range
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Time that of the contraction for the points of the ball and its margin.
  [[nodiscard]] RegionPreview contracted(const Ball& ball, const PipelineOptions& options,
                                         const Progress& progress = {}) const;

  /// The same, and what the skeleton would become there: all steps before the radii.
  ///
  /// Each part of the points that is connected by links of at most 8 point spacings is
  /// reconstructed by itself, from the point of it that is nearest to the root along the plant;
  /// no part is joined to another. Parts of fewer than 20 points are left out.
  [[nodiscard]] RegionPreview reconstructed(const Ball& ball, const PipelineOptions& options,
                                            const Progress& progress = {}) const;

  /// The largest ball about a place that holds at most `count` points. O(found).
  [[nodiscard]] Ball ballWith(const Eigen::Vector3d& center, Eigen::Index count) const;

private:
  struct Whole;
  struct Regions;
  std::unique_ptr<Whole> whole_;
};

} // namespace espalier
