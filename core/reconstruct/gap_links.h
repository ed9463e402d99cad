#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace espalier {

struct GapOptions {
  Length widest =
      spacings(3); // [L] edges this much longer than the wood is thick bridge a gap, > 0
  Length reach = spacings(50); // [L] how far across a gap wood is looked for, >= widest
  double turnCost = 4; // how much more a link costs that turns back than one straight on, >= 0
  Length backCost = spacings(20); // [L] what it costs that a branch points back, >= 0
};

/// What speaks for a link over a gap.
struct GapEvidence {
  double length = 0;      // [L]
  double cost = 0;        // [L], as withJoinedGaps() has it
  double goesOn = 0;      // cosine between the wood that is borne, at its end, and the link: 1 is
                          // straight on; 0 where it has no direction
  double miss = 0;        // from the place to the line that the wood goes on along, backwards [L]
  bool isFromTip = false; // of what bears it
  double goesOnBelow = 0; // likewise, at that tip
  double turn = 0;        // cosine between the link and the wood below the place; 0: none is there
  double radii = 0;       // difference of the logarithms of the radii at two tips, >= 0
  double thicker = 0;     // logarithm of the radius of the wood by that of the place, between -2
                          // and 2; 0 where one is not known
  double passes = 0;      // share of the link's middle that other wood is near
  bool isThere = false;   // the long edge itself
  std::size_t nodes = 0;  // of the fragment that bears it
  double backward = 0;    // branches that point back, see backwardBranches()
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // of the link, length 1; 0 if it has none
};

/// A link from a node of one fragment to one of another, which it would bear.
struct GapLink {
  NodeId from;
  NodeId to;
  std::uint32_t bearer = 0; // fragments
  std::uint32_t borne = 0;
  GapEvidence evidence;
};

/// The fragments of a skeleton between its long edges, and the links by which they may be attached
/// to each other.
struct Gaps {
  std::vector<NodeId> entries;    // of each fragment: its lowest node, as it is entered now
  std::vector<std::size_t> nodes; // in each
  /// By bearer and borne: of each two fragments in reach the cheapest, the shortest, the
  /// straightest for its length, and the edge that is there.
  std::vector<GapLink> links;
};

/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n log n + ends * nodes in reach).
[[nodiscard]] Gaps gapsIn(const Skeleton& skeleton, const GapOptions& options,
                          const Progress& progress = {});

/// Whether two links enter the same wood from about the same place: one within `near` [L] and a
/// fifth of the length of the other.
[[nodiscard]] bool isAlike(const Skeleton& skeleton, const GapLink& a, const GapLink& b,
                           double near);

/// A skeleton whose fragments are attached to each other by other links.
struct LinkedFragments {
  Skeleton skeleton;
  std::vector<int> chosen; // by fragment: its link, a place in Gaps::links; -1: as it was
};

/// Attaches the fragments to each other and at last to that of the root by the links with the least
/// sum of costs; fragments are turned around where that enters them elsewhere.
/// @param costs  one per link, finite
[[nodiscard]] LinkedFragments linkedBy(const Skeleton& skeleton, const Gaps& gaps,
                                       const std::vector<double>& costs);

} // namespace espalier
