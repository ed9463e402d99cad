#pragma once

#include <string>
#include <string_view>

namespace espalier {

/// Refuses text of two bytes per character, as Excel's "Unicode Text" is.
/// @throws Error that names `file`, UTF-16 and what to try
void requireNoUtf16(std::string_view beginning, const std::string& file);

} // namespace espalier
