#pragma once

#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_units.h"

#include <optional>
#include <vector>

namespace espalier {

/// Which vertices of an MTG the units of an edited skeleton are.
///
/// A unit is the vertex that started at its start before. Else it is a vertex that no unit is by
/// that rule, that one of its nodes was part of, and whose entity it carries: edits hand units on
/// to other nodes. Units in several parts are one vertex; what begins within a unit is another.
/// @param before, after  tables of view.skeleton and `edited`, of the same scales
/// @return by place in after.units(); none: it is new
/// Time O(n log n) for n nodes and their units.
[[nodiscard]] std::vector<std::optional<VertexId>> unitClaims(const Mtg& base, const MtgView& view,
                                                              const UnitTable& before,
                                                              const Skeleton& edited,
                                                              const UnitTable& after);

} // namespace espalier
