#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/entity.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// The features that hold position and radius of this vertex.
[[nodiscard]] std::vector<std::size_t> geometricFeatures(const Mtg& mtg, const MtgVertex& vertex);

/// Gives a vertex the label and values of an entity; features in `kept` keep their values. Classes
/// and features that the MTG lacks are added.
void writeEntity(Mtg& mtg, VertexId id, const Entity& entity, const std::vector<std::size_t>& kept);

/// Writes those coordinates that differ from what is written, as the shortest decimals that read
/// back. Adds XX, YY and ZZ if the MTG has no such features.
void writePosition(Mtg& mtg, VertexId id, const Eigen::Vector3d& position);

/// Writes a radius, or twice of it as the diameter; 0, not known, leaves none.
void writeRadius(Mtg& mtg, VertexId id, double radius);

} // namespace espalier
