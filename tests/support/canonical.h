#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier::test {

/// The same plant under ids that depend on nothing but the plant: two skeletons that differ in the
/// numbers of their nodes only have equal canonical forms. (Siblings must differ in edge, position
/// or radius.)
[[nodiscard]] Skeleton canonical(const Skeleton& skeleton);

/// The same nodes without what an MTG says of them.
[[nodiscard]] Skeleton withoutEntities(Skeleton skeleton);

/// The same nodes without where their radii are from, which files of others do not say.
[[nodiscard]] Skeleton withoutOrigins(Skeleton skeleton);

} // namespace espalier::test
