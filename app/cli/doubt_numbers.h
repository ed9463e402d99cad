#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/pipeline/pipeline.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>

namespace espalier {

/// What is in doubt about a plant that was reconstructed. Keys: expected_right, the share of the
/// length that is right as the odds say; answers_for, how many answers would probably make that .9,
/// .95 and .98, null where all would not; count; and doubts, what puts most right first, each with
/// kind, node, place, nodes, length, gain, present, and alternatives[].{kind,probability,onto,
/// onto_place,branch}: places in the frame of the scan, and nodes by their rows, the places in
/// Skeleton::ids() of the plant and of its MTG, read back.
/// @throws Cancelled if `progress` asks to stop
/// Time: of doubtsOf().
[[nodiscard]] nlohmann::ordered_json doubtNumbers(const std::shared_ptr<const PointCloud>& cloud,
                                                  const Reconstruction& result, UpAxis up,
                                                  const Progress& progress = {});

} // namespace espalier
