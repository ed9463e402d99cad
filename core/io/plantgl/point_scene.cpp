#include "core/io/plantgl/point_scene.h"

#include "core/base/listed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint64_t mostRepeats = 16; // of shared points: a scene of less than 1 kB could ask
                                          // for any number

/// An object where it stands: p becomes linear * p + offset.
struct Placed {
  std::uint32_t object;
  Eigen::Matrix3d linear;
  Eigen::Vector3d offset; // [L]
};

void checkSize(const PointScene& scene, const std::string& file) {
  const std::uint64_t listed = scene.points.positions.size();
  std::uint64_t total = 0;
  for (const std::uint32_t shape : scene.shapes) {
    const std::uint64_t more = scene.objects[shape].total;
    if (more > mostRepeats * listed || total + more > mostRepeats * listed)
      throw ShownError(
          {espalier::Shown::tr(
               "repeats its %1 points more than %2 times: export the points alone, or as PLY"),
           {std::to_string(listed), std::to_string(mostRepeats)},
           FilePlace{file}});
    total += more;
  }
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw ShownError({espalier::Shown::tr(
                          "holds %1 points, more than can be worked on at once: thin or split it"),
                      {std::to_string(total)},
                      FilePlace{file}});
}

RawPoints pointsOfShapes(const PointScene& scene, const Progress& progress) {
  RawPoints points;
  std::vector<Placed> stack;
  for (auto shape = scene.shapes.rbegin(); shape != scene.shapes.rend(); ++shape)
    stack.push_back({*shape, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()});
  while (!stack.empty()) {
    const Placed placed = stack.back();
    stack.pop_back();
    const SceneObject& object = scene.objects[placed.object];
    if (object.total == 0) continue; // so that all steps lead to points
    for (std::size_t i = 0; i < object.pointCount; ++i) {
      if (i % 65536 == 0) progress.update(0);
      const std::size_t point = object.firstPoint + i;
      points.positions.emplace_back(placed.linear * scene.points.positions[point] + placed.offset);
      if (scene.hasColors) points.colors.push_back(scene.points.colors[point]);
    }
    for (auto part = object.parts.rbegin(); part != object.parts.rend(); ++part)
      stack.push_back(
          {*part, placed.linear * object.linear, placed.linear * object.offset + placed.offset});
  }
  return points;
}

std::vector<ShownMessage> notesOn(const PointScene& scene, const std::string& file) {
  std::vector<ShownMessage> notes;
  if (!scene.skipped.empty())
    notes.push_back({espalier::Shown::tr("objects that are no point sets are passed over: %1"),
                     {listed({scene.skipped.begin(), scene.skipped.end()})},
                     FilePlace{file}});
  if (scene.unplaced > 0)
    notes.push_back(
        {scene.unplaced == 1
             ? espalier::Shown::tr(
                   "1 point in objects that the scene bends, or turns unclearly, left out")
             : espalier::Shown::tr(
                   "%1 points in objects that the scene bends, or turns unclearly, left out"),
         {std::to_string(scene.unplaced)},
         FilePlace{file}});
  if (scene.badColors > 0)
    notes.push_back(
        {scene.badColors == 1
             ? espalier::Shown::tr(
                   "1 point set has another number of colors than of points, and loses them")
             : espalier::Shown::tr(
                   "%1 point sets have another number of colors than of points, and lose them"),
         {std::to_string(scene.badColors)},
         FilePlace{file}});
  return notes;
}

} // namespace

std::uint32_t PointScene::add(SceneObject object) {
  object.total = object.pointCount;
  for (const std::uint32_t part : object.parts) {
    const std::uint64_t more = objects[part].total;
    object.height = std::max(object.height, objects[part].height + 1);
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    object.total = more > most - object.total ? most : object.total + more;
  }
  objects.push_back(std::move(object));
  return static_cast<std::uint32_t>(objects.size() - 1);
}

void PointScene::leaveOutParts(SceneObject& object, std::uint64_t most) {
  for (const std::uint32_t part : object.parts)
    unplaced += std::min(objects[part].total, most);
  object.parts.clear();
}

Eigen::Matrix3d turnedAbout(const Eigen::Vector3d& axis, double angle) {
  const double length = axis.norm();
  if (length == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, axis / length).toRotationMatrix();
}

Eigen::Matrix3d turnedByEuler(double azimuth, double elevation, double roll) {
  return turnedAbout(Eigen::Vector3d::UnitZ(), azimuth) *
         turnedAbout(Eigen::Vector3d::UnitY(), elevation) *
         turnedAbout(Eigen::Vector3d::UnitX(), roll);
}

std::optional<Eigen::Matrix3d> turnedTo(const Eigen::Vector3d& primary,
                                        const Eigen::Vector3d& secondary) {
  constexpr double mostCosine = 1e-4; // texts are rounded to some 6 digits
  const Eigen::Vector3d x = primary.normalized();
  const Eigen::Vector3d y = secondary.normalized();
  const bool areDirections = x.norm() > 0.5 && y.norm() > 0.5; // false too if not finite
  if (!areDirections || !(std::abs(x.dot(y)) < mostCosine)) return std::nullopt;
  Eigen::Matrix3d result;
  result << x, y, x.cross(y);
  return result;
}

Imported<RawPoints> placedPoints(const PointScene& scene, const std::string& file,
                                 const Progress& progress) {
  checkSize(scene, file);
  return {pointsOfShapes(scene, progress), notesOn(scene, file)};
}

} // namespace espalier
