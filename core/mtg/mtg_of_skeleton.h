#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/structure.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>

namespace espalier {

/// The scales of an MTG made from a skeleton that carries none.
enum class MtgStyle : std::uint8_t {
  plantNode,    // P of scale 1, N of scale 2, as PlantScan3D writes
  plantAxisNode // P, A and N: an axis for each root and each branching node
};

/// Whether a structure has scales of its own, which an MTG of it keeps: no style applies then.
[[nodiscard]] bool hasScales(const Structure& structure);

/// Whether a structure is a plant without its shape: an MTG none of whose vertices has a position,
/// and no node made since. Time O(vertices).
[[nodiscard]] bool isWithoutPositions(const Structure& structure);

/// An MTG of a skeleton alone, with features XX YY ZZ radius.
///
/// If any node carries entities these are its classes, `style` is not looked at, and nodes that
/// carry none are of the class of their parents; else plants and axes are numbered from 1.
/// pre: a node that carries entities carries its own as the last
/// @throws Error if a position or radius is not finite
/// Time O(n log n).
[[nodiscard]] Mtg mtgOf(const Skeleton& skeleton, MtgStyle style = MtgStyle::plantNode);

} // namespace espalier
