#include "core/mtg/mtg_cells.h"

#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <map>

namespace espalier {
namespace {

/// What must change in a line so that `column` holds `value`.
/// @param width  the columns that changes before gave the line at its end
MtgReplacement replacement(const MtgSource& source, const MtgLine& line, std::size_t column,
                           const std::string& value, std::size_t& width) {
  std::size_t start = line.start;
  for (std::size_t i = 0; i < column; ++i) {
    const std::size_t tab = source.text.find('\t', start);
    if (tab >= line.end) {
      const std::size_t present = std::max(width, i); // columns before this one, with added ones
      width = column;
      std::size_t at = line.end; // before a comment, which is blank in the text
      while (at > line.start && source.text[at - 1] == ' ')
        --at;
      return {at, at, std::string(column - present, '\t') + value};
    }
    start = tab + 1;
  }
  const std::size_t end = std::min(source.text.find('\t', start), line.end);
  const std::string_view field = trimmed(std::string_view(source.text).substr(start, end - start));
  if (field.empty()) return {start, start, value + (start < end ? " " : "")};
  const auto from = static_cast<std::size_t>(field.data() - source.text.data());
  return {from, from + field.size(), value};
}

} // namespace

FeatureMatch::FeatureMatch(const Mtg& file, const Mtg& edited) : features_(file.features) {
  std::map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < edited.features.size(); ++i)
    places.emplace(edited.features[i].name, i);
  for (const MtgFeature& feature : file.features) {
    const auto found = places.find(feature.name);
    inEdited_.push_back(found == places.end() ? std::nullopt : std::optional(found->second));
    if (found != places.end()) places.erase(found);
  }
  for (const auto& [name, place] : places)
    added_.push_back(place);
}

bool FeatureMatch::isSame(const std::vector<std::string>& file,
                          const std::vector<std::string>& edited, std::size_t feature) const {
  if (!inEdited_[feature]) return true; // the edited plant does not know of it
  const std::string_view before = mtgValueAt(file, feature);
  const std::string_view after = mtgValueAt(edited, *inEdited_[feature]);
  if (before == after || (isMissingMtgValue(before) && isMissingMtgValue(after))) return true;
  return isNumberFeature(features_[feature]) && numberIn(before) && numberIn(after) &&
         *numberIn(before) == *numberIn(after);
}

bool FeatureMatch::isSame(const std::vector<std::string>& file,
                          const std::vector<std::string>& edited) const {
  for (std::size_t i = 0; i < inEdited_.size(); ++i)
    if (!isSame(file, edited, i)) return false;
  return std::ranges::all_of(
      added_, [&](std::size_t place) { return isMissingMtgValue(mtgValueAt(edited, place)); });
}

std::string FeatureMatch::textOf(const std::vector<std::string>& edited,
                                 std::size_t feature) const {
  return mtgCellText(std::string(mtgValueAt(edited, *inEdited_[feature])), features_[feature]);
}

std::string_view mtgValueAt(const std::vector<std::string>& values, std::size_t feature) {
  return feature < values.size() ? std::string_view(values[feature]) : std::string_view();
}

const std::vector<std::string>& mtgValuesAt(const Mtg& mtg, VertexId id,
                                            std::optional<std::size_t> date) {
  const MtgVertex& vertex = mtg.vertices[indexOf(id)];
  return date ? vertex.later[*date] : vertex.values;
}

std::optional<std::vector<MtgReplacement>> cellChanges(const ParsedMtg& file, const MtgLine& line,
                                                       const std::vector<std::string>& edited,
                                                       const FeatureMatch& match) {
  const auto& before = mtgValuesAt(file.mtg, line.last, line.date);
  std::vector<MtgReplacement> changes;
  std::size_t width = 0;
  for (std::size_t column = 0; column < file.columns.features.size(); ++column) {
    const auto feature = file.columns.features[column];
    if (!feature || match.isSame(before, edited, *feature)) continue;
    const std::string value = match.textOf(edited, *feature);
    if (!survivesMtg(value)) return std::nullopt;
    changes.push_back(replacement(file.source, line, column, value, width));
  }
  return changes;
}

void appendChanged(const std::string& original, const std::vector<MtgReplacement>& changes,
                   std::size_t& copied, std::string& text) {
  for (const MtgReplacement& change : changes) {
    text.append(original, copied, change.from - copied);
    text += change.text;
    copied = change.to;
  }
}

} // namespace espalier
