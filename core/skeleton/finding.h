#pragma once

#include "core/base/shown_message.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace espalier {

/// What is worth a second look in a skeleton.
struct Finding {
  enum class Kind : std::uint8_t {
    separatePiece,      // a tree beside the largest one
    twoSuccessors,      // more than one child continues the axis of the node
    loneBranch,         // an axis begins at the node, the only child of its parent
    noLength,           // the edge to the parent has no length
    duplicatedEdge,     // the edge to the parent lies on another one
    sharpTurn,          // the axis turns back at the node, or the branch that begins there
    crossing,           // touches a branch that does not bear it
    loop,               // an axis ends on wood that does not bear it, or on itself
    radiusAboveParent,  // thicker than what bears the node
    edgesWithoutPoints, // nothing of the scan is near
    noOwnPoints,        // a branch begins where all points are of other wood
    besidePoints,       // the wood lies beside its points
    shortFoot,          // the points of a stem go on below its root
    unexplainedPoints   // points of the scan that no edge is near
  };
  Kind kind;
  NodeId node;                     // where to look; of points, where they come nearest
  std::vector<NodeId> others = {}; // that take part
  double amount = 0;               // see describe: a count, an angle [rad], or a length [L]
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // of points: their centroid [L]
  double reach = 0;                                // of points: how far they go from there [L]
  std::vector<Eigen::Index> points = {};           // that are meant, of the cloud; ascending

  bool operator==(const Finding&) const = default;
};

inline constexpr int findingKinds = 14;

/// The nodes to look at: the one it is at first.
[[nodiscard]] std::vector<NodeId> nodesOf(const Finding& finding);

/// Sets `place` and `reach` to where its points are. pre: it has points, and `cloud` those
void place(Finding& finding, const PointCloud& cloud);

/// The box about all that takes part [L], frame of the file. pre: `skeleton` has its nodes
[[nodiscard]] Eigen::AlignedBox3d boundsOf(const Finding& finding, const Skeleton& skeleton);

/// Whether two findings, before and after some edit, are one to a person: they are of one kind, and
/// at the same node or about the same points.
[[nodiscard]] bool isSame(const Finding& a, const Finding& b);

/// How the numbers of a finding are written.
struct FindingNumbers {
  std::function<std::string(double)> length;     // [L]
  std::function<std::string(std::size_t)> count; // of nodes, of points
};

/// "node 12 has 2 successors: an axis continues once".
[[nodiscard]] ShownMessage describe(const Finding& finding, const Skeleton& skeleton,
                                    const FindingNumbers& numbers);
[[nodiscard]] std::string describe(const Finding& finding, const Skeleton& skeleton);

/// "two_successors", "no_length", "radius_above_parent" ...
[[nodiscard]] std::string nameOf(Finding::Kind kind);

} // namespace espalier
