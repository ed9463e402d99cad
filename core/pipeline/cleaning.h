#pragma once

#include "core/cloud/point_set.h"
#include "core/pipeline/registry.h"

#include <memory>
#include <vector>

namespace espalier {

/// A way to clean a scan: a method of one of the steps that leave points out.
struct CleaningMethod {
  const Step* step = nullptr;
  const Method* method = nullptr;
};

/// All that leave out something, in the order of the steps.
[[nodiscard]] std::vector<CleaningMethod> cleaningMethods();

/// The points that a method would leave out, among those not yet set aside; with each those
/// repeated at its place.
/// @param values   one per option of the method, in order
/// @param leftOut  what was set aside; none of it is returned
/// @throws Error     if the method does
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] PointSet leftOutBy(const Method& method, const std::vector<double>& values,
                                 const std::shared_ptr<const PointCloud>& cloud,
                                 const PointSet& leftOut, const Progress& progress = {});

} // namespace espalier
