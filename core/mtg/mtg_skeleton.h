#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton.h"

#include <string>

namespace espalier {

/// Whether any vertex has a position, so that there is a skeleton of it.
/// @throws Error if a coordinate is no number
[[nodiscard]] bool hasPositions(const Mtg& mtg, const std::string& file);

/// The vertices of the finest scale that has positions, as a skeleton.
///
/// Positions are the features XX YY ZZ or X Y Z; radii the feature radius, or half of diameter; the
/// case of names does not matter. Vertices of this scale without a finite position are passed over,
/// with a note: what hangs on them hangs on the nearest ancestor that has one. Node ids follow the
/// order of the vertices.
///
/// @param file  name for messages
/// @throws Error if no vertex has a position, or a value is no number
[[nodiscard]] Imported<Skeleton> skeletonOf(const Mtg& mtg, const std::string& file);

} // namespace espalier
