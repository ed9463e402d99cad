#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// An object of a scene of PlantGL, as far as it leads to points.
struct BgeomObject {
  std::size_t firstPoint = 0; // its own, in the order of the file
  std::size_t pointCount = 0;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  // what it does to its parts: first this,
  Eigen::Vector3d offset = Eigen::Vector3d::Zero(); // then this [L]
  std::vector<std::uint32_t> parts;                 // places of earlier objects
  std::uint64_t total = 0; // points in it and its parts, as often as they occur
  int height = 0;          // of the tree of its parts
};

/// A scene of PlantGL, where shared objects are not yet repeated.
struct BgeomScene {
  std::vector<BgeomObject> objects; // parts before what they are parts of
  std::vector<std::uint32_t> shapes;
  RawPoints points;              // as listed; colors are one per point
  bool hasColors = false;        // of any set
  std::set<std::string> skipped; // types of objects that are no point sets
  std::uint64_t turned = 0;      // points in objects that would turn or bend them
  std::uint64_t badColors = 0;   // sets with another number of colors than of points
};

/// Reads the objects of a .bgeom file. For what is refused see `readBgeom`.
[[nodiscard]] BgeomScene bgeomSceneIn(std::string_view bytes, const std::string& file,
                                      const Progress& progress);

} // namespace espalier
