#include "core/radius/recenter_on_cylinders.h"

#include "core/skeleton/smooth_axes.h"

#include <optional>
#include <vector>

namespace espalier {

Skeleton recenteredOnCylinders(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                               const Eigen::Vector3d& origin,
                               const CylinderCenteringOptions& options, const Progress& progress) {
  Skeleton result = skeleton;
  if (skeleton.isEmpty() || points.cols() == 0) return result;
  for (int round = 0; round < options.rounds; ++round) {
    const Progress part = progress.part(static_cast<double>(round) / options.rounds,
                                        static_cast<double>(round + 1) / options.rounds);
    const AssignedPoints assigned(result, points, origin, part.part(0, 0.5));
    const auto cylinders = cylindersAbout(result, assigned, options.cylinders, part.part(0.5, 1));
    for (const NodeId id : skeleton.ids()) {
      const std::optional<FittedCylinder>& cylinder = cylinders[indexOf(id)];
      if (!cylinder) continue;
      const Eigen::Vector3d from = result[id].position - cylinder->point;
      const Eigen::Vector3d onto =
          cylinder->point + from.dot(cylinder->direction) * cylinder->direction;
      if ((onto - result[id].position).norm() <= options.farthest * cylinder->radius)
        result.setPosition(id, onto);
    }
    result = withSmoothAxes(result, options.smoothing);
  }
  return result;
}

} // namespace espalier
