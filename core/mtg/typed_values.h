#pragma once

#include "core/mtg/mtg.h"

#include <string>

namespace espalier {

// What is typed for an MTG by hand: taken as it is or refused, never evaluated. The messages are
// one sentence and say what is expected.

/// The value of a feature, without blanks around it. REAL must be a finite number, INT a whole one;
/// DD/MM, MM/YY, DD/MM/YY, DD/MM/YYYY and those with -TIME (hh:mm) a date of this form; of other
/// types any text that a line of an MTG can hold. Empty: no value.
/// @throws Error if it is not
[[nodiscard]] std::string typedValue(const MtgFeature& feature, const std::string& text);

/// The symbol of a class: letters alone, which all readers of MTGs know.
/// @throws Error if it is not
[[nodiscard]] std::string typedSymbol(const std::string& text);

} // namespace espalier
