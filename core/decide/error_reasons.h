#pragma once

#include "core/decide/error_odds.h"

#include <cstdint>
#include <vector>

namespace espalier {

/// What speaks for an error in a piece of a plant.
struct ErrorReason {
  enum class Kind : std::uint8_t {
    inAir,            // no point is near a share of it
    noPointsOfItsOwn, // its beginning has none
    scatter,          // its points lie off its surface
    fewPoints,        // on it
    unexplained,      // points beside it belong to no wood
    beside,           // it is near other wood
    turn,             // where it begins
    findings,         // of its shape
    end,              // it may be no shoot
    gap,              // that it bridges may be bridged otherwise
    extent,           // wood as long, and with as much above it, is often wrong
    radius            // likewise as thick
  };
  Kind kind;
  double effect = 0; // on the logarithm of the odds of an error

  bool operator==(const ErrorReason&) const = default;
};

/// Why a piece is risky: what makes an error more probable by half at least (in odds) than if it
/// were as is usual of wood that is right. The strongest first.
///
/// Each is taken alone, as the odds are a sum; features of one kind together.
[[nodiscard]] std::vector<ErrorReason> reasonsFor(const ErrorEvidence& evidence,
                                                  const ErrorOdds& odds = fittedErrorOdds());

} // namespace espalier
