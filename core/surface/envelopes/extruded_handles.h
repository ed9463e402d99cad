#pragma once

#include "core/surface/envelopes/envelope_handles.h"
#include "core/surface/envelopes/extruded_hull.h"

namespace espalier {

/// Of an extruded hull: its top and bottom, both sides of the side profile at three heights, and
/// six places of the outline, shown where it is widest.
[[nodiscard]] std::vector<EnvelopeHandle> handlesOf(const ExtrudedHull& hull);
[[nodiscard]] std::vector<std::string> extrudedHandleNames();

/// Where a handle comes to stand that is dragged to `place`: as near to there as it may be, so that
/// top and sides do not pass bottom and other sides. Those of the outline stay within its ends.
/// pre: handlesOf(hull) has one of this name
[[nodiscard]] HandlePlace draggedTo(const ExtrudedHull& hull, const std::string& name,
                                    const Eigen::Vector3d& place);

/// The hull with these handles there. Between them, and up to the ends of their profile, both
/// profiles follow evenly.
[[nodiscard]] ExtrudedHull withHandles(ExtrudedHull hull, const HandlePlaces& places);

} // namespace espalier
