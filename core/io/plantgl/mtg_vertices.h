#pragma once

#include "core/base/shown_message.h"
#include "core/io/plantgl/mtg_tables.h"
#include "core/mtg/mtg.h"

#include <map>
#include <string>
#include <vector>

namespace espalier {

/// The vertices of a pickled MTG without their values, and where they are.
struct TableVertices {
  Mtg mtg;                              // classes, rules and vertices; no features
  std::map<std::int64_t, VertexId> ids; // by the number in the tables
  std::vector<ShownMessage> notes;
};

/// Vertices, classes and edges by the rules stated at `readBmtg`. Vertices keep the order of their
/// numbers as far as parents and complexes can come first.
/// @throws Error if a vertex is attached to one that is missing or of a scale that does not fit,
///         or is among its own ancestors
/// Time O(N log N).
[[nodiscard]] TableVertices verticesOf(const Pickle& pickle, const MtgTables& tables,
                                       const std::string& file);

} // namespace espalier
