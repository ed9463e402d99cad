#pragma once

#include <string_view>

namespace espalier {

// The types of objects in a text scene of PlantGL. In objects that are passed over, only these
// names distinguish an object from a field.

/// Whether it is seen, but is no point set, and neither holds nor places some as they are.
[[nodiscard]] bool isOtherGeometry(std::string_view type);
/// Whether it moves, scales or turns another.
[[nodiscard]] bool isPlacing(std::string_view type);
/// Whether it sets how others look.
[[nodiscard]] bool isAppearance(std::string_view type);
/// Whether it is seen: also a point set, a group, a shape.
[[nodiscard]] bool isGeometry(std::string_view type);

} // namespace espalier
