#include "ui/view/graphics_versions.h"

#include <GL/glew.h>
#include <vtkVersion.h>

namespace espalier {

GraphicsVersions graphicsVersions() {
  return {.vtk = vtkVersion::GetVTKVersion(),
          .glew = reinterpret_cast<const char*>(glewGetString(GLEW_VERSION))};
}

} // namespace espalier
