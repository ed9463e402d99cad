#include "core/io/plantgl/mtg_vertices.h"

#include "core/base/text.h"

#include <queue>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace espalier {
namespace {

constexpr std::size_t longestSymbol = 32;

/// A vertex in the tables: its numbers, and how many of these must come before it.
struct NumberedVertex {
  std::int64_t number = 0;
  int scale = 1;
  std::optional<std::int64_t> parent;
  std::optional<std::int64_t> complex; // as stated; else its parent's
};

class Topology {
public:
  Topology(const MtgTables& tables, const std::string& file) : tables_(tables), file_(file) {}

  /// All vertices but the scene, parents and complexes before those that need them.
  std::vector<NumberedVertex> ordered() {
    for (const auto& [number, scale] : tables_.scales)
      if (scale != 0) entries_.emplace(number, entryOf(number, scale));
    std::map<std::int64_t, std::vector<std::int64_t>> dependents;
    std::map<std::int64_t, int> missing; // in order, so that messages are always the same
    std::priority_queue<std::int64_t, std::vector<std::int64_t>, std::greater<>> ready;
    for (const auto& [number, entry] : entries_) {
      for (const auto& needed : {entry.parent, entry.complex})
        if (needed) {
          dependents[*needed].push_back(number);
          ++missing[number];
        }
      if (!entry.parent && !entry.complex) ready.push(number);
    }
    std::vector<NumberedVertex> order;
    while (!ready.empty()) {
      const std::int64_t number = ready.top();
      ready.pop();
      order.push_back(entries_.at(number));
      for (const std::int64_t dependent : dependents[number])
        if (--missing[dependent] == 0) ready.push(dependent);
    }
    for (const auto& [number, count] : missing)
      if (count > 0)
        fail({espalier::Shown::tr("vertex %1 is among its own ancestors: the file is damaged, or "
                                  "was saved by a program that failed"),
              {std::to_string(number)}});
    return order;
  }

private:
  [[noreturn]] void fail(ShownMessage what) const {
    what.where = FilePlace{file_};
    throw ShownError(std::move(what));
  }

  [[nodiscard]] NumberedVertex entryOf(std::int64_t number, std::int64_t scale) const {
    if (scale < 0 || scale > finestScale)
      fail({espalier::Shown::tr("vertex %1 is of scale %2: the file is damaged, or was saved by a "
                                "program that failed"),
            {std::to_string(number), std::to_string(scale)}});
    NumberedVertex entry{number, static_cast<int>(scale), std::nullopt, std::nullopt};
    if (const auto parent = tables_.parents.find(number); parent != tables_.parents.end()) {
      if (scaleOf(parent->second, number) != scale)
        fail({espalier::Shown::tr("vertex %1 is attached to vertex %2 of another scale: the file "
                                  "is damaged, or was saved by a program that failed"),
              {std::to_string(number), std::to_string(parent->second)}});
      entry.parent = parent->second;
    }
    if (const auto complex = tables_.complexes.find(number); complex != tables_.complexes.end()) {
      const std::int64_t coarser = scaleOf(complex->second, number);
      if (coarser >= scale)
        fail({espalier::Shown::tr("vertex %1 is a part of vertex %2, which is no coarser: the file "
                                  "is damaged, or was saved by a program that failed"),
              {std::to_string(number), std::to_string(complex->second)}});
      if (coarser > 0) entry.complex = complex->second;
    }
    return entry;
  }

  [[nodiscard]] std::int64_t scaleOf(std::int64_t number, std::int64_t for_) const {
    const auto found = tables_.scales.find(number);
    if (found == tables_.scales.end())
      fail({espalier::Shown::tr("vertex %1 needs vertex %2, which is missing: the file is damaged, "
                                "or was saved by a program that failed"),
            {std::to_string(for_), std::to_string(number)}});
    return found->second;
  }

  const MtgTables& tables_;
  const std::string& file_;
  std::map<std::int64_t, NumberedVertex> entries_;
};

/// A text property by vertex; values of other kinds are as good as none.
std::map<std::int64_t, std::string_view> textsOf(const Pickle& pickle, const MtgTables& tables,
                                                 std::string_view property) {
  std::map<std::int64_t, std::string_view> texts;
  for (const MtgProperty& candidate : tables.properties)
    if (candidate.name == property)
      for (const auto& [vertex, value] : candidate.values)
        if (const auto* text = std::get_if<std::string>(&pickle[value])) texts[vertex] = *text;
  return texts;
}

struct Label {
  std::string symbol; // empty if the text is no label
  std::optional<LabelIndex> index;
};

Label labelIn(std::string_view text) {
  const auto end =
      static_cast<std::size_t>(std::ranges::find_if_not(text, isLetter) - text.begin());
  if (end == 0 || end > longestSymbol) return {};
  Label label{std::string(text.substr(0, end)), std::nullopt};
  const std::string_view digits = text.substr(end);
  if (digits.empty()) return label;
  label.index = LabelIndex::in(digits);
  return label.index ? label : Label{};
}

/// Makes the classes of these scales and symbols: each gets a name of its own, which vertices take.
void nameClasses(const std::set<std::pair<int, std::string>>& classes, TableVertices& result,
                 const std::string& file) {
  std::map<std::pair<int, std::string>, std::string> names;
  std::set<std::string> used;
  result.mtg.classes.push_back({"$", 0, "FREE", "FREE", "IMPLICIT"});
  for (const auto& [scale, symbol] : classes) {
    std::string name = symbol;
    while (!used.insert(name).second)
      name += symbol;
    if (name != symbol)
      result.notes.push_back(
          {espalier::Shown::tr("label %1 is used on several scales, and becomes %2 on scale %3"),
           {symbol, name, std::to_string(scale)},
           FilePlace{file}});
    result.mtg.classes.push_back({.symbol = name, .scale = scale});
    names.emplace(std::pair(scale, symbol), name);
  }
  for (MtgVertex& vertex : result.mtg.vertices)
    vertex.symbol = names.at({vertex.scale, vertex.symbol});
}

/// Sets symbols and indices, and the classes they are of.
void nameVertices(const std::vector<NumberedVertex>& entries,
                  const std::map<std::int64_t, std::string_view>& labels, TableVertices& result,
                  const std::string& file) {
  std::size_t nameless = 0;
  const int coarsest = std::ranges::min(entries, {}, &NumberedVertex::scale).scale;
  std::set<std::pair<int, std::string>> classes;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto found = labels.find(entries[i].number);
    Label label = found != labels.end() ? labelIn(found->second) : Label{};
    if (label.symbol.empty()) {
      ++nameless;
      label.symbol = entries[i].scale == coarsest ? "P" : "N";
    }
    result.mtg.vertices[i].symbol = label.symbol;
    result.mtg.vertices[i].index = label.index;
    classes.emplace(entries[i].scale, label.symbol);
  }
  if (nameless > 0)
    result.notes.push_back(
        {nameless == 1
             ? espalier::Shown::tr("1 vertex has no label of letters and a number, and gets P or N")
             : espalier::Shown::tr(
                   "%1 vertices have no label of letters and a number, and get P or N"),
         {std::to_string(nameless)},
         FilePlace{file}});
  nameClasses(classes, result, file);
}

/// Sets the edges to the parents.
void setEdges(const std::vector<NumberedVertex>& entries,
              const std::map<std::int64_t, std::string_view>& types, TableVertices& result,
              const std::string& file) {
  std::vector<MtgVertex>& vertices = result.mtg.vertices;
  std::vector<std::size_t> successors(vertices.size());
  std::vector<std::size_t> unclear;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!vertices[i].parent) continue;
    const auto type = types.find(entries[i].number);
    if (type == types.end() || (type->second != "<" && type->second != "+")) {
      unclear.push_back(i);
    } else if (type->second == "+") {
      vertices[i].edge = EdgeType::branching;
    } else {
      ++successors[indexOf(*vertices[i].parent)];
    }
  }
  for (const std::size_t i : unclear)
    if (successors[indexOf(*vertices[i].parent)]++ > 0) vertices[i].edge = EdgeType::branching;
  for (const std::size_t i : unclear)
    if (vertices[i].edge == EdgeType::branching) --successors[indexOf(*vertices[i].parent)];
  if (!unclear.empty())
    result.notes.push_back(
        {unclear.size() == 1 ? espalier::Shown::tr("1 edge is neither < nor +, and is taken as < "
                                                   "where the parent has no other, else as +")
                             : espalier::Shown::tr("%1 edges are neither < nor +, and are taken as "
                                                   "< where the parent has no other, else as +"),
         {std::to_string(unclear.size())},
         FilePlace{file}});
  const auto several = std::ranges::count_if(successors, [](std::size_t n) { return n > 1; });
  if (several > 0)
    result.notes.push_back(
        {several == 1
             ? espalier::Shown::tr("1 vertex has more than one successor, and is kept so")
             : espalier::Shown::tr("%1 vertices have more than one successor, and are kept so"),
         {std::to_string(several)},
         FilePlace{file}});
}

/// Which classes follow which.
std::vector<MtgRule> rulesOf(const std::vector<MtgVertex>& vertices) {
  std::set<std::array<std::string, 3>> seen;
  std::vector<MtgRule> rules;
  for (const MtgVertex& vertex : vertices) {
    if (!vertex.parent) continue;
    const std::string& left = vertices[indexOf(*vertex.parent)].symbol;
    const std::string edge(1, static_cast<char>(vertex.edge));
    if (seen.insert({left, vertex.symbol, edge}).second)
      rules.push_back({left, vertex.symbol, edge, "?"});
  }
  return rules;
}

} // namespace

TableVertices verticesOf(const Pickle& pickle, const MtgTables& tables, const std::string& file) {
  TableVertices result;
  const std::vector<NumberedVertex> entries = Topology(tables, file).ordered();
  if (entries.empty())
    throw ShownError({espalier::Shown::tr("holds no vertices"), {}, FilePlace{file}});
  for (const NumberedVertex& entry : entries) {
    const VertexId id{static_cast<std::uint32_t>(result.mtg.vertices.size())};
    MtgVertex vertex{.symbol = {}, .index = {}, .scale = entry.scale, .values = {}};
    if (entry.parent) {
      vertex.parent = result.ids.at(*entry.parent);
      vertex.complex = result.mtg.vertices[indexOf(*vertex.parent)].complex;
    }
    if (entry.complex) vertex.complex = result.ids.at(*entry.complex);
    result.ids.emplace(entry.number, id);
    result.mtg.vertices.push_back(std::move(vertex));
  }
  nameVertices(entries, textsOf(pickle, tables, "label"), result, file);
  setEdges(entries, textsOf(pickle, tables, "edge_type"), result, file);
  result.mtg.rules = rulesOf(result.mtg.vertices);
  return result;
}

} // namespace espalier
