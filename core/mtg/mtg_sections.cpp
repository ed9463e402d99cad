#include "core/mtg/mtg_sections.h"

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

void checkCode(std::string_view line, const FilePlace& where) {
  const std::vector<std::string_view> fields =
      filledFields(line.substr(std::min(line.find(':'), line.size() - 1) + 1));
  const std::string_view form = fields.empty() ? std::string_view() : fields.front();
  if (isSameWord(form, "FORM-B"))
    throw ShownError(
        {espalier::Shown::tr("the code FORM-B is older than the syntax of MTG files, which does "
                             "not say how to read it: code the plant in FORM-A"),
         {},
         where});
  if (!isSameWord(form, "FORM-A"))
    throw ShownError(
        {espalier::Shown::tr("only MTG files of code FORM-A can be read, this one is of code %1"),
         {inQuotes(form)},
         where});
}

MtgClass classOf(std::string_view line, const FilePlace& where) {
  std::vector<std::string_view> fields = mtgFields(line);
  if (fields.size() < 2 || !numberIn(fields[1])) {
    const std::vector<std::string_view> words = wordsOf(line); // parted by blanks here and there
    if (words.size() < 2 || numberIn(words[1])) fields = words;
  }
  MtgClass result;
  if (fields.size() < 2)
    throw ShownError({espalier::Shown::tr("expected a symbol and its scale, found %1"),
                      {inQuotes(trimmed(line))},
                      where});
  result.symbol = fields[0];
  const char* end = fields[1].data() + fields[1].size();
  const auto [stop, error] = std::from_chars(fields[1].data(), end, result.scale);
  if (stop != end || error != std::errc{} || result.scale < 0 || result.scale > finestScale)
    throw ShownError(
        {espalier::Shown::tr("expected the scale of %1, a number from 0 to %2, found %3"),
         {inQuotes(result.symbol), std::to_string(finestScale), inQuotes(fields[1])},
         where});
  if (result.symbol.size() > longestSymbol)
    throw ShownError(
        {espalier::Shown::tr("the symbol %1 is too long"), {inQuotes(result.symbol)}, where});
  if (fields.size() > 2 && !fields[2].empty()) result.decomposition = fields[2];
  if (fields.size() > 3 && !fields[3].empty()) result.indexation = fields[3];
  if (fields.size() > 4 && !fields[4].empty()) result.definition = fields[4];
  return result;
}

void addFeature(const std::vector<std::string_view>& fields, const FilePlace& where,
                MtgNotes& notes, std::unordered_set<std::string>& known, Mtg& mtg) {
  MtgFeature feature{std::string(fields[0]), "ALPHA"};
  if (fields.size() > 1)
    feature.type = typeOf(fields[1]);
  else
    notes.repaired(where, {espalier::Shown::tr("the feature %1 has no type and is taken as ALPHA"),
                           {inQuotes(feature.name)}});
  if (fields.size() > 2) feature.file = fields[2];
  if (known.insert(feature.name).second)
    mtg.features.push_back(std::move(feature));
  else
    notes.repaired(
        where, {espalier::Shown::tr("the feature %1 is listed twice"), {inQuotes(feature.name)}});
}

/// Refuses what stands before the line of the code.
void checkBeginning(std::string_view line, std::string_view opened, const FilePlace& where) {
  if (!opened.empty() && opened != "CODE")
    throw ShownError({espalier::Shown::tr(
                          "the section %1 stands before 'CODE : FORM-A': put that line at the top"),
                      {std::string(opened)},
                      where});
  if (opened.empty() && !trimmed(line).empty())
    throw ShownError(
        {espalier::Shown::tr("expected 'CODE: FORM-A', found %1: is this an MTG file?"),
         {inQuotes(trimmed(line))},
         where});
}

/// Reads lines that are none of titles and empty lines.
class SectionReader {
public:
  SectionReader(Mtg& mtg, MtgNotes& notes) : mtg_(mtg), notes_(notes) {}

  void read(std::string_view line, std::string_view section, const FilePlace& where) {
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
  void addClass(MtgClass added, const FilePlace& where) {
    if (symbols_.insert(added.symbol).second)
      mtg_.classes.push_back(std::move(added));
    else
      notes_.repaired(
          where, {espalier::Shown::tr("the class %1 is listed twice: the first line of it counts"),
                  {inQuotes(added.symbol)}});
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
    const FilePlace where{notes.file(), lines.number()};
    const std::string_view opened = mtgSectionOf(*line);
    if (section.empty()) checkBeginning(*line, opened, where);
    if (opened == "CODE") checkCode(*line, where);
    const bool isOfColumns = !section.empty() && isMtgColumnName(mtgFields(*line).front());
    if (isOfColumns) {
      notes.repaired(
          where, {espalier::Shown::tr("the line 'MTG :' is missing before that of the columns")});
      lines = before;
    }
    if (opened == "MTG" || isOfColumns) {
      if (mtg.classes.empty())
        throw ShownError(
            {espalier::Shown::tr("no CLASSES are listed before the vertices"), {}, where});
      return mtg;
    }
    if (!opened.empty())
      section = opened;
    else
      reader.read(*line, section, where);
  }
  throw ShownError(
      {espalier::Shown::tr("has no section 'MTG:': it is no MTG file, or is cut short"),
       {},
       FilePlace{notes.file()}});
}

} // namespace espalier
