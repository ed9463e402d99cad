#pragma once

#include "core/base/progress.h"
#include "core/io/plantgl/point_scene.h"

#include <string>
#include <string_view>

namespace espalier {

/// Reads the objects of a .geom file. For what is refused see `readGeom`.
[[nodiscard]] PointScene geomSceneIn(std::string_view text, const std::string& file,
                                     const Progress& progress);

} // namespace espalier
