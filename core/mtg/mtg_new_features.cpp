#include "core/mtg/mtg_new_features.h"

#include "core/base/text.h"
#include "core/mtg/mtg_sections.h"

#include <algorithm>
#include <string_view>

namespace espalier {
namespace {

/// Behind the last line of the section FEATURES that tells something; none without the section.
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

} // namespace

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

} // namespace espalier
