#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

/// Which units of coarser scales each node of a skeleton belongs to: those that start at it, and
/// for the other scales those of its parent (Node::entities).
class UnitTable {
public:
  struct Unit {
    NodeId start{};
    std::size_t entity = 0; // place in the entities of its start
    std::size_t scale = 0;  // place in scales()
  };

  /// @param scales     ascending, all that entities of units have
  /// @param nodeScale  entities of it and finer ones are of the nodes themselves
  /// Time and memory O(nodes x scales).
  UnitTable(const Skeleton& skeleton, std::vector<int> scales, int nodeScale);

  [[nodiscard]] const std::vector<int>& scales() const { return scales_; }
  [[nodiscard]] const std::vector<Unit>& units() const { return units_; } // parents' come first

  /// Place in units() of the one that a node belongs to; none if it belongs to none.
  [[nodiscard]] std::optional<std::size_t> at(NodeId id, std::size_t scale) const;
  /// The same of the parent of a node; none for a root.
  [[nodiscard]] std::optional<std::size_t> below(const Skeleton& skeleton, NodeId id,
                                                 std::size_t scale) const;

private:
  std::vector<int> scales_;
  std::vector<Unit> units_;
  std::vector<std::uint32_t> table_; // scales by node id; 0: none, else one more than the place
};

/// The scales of the entities of a skeleton that are coarser than `nodeScale`, ascending.
[[nodiscard]] std::vector<int> unitScales(const Skeleton& skeleton, int nodeScale);

} // namespace espalier
