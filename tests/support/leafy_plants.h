#pragma once

#include "core/cloud/organ.h"
#include "core/cloud/point_cloud.h"
#include "core/simulate/foliage.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier::test {

/// A scan with what each of its points lies on.
struct LabeledCloud {
  PointCloud cloud;
  std::vector<Organ> organs; // by point of the cloud

  [[nodiscard]] double spacing() const { return pointSpacing(cloud.positions()); }
};

[[nodiscard]] LabeledCloud labeledScanOf(const Skeleton& plant, const Foliage& foliage,
                                         Eigen::Index points);

/// 12 000 points of a stem and leaves on petioles, that no odds were fitted on. Made once.
[[nodiscard]] const LabeledCloud& leafyHerb();

/// An upright stem of length 1 and radius 0.01 above the origin, with a blade that hangs from its
/// lower third to 0.1 below its foot.
[[nodiscard]] PointCloud hangingLeaf();

} // namespace espalier::test
