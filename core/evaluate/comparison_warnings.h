#pragma once

#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/traits/traits.h"

#include <string>
#include <string_view>

namespace espalier {

// Each says in a line what makes the numbers of a comparison doubtful; empty if nothing does.

/// Several trees in one structure. `role` is what the user calls it: "the result".
[[nodiscard]] std::string warningOfTrees(const Traits& traits, std::string_view role);
[[nodiscard]] std::string warningOfTrees(const Traits& traits); // of a plant measured by itself

/// Structures of very different size: the units, where the ratio is that of two of mm, cm and m.
[[nodiscard]] std::string warningOfSize(const Traits& result, const Traits& reference);

/// A result that was laid on the reference, where little of both lies near the other.
[[nodiscard]] std::string warningOfFit(const Registration& registration);

/// Structures of which hardly anything lies near the other at the widest tolerance.
[[nodiscard]] std::string warningOfDistance(const ToleranceCurve& curve, bool isRegistered);

} // namespace espalier
