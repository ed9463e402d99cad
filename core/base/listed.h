#pragma once

#include "core/base/counted.h"
#include "core/base/text.h"

#include <algorithm>
#include <string>
#include <vector>

namespace espalier {

/// Names in a message: "'a', 'b'"; of many the first 10, "and 7 more".
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (i > 0 ? ", " : "") + inQuotes(names[i]);
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list;
}

/// The first notes of many, and how many more there are: nobody reads 500 000 lines.
[[nodiscard]] inline std::vector<std::string> firstNotes(const std::vector<std::string>& notes) {
  constexpr std::size_t most = 20;
  if (notes.size() <= most) return notes;
  std::vector<std::string> first(notes.begin(), notes.begin() + most);
  first.push_back("and " + counted(notes.size() - most, "note") + " more");
  return first;
}

} // namespace espalier
