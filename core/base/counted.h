#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace espalier {

/// "1 point", "2 points", "0 points"; with `many` where an s does not do: "1 vertex", "2 vertices".
[[nodiscard]] inline std::string counted(std::size_t number, std::string_view one,
                                         std::string_view many = {}) {
  std::string text = std::to_string(number) + ' ';
  if (number == 1 || many.empty())
    text += one;
  else
    text += many;
  return number == 1 || !many.empty() ? text : text + 's';
}

} // namespace espalier
