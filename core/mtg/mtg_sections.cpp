#include "core/mtg/mtg_sections.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>

namespace espalier {
namespace {

constexpr auto sectionNames =
    std::to_array<std::string_view>({"CODE", "CLASSES", "DESCRIPTION", "FEATURES", "MTG"});

constexpr auto featureTypes = std::to_array<std::string_view>(
    {"INT", "REAL", "STRING", "ALPHA", "BOOLEAN", "DD/MM", "MM/YY", "DD/MM/YY", "DD/MM/YYYY",
     "DD/MM-TIME", "DD/MM/YY-TIME", "GEOMETRY", "APPEARANCE", "OBJECT"});

constexpr std::size_t longestSymbol = 100; // bounds the search for the symbol in a label

bool isSameWord(std::string_view a, std::string_view b) {
  return lowerCase(a) == lowerCase(b);
}

/// Words parted by blanks or tabs, where those parted by commas are one: "U, W".
std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (auto word = nextWord(line); !word.empty(); word = nextWord(line)) {
    const std::string_view next = trimmed(word); // of blanks that part no words
    if (next.empty()) continue;
    if (!words.empty() && (words.back().ends_with(',') || next.starts_with(',')))
      words.back() = {words.back().data(), next.data() + next.size()};
    else
      words.push_back(next);
  }
  return words;
}

/// Fields without empty ones; of a line without tabs, its words.
std::vector<std::string_view> filledFields(std::string_view line) {
  std::vector<std::string_view> fields = mtgFields(line);
  std::erase_if(fields, [](std::string_view field) { return field.empty(); });
  return fields.size() == 1 ? wordsOf(fields.front()) : fields;
}

/// A type as other programs spell it. Behind it may stand what its author says of it: "INT (mm)".
std::string typeOf(std::string_view field) {
  std::string_view rest = field;
  const std::string_view word = nextWord(rest);
  const auto* known = std::ranges::find_if(
      featureTypes, [&](std::string_view type) { return isSameWord(type, word); });
  return std::string(known == featureTypes.end() ? field : *known);
}

void checkCode(std::string_view line, const std::string& where) {
  const std::vector<std::string_view> fields =
      filledFields(line.substr(std::min(line.find(':'), line.size() - 1) + 1));
  const std::string_view form = fields.empty() ? std::string_view() : fields.front();
  if (isSameWord(form, "FORM-B"))
    throw Error(where + "the code FORM-B is older than the syntax of MTG files, which does not say "
                        "how to read it: code the plant in FORM-A");
  if (!isSameWord(form, "FORM-A"))
    throw Error(where + "only MTG files of code FORM-A can be read, this one is of code " +
                inQuotes(form));
}

MtgClass classOf(std::string_view line, const std::string& where) {
  std::vector<std::string_view> fields = mtgFields(line);
  if (fields.size() < 2 || !numberIn(fields[1])) {
    const std::vector<std::string_view> words = wordsOf(line); // parted by blanks here and there
    if (words.size() < 2 || numberIn(words[1])) fields = words;
  }
  MtgClass result;
  if (fields.size() < 2)
    throw Error(where + "expected a symbol and its scale, found " + inQuotes(trimmed(line)));
  result.symbol = fields[0];
  const char* end = fields[1].data() + fields[1].size();
  const auto [stop, error] = std::from_chars(fields[1].data(), end, result.scale);
  if (stop != end || error != std::errc{} || result.scale < 0 || result.scale > finestScale)
    throw Error(where + "expected the scale of " + inQuotes(result.symbol) +
                ", a number from 0 to " + std::to_string(finestScale) + ", found " +
                inQuotes(fields[1]));
  if (result.symbol.size() > longestSymbol)
    throw Error(where + "the symbol " + inQuotes(result.symbol) + " is too long");
  if (fields.size() > 2 && !fields[2].empty()) result.decomposition = fields[2];
  if (fields.size() > 3 && !fields[3].empty()) result.indexation = fields[3];
  if (fields.size() > 4 && !fields[4].empty()) result.definition = fields[4];
  return result;
}

void addFeature(const std::vector<std::string_view>& fields, const std::string& where,
                MtgNotes& notes, std::unordered_set<std::string>& known, Mtg& mtg) {
  MtgFeature feature{std::string(fields[0]), "ALPHA"};
  if (fields.size() > 1)
    feature.type = typeOf(fields[1]);
  else
    notes.repaired(where,
                   "the feature " + inQuotes(feature.name) + " has no type and is taken as ALPHA");
  if (fields.size() > 2) feature.file = fields[2];
  if (known.insert(feature.name).second)
    mtg.features.push_back(std::move(feature));
  else
    notes.repaired(where, "the feature " + inQuotes(feature.name) + " is listed twice");
}

/// Reads lines that are none of titles and empty lines.
class SectionReader {
public:
  SectionReader(Mtg& mtg, MtgNotes& notes) : mtg_(mtg), notes_(notes) {}

  void read(std::string_view line, std::string_view section, const std::string& where) {
    const std::vector<std::string_view> fields = filledFields(line);
    if (fields.empty()) return;
    const auto field = [&](std::size_t i) {
      return i < fields.size() ? std::string(fields[i]) : std::string();
    };
    if (section == "CLASSES" && !isSameWord(fields[0], "SYMBOL"))
      addClass(classOf(line, where), where);
    else if (section == "DESCRIPTION" && !isSameWord(fields[0], "LEFT"))
      mtg_.rules.push_back({field(0), field(1), field(2), field(3)});
    else if (section == "FEATURES" && !isSameWord(fields[0], "NAME"))
      addFeature(fields, where, notes_, features_, mtg_);
  }

private:
  void addClass(MtgClass added, const std::string& where) {
    if (symbols_.insert(added.symbol).second)
      mtg_.classes.push_back(std::move(added));
    else
      notes_.repaired(where, "the class " + inQuotes(added.symbol) +
                                 " is listed twice: the first line of it counts");
  }

  Mtg& mtg_;
  MtgNotes& notes_;
  std::unordered_set<std::string> symbols_;
  std::unordered_set<std::string> features_;
};

} // namespace

std::string_view mtgSectionOf(std::string_view line) {
  const std::size_t colon = line.find(':');
  const std::string_view name = trimmed(line.substr(0, colon));
  const auto* found = std::ranges::find_if(sectionNames, [&](std::string_view section) {
    return colon == std::string_view::npos ? name == section : isSameWord(name, section);
  });
  return found == sectionNames.end() ? std::string_view() : *found;
}

bool isMtgColumnName(std::string_view field) {
  return isSameWord(field, "ENTITY-CODE") || isSameWord(field, "TOPO");
}

std::string lineEndOf(const std::string& text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string::npos || text[end] == '\n') return "\n";
  return text.compare(end, 2, "\r\n") == 0 ? "\r\n" : "\r";
}

std::vector<std::string_view> mtgFields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find('\t', start), line.size());
    const std::string_view field = line.substr(start, end - start);
    fields.push_back(trimmed(field));
    start = end + 1;
  }
  return fields;
}

std::optional<LineReader> mtgCodeIn(std::string_view text) {
  LineReader lines(text);
  bool isFirst = true; // then it is the code, whatever its form
  for (LineReader before = lines; const auto line = lines.next(); before = lines) {
    if (trimmed(*line).empty()) continue;
    const bool isCode = mtgSectionOf(*line) == "CODE" && line->find(':') != std::string_view::npos;
    if (isCode && (isFirst || lowerCase(*line).find("form-") != std::string::npos)) return before;
    isFirst = false;
  }
  return std::nullopt;
}

Mtg readMtgSections(LineReader& lines, MtgNotes& notes) {
  Mtg mtg;
  SectionReader reader(mtg, notes);
  std::string_view section;
  for (LineReader before = lines; const auto line = lines.next(); before = lines) {
    const std::string where = place(notes.file(), lines.number());
    const std::string_view opened = mtgSectionOf(*line);
    if (section.empty() && !opened.empty() && opened != "CODE")
      throw Error(where + "the section " + std::string(opened) +
                  " stands before 'CODE : FORM-A': put that line at the top");
    if (section.empty() && opened.empty() && !trimmed(*line).empty())
      throw Error(where + "expected 'CODE: FORM-A', found " + inQuotes(trimmed(*line)) +
                  ": is this an MTG file?");
    if (opened == "CODE") checkCode(*line, where);
    const bool isOfColumns = !section.empty() && isMtgColumnName(mtgFields(*line).front());
    if (isOfColumns) {
      notes.repaired(where, "the line 'MTG :' is missing before that of the columns");
      lines = before;
    }
    if (opened == "MTG" || isOfColumns) {
      if (mtg.classes.empty()) throw Error(where + "no CLASSES are listed before the vertices");
      return mtg;
    }
    if (!opened.empty())
      section = opened;
    else
      reader.read(*line, section, where);
  }
  throw Error(notes.file() + ": has no section 'MTG:': it is no MTG file, or is cut short");
}

} // namespace espalier
