#pragma once

#include "core/cloud/organ_marks.h"
#include "core/cloud/point_set.h"
#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// Plants and deltas as bytes of a project.
///
/// A version byte, the nodes, the runs of points, those of organs, and the contentHash of all.
/// Numbers are little-endian, doubles IEEE 754, so that files move between machines and nothing is
/// rounded. A node is its flags (1 parent, 2 branching, 4 entities, 8 marked, 16 review, 32 origin
/// of the radius), position, radius, and what the flags announce. Version 6 is for organs that were
/// set by hand, 5 for origins of radii, 4 for indices of entities that are texts; 3 is written
/// where there is none of these. Version 2, without points, and version 1, without reviews too, are
/// read as well. Reading gives none for bytes that were cut, changed, or are of a later version;
/// memory stays within a small multiple of the bytes, but for the table by id (see mostIds).
/// Writing throws an Error for what reading would refuse: a place or radius that is not finite, a
/// radius below 0, an id past mostIds.

/// What a step changes, of the nodes and of the points (HistoryStep).
struct StoredDelta {
  SkeletonDelta delta;
  PointSet points = {};
  OrganMarks organs = {};
  bool operator==(const StoredDelta&) const = default;
};
[[nodiscard]] std::string bytesOf(const SkeletonDelta& delta, const PointSet& points = {},
                                  const OrganMarks& organs = {});
[[nodiscard]] std::optional<StoredDelta> deltaFrom(std::string_view bytes);

/// A skeleton, the points that are set aside, and the organs that were set by hand.
struct StoredPlant {
  Skeleton skeleton;
  PointSet leftOut = {};
  OrganMarks organs = {};
  bool operator==(const StoredPlant&) const = default;
};
[[nodiscard]] std::string bytesOf(const Skeleton& skeleton, const PointSet& leftOut = {},
                                  const OrganMarks& organs = {});
[[nodiscard]] std::optional<StoredPlant> plantFrom(std::string_view bytes);
/// Ids that a file may name whose nodes and edits take so many bytes, at most mostIds. A plant has
/// a table by id, so a large one takes the memory of all below it: that follows from what the file
/// holds, but for four million, as of reconstructions that were undone and made again.
[[nodiscard]] std::size_t idsFor(std::size_t bytes);
/// How many ids a skeleton is stored with, of those it has handed out, where nodes use ids to
/// before `used`. All that any file may name; where they are more, as after hundreds of
/// reconstructions that were undone, only those in use, and steps know theirs: the project would be
/// refused.
[[nodiscard]] std::size_t storedIdEnd(std::size_t handedOut, std::size_t used);
/// How many ids plantFrom would make a table for; only the first 5 bytes are looked at, as they
/// are.
[[nodiscard]] std::size_t idEndOf(std::string_view bytes);

} // namespace espalier
