#pragma once

#include "core/io/plantgl/pickle.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A property of OpenAlea's MTG: its values by vertex.
struct MtgProperty {
  std::string name;
  std::vector<std::pair<std::int64_t, PickleId>> values; // in order; of equal vertices the last
};

/// The tables of OpenAlea's class MTG, by the vertices' own numbers. (Trees, not hash tables: the
/// numbers are those of the file, which could choose them to collide.)
struct MtgTables {
  using ByVertex = std::map<std::int64_t, std::int64_t>;

  ByVertex scales;    // 0 is the scene
  ByVertex parents;   // at the same scale; without those that have none
  ByVertex complexes; // only where they are not the parent's
  std::vector<MtgProperty> properties;
};

/// The tables in a pickle of an MTG. Vertices without a scale stay in the tables.
/// @throws Error if it holds no MTG, or its tables are of other kinds, or share one another so
/// often
///         that walking along them would take more than linear time
[[nodiscard]] MtgTables mtgTablesIn(const Pickle& pickle, const std::string& file);

/// What a pickled MTG may mention: the class MTG first, then PlantGL's Vector3 by all its paths.
[[nodiscard]] std::span<const PickleGlobal> mtgGlobals();

/// The coordinates of a Vector3, or of a tuple or list of three numbers; none of anything else.
[[nodiscard]] std::optional<std::array<double, 3>> vectorIn(const Pickle& pickle, PickleId id);

} // namespace espalier
