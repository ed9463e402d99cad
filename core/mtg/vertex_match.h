#pragma once

#include "core/mtg/mtg.h"

#include <optional>
#include <vector>

namespace espalier {

/// Which vertex of a file each edited one is, and the other way round.
struct VertexMatch {
  std::vector<std::optional<VertexId>> before; // by edited vertex
  std::vector<std::optional<VertexId>> after;  // by vertex of the file
};

/// Matches the vertices of two plants in order: those of which the same is said, then those between
/// them, as far as these are as many or are the same but for what they are attached to. None if too
/// many differ.
/// pre: the features of `file` come first in `edited`, in their order
/// Time O((size of both) times vertices that differ).
[[nodiscard]] std::optional<VertexMatch> matchVertices(const Mtg& file, const Mtg& edited);

} // namespace espalier
