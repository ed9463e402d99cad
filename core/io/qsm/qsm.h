#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A cylinder of a quantitative structure model, by TreeQSM's ideas.
struct QsmCylinder {
  double radius = 0;                               // [L]
  Eigen::Vector3d start = Eigen::Vector3d::Zero(); // [L]
  Eigen::Vector3d end = Eigen::Vector3d::Zero();   // [L]
  std::uint32_t parent = 0;                        // number of a cylinder, from 1; 0: none
  std::uint32_t extension = 0;                     // the cylinder that continues it; 0: none
  std::uint32_t branch = 0;                        // which one it is a part of
  std::uint32_t order = 0;                         // of that branch; 0: the stem
  std::optional<double> startRadius;               // [L], where there is more than TreeQSM writes
  std::size_t line = 0;                            // in the file, for messages; 0: it has none
};

/// A model, and which of the optional columns its file has.
struct Qsm {
  std::vector<QsmCylinder> cylinders; // numbered from 1 in this order
  bool hasExtensions = false;
  bool hasBranches = false;
  bool hasOrders = false;
};

/// The end of a cylinder; `axis` need not be of length 1 [L].
[[nodiscard]] Eigen::Vector3d qsmEnd(const Eigen::Vector3d& start, const Eigen::Vector3d& axis,
                                     double length);

/// The skeleton along the axes of the cylinders: a node at the end of each, with its radius, that
/// is attached to the node of its parent cylinder. Where a cylinder has no parent, a root is made
/// at its start; those that start at the very same place share it. One of no length without a
/// `startRadius` is such a root itself.
///
/// The extension of a cylinder is the successor of its node, all others on it branch. Without
/// extensions it is the one of the same branch, without branches the first in the file, with a
/// note. At a shared root, those of order 0 are successors, without orders the first. A cylinder
/// that begins beside or along its parent is attached to the parent's end nevertheless; those that
/// begin farther from it than the parent's radius are counted in a note.
///
/// @param file  its name, for messages
/// @throws Error if there is no cylinder, a value is not finite, a radius negative, or a parent is
///         missing or carried by the cylinder itself
/// Time O(N log N). Node ids go breadth first from the roots.
[[nodiscard]] Imported<Skeleton> skeletonOf(const Qsm& qsm, const std::string& file);

/// The other way around: a cylinder for each edge, with the radius of the node at its end, and one
/// of no length for a node alone. Of several successors of a node, the one of the lowest id is the
/// extension.
[[nodiscard]] Qsm qsmOf(const Skeleton& skeleton);

} // namespace espalier
