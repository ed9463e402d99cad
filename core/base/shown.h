#pragma once

namespace espalier {

/// Marks English text that users see, for lupdate: core knows no Qt, so the window translates it
/// (ui/document/shown_text.h).
struct Shown {
  [[nodiscard]] static constexpr const char* tr(const char* english) { return english; }
};

} // namespace espalier
