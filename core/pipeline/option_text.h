#pragma once

#include "core/pipeline/option_table.h"

#include <string>

namespace espalier {

/// What a value may be: "0.5 to 20 point spacings", or its words.
[[nodiscard]] std::string rangeText(const Option& option);

/// "length, default 7.5 point spacings, range 0.5 to 20 point spacings"
[[nodiscard]] std::string summaryOf(const Option& option);

} // namespace espalier
