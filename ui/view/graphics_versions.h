#pragma once

#include <string>

namespace espalier {

/// The libraries that pictures in 3D are drawn with, as they are at run time: "9.1.0".
struct GraphicsVersions {
  std::string vtk;
  std::string glew;
};
[[nodiscard]] GraphicsVersions graphicsVersions();

} // namespace espalier
