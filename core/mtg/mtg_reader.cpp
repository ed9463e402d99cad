#include "core/mtg/mtg_reader.h"

#include "core/mtg/mtg_parser.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/mtg_source.h"

#include <utility>

namespace espalier {

bool isMtg(std::string_view beginning) {
  return mtgCodeIn(mtgSource(std::string(beginning)).text).has_value();
}

Imported<Mtg> readMtg(std::istream& in, const std::string& file, const MtgReadOptions& options) {
  ParsedMtg parsed = parseMtg(readAll(in), file, options);
  return {std::move(parsed.mtg), std::move(parsed.notes)};
}

Imported<Mtg> readMtg(std::istream& in, const std::string& file) {
  return readMtg(in, file, {});
}

} // namespace espalier
