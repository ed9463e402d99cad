#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/mtg/structure.h"
#include "core/project/project.h"

#include <memory>
#include <string>

namespace espalier {

/// The structure that a file holds, or a project, with what an MTG says of it beside. Notes of
/// reading it are printed.
/// @throws Error as readStructure, and if a project has no skeleton
[[nodiscard]] Structure plantIn(const std::string& file);

/// The points of a project that are not set aside; null: it has no scan, or it is not found, or a
/// part of it was opened, which is printed. Notes of reading them are printed, too.
/// @throws Error as readPoints
[[nodiscard]] std::shared_ptr<const PointCloud>
pointsOf(const Project& project, const PointSet& leftOut, const Progress& progress);

/// The unit of a plant: that which a project has, else that which is given; empty: not known.
/// @throws WrongUsage where the two differ
[[nodiscard]] std::string unitOfPlant(const std::string& file, const std::string& given);

} // namespace espalier
