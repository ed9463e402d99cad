#pragma once

#include <cstddef>
#include <string>

namespace espalier {

/// Text that Shown::tr() marks, with a number in the place of its "%1": "order %1" is "order 2".
/// The window finds the text again by the number in it (numberedText() in
/// ui/document/shown_text.h).
[[nodiscard]] inline std::string withNumber(std::string text, std::size_t number) {
  return text.replace(text.find("%1"), 2, std::to_string(number));
}

} // namespace espalier
