#pragma once

#include "core/mtg/mtg.h"

#include <span>
#include <string>
#include <string_view>

namespace espalier {

// What is typed for an MTG by hand: taken as it is or refused, never evaluated. The messages are
// one sentence and say what is expected.

/// The value of a feature, without blanks around it. REAL must be a finite number, INT a whole one;
/// DD/MM, MM/YY, DD/MM/YY, DD/MM/YYYY and those with -TIME (hh:mm) a date of this form; of other
/// types any text that a line of an MTG can hold. Empty: no value.
/// @throws Error if it is not
[[nodiscard]] std::string typedValue(const MtgFeature& feature, const std::string& text);

/// The types of features whose values can be typed: REAL, INT, ALPHA, STRING, and those of dates.
/// (GEOMETRY, APPEARANCE and OBJECT name files of other programs.)
[[nodiscard]] std::span<const std::string_view> featureTypes();

/// A value of this type, to show: "12.5".
[[nodiscard]] std::string exampleOf(std::string_view featureType);

/// The name of a new feature: a letter, then letters, digits and _, which all readers of MTGs take
/// for a name; none that stands for a position, a radius or an alias.
/// @throws Error if it is not
[[nodiscard]] std::string typedFeatureName(const std::string& text);

/// The alias of a vertex: letters, digits, and _ - . in it, so that codes can begin with it. Empty:
/// it has none.
/// @throws Error if it is not
[[nodiscard]] std::string typedAlias(const std::string& text);

/// The symbol of a class: letters alone, which all readers of MTGs know.
/// @throws Error if it is not
[[nodiscard]] std::string typedSymbol(const std::string& text);

} // namespace espalier
