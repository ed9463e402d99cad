#pragma once

#include "core/base/progress.h"
#include "core/contract/circle_center.h"
#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// A cone through which point tracking looks for children of a node.
struct SightCone {
  Eigen::Vector3d apex = Eigen::Vector3d::Zero();      // the node [L], frame of the file
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // unit
  double angle = 0;                                    // full opening [rad]
  double length = 0;                                   // [L]
};

/// What the chosen methods see at one point of a scan. Points are columns of the cloud; places are
/// in the frame of the file.
struct MethodSight {
  Eigen::Index point = 0;
  std::vector<Eigen::Index> neighbors; // linked to it
  std::vector<Eigen::Index> ball;      // that the contraction takes its new place from, ascending
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // of the plant there, unit, of either sign
  double linearity = 0;                                // of the points it is from, [0, 1]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // of the surface, unit, of either sign
  double radius = 0;                                   // the contraction looks within it [L]
  double density = 0;                                  // normalized, [0, 1]
  std::optional<WoodCircle> circle;                    // whose center takes the place of the mean
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();     // where the point goes
  std::vector<SightCone> cones; // at the nearest node, of the skeleton method that tracks points
};

/// Shows what the chosen methods see at any point.
class MethodSights {
public:
  /// Prepares what is of the whole scan: which points cleaning keeps, links between them, how dense
  /// they lie. Time about that of the contraction.
  /// @param contracted by point, about the origin of the cloud, by the same options
  /// @throws Error     if an option is unknown or out of range
  /// @throws Cancelled if `progress` asks to stop
  MethodSights(std::shared_ptr<const PointCloud> cloud,
               std::shared_ptr<const Eigen::Matrix3Xf> contracted, const PipelineOptions& options,
               const PlantScale& scale, const Progress& progress = {});
  ~MethodSights();
  MethodSights(MethodSights&&) noexcept;
  MethodSights& operator=(MethodSights&&) noexcept;

  /// What is seen at one point; nothing but `moved` at one that cleaning leaves out.
  ///
  /// The ball is that of the method: along the plant or in space, a section, or the nearest points.
  /// Of methods that take no mean of points near it, it is where they look: the nearest of an
  /// implicit Laplacian, the last radius of an L1 medial, the reach of symmetry axes, the links of
  /// contraction along paths. The direction is that within the orientation radius of the method, or
  /// else within its radius; the density that which sets its radius, or else that of the 16
  /// nearest.
  /// @param skeleton its node nearest to the point has the cones; none without nodes
  /// May be called on several threads. Time O(N) bytes, and that of one ball.
  [[nodiscard]] MethodSight at(Eigen::Index point, const Skeleton& skeleton = {}) const;

private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

} // namespace espalier
