#pragma once

#include "core/pipeline/pipeline.h"

#include <QString>

#include <string>

namespace espalier {

/// What was chosen otherwise, as people say it: "Contract: radius 12.5 mm". Empty: nothing.
/// @param unit of lengths; empty: not known
[[nodiscard]] QString changeText(const PipelineOptions& before, const PipelineOptions& after,
                                 const PlantScale& scale, const QString& unit);

/// Options as a project keeps them, and back: up and root, then the steps as a preset.
/// @throws Error if it is no such text
[[nodiscard]] std::string keptText(const PipelineOptions& options);
[[nodiscard]] PipelineOptions keptOptions(const std::string& text);

/// A value with its unit, as the form of its step shows it: "12.5 mm", "7", "yes".
[[nodiscard]] QString valueText(const Option& option, double value, const QString& unit);

} // namespace espalier
