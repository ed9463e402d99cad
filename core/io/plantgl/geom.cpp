#include "core/io/plantgl/geom.h"

#include "core/base/text.h"
#include "core/io/plantgl/geom_scene.h"

namespace espalier {

Imported<RawPoints> readGeom(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string text = readAll(in, progress.part(0, 0.3));
  const PointScene scene = geomSceneIn(text, file, progress.part(0.3, 0.8));
  return placedPoints(scene, file, progress.part(0.8, 1));
}

} // namespace espalier
