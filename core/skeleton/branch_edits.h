#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

// Edits by hand of whole branches. Each leaves a valid forest with at most one successor more per
// node than it found, and is refused before it changes anything. pre, of all: each id given is
// contained.

/// Attaches a chain of new nodes to `parent`, or makes a tree of its own of it.
///
/// It continues the axis of `parent` if that has no successor, else it branches. No new node is
/// thicker than `parent`, if that has a radius; one without radius has that of the one before.
/// @param places [L], one per new node, in order; not empty
/// @param radii  [L], as many, >= 0
/// @return the last new node
NodeId addBranch(SkeletonEditor& editor, std::optional<NodeId> parent,
                 const std::vector<Eigen::Vector3d>& places, const std::vector<double>& radii);

/// Removes all that `id` carries, and attaches there what the root of `part` carries: that root
/// stands for `id`, which stays as it is. Edges keep their types. pre: `part` has one root
void replaceCarried(SkeletonEditor& editor, NodeId id, const Skeleton& part);

/// Attaches to `id` what the root of `part` carries: that root stands for `id`, which stays as it
/// is. The first goes on with the axis of `id` if nothing does, the others branch; edges above keep
/// their types. pre: `part` has one root
/// @return the first new nodes
std::vector<NodeId> addCarried(SkeletonEditor& editor, NodeId id, const Skeleton& part);

/// Lets two branches that cross exchange what lies beyond the crossing: `a`, with all it carries,
/// goes to where `b` was attached and `b` to where `a` was, by the same types of edges. Units that
/// start at one go with it; for scales where none does, it joins those of its new parent.
/// @throws Error if one is a root, both are attached to one node, or one carries the other
void exchangeArms(SkeletonEditor& editor, NodeId a, NodeId b);

} // namespace espalier
