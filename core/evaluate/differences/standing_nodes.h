#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// Where something is to be attached so that it is borne as in the reference.
struct Hold {
  std::optional<NodeId> host; // of the result; none: it has nothing on the path down
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // on an edge at the host, or beside it [L]
  std::vector<NodeId> path; // of the reference, missed from the place up to what is attached
  EdgeType edge = EdgeType::branching; // by which it is attached to the last of these
};

/// Which nodes of a result stand where on a reference, while the result is edited: each on the edge
/// of the reference that it was nearest to when the two were compared.
///
/// All three must outlive it. Nodes added since stand on nothing.
class StandingNodes {
public:
  StandingNodes(const Skeleton& result, const Differences& found, const Skeleton& reference);

  /// The lowest of the result on an edge of the reference that is still there.
  [[nodiscard]] std::optional<NodeId> lowestOn(NodeId edge) const;
  /// The lowest on an edge, or, where none is, those next above it on each path up.
  [[nodiscard]] std::vector<NodeId> nextAbove(NodeId edge) const;
  /// What stands next below `attached`, or below the first that it carries and that stands
  /// anywhere: neither of what it carries nor of what is `leftOut`. None: that carries nothing that
  /// stands on the reference.
  [[nodiscard]] std::optional<Hold> below(NodeId attached,
                                          const std::function<bool(NodeId)>& leftOut) const;

private:
  [[nodiscard]] bool isThere(NodeId node) const { return result_.contains(node); }
  /// Of what a node carries, it included, the first that stands anywhere.
  [[nodiscard]] std::optional<NodeId> firstStanding(NodeId node) const;
  [[nodiscard]] double share(NodeId edge, NodeId node) const; // of the edge, from below

  const Skeleton& result_;
  const Differences& found_;
  const Skeleton& reference_;
  std::vector<std::vector<NodeId>> standing_; // by edge of the reference: the lowest first
};

} // namespace espalier
