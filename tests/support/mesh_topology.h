#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace espalier::test {

using Triangles = std::vector<std::array<int, 3>>; // corners

/// How triangles are connected.
struct MeshTopology {
  int pieces = 0;
  int boundaryLoops = 0;
  int eulerCharacteristic = 0; // corners - edges + triangles: 2 for each piece like a sphere

  bool operator==(const MeshTopology&) const = default;
};

/// Fails a test where triangles turn different ways, or an edge is of more than two.
[[nodiscard]] MeshTopology topologyOf(int corners, const Triangles& triangles);

/// Volume that closed triangles hold, which turn out [L^3]; pieces that overlap count twice.
[[nodiscard]] double volumeOf(const Eigen::Matrix3Xd& corners, const Triangles& triangles);

} // namespace espalier::test
