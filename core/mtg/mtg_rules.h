#pragma once

#include "core/mtg/mtg.h"

namespace espalier {

/// `edited` with rules for the classes that `base` does not have, if `base` has rules at all:
/// OpenAlea and the programs after it expect a line of DESCRIPTION for each class that is linked.
///
/// Each new class may follow and branch off itself, and get what links it has with other classes
/// here, each as often as one likes. No rule is made twice.
/// Time O(vertices).
[[nodiscard]] Mtg withRulesOfNewClasses(const Mtg& base, Mtg edited);

} // namespace espalier
