#pragma once

#include "core/cloud/point_set.h"
#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// Plants and deltas as bytes of a project.
///
/// A version byte, the nodes, the runs of points, and the contentHash of all. Numbers are
/// little-endian, doubles IEEE 754, so that files move between machines and nothing is rounded. A
/// node is its flags (1 parent, 2 branching, 4 entities, 8 marked, 16 review), position, radius,
/// and what the flags announce. Version 2, without points, and version 1, without reviews too, are
/// read as well. Reading gives none for bytes that were cut, changed, or are of a later version;
/// memory stays within a small multiple of the bytes, but for the table by id (see mostIds).

/// What a step changes, of the nodes and of the points (HistoryStep).
struct StoredDelta {
  SkeletonDelta delta;
  PointSet points = {};
  bool operator==(const StoredDelta&) const = default;
};
[[nodiscard]] std::string bytesOf(const SkeletonDelta& delta, const PointSet& points = {});
[[nodiscard]] std::optional<StoredDelta> deltaFrom(std::string_view bytes);

/// A skeleton and the points that are set aside.
struct StoredPlant {
  Skeleton skeleton;
  PointSet leftOut = {};
  bool operator==(const StoredPlant&) const = default;
};
[[nodiscard]] std::string bytesOf(const Skeleton& skeleton, const PointSet& leftOut = {});
[[nodiscard]] std::optional<StoredPlant> plantFrom(std::string_view bytes);

} // namespace espalier
