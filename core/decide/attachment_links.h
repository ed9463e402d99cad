#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// What speaks for wood growing from a place of other wood. Lengths in point spacings.
struct AttachmentEvidence {
  double gap = 0;       // between the surfaces of the two
  double goesOn = 0;    // cosine between the wood and the edge that would attach it
  double turn = 0;      // cosine between the wood and that below the place
  double miss = 0;      // from the place to the line that the wood goes on along, backwards
  double thicker = 0;   // logarithm of its radius by that of the place; 0 where one is not known
  double inAir = 0;     // share of the edge that no point is near
  double upward = 0;    // cosine between the edge and up
  double end = 0;       // length of the unbranched wood that ends at the place; 0: none does
  double carried = 0;   // by the wood, its own length included
  double sibling = -1;  // cosine between what else goes on there, the straightest, and the wood
                        // below; -1: nothing does
  bool isThere = false; // it is attached there now
};

/// A node that some wood may grow from.
struct AttachmentLink {
  NodeId from;
  AttachmentEvidence evidence;
};

/// From where the wood above an edge may grow.
struct AttachmentChoice {
  NodeId node; // the lowest of that wood
  /// At most one for each unbranched run of nodes: the first is as it is now, the others by how
  /// short and straight they are; never fewer than two.
  std::vector<AttachmentLink> links;
};

/// What each branch of a plant may be attached to: other wood, not what it carries nor what meets
/// it where it is attached now. Asked of each child of a branching, and of what lies beyond long
/// edges.
///
/// @param skeleton with radii, in the frame of the file
/// @param points   of the scan, 3 x N, in the frame of the skeleton less `origin`; `index` is
/// theirs
/// @param spacing  of points [L], > 0
/// @param up       length 1
/// @throws Cancelled if `progress` asks to stop
/// Uses all threads, deterministic. Time O(n m log N), m: nodes within 30 spacings of a branch.
[[nodiscard]] std::vector<AttachmentChoice>
attachmentChoices(const Skeleton& skeleton, const SpatialIndex& index,
                  const Eigen::Vector3d& origin, double spacing, const Eigen::Vector3d& up,
                  const Progress& progress = {});

} // namespace espalier
