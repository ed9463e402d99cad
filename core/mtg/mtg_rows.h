#pragma once

#include "core/mtg/mtg.h"

#include <vector>

namespace espalier {

/// How a line of MTG text writes a vertex: "\t^<U3" is in column 1, continues it, by edge <.
struct MtgRow {
  VertexId vertex{};
  std::size_t column = 0;
  bool continues = false; // is attached to the last of its own column (^), else of that before it
  char edge = '/';
};

/// All vertices in the order of their lines: each after what it is attached to, and directly after
/// all that branches off before it.
struct MtgRows {
  std::vector<MtgRow> rows;
  std::size_t columns = 1;
  /// A vertex has three successors or more, so that some stand without ^ below another of their
  /// column: programs differ on what those follow.
  bool isAmbiguous = false;
};

/// Lays out an MTG as lines.
///
/// What has a successor continues its column with it; other children open the next column. Beyond
/// 64 columns what carries most continues, so that there are at most log2(vertices) more. A vertex
/// that begins parts of its own is attached to the finest vertex that its first part is attached
/// to, as in "/U1/E1<E2+U1/E1". Children keep the order of their ids, but for: successors that open
/// a column first, the one that continues it last.
/// @throws Error if a vertex is attached where no text can attach it: its parent is of another
///         complex, to which its own complex is not attached by the same edge
/// Time O(vertices times scales, and their sorting).
[[nodiscard]] MtgRows mtgRows(const Mtg& mtg);

} // namespace espalier
