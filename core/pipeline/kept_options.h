#pragma once

#include "core/pipeline/pipeline_options.h"

#include <string>

namespace espalier {

/// Options as a project keeps them, and back: up and root, then the steps as a preset.
/// @throws Error if it is no such text
[[nodiscard]] std::string keptText(const PipelineOptions& options);
[[nodiscard]] PipelineOptions keptOptions(const std::string& text);

/// The document of a project that has them.
inline constexpr auto keptOptionsName = "pipeline";

} // namespace espalier
