#pragma once

#include "core/base/imported.h"
#include "core/project/project.h"
#include "core/skeleton/skeleton.h"

#include <QString>

#include <optional>

namespace espalier {

/// Reads what a plant is to be compared with: a structure of any format, or the plant of a project,
/// as another expert has it.
/// @throws Error which file, where in it, what is wrong
[[nodiscard]] Imported<Skeleton> readReference(const QString& path);

/// The scan of a project, in whose frame its plant lies; none: it has none, or is a structure.
/// @throws Error as readReference
[[nodiscard]] std::optional<ScanReference> scanOfReference(const QString& path);

} // namespace espalier
