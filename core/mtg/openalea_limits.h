#pragma once

#include "core/mtg/mtg.h"

#include <string>
#include <vector>

namespace espalier {

/// What OpenAlea (openalea.mtg 2) stumbles over in the text that `writeMtg` writes, a line each:
/// values with signs of its own syntax, and types, symbols and names that it does not know. Nothing
/// of it is lost, nor in the way of other readers.
///
/// At most 20 values are named, the others are counted.
[[nodiscard]] std::vector<std::string> openAleaLimits(const Mtg& mtg);

} // namespace espalier
