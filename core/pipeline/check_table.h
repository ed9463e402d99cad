#pragma once

#include "core/pipeline/option_table.h"
#include "core/skeleton/check_options.h"

namespace espalier {

/// The options of the checks: names, defaults, ranges and help.
[[nodiscard]] const OptionTable<CheckOptions>& checkTable();

} // namespace espalier
