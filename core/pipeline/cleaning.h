#pragma once

#include "core/base/imported.h"
#include "core/cloud/point_set.h"
#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <vector>

namespace espalier {

/// A way to clean a scan: a method of one of the steps that leave points out.
struct CleaningMethod {
  const Step* step = nullptr;
  const Method* method = nullptr;
};

/// All that leave out something, in the order of the steps, but those that try the plant
/// (Method::triesPlant).
[[nodiscard]] std::vector<CleaningMethod> cleaningMethods();

/// The points that a method would leave out, among those not yet set aside; with each those
/// repeated at its place; and what the method notes, as why there are none.
/// @param values   one per option of the method, in order
/// @param options  up, the root, and what was set aside; none of that is returned
/// @throws Error     if the method does
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Imported<PointSet> leftOutBy(const Method& method, const std::vector<double>& values,
                                           const std::shared_ptr<const PointCloud>& cloud,
                                           const PipelineOptions& options,
                                           const Progress& progress = {});

} // namespace espalier
