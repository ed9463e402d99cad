#pragma once

#include "core/cloud/point_cloud.h"
#include "core/evaluate/differences/differences.h"

#include <QString>

namespace espalier {

/// "Matched", "Missed", "Invented", "Wrongly attached"
[[nodiscard]] QString titleOf(Difference difference);

/// Grey, blue, vermillion and purple: distinct to the color-blind, on dark and on light.
[[nodiscard]] Color colorOf(Difference difference);

} // namespace espalier
