#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <QString>

namespace espalier {

/// Reads what a plant is to be compared with: a structure of any format, or the plant of a project,
/// as another expert has it.
/// @throws Error which file, where in it, what is wrong
[[nodiscard]] Imported<Skeleton> readReference(const QString& path);

} // namespace espalier
