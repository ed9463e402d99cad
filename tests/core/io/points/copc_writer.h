#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace espalier::test {

/// The octree of a COPC file.
struct CopcOctree {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double halfSide = 1;
  std::vector<std::array<int, 4>> cells = {}; // of each chunk: level, and its place there in x y z
};

/// A LAZ file made a COPC file: with a record of its octree, whose pages, of the cells of each
/// level one, stand at the end. pre: all chunks have points, and a cell each
[[nodiscard]] std::string copcFile(std::string laz, const CopcOctree& octree);

} // namespace espalier::test
