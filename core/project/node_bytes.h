#pragma once

#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// Skeletons and deltas as bytes of a project.
///
/// A version byte, the nodes, and the contentHash of both. Numbers are little-endian, doubles
/// IEEE 754, so that files move between machines and nothing is rounded. A node is its flags
/// (1 parent, 2 branching, 4 entities, 8 marked, 16 review), position, radius, and what the flags
/// announce. Version 1, without reviews, is read too.
/// Reading gives none for bytes that were cut, changed, or are of a later version; memory stays
/// within a small multiple of the bytes, but for the table by id (see mostIds).

[[nodiscard]] std::string bytesOf(const SkeletonDelta& delta);
[[nodiscard]] std::optional<SkeletonDelta> deltaFrom(std::string_view bytes);

[[nodiscard]] std::string bytesOf(const Skeleton& skeleton);
[[nodiscard]] std::optional<Skeleton> skeletonFrom(std::string_view bytes);

} // namespace espalier
