#pragma once

#include "core/base/shown_message.h"
#include "core/cloud/point_cloud.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// What one should know of a scan before work: which points are not taken for the plant, and why.
/// @param name  of its file, which each note begins with
[[nodiscard]] std::vector<ShownMessage> scanNotes(const PointCloud& cloud, const std::string& name);

/// How many of the points that were listed are no part of the cloud, and why. None: all are.
/// @param name  likewise
[[nodiscard]] std::optional<ShownMessage> leftOutNote(const PointCloud& cloud, std::size_t listed,
                                                      const std::string& name);

} // namespace espalier
