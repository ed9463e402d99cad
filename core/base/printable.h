#pragma once

#include <string>
#include <string_view>

namespace espalier {

[[nodiscard]] bool isUtf8(std::string_view text);

/// `text` as a terminal may show it, on one line: whatever breaks the line, steers the terminal or
/// is no UTF-8 becomes "?". Names of files may hold any of it.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace espalier
