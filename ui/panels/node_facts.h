#pragma once

#include "core/skeleton/skeleton.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

class PlantDocument;

/// What a table shows of a node.
enum class NodeColumn : std::uint8_t {
  node,
  parent,
  edge,
  order,
  axis, // its number in the order of the review walk, from 1
  x,
  y,
  z,
  radius,
  length, // of the edge to the parent
  unit,   // class of the node's own entity of an MTG
  index,  // likewise
  mark,   // a unit is to start here
  review,
  comment,
  source, // of the radius
  least,  // bounds of its interval
  most
};
inline constexpr int nodeColumns = static_cast<int>(NodeColumn::most) + 1;

/// "Radius"
[[nodiscard]] QString nameOf(NodeColumn column);
/// The same for a file: "radius", never translated.
[[nodiscard]] QString keyOf(NodeColumn column);
[[nodiscard]] bool isLength(NodeColumn column); // in the unit of the document
[[nodiscard]] bool isNumber(NodeColumn column);

/// The cells of the table, read from the document one by one.
class NodeFacts {
public:
  /// @param document must outlive it
  explicit NodeFacts(const PlantDocument& document) : document_(document) {}

  /// Finds the orders and axes again, after an edit. O(N).
  void update();

  /// None where there is none, as the parent of a root. pre: the document has the node
  [[nodiscard]] std::optional<double> number(NodeId id, NodeColumn column) const;
  /// To all digits, whatever the locale. pre: likewise
  [[nodiscard]] QString text(NodeId id, NodeColumn column) const;

  [[nodiscard]] const PlantDocument& document() const { return document_; }

private:
  const PlantDocument& document_;
  std::vector<int> orders_; // by id
  std::vector<int> axes_;   // likewise
};

} // namespace espalier
