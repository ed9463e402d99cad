#include "core/mtg/mtg_line_edits.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mtg/mtg_cells.h"
#include "core/mtg/mtg_comments.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/vertex_match.h"

#include <algorithm>
#include <list>
#include <map>
#include <utility>

namespace espalier {
namespace {

using MaybeVertex = std::optional<VertexId>;

/// A line of the file that stays, or a new one.
struct Item {
  const MtgLine* line = nullptr; // null: new
  std::size_t column = 0;        // of its code
  VertexId vertex{};             // edited: what a code of a further column is attached to
  std::string text = {};         // of a new one
};

using Items = std::list<Item>;

class LineEdits {
public:
  LineEdits(const ParsedMtg& file, const Mtg& edited, VertexMatch match)
      : file_(file), edited_(edited), match_(std::move(match)), features_(file.mtg, edited),
        at_(edited.vertices.size()) {}

  std::optional<std::string> text() {
    if (!hasColumns() || !hasClasses() || !keepLines() || !addLines()) return std::nullopt;
    return assembled();
  }

private:
  [[nodiscard]] bool hasColumns();
  [[nodiscard]] bool hasClasses() const;
  [[nodiscard]] bool keepLines();
  [[nodiscard]] bool keepLine(const MtgLine& line, std::size_t firstMade);
  [[nodiscard]] bool addLines();
  [[nodiscard]] bool addLine(const MtgRow& row, MaybeVertex bearer, MaybeVertex before);
  [[nodiscard]] std::string assembled() const;
  [[nodiscard]] std::optional<std::vector<MtgReplacement>>
  labelChanges(const MtgLine& line, std::size_t firstMade) const;
  [[nodiscard]] std::size_t columnOf(const MtgLine& line) const;
  [[nodiscard]] Items::iterator behind(Items::iterator item, std::size_t column);

  const ParsedMtg& file_;
  const Mtg& edited_;
  VertexMatch match_;
  FeatureMatch features_;
  MtgLayout layout_;
  Items items_;
  std::vector<std::optional<Items::iterator>> at_; // by edited vertex that ends a line: that line
  std::map<const MtgLine*, std::vector<MtgReplacement>> changes_;
  std::vector<const MtgLine*> gone_;
};

bool LineEdits::hasColumns() {
  layout_.width = file_.columns.features.size();
  for (const MtgFeature& feature : edited_.features) {
    const auto isIt = [&](const std::optional<std::size_t>& place) {
      return place && file_.mtg.features[*place].name == feature.name;
    };
    const auto found = std::ranges::find_if(file_.columns.features, isIt);
    const std::size_t place = layout_.columns.size();
    const auto needs = [place](const std::vector<std::string>& values) {
      return !mtgValueAt(values, place).empty();
    };
    if (found == file_.columns.features.end() &&
        std::ranges::any_of(edited_.vertices, [&](const MtgVertex& vertex) {
          return needs(vertex.values) || std::ranges::any_of(vertex.later, needs);
        }))
      return false;
    layout_.columns.push_back(static_cast<std::size_t>(found - file_.columns.features.begin()));
  }
  return true;
}

bool LineEdits::hasClasses() const {
  return std::ranges::all_of(edited_.classes, [&](const MtgClass& each) {
    const auto found = std::ranges::find(file_.mtg.classes, each.symbol, &MtgClass::symbol);
    return found != file_.mtg.classes.end() && found->scale == each.scale;
  });
}

std::size_t LineEdits::columnOf(const MtgLine& line) const {
  const std::string& text = file_.source.text;
  const std::size_t code =
      std::min(text.find_first_not_of(" \t\xEF\xBB\xBF", line.start), line.end);
  return static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(line.start),
                                             text.begin() + static_cast<std::ptrdiff_t>(code),
                                             '\t'));
}

bool LineEdits::keepLines() {
  std::size_t made = 0; // vertices of the lines before
  for (const MtgLine& line : file_.lines) {
    if (!keepLine(line, made)) return false;
    made = std::max(made, indexOf(line.last) + 1);
  }
  return true;
}

bool LineEdits::keepLine(const MtgLine& line, std::size_t firstMade) {
  const MaybeVertex last = match_.after[indexOf(line.last)];
  const std::size_t first = line.date ? indexOf(line.last) : firstMade;
  for (std::size_t i = first; i <= indexOf(line.last); ++i)
    if (match_.after[i].has_value() != last.has_value()) return false;
  if (!last) {
    gone_.push_back(&line);
    return true;
  }
  const MtgVertex& now = edited_.vertices[indexOf(*last)];
  const MtgVertex& was = file_.mtg.vertices[indexOf(line.last)];
  if (now.later.size() != was.later.size() || now.alias != was.alias) return false;
  auto values = cellChanges(file_, line, mtgValuesAt(edited_, *last, line.date), features_);
  auto labels = line.date ? std::vector<MtgReplacement>() : labelChanges(line, firstMade);
  if (!values || !labels) return false;
  labels->insert(labels->end(), values->begin(), values->end());
  if (!labels->empty()) changes_[&line] = std::move(*labels);
  items_.push_back({&line, columnOf(line), *last});
  at_[indexOf(*last)] = std::prev(items_.end());
  return true;
}

/// Other labels in the code of a line, which made the vertices from `firstMade` on; none if they
/// cannot be separated from what else it says.
std::optional<std::vector<MtgReplacement>> LineEdits::labelChanges(const MtgLine& line,
                                                                   std::size_t firstMade) const {
  const std::string_view text = file_.source.text;
  std::vector<MtgReplacement> changes;
  std::size_t end = std::min(text.find_first_not_of(" \t", line.start), line.end);
  end = std::min(text.find('\t', end), line.end);
  for (std::size_t vertex = indexOf(line.last) + 1; vertex-- > firstMade;) { // last label first
    const MtgVertex& was = file_.mtg.vertices[vertex];
    const MtgVertex& now = edited_.vertices[indexOf(*match_.after[vertex])];
    const std::string_view code = text.substr(line.start, end - line.start);
    const std::size_t sign = code.find_last_of("/<+^(");
    const std::size_t start = sign == std::string_view::npos ? 0 : sign + 1;
    const std::string_view label = trimmed(code.substr(start));
    end = line.start + std::max<std::size_t>(start, 1) - 1;
    if (mtgLabel(was) == mtgLabel(now)) continue;
    if (label != mtgLabel(was)) return std::nullopt; // within a range, or typed otherwise
    const auto from = static_cast<std::size_t>(label.data() - text.data());
    changes.insert(changes.begin(), {from, from + label.size(), mtgLabel(now)});
  }
  return changes;
}

/// Behind all that stands in further columns than this one.
Items::iterator LineEdits::behind(Items::iterator item, std::size_t column) {
  return std::find_if(std::next(item), items_.end(),
                      [column](const Item& each) { return each.column <= column; });
}

bool LineEdits::addLines() {
  const MtgRows rows = mtgRows(edited_);
  std::vector<MaybeVertex> lastOf;              // by column
  std::map<MaybeVertex, MaybeVertex> lastChild; // by what it is attached to
  for (const MtgRow& row : rows.rows) {
    const std::size_t bearerColumn = row.continues ? row.column + 1 : row.column;
    const MaybeVertex bearer = bearerColumn == 0 ? std::nullopt : lastOf[bearerColumn - 1];
    const MaybeVertex before = std::exchange(lastChild[bearer], row.vertex);
    lastOf.resize(row.column);
    lastOf.emplace_back(row.vertex);
    if (match_.before[indexOf(row.vertex)]) continue;
    if (!addLine(row, bearer, before)) return false;
  }
  return true;
}

bool LineEdits::addLine(const MtgRow& row, MaybeVertex bearer, MaybeVertex before) {
  MtgRow written = row;
  auto place = items_.end();
  if (!bearer) {
    written.column = 0;
    written.continues = false;
  } else {
    const auto& above = at_[indexOf(*bearer)];
    if (!above) return false; // it stands within a line
    const std::size_t column = (*above)->column;
    const bool isLastColumn =
        column + 1 >= file_.columns.firstFeature; // then ^+ where none goes on
    written.continues = row.continues || isLastColumn;
    written.column = written.continues ? column : column + 1;
    const bool follows = before && !written.continues && at_[indexOf(*before)] &&
                         (*at_[indexOf(*before)])->column == written.column;
    place = written.continues ? behind(*above, column)
            : follows         ? behind(*at_[indexOf(*before)], written.column)
                              : std::next(*above);
  }
  if (written.column >= file_.columns.firstFeature) return false;
  Item item{.column = written.column, .vertex = row.vertex};
  item.text = mtgLines(written, edited_, layout_);
  at_[indexOf(row.vertex)] = items_.insert(place, std::move(item));
  return true;
}

std::string LineEdits::assembled() const {
  const std::string& original = file_.source.original;
  const std::string lineEnd = lineEndOf(original);
  std::string text;
  std::size_t copied = 0;
  auto gone = gone_.begin();
  const auto takeOutUpTo = [&](std::size_t end) { // lines that go, but for their comments
    for (; gone != gone_.end() && (*gone)->start < end; ++gone) {
      const std::size_t start = (*gone)->start;
      text.append(original, copied, start - copied);
      for (const char c : mtgCommentLines(file_, start, (*gone)->end))
        text += c == '\n' ? lineEnd : std::string(1, c);
      copied = std::min(original.find_first_of("\r\n", start), original.size());
      if (original.compare(copied, lineEnd.size(), lineEnd) == 0) copied += lineEnd.size();
    }
  };
  for (const Item& item : items_) {
    if (item.line != nullptr) {
      takeOutUpTo(item.line->start);
      const auto changes = changes_.find(item.line);
      if (changes != changes_.end()) appendChanged(original, changes->second, copied, text);
      const std::size_t end =
          std::min(original.find_first_of("\r\n", item.line->start), original.size());
      const bool isEnded = original.compare(end, lineEnd.size(), lineEnd) == 0;
      const std::size_t next = isEnded ? end + lineEnd.size() : end;
      text.append(original, copied, next - copied);
      copied = next;
      continue;
    }
    if (!text.empty() && text.back() != '\n' && text.back() != '\r') text += lineEnd;
    for (const char c : item.text)
      text += c == '\n' ? lineEnd : std::string(1, c);
  }
  takeOutUpTo(original.size());
  text += original.substr(copied);
  const bool hasEnd = original.ends_with('\n') || original.ends_with('\r');
  if (!hasEnd && text.ends_with(lineEnd)) text.resize(text.size() - lineEnd.size());
  return text;
}

} // namespace

std::optional<std::string> withOtherLines(const ParsedMtg& file, const Mtg& edited) {
  auto match = matchVertices(file.mtg, edited);
  if (!match) return std::nullopt;
  return LineEdits(file, edited, std::move(*match)).text();
}

} // namespace espalier
