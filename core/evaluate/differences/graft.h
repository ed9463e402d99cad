#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/evaluate/differences/standing_nodes.h"
#include "core/skeleton/skeleton_delta.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A node at the place nearest to `place` on the edges that meet at `host`: one that is there
/// within the tolerance [L], else a new one on its edge. Not on what `attached` carries.
NodeId nodeAt(SkeletonEditor& editor, NodeId host, const Eigen::Vector3d& place, double tolerance,
              std::optional<NodeId> attached = std::nullopt);

/// The node above the place nearest to `place` in the trees of `roots`. pre: there are some
[[nodiscard]] NodeId nearestIn(const Skeleton& skeleton, const std::vector<NodeId>& roots,
                               const Eigen::Vector3d& place);

/// What a copy of a node of the reference keeps: its wood alone, or, of a state of the plant
/// itself, all but that it was reviewed.
enum class Copied : std::uint8_t { wood, all };

/// Puts parts of a reference into a result that is edited, and attaches to them what it has
/// already. All must outlive it.
class Graft {
public:
  Graft(SkeletonEditor& editor, const Differences& found, const Skeleton& reference, Copied copied);

  /// Copies a node, or takes the one of the result that stands there. It is
  /// attached to `host`, or else to the copy of its parent, or is a root.
  void copy(NodeId id, std::optional<NodeId> host = std::nullopt);
  /// Attaches what the reference goes on with above a copied node to its copy.
  void goOnAbove(NodeId id);
  /// Attaches a node where a hold says, along copies of what was missed on the path.
  void attachAlong(NodeId id, const Hold& hold);

  [[nodiscard]] const StandingNodes& standing() const { return standing_; }
  [[nodiscard]] const std::vector<NodeId>& added() const { return added_; }

private:
  /// Attaches a node by an edge of that type, and removes what leads to nothing any more. What else
  /// continued the axis there branches.
  void attach(NodeId id, NodeId onto, EdgeType edge);
  /// Adds a copy of a node of the reference.
  void add(NodeId id, std::optional<NodeId> host);
  [[nodiscard]] bool carries(NodeId id, std::optional<NodeId> other) const;
  void removeDeadEnd(std::optional<NodeId> end);

  SkeletonEditor& editor_;
  const Differences& found_;
  const Skeleton& reference_;
  Copied copied_;
  StandingNodes standing_;
  std::vector<std::optional<NodeId>> copies_; // by id of the reference
  std::vector<NodeId> added_;
};

} // namespace espalier
