#include "core/mtg/mtg_reader.h"

#include "core/base/text.h"
#include "core/mtg/mtg_parser.h"
#include "core/mtg/mtg_source.h"

#include <utility>

namespace espalier {

bool isMtg(std::string_view beginning) {
  const std::string text = mtgSource(std::string(beginning)).text;
  LineReader lines(text);
  while (const auto line = lines.next()) {
    const std::string_view first = trimmed(*line);
    if (first.empty()) continue;
    return first.starts_with("CODE") && trimmed(first.substr(4)).starts_with(':');
  }
  return false;
}

Imported<Mtg> readMtg(std::istream& in, const std::string& file, const MtgReadOptions& options) {
  ParsedMtg parsed = parseMtg(readAll(in), file, options);
  return {std::move(parsed.mtg), std::move(parsed.notes)};
}

Imported<Mtg> readMtg(std::istream& in, const std::string& file) {
  return readMtg(in, file, {});
}

} // namespace espalier
