#pragma once

#include <QString>

#include <optional>

namespace espalier {

/// The number that people typed, finite, with a point or a comma and any spaces, whatever the
/// system writes; none if it is none.
[[nodiscard]] std::optional<double> typedNumber(QString text);

} // namespace espalier
