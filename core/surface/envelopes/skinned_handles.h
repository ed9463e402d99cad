#pragma once

#include "core/surface/envelopes/envelope_handles.h"
#include "core/surface/envelopes/skinned_hull.h"

namespace espalier {

/// Of a skinned hull: its top and bottom, and three places on each of up to eight profiles, as
/// evenly around the axis as profiles are.
[[nodiscard]] std::vector<EnvelopeHandle> handlesOf(const SkinnedHull& hull);
[[nodiscard]] std::vector<std::string> skinnedHandleNames();

/// Where a handle comes to stand that is dragged to `place`: as near to there as it may be, so that
/// nothing passes the axis or its other end.
/// pre: handlesOf(hull) has one of this name
[[nodiscard]] HandlePlace draggedTo(const SkinnedHull& hull, const std::string& name,
                                    const Eigen::Vector3d& place);

/// The hull with these handles there. Its profiles follow evenly from handle to handle.
[[nodiscard]] SkinnedHull withHandles(SkinnedHull hull, const HandlePlaces& places);

} // namespace espalier
