#pragma once

#include "core/base/progress.h"
#include "core/io/plantgl/point_scene.h"

#include <string>
#include <string_view>

namespace espalier {

/// Reads the objects of a .bgeom file. For what is refused see `readBgeom`.
[[nodiscard]] PointScene bgeomSceneIn(std::string_view bytes, const std::string& file,
                                      const Progress& progress);

} // namespace espalier
