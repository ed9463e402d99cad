#include "core/mtg/mtg_text_edit.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mtg/mtg_cells.h"
#include "core/mtg/mtg_comments.h"
#include "core/mtg/mtg_line_edits.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_parser.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/mtg_values.h"
#include "core/mtg/mtg_writer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

namespace espalier {
namespace {

/// Behind the last line of the section FEATURES that holds something; none without the section.
std::optional<std::size_t> endOfFeatures(const ParsedMtg& file) {
  const std::string_view text(file.source.text);
  std::string_view section;
  std::optional<std::size_t> end;
  for (std::size_t start = 0; start < file.columnsStart;) {
    const std::size_t next = std::min(text.find('\n', start), text.size() - 1) + 1;
    const std::string_view line = text.substr(start, next - start);
    const std::string_view opened = mtgSectionOf(line);
    if (!opened.empty()) section = opened;
    if (section == "FEATURES" && !trimmed(line).empty()) end = next;
    start = next;
  }
  return end;
}

/// Behind all columns of the line of columns, before its comment and its line end.
std::size_t endOfColumns(const ParsedMtg& file) {
  std::size_t end = file.start;
  while (end > file.columnsStart &&
         std::string_view(" \r\n").find(file.source.text[end - 1]) != std::string_view::npos)
    --end;
  return end;
}

std::string lineOf(const MtgFeature& feature) {
  return feature.name + '\t' + feature.type + (feature.file.empty() ? "" : '\t' + feature.file);
}

/// The text of a file with more features: a line for each at the end of its section FEATURES, and a
/// column behind the others. All else stays as it was, comments too.
///
/// @param added none of those of the file
/// @return none if the file has no such section, or no column of a feature: codes would stand where
/// the new columns begin
/// Time O(sections).
std::optional<std::string> withMoreFeatures(const ParsedMtg& file,
                                            const std::vector<MtgFeature>& added) {
  const std::optional<std::size_t> features = endOfFeatures(file);
  const auto isKnown = [](const std::optional<std::size_t>& feature) {
    return feature.has_value();
  };
  if (!features || std::ranges::none_of(file.columns.features, isKnown)) return std::nullopt;
  std::string lines;
  std::string columns;
  for (const MtgFeature& feature : added) {
    lines += lineOf(feature) + lineEndOf(file.source.original);
    columns += '\t' + feature.name;
  }
  std::string text = file.source.original;
  text.insert(endOfColumns(file), columns); // the later place first
  text.insert(*features, lines);
  return text;
}

constexpr const char* resultName = "MTG";

bool isSamePlace(const MtgVertex& a, const MtgVertex& b) {
  return a.symbol == b.symbol && a.index == b.index && a.scale == b.scale &&
         a.complex == b.complex && a.parent == b.parent && (!a.parent || a.edge == b.edge) &&
         a.alias == b.alias && a.later.size() == b.later.size();
}

bool isSamePlant(const Mtg& a, const Mtg& b) {
  return std::ranges::equal(a.vertices, b.vertices, isSamePlace);
}

/// Whether both are the same plant, but for the spelling of values.
bool isSame(const Mtg& file, const Mtg& edited) {
  const FeatureMatch match(file, edited);
  const auto isSameVertex = [&](const MtgVertex& a, const MtgVertex& b) {
    return match.isSame(a.values, b.values) &&
           std::ranges::equal(a.later, b.later,
                              [&](const auto& x, const auto& y) { return match.isSame(x, y); });
  };
  return isSamePlant(file, edited) &&
         std::ranges::equal(file.vertices, edited.vertices, isSameVertex);
}

/// The text with other values in its cells; none if more than cells must change.
std::optional<std::string> withOtherCells(const ParsedMtg& file, const Mtg& edited) {
  if (!isSamePlant(file.mtg, edited)) return std::nullopt;
  const FeatureMatch match(file.mtg, edited);
  std::string text;
  std::size_t copied = 0;
  for (const MtgLine& line : file.lines) {
    const auto changes = cellChanges(file, line, mtgValuesAt(edited, line.last, line.date), match);
    if (!changes) return std::nullopt;
    appendChanged(file.source.original, *changes, copied, text);
  }
  return text + file.source.original.substr(copied);
}

std::string withLineEnds(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += end;
    else
      result += c;
  return result;
}

/// `mtg` with the features of the file first, in the order they have there.
Mtg withFeaturesLike(const Mtg& file, Mtg mtg) {
  const auto placeInFile = [&](const MtgFeature& feature) {
    return std::ranges::find(file.features, feature.name, &MtgFeature::name) -
           file.features.begin();
  };
  std::vector<std::pair<std::ptrdiff_t, std::size_t>> order;
  for (std::size_t i = 0; i < mtg.features.size(); ++i)
    order.emplace_back(placeInFile(mtg.features[i]), i);
  std::ranges::sort(order);
  const auto reorder = [&](std::vector<std::string>& values) {
    std::vector<std::string> result(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      result[i] = mtgValueAt(values, order[i].second);
    values = std::move(result);
  };
  std::vector<MtgFeature> features;
  features.reserve(order.size());
  for (const auto& each : order)
    features.push_back(mtg.features[each.second]);
  mtg.features = std::move(features);
  for (MtgVertex& vertex : mtg.vertices) {
    reorder(vertex.values);
    for (auto& values : vertex.later)
      reorder(values);
  }
  return mtg;
}

/// Whether the columns of the file can hold all rows and features; fills `layout` if so.
bool hasRoom(const ParsedMtg& file, const Mtg& mtg, const MtgRows& rows, MtgLayout& layout) {
  if (rows.columns > file.columns.firstFeature) return false;
  layout.width = file.columns.features.size();
  for (const MtgFeature& feature : mtg.features) {
    const auto isIt = [&](const std::optional<std::size_t>& place) {
      return place && file.mtg.features[*place].name == feature.name;
    };
    const auto found = std::ranges::find_if(file.columns.features, isIt);
    if (found == file.columns.features.end()) return false;
    layout.columns.push_back(static_cast<std::size_t>(found - file.columns.features.begin()));
  }
  return true;
}

/// The vertices anew below the sections of the file, which may not fit them.
/// pre: mtg is as mtgAsWritten gives
std::string belowSections(const ParsedMtg& file, const Mtg& mtg) {
  const MtgRows rows = mtgRows(mtg);
  const std::string& original = file.source.original;
  MtgLayout layout;
  std::string text = rows.isAmbiguous ? std::string(previousColumnMark) + '\n' : "";
  std::size_t kept = file.start; // bytes
  std::string head = original.substr(0, kept);
  if (!hasRoom(file, mtg, rows, layout)) {
    layout = {.width = rows.columns + mtg.features.size()};
    kept = file.columnsStart;
    head = original.substr(0, kept) + "ENTITY-CODE" + std::string(rows.columns, '\t');
    for (std::size_t i = 0; i < mtg.features.size(); ++i) {
      layout.columns.push_back(rows.columns + i);
      head += (i > 0 ? "\t" : "") + mtg.features[i].name;
    }
    head += lineEndOf(original);
  }
  std::string lines;
  for (const MtgRow& row : rows.rows)
    lines += mtgLines(row, mtg, layout);
  lines += mtgCommentLines(file, kept);
  return withLineEnds(text, lineEndOf(original)) + head + withLineEnds(lines, lineEndOf(original));
}

/// All anew but for what stands before CODE.
std::string belowFirstComments(const ParsedMtg& file, const Mtg& mtg) {
  const std::string& original = file.source.original;
  const auto code = mtgCodeIn(file.source.text);
  const std::size_t start = code ? code->offset() : 0;
  std::ostringstream out;
  writeMtg(out, mtg);
  return original.substr(0, start) +
         withLineEnds(out.str() + mtgCommentLines(file, start), lineEndOf(original));
}

/// Whether `text` is read as `edited`.
bool readsAs(const std::string& text, const Mtg& edited, const MtgReadOptions& options) {
  try {
    return isSame(parseMtg(text, resultName, options).mtg, edited);
  } catch (const Error&) {
    return false;
  }
}

/// Whether `text` is read as `edited`, but for the order of the vertices, which its lines set.
bool readsAsAll(const std::string& text, const Mtg& edited, const MtgReadOptions& options) {
  return isSame(mtgAsWritten(parseMtg(text, resultName, options).mtg), mtgAsWritten(edited));
}

/// The text with other lines, if lines can hold the edited plant.
std::optional<std::string> withLinesOf(const ParsedMtg& file, const Mtg& edited,
                                       const MtgReadOptions& options) {
  try {
    const auto text = withOtherLines(file, mtgNormalized(withFeaturesLike(file.mtg, edited)));
    return text && readsAsAll(*text, edited, options) ? text : std::nullopt;
  } catch (const Error&) { // all is written anew, or refused there
    return std::nullopt;
  }
}

/// The features that the file does not have: readers take a column without one for text at best.
std::vector<MtgFeature> missingFeatures(const Mtg& file, const Mtg& mtg) {
  std::vector<MtgFeature> missing;
  for (const MtgFeature& feature : mtg.features)
    if (std::ranges::find(file.features, feature.name, &MtgFeature::name) == file.features.end())
      missing.push_back(feature);
  return missing;
}

std::string encoded(std::string text, bool isLatin1) {
  if (!isLatin1 || !fitsLatin1(text)) return text;
  std::string bytes = toLatin1(text);
  return mtgSource(bytes).original == text ? bytes : text; // by chance they may be UTF-8
}

} // namespace

std::string mtgTextWith(const std::string& original, const Mtg& edited,
                        const MtgReadOptions& options) {
  ParsedMtg file = parseMtg(original, "MTG", options);
  const bool isLatin1 = file.source.isLatin1;
  const auto withSections = [&]() -> std::optional<std::string> {
    auto text = withOtherCells(file, edited);
    if (text && readsAs(*text, edited, options)) return text;
    return withLinesOf(file, edited, options);
  };
  if (const auto text = withSections()) return encoded(*text, isLatin1);
  if (const auto missing = missingFeatures(file.mtg, edited); !missing.empty())
    if (const auto more = withMoreFeatures(file, missing)) {
      file = parseMtg(*more, resultName, options);
      if (const auto text = withSections()) return encoded(*text, isLatin1);
    }
  const Mtg written = mtgAsWritten(withFeaturesLike(file.mtg, edited));
  const std::string anew = belowFirstComments(file, written); // checks that it can be written
  const bool hasAll = missingFeatures(file.mtg, written).empty();
  const std::string kept = hasAll ? belowSections(file, written) : anew;
  return encoded(readsAs(kept, written, options) ? kept : anew, isLatin1);
}

} // namespace espalier
