#pragma once

#include <QString>

#include <optional>

namespace espalier {

/// Seconds until a job is done, if it goes on as it went; none while that would be a guess.
/// @param elapsed seconds since it started
/// @param fraction done, in [0, 1]
[[nodiscard]] std::optional<double> secondsLeft(double elapsed, double fraction);

/// "about 12 s left", "about 3 min left"; empty without a number.
[[nodiscard]] QString describeTimeLeft(std::optional<double> seconds);

} // namespace espalier
