#pragma once

#include "ui/view/clip.h"

#include <vector>

namespace espalier {

/// A clip that shows these places from a camera: its slab and its box are moved along, as little as
/// may be, and get larger only if they are too small for all of the places. One that shows them
/// already stays as it is.
/// @param bounds of the plant [L], frame of the file, as are the places
[[nodiscard]] Clip movedToShow(const Clip& clip, const std::vector<Eigen::Vector3d>& places,
                               const Eigen::AlignedBox3d& bounds, const Camera& camera);

} // namespace espalier
