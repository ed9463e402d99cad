#pragma once

#include "core/base/shown_message.h"

#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A file of MTG text, as its parser and as its author see it: byte for byte at the same places.
struct MtgSource {
  std::string original; // UTF-8, whatever the file was in
  std::string text;     // the same with blanks for comments, and \n where only \r ended lines
  bool isLatin1 = false;
  std::vector<ShownMessage> notes; // what was done to read it; of the whole file
};

/// Takes the comments out of a file: from # to the next tab or line end, the whole line if # begins
/// it; from ; to the next tab or line end, where it begins a field or follows a blank; from (# to
/// #), over lines; a quote before # is one that Excel puts around a cell with a comma. So does it
/// with the signs 0x1A at the end of a file from DOS. Bytes that are no UTF-8 are taken
/// for Latin-1. Time O(size).
[[nodiscard]] MtgSource mtgSource(std::string bytes);

/// Whether Latin-1 has all characters of `text`. pre: text is UTF-8
[[nodiscard]] bool fitsLatin1(std::string_view text);
[[nodiscard]] std::string toLatin1(std::string_view text); // pre: fitsLatin1(text)

} // namespace espalier
