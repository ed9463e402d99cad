#include "core/mtg/mtg_parser.h"

#include "core/base/text.h"
#include "core/base/utf16.h"
#include "core/mtg/mtg_notes.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/mtg_topology.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <map>

namespace espalier {
namespace {

constexpr std::size_t mostSharedBytes = 100'000'000;

/// The columns as listed by a line, ENTITY-CODE ...; features are put into their order.
///
/// So the cost of a vertex is bounded by the length of its line, whatever the section FEATURES
/// says.
MtgColumns columnsOf(const std::vector<std::string_view>& names, const FilePlace& where,
                     MtgNotes& notes, Mtg& mtg) {
  std::map<std::string, MtgFeature, std::less<>> declared;
  for (const MtgFeature& feature : mtg.features)
    declared.emplace(feature.name, feature);
  MtgColumns columns;
  columns.features.resize(names.size());
  columns.firstFeature = names.size();
  std::vector<MtgFeature> features;
  std::map<std::string_view, std::size_t> taken;
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    columns.firstFeature = std::min(columns.firstFeature, i);
    if (!taken.emplace(names[i], features.size()).second) {
      notes.repaired(
          where, {espalier::Shown::tr("the column %1 stands there twice"), {inQuotes(names[i])}});
      continue;
    }
    const auto found = declared.find(names[i]);
    if (found == declared.end())
      notes.repaired(where, {espalier::Shown::tr("the feature %1 has a column but no type in "
                                                 "FEATURES and is taken as ALPHA"),
                             {inQuotes(names[i])}});
    columns.features[i] = features.size();
    features.push_back(found == declared.end() ? MtgFeature{std::string(names[i]), "ALPHA"}
                                               : found->second);
  }
  for (const MtgFeature& feature : mtg.features)
    if (!taken.contains(feature.name)) features.push_back(feature);
  mtg.features = std::move(features);
  if (columns.firstFeature == names.size()) columns.firstFeature = std::string::npos;
  return columns;
}

MtgColumns readColumns(LineReader& lines, MtgNotes& notes, Mtg& mtg, std::size_t& start) {
  for (start = lines.offset();; start = lines.offset()) {
    const auto line = lines.next();
    if (!line) break;
    const std::vector<std::string_view> names = mtgFields(*line);
    if (std::ranges::all_of(names, [](std::string_view name) { return name.empty(); })) continue;
    const FilePlace where{notes.file(), lines.number()};
    if (isMtgColumnName(names.front())) return columnsOf(names, where, notes, mtg);
    std::string_view rest = names.front();
    if (isMtgColumnName(nextWord(rest)))
      throw ShownError(
          {espalier::Shown::tr("the columns are parted by blanks: put tabs between them"),
           {},
           where});
    throw ShownError(
        {espalier::Shown::tr("expected the line of columns, ENTITY-CODE ..., found %1"),
         {inQuotes(*line)},
         where});
  }
  throw ShownError(
      {espalier::Shown::tr("ends before the columns of its section MTG: it is cut short"),
       {},
       FilePlace{notes.file()}});
}

/// Whether a field was meant as a code.
bool isCode(std::string_view field) {
  return std::string_view("/<+^*(").find(field.front()) != std::string_view::npos;
}

/// What is wrong with a field among the values of a line without a code.
ShownError withoutCode(std::string_view field, const FilePlace& where) {
  if (!isCode(field) || numberIn(field))
    return ShownError({espalier::Shown::tr("values stand without a code before them"), {}, where});
  return ShownError({espalier::Shown::tr("the code %1 stands among the columns of values: move it "
                                         "to the left, or these to the right"),
                     {inQuotes(field)},
                     where});
}

/// Reads the lines of the section MTG.
class Body {
public:
  Body(ParsedMtg& parsed, MtgNotes& notes, bool continuesColumns)
      : parsed_(parsed), mtg_(parsed.mtg), notes_(notes),
        topology_(parsed.mtg, notes, continuesColumns) {
    for (std::size_t i = 0; i < mtg_.features.size(); ++i)
      if (isAliasFeature(mtg_.features[i])) alias_ = i;
  }

  /// Reads all lines to the end.
  void read(LineReader lines) {
    const char* text = parsed_.source.text.data();
    while (const auto line = lines.next()) {
      MtgLine row{.start = static_cast<std::size_t>(line->data() - text)};
      row.end = row.start + line->size();
      if (readLine(*line, lines.number(), row)) parsed_.lines.push_back(row);
    }
    if (nameless_ > 0)
      notes_.add({nameless_ == 1 ? espalier::Shown::tr("1 value stands in a column without a "
                                                       "name and is left out")
                                 : espalier::Shown::tr("%1 values stand in columns without a "
                                                       "name and are left out"),
                  {std::to_string(nameless_)}});
  }

  [[nodiscard]] const MtgTopology& topology() const { return topology_; }

private:
  /// @return whether it holds a vertex
  bool readLine(std::string_view line, std::size_t number, MtgLine& row) {
    const std::vector<std::string_view> fields = mtgFields(line);
    const auto column = codeColumn(fields, number);
    if (!column) return false;
    std::string_view code = fields[*column];
    const MtgPlace place{number, *column};
    if (code.starts_with("^*")) code.remove_prefix(1);
    if (code == "*") {
      row.first = row.last = topology_.lastOf(place);
      auto& later = mtg_.vertices[indexOf(row.last)].later;
      row.date = later.size();
      later.push_back(readValues(fields, row.last, number));
      return true;
    }
    const MtgSpan span = topology_.add(code, place);
    row.first = span.first;
    row.last = span.last;
    mtg_.vertices[indexOf(span.last)].values = readValues(fields, span.last, number);
    share(span, line.size(), place);
    return true;
  }

  /// The column of the code in a line; none for a line without any.
  std::optional<std::size_t> codeColumn(const std::vector<std::string_view>& fields,
                                        std::size_t line) {
    const auto where = [&](std::size_t column) { return mtgCell(notes_.file(), line, column); };
    const std::size_t end = std::min(fields.size(), parsed_.columns.firstFeature);
    std::optional<std::size_t> column;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].empty()) continue;
      if (i >= end && !column) throw withoutCode(fields[i], where(i));
      if (i >= end) break;
      if (column && !isCode(fields[i])) {
        notes_.repaired(where(i), {espalier::Shown::tr(
                                       "%1 stands left of the columns of values and is left out"),
                                   {inQuotes(fields[i])}});
        continue;
      }
      if (column)
        throw ShownError({espalier::Shown::tr("two codes stand in one line, %1 and %2"),
                          {inQuotes(fields[*column]), inQuotes(fields[i])},
                          where(i)});
      column = i;
    }
    return column;
  }

  std::vector<std::string> readValues(const std::vector<std::string_view>& fields, VertexId vertex,
                                      std::size_t line) {
    std::vector<std::string> values;
    for (std::size_t i = parsed_.columns.firstFeature; i < fields.size(); ++i) {
      if (fields[i].empty()) continue;
      const auto feature =
          i < parsed_.columns.features.size() ? parsed_.columns.features[i] : std::nullopt;
      if (!feature) {
        ++nameless_;
      } else if (feature == alias_) {
        mtg_.vertices[indexOf(vertex)].alias = fields[i];
        topology_.name(std::string(fields[i]), vertex, {line, i});
      } else {
        checkValue(fields[i], mtg_.features[*feature], {line, i});
        values.resize(*feature + 1);
        values.back() = fields[i];
      }
    }
    return values;
  }

  void checkValue(std::string_view value, const MtgFeature& feature, MtgPlace place) const {
    if (!isNumberFeature(feature) || isMissingMtgValue(value) || numberIn(value)) return;
    const bool isComma = value.find(',') != std::string_view::npos;
    throw ShownError({isComma ? espalier::Shown::tr(
                                    "%1 is %2, expected a number with a decimal point, not a comma")
                              : espalier::Shown::tr("%1 is %2, expected a number"),
                      {feature.name, inQuotes(value)},
                      mtgCell(notes_.file(), place.line, place.column)});
  }

  /// Gives all of a range what its last vertex has.
  void share(MtgSpan span, std::size_t bytes, MtgPlace place) {
    const std::vector<std::string> values = mtg_.vertices[indexOf(span.last)].values;
    if (values.empty()) return;
    shared_ += (indexOf(span.last) - indexOf(span.first)) * (bytes + 32 * values.size());
    if (shared_ > mostSharedBytes)
      throw ShownError(
          {espalier::Shown::tr("the ranges up to here share too many values: correct the index"),
           {},
           mtgCell(notes_.file(), place.line, place.column)});
    for (std::size_t i = indexOf(span.first); i < indexOf(span.last); ++i)
      mtg_.vertices[i].values = values;
  }

  ParsedMtg& parsed_;
  Mtg& mtg_;
  MtgNotes& notes_;
  MtgTopology topology_;
  std::optional<std::size_t> alias_;
  std::size_t nameless_ = 0;
  std::size_t shared_ = 0;
};

/// Whether the disputed vertices follow something that nothing else follows.
bool isLegal(const Mtg& mtg, const std::vector<VertexId>& disputed) {
  std::vector<unsigned> successors(mtg.vertices.size());
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.parent && vertex.edge == EdgeType::successor) ++successors[indexOf(*vertex.parent)];
  return std::ranges::all_of(disputed, [&](VertexId id) {
    const MtgVertex& vertex = mtg.vertices[indexOf(id)];
    return vertex.parent && successors[indexOf(*vertex.parent)] < 2;
  });
}

void noteDispute(const MtgTopology& topology, bool continues, MtgNotes& notes) {
  if (topology.disputed().empty()) return;
  const std::string line = std::to_string(topology.firstDispute().line);
  if (topology.disputed().size() == 1)
    notes.add({continues ? espalier::Shown::tr(
                               "1 code with < but no ^ stands below another of its column, in line "
                               "%1: it follows the vertex above it, as OpenAlea reads")
                         : espalier::Shown::tr(
                               "1 code with < but no ^ stands below another of its column, in line "
                               "%1: it follows the column before, as the specification says"),
               {line}});
  else
    notes.add({continues ? espalier::Shown::tr(
                               "%1 codes with < but no ^ stand below others of their column, the "
                               "first in line %2: they follow the vertex above them, as OpenAlea "
                               "reads")
                         : espalier::Shown::tr(
                               "%1 codes with < but no ^ stand below others of their column, the "
                               "first in line %2: they follow the column before, as the "
                               "specification says"),
               {std::to_string(topology.disputed().size()), line}});
}

/// Reads the body by the dialect that is asked for, or by the one that makes a plant of it.
void readBody(ParsedMtg& parsed, MtgNotes& notes, const LineReader& lines, MtgDialect dialect) {
  const Mtg head = parsed.mtg;
  const MtgNotes notesOnHead = notes;
  const bool isMarked =
      ("\n" + parsed.source.original).find("\n" + std::string(previousColumnMark)) !=
      std::string::npos;
  const bool canChoose = dialect == MtgDialect::automatic && !isMarked;
  {
    const bool continues = dialect == MtgDialect::continuation;
    Body body(parsed, notes, continues);
    try {
      body.read(lines);
      if (!canChoose || isLegal(parsed.mtg, body.topology().disputed())) {
        noteDispute(body.topology(), continues, notes);
        return;
      }
    } catch (const Error&) {
      if (!canChoose || body.topology().disputed().empty()) throw;
    }
  }
  parsed.mtg = head;
  parsed.lines.clear();
  notes = notesOnHead;
  Body body(parsed, notes, true);
  body.read(lines);
  noteDispute(body.topology(), true, notes);
}

} // namespace

ParsedMtg parseMtg(std::string bytes, const std::string& file, const MtgReadOptions& options) {
  if (trimmed(bytes).empty())
    throw ShownError({espalier::Shown::tr("is empty"), {}, FilePlace{file}});
  requireNoUtf16(bytes, file);
  ParsedMtg parsed{.source = mtgSource(std::move(bytes))};
  MtgNotes notes(file, options.isStrict);
  for (const ShownMessage& note : parsed.source.notes)
    notes.add(note);
  LineReader lines = mtgCodeIn(parsed.source.text).value_or(LineReader(parsed.source.text));
  parsed.mtg = readMtgSections(lines, notes);
  parsed.columns = readColumns(lines, notes, parsed.mtg, parsed.columnsStart);
  parsed.start = lines.offset();
  readBody(parsed, notes, lines, options.dialect);
  if (parsed.mtg.vertices.empty())
    throw ShownError({espalier::Shown::tr("holds no vertices"), {}, FilePlace{file}});
  parsed.notes = notes.take();
  return parsed;
}

} // namespace espalier
