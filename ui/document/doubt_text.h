#pragma once

#include "core/doubt/doubt.h"
#include "ui/document/length_unit.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace espalier {

/// A doubt of this kind, briefly, also where they are counted: "No wood?"
[[nodiscard]] QString nameOfOne(Doubt::Kind kind);

/// What is asked: "Is this branch wood? 12 cm long"
[[nodiscard]] QString questionOf(const Doubt& doubt, LengthUnit unit);

/// An answer in a few words: "as it is", "from node 14".
[[nodiscard]] QString textOf(const Doubt& doubt, const Alternative& alternative);

/// The alternatives in the order of their numbers, which are also their keys: what leaves the plant
/// as it is, then the others, the most probable first. So the first key means the same everywhere.
[[nodiscard]] std::vector<std::size_t> numbered(const Doubt& doubt);

} // namespace espalier
