#pragma once

#include "core/io/points/first_lines.h"
#include "core/io/points/point_glance.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace espalier {

/// What a file of points holds, found out without reading it all, in a fraction of a second
/// whatever its size; formats that say nothing otherwise (scenes of PlantGL) are read whole, and
/// the glance says so. Unit and up axis that the file does not state are guessed: the unit from the
/// size, as makes a plant between a hand and a tall tree high, the axis from where a foot is
/// (likelyUp).
/// @throws Error as readPoints, if the header is damaged or the file holds a structure
/// @param columns  of a text file, as a user names them; none: found out
[[nodiscard]] PointGlance glanceAt(const std::filesystem::path& path,
                                   const std::vector<PointField>& columns = {});

/// The unit of what lies in some bounds [L]: "m" where they are of a map, far from 0, 0 for their
/// size; else the one that makes a plant between a hand and a tall tree high, "m" or "mm"; empty:
/// they do not show it.
[[nodiscard]] std::string unitOfBounds(const Eigen::AlignedBox3d& bounds);

/// How a text file of points begins; none of a file that says itself what its columns hold.
/// @throws Error as glanceAt; also if it has fewer than 3 columns
[[nodiscard]] std::optional<FirstLines> firstLinesAt(const std::filesystem::path& path);

} // namespace espalier
