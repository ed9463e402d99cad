#include "core/io/plantgl/bgeom.h"

#include "core/base/text.h"
#include "core/io/plantgl/bgeom_scene.h"

namespace espalier {

bool isBgeom(std::string_view beginning) {
  return beginning.starts_with("!bGEOM");
}

Imported<RawPoints> readBgeom(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string bytes = readAll(in, progress.part(0, 0.3));
  const PointScene scene = bgeomSceneIn(bytes, file, progress.part(0.3, 0.8));
  return placedPoints(scene, file, progress.part(0.8, 1));
}

} // namespace espalier
