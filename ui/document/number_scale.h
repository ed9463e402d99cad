#pragma once

#include <QString>

#include <vector>

namespace espalier {

/// The greatest of 1, 2 or 5 times a power of ten that is not above `most`; pre: most > 0
[[nodiscard]] double roundStep(double most);

/// The multiples of `step` within a range, for the numbers of an axis; pre: step > 0
[[nodiscard]] std::vector<double> multiplesOf(double step, double from, double to);

/// A number with its thousands parted, as everywhere in the window: "1 250.5". pre: decimals >= 0
[[nodiscard]] QString numberText(double value, int decimals);

/// A number with as many digits as a step between such numbers calls for: "1 250", "0.05".
[[nodiscard]] QString numberAtStep(double value, double step);

} // namespace espalier
