#pragma once

#include "core/base/imported.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace espalier {

inline constexpr Color unpainted = {255, 255, 255}; // of points without a color

/// An object of a scene of PlantGL, as far as it leads to points.
struct SceneObject {
  std::size_t firstPoint = 0; // its own, in the order of the file
  std::size_t pointCount = 0;
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity(); // what it does to its parts: first this,
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();     // then this [L]
  std::vector<std::uint32_t> parts;                     // places of earlier objects
  std::uint64_t total = 0; // points in it and its parts, as often as they occur
  int height = 0;          // of the tree of its parts
};

/// The points of a scene of PlantGL, where shared objects are not yet repeated.
struct PointScene {
  static constexpr int deepest = 64; // objects in one another

  std::vector<SceneObject> objects; // parts before what they are parts of
  std::vector<std::uint32_t> shapes;
  RawPoints points;              // as listed; colors are one per point
  bool hasColors = false;        // of any set
  std::set<std::string> skipped; // types of objects that are no point sets
  std::uint64_t unplaced = 0;    // points in objects that would bend them, or turn them unclearly
  std::uint64_t badColors = 0;   // sets with another number of colors than of points

  /// Adds an object whose total and height are not known yet, and returns its place.
  std::uint32_t add(SceneObject object);
  /// Takes the parts off an object that they cannot be placed by. Of their number no more than
  /// `most` is reported.
  void leaveOutParts(SceneObject& object, std::uint64_t most);
};

/// How PlantGL turns what is in an object. Angles in radians, right-handed.
/// An axis of no length turns nothing.
[[nodiscard]] Eigen::Matrix3d turnedAbout(const Eigen::Vector3d& axis, double angle);
/// By the roll about x, then the elevation about y, then the azimuth about z.
[[nodiscard]] Eigen::Matrix3d turnedByEuler(double azimuth, double elevation, double roll);
/// x to the primary direction, y to the secondary; none unless they are at right angles.
[[nodiscard]] std::optional<Eigen::Matrix3d> turnedTo(const Eigen::Vector3d& primary,
                                                      const Eigen::Vector3d& secondary);

/// The points of all shapes, in the order of the scene, and what was left out.
/// @param file  its name, for messages
/// @throws Error     if shared points are repeated more than 16 times, or there are more points
///                   than can be worked on
/// @throws Cancelled if `progress` asks to stop
/// Time and memory O(points).
[[nodiscard]] Imported<RawPoints> placedPoints(const PointScene& scene, const std::string& file,
                                               const Progress& progress);

} // namespace espalier
