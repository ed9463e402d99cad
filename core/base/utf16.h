#pragma once

#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is text of two bytes per character, as Excel's "Unicode Text" is:
/// by its mark, or as every second byte is 0.
[[nodiscard]] bool isUtf16(std::string_view beginning);

/// Refuses text that cannot be read because it is of that kind.
/// @throws Error that names `file`, UTF-16 and what to try
void requireNoUtf16(std::string_view beginning, const std::string& file);

} // namespace espalier
