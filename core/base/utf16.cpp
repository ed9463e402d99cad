#include "core/base/utf16.h"

#include "core/base/shown_message.h"

#include <algorithm>

namespace espalier {
namespace {

/// By its mark, or as every second byte is 0.
bool isUtf16(std::string_view beginning) {
  if (beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF")) return true;
  constexpr std::size_t few = 8;
  constexpr std::size_t looked = 256;
  const std::size_t bytes = std::min(beginning.size(), looked) / 2 * 2;
  const auto isText = [&](std::size_t zeros) { // at which of two places they are
    for (std::size_t i = 0; i < bytes; ++i)
      if ((beginning[i] == '\0') != (i % 2 == zeros)) return false;
    return bytes >= few;
  };
  return isText(0) || isText(1);
}

} // namespace

void requireNoUtf16(std::string_view beginning, const std::string& file) {
  if (isUtf16(beginning))
    throw ShownError({Shown::tr("is text of two bytes per character (UTF-16, \"Unicode Text\" in "
                                "Excel), which cannot be read: save it as UTF-8, or in Excel as "
                                "\"Text (Tab delimited)\""),
                      {},
                      FilePlace{file}});
}

} // namespace espalier
