#pragma once

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>
#include <string>
#include <vector>

namespace espalier {

/// Names in a message: "'a', 'b'"; of many the first 10, "+ 7".
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (i > 0 ? ", " : "") + inQuotes(names[i]);
  if (names.size() > most) list += ", + " + std::to_string(names.size() - most);
  return list;
}

/// The first notes of many, and how many more there are: nobody reads 500 000 lines.
[[nodiscard]] inline std::vector<ShownMessage> firstNotes(const std::vector<ShownMessage>& notes) {
  constexpr std::size_t most = 20;
  if (notes.size() <= most) return notes;
  std::vector<ShownMessage> first(notes.begin(), notes.begin() + most);
  const std::size_t others = notes.size() - most;
  first.push_back(others == 1
                      ? ShownMessage{Shown::tr("and 1 note more")}
                      : ShownMessage{Shown::tr("and %1 notes more"), {std::to_string(others)}});
  return first;
}

} // namespace espalier
