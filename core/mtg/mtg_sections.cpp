#include "core/mtg/mtg_sections.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace espalier {
namespace {

constexpr auto sectionNames =
    std::to_array<std::string_view>({"CODE", "CLASSES", "DESCRIPTION", "FEATURES", "MTG"});

/// The section that a line opens, if it does: "FEATURES :".
std::string_view sectionOf(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return {};
  const std::string_view name = trimmed(line.substr(0, colon));
  const auto* found = std::ranges::find(sectionNames, name);
  return found == sectionNames.end() ? std::string_view() : *found;
}

/// Fields without empty ones; of a line without tabs, its words.
std::vector<std::string_view> filledFields(std::string_view line) {
  std::vector<std::string_view> fields = mtgFields(line);
  std::erase_if(fields, [](std::string_view field) { return field.empty(); });
  if (fields.size() != 1) return fields;
  std::string_view rest = fields.front();
  fields.clear();
  for (auto word = nextWord(rest); !word.empty(); word = nextWord(rest))
    fields.push_back(word);
  return fields;
}

void checkCode(std::string_view line, const std::string& where) {
  const std::vector<std::string_view> fields = filledFields(line.substr(line.find(':') + 1));
  if (fields.empty() || fields.front() != "FORM-A")
    throw Error(where + "only MTG files of code FORM-A can be read, this one is of code " +
                inQuotes(fields.empty() ? std::string_view() : fields.front()));
}

MtgClass classOf(std::string_view line, const std::string& where) {
  std::vector<std::string_view> fields = mtgFields(line);
  if (fields.size() < 2 || fields[1].empty()) fields = filledFields(line);
  MtgClass result;
  if (fields.size() < 2)
    throw Error(where + "expected a symbol and its scale, found " + inQuotes(trimmed(line)));
  result.symbol = fields[0];
  const char* end = fields[1].data() + fields[1].size();
  const auto [stop, error] = std::from_chars(fields[1].data(), end, result.scale);
  if (stop != end || error != std::errc{} || result.scale < 0)
    throw Error(where + "expected the scale of " + inQuotes(result.symbol) + ", found " +
                inQuotes(fields[1]));
  if (fields.size() > 2 && !fields[2].empty()) result.decomposition = fields[2];
  if (fields.size() > 3 && !fields[3].empty()) result.indexation = fields[3];
  if (fields.size() > 4 && !fields[4].empty()) result.definition = fields[4];
  return result;
}

/// Reads a line that is none of titles and empty lines into `mtg`.
void readLine(std::string_view line, std::string_view section, const std::string& where, Mtg& mtg) {
  const std::vector<std::string_view> fields = filledFields(line);
  if (fields.empty()) return;
  const auto field = [&](std::size_t i) {
    return i < fields.size() ? std::string(fields[i]) : std::string();
  };
  if (section == "CLASSES" && fields[0] != "SYMBOL") {
    mtg.classes.push_back(classOf(line, where));
  } else if (section == "DESCRIPTION" && fields[0] != "LEFT") {
    mtg.rules.push_back({field(0), field(1), field(2), field(3)});
  } else if (section == "FEATURES" && fields[0] != "NAME") {
    if (fields.size() < 2)
      throw Error(where + "the feature " + inQuotes(fields[0]) + " has no type, as REAL");
    mtg.features.push_back({field(0), field(1)});
  }
}

} // namespace

std::vector<std::string_view> mtgFields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find('\t', start), line.size());
    const std::string_view field = line.substr(start, end - start);
    fields.push_back(trimmed(field.substr(0, field.find('#'))));
    start = end + 1;
  }
  return fields;
}

Mtg readMtgSections(LineReader& lines, const std::string& file) {
  Mtg mtg;
  std::string_view section;
  while (const auto line = lines.next()) {
    const std::string where = place(file, lines.number());
    const std::string_view opened = sectionOf(*line);
    if (section.empty() && opened.empty() && !trimmed(mtgFields(*line).front()).empty())
      throw Error(where + "expected 'CODE: FORM-A', found " + inQuotes(trimmed(*line)) +
                  ": is this an MTG file?");
    if (opened == "CODE") checkCode(*line, where);
    if (opened == "MTG") {
      if (mtg.classes.empty()) throw Error(where + "no CLASSES are listed before the vertices");
      return mtg;
    }
    if (!opened.empty())
      section = opened;
    else
      readLine(*line, section, where, mtg);
  }
  throw Error(file + ": has no section 'MTG:': it is no MTG file, or is cut short");
}

} // namespace espalier
