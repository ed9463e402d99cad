#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton.h"

#include <string>
#include <vector>

namespace espalier {

/// A skeleton as a view of an MTG, and where its nodes came from.
struct MtgView {
  int scale = 1;                             // of the vertices that are nodes
  Skeleton skeleton;                         // node i is the i-th of them
  std::vector<VertexId> vertices;            // by node id: the vertex it is
  std::vector<std::vector<VertexId>> starts; // by node id: the coarser ones that start at it, as
                                             // its entities are, without its own
  std::vector<NodeId> interpolated;          // nodes whose vertex has no position of its own
};

/// Whether any vertex has a position, so that there is a skeleton of it.
/// @throws Error if a coordinate is no number
[[nodiscard]] bool hasPositions(const Mtg& mtg, const std::string& file);

/// The vertices of the finest scale that has positions, as a skeleton.
///
/// Positions are the features XX YY ZZ or X Y Z; radii the feature radius, or half of diameter; the
/// case of names does not matter. A vertex of this scale without a finite position, but with an
/// ancestor and, along its axis, a successor that have one, stands evenly between these; others are
/// passed over: what is attached to them goes to the nearest ancestor that has one. Notes report
/// both. Node ids follow the order of the vertices.
///
/// Node::entities are its own vertex, with all values but position and radius, and before it the
/// coarser vertices it is a part of and its parent is not. A vertex in several separate parts is
/// carried by the first node of each; its values by the first of all.
///
/// @param file  name for messages
/// @throws Error if no vertex has a position, a value is no number, or there are over 32 scales
/// Time and memory O(size of the MTG).
[[nodiscard]] Imported<MtgView> viewOf(const Mtg& mtg, const std::string& file);

/// The same of an MTG that is worked on. One without positions is a view without nodes, of its
/// finest class: what is made in it becomes vertices of that scale.
/// @throws Error as viewOf, but for positions
[[nodiscard]] MtgView openedView(const Mtg& mtg);

/// The skeleton of viewOf().
[[nodiscard]] Imported<Skeleton> skeletonOf(const Mtg& mtg, const std::string& file);

/// What an MTG says of a vertex.
/// @param without  features to leave out of its values
[[nodiscard]] Entity entityOf(const Mtg& mtg, VertexId id,
                              const std::vector<std::size_t>& without = {});

} // namespace espalier
