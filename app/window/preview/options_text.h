#pragma once

#include "core/pipeline/pipeline.h"

#include <QString>

namespace espalier {

/// What was chosen otherwise, as people say it: "Contract: radius 12.5 mm". Empty: nothing. Where
/// no scan is open, values of steps mean nothing, and none is named.
/// @param unit of lengths; empty: not known
[[nodiscard]] QString changeText(const PipelineOptions& before, const PipelineOptions& after,
                                 const PlantScale& scale, const QString& unit);

/// The same of as many steps as have room in `most` characters, of one at least.
[[nodiscard]] QString shortChangeText(const PipelineOptions& before, const PipelineOptions& after,
                                      const PlantScale& scale, const QString& unit, qsizetype most);

/// A value with its unit, as the form of its step shows it: "12.5 mm", "7", "yes".
[[nodiscard]] QString valueText(const Option& option, double value, const QString& unit);

} // namespace espalier
