#pragma once

#include "core/mtg/structure.h"
#include "core/project/project.h"

#include <memory>

namespace espalier {

/// What the MTG of a project says beside its plant; null: the plant is of no MTG. Edits go back
/// into it as into the file that was opened. Time O(size of the MTG).
/// @throws Error if the project is damaged there
[[nodiscard]] std::shared_ptr<const MtgFrame> frameOf(const Project& project);

} // namespace espalier
