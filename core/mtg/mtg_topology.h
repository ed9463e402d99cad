#pragma once

#include "core/mtg/mtg.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace espalier {

/// Adds vertices to an MTG from the codes of its text, such as "^<N", "/P1/A1" or "+B2/U1".
///
/// A code without ^ hangs on the last vertex of the column before its own, one with ^ on the last
/// vertex of its own column; in the first column, a code without ^ hangs on the scene if it begins
/// with / and its class is of the coarsest scale, else continues the column. A code
/// of a coarser scale than that vertex hangs on what it is a part of, and its own first part hangs
/// on the vertex; + leaves the vertex open for more codes with ^. Ranges (<<, ++), aliases and
/// dates are not read.
class MtgTopology {
public:
  explicit MtgTopology(Mtg& mtg); // mtg.classes are complete

  /// Adds the vertices of a code that stands in `column`.
  /// @param where  the start of messages
  /// @return the last vertex of the code, to which the values of the line belong
  /// @throws Error if the code is malformed, or hangs on nothing
  VertexId add(std::string_view code, std::size_t column, const std::string& where);

private:
  struct Label {
    std::string symbol;
    int scale = 1;
    std::optional<int> index;
  };
  struct Entry { // from which vertex, and how, a coarser one was reached: its first part hangs
                 // there
    VertexId vertex;
    EdgeType edge;
  };

  struct Column { // what stands in it so far; nothing stands for the scene
    std::optional<VertexId> last;
    std::map<int, VertexId> lastOfScale;
  };

  [[nodiscard]] Label labelOf(std::string_view text, const std::string& where) const;
  [[nodiscard]] Column anchor(std::string_view code, std::size_t column,
                              const std::string& where) const;
  [[nodiscard]] std::optional<VertexId> upTo(std::optional<VertexId> vertex, int scale) const;
  [[nodiscard]] std::optional<VertexId> bearerOf(const Label& label, char edge,
                                                 const Column& before) const;
  void place(VertexId id, char edge, Column& column) const;
  VertexId attach(const Label& label, char edge, const Column& before, const std::string& where);
  void linkFirstPart(MtgVertex& part, VertexId id);

  Mtg& mtg_;
  int coarsest_ = 1;
  std::unordered_map<std::string, int> scales_; // by symbol
  std::map<VertexId, Entry> entries_;           // of vertices that have no parts yet
  std::vector<Column> columns_;
};

} // namespace espalier
