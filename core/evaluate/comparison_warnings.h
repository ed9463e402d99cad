#pragma once

#include "core/base/shown_message.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/traits/traits.h"

#include <optional>
#include <string>

namespace espalier {

/// A number with so many significant digits, as warnings have them.
[[nodiscard]] std::string inDigits(double value, int digits);

// Each says in a line what makes the numbers of a comparison doubtful; none if nothing does.

/// Several trees in one structure.
[[nodiscard]] std::optional<ShownMessage> warningOfTrees(const Traits& traits, ComparedAs as);
[[nodiscard]] std::optional<ShownMessage> warningOfTrees(const Traits& traits); // of one by itself

/// A structure without radii, the light on which is left out.
[[nodiscard]] ShownMessage warningOfNoRadii(ComparedAs as);
/// A structure by itself of which a hundredth of the length or more lies between nodes without
/// radii: what follows from radii lacks that wood. O(N)
[[nodiscard]] std::optional<ShownMessage> warningOfNoRadii(const Skeleton& plant);

/// Structures of very different size: the units, where the ratio is that of two of mm, cm and m.
[[nodiscard]] std::optional<ShownMessage> warningOfSize(const Traits& result,
                                                        const Traits& reference);

/// A result that was laid on the reference, where little of both lies near the other.
[[nodiscard]] std::optional<ShownMessage> warningOfFit(const Registration& registration);

/// Structures of which hardly anything lies near the other at the widest tolerance.
[[nodiscard]] std::optional<ShownMessage> warningOfDistance(const ToleranceCurve& curve,
                                                            bool isRegistered);

} // namespace espalier
