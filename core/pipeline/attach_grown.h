#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton_delta.h"

#include <numbers>
#include <vector>

namespace espalier {

/// A new tree for a node, or for a place on the edge below it: its root stands for that place.
struct GrownBranch {
  NodeId on;
  Skeleton part;
  double fraction = 1; // of the edge to `on`, from its parent on; 1: at `on` itself
};

struct AttachOptions {
  double spacing = 0;    // [L] between points, > 0
  double widestGap = 0;  // [L] no edge of what grew crosses a wider one that no points are in, > 0
  double widestJoin = 0; // [L] nor one that attaches it to the plant, or to others, > 0
  /// [L] but for ends of a piece across a gap that their course leads over, which may be so wide;
  /// 0: as widestJoin
  double widestAhead = 0;
  double sharpestTurn = 2 * std::numbers::pi / 3; // [rad] no edge turns off by more, in (0, pi]
};

/// Attaches wood that grew by itself to a plant, as it may have grown there.
///
/// Edges across wide gaps are cut, and nodes that lie off the points go back to them. Each piece
/// may be entered at any of its nodes from any place of the plant and of pieces before it, across
/// `widestJoin` at most, or up to ten times as far along points, or `widestAhead` straight ahead;
/// what goes on by a turn sharper than `sharpestTurn` is a piece of its own. Of all choices to
/// attach a piece that costs least which is short and turns little, the cheapest of all pieces
/// first (Prim). Pieces that nothing leads to are left out. No new node is thicker than the one it
/// is attached to, if that has a radius.
///
/// @param plant  with radii; not empty
/// @param onto   its nodes that may bear new ones: at them, and on the edges between two of them
/// @param grown  a forest of new nodes, in the frame of the file; where its trees are rooted has no
///               meaning
/// @param cloud  the points, all of them
/// @return in order of their places along the plant; each place once
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n log N + n m) for n new nodes of m pieces.
[[nodiscard]] std::vector<GrownBranch>
attached(const Skeleton& plant, const std::vector<NodeId>& onto, const Skeleton& grown,
         const PointCloud& cloud, const AttachOptions& options, const Progress& progress = {});

/// Adds branches to the plant they were grown for; their places on edges become new nodes.
/// @return the first new nodes of each branch, as many as there are branches
std::vector<std::vector<NodeId>> addGrown(SkeletonEditor& editor,
                                          const std::vector<GrownBranch>& branches);

} // namespace espalier
