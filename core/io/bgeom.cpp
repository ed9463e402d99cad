#include "core/io/bgeom.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/bgeom_scene.h"

#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint64_t mostRepeats = 16; // of shared points: a scene of less than 1 kB could ask
                                          // for any number

/// An object where it stands: p becomes scale * p + offset.
struct Placed {
  std::uint32_t object;
  Eigen::Vector3d scale;
  Eigen::Vector3d offset; // [L]
};

void checkSize(const BgeomScene& scene, const std::string& file) {
  const std::uint64_t listed = scene.points.positions.size();
  std::uint64_t total = 0;
  for (const std::uint32_t shape : scene.shapes) {
    const std::uint64_t more = scene.objects[shape].total;
    if (more > mostRepeats * listed || total + more > mostRepeats * listed)
      throw Error(file + ": repeats its " + std::to_string(listed) + " points more than " +
                  std::to_string(mostRepeats) + " times: export the points alone, or as PLY");
    total += more;
  }
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw Error(file + ": holds " + std::to_string(total) +
                " points, more than can be worked on at once: thin or split it");
}

/// The points of all shapes, in the order of the scene.
RawPoints placedPoints(const BgeomScene& scene, const Progress& progress) {
  RawPoints points;
  std::vector<Placed> stack;
  for (auto shape = scene.shapes.rbegin(); shape != scene.shapes.rend(); ++shape)
    stack.push_back({*shape, Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero()});
  while (!stack.empty()) {
    const Placed placed = stack.back();
    stack.pop_back();
    const BgeomObject& object = scene.objects[placed.object];
    if (object.total == 0) continue; // so that all steps lead to points
    for (std::size_t i = 0; i < object.pointCount; ++i) {
      if (i % 65536 == 0) progress.update(0);
      const std::size_t point = object.firstPoint + i;
      points.positions.emplace_back(placed.scale.cwiseProduct(scene.points.positions[point]) +
                                    placed.offset);
      if (scene.hasColors) points.colors.push_back(scene.points.colors[point]);
    }
    for (auto part = object.parts.rbegin(); part != object.parts.rend(); ++part)
      stack.push_back({*part, placed.scale.cwiseProduct(object.scale),
                       placed.scale.cwiseProduct(object.offset) + placed.offset});
  }
  return points;
}

std::vector<std::string> notesOn(const BgeomScene& scene, const std::string& file) {
  std::vector<std::string> notes;
  if (!scene.skipped.empty()) {
    std::string types;
    for (const std::string& type : scene.skipped)
      types += (types.empty() ? "" : ", ") + type;
    notes.push_back(file + ": objects that are no point sets are passed over: " + types);
  }
  if (scene.turned > 0)
    notes.push_back(file + ": " + std::to_string(scene.turned) +
                    " points in objects that the scene turns or bends are left out");
  if (scene.badColors > 0)
    notes.push_back(file + ": " + std::to_string(scene.badColors) +
                    " point sets have another number of colors than of points, and lose them");
  return notes;
}

} // namespace

bool isBgeom(std::string_view beginning) {
  return beginning.starts_with("!bGEOM");
}

Imported<RawPoints> readBgeom(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string bytes = readAll(in, progress.part(0, 0.3));
  const BgeomScene scene = bgeomSceneIn(bytes, file, progress.part(0.3, 0.8));
  checkSize(scene, file);
  return {placedPoints(scene, progress.part(0.8, 1)), notesOn(scene, file)};
}

} // namespace espalier
