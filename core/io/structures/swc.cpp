#include "core/io/structures/swc.h"

#include "core/base/text.h"
#include "core/io/structures/node_rows.h"
#include "core/skeleton/assemble_axes.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t swcColumns = 7; // id type x y z radius parent

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view rest = trimmed(line); !rest.empty() && words.size() < swcColumns;)
    words.push_back(nextWord(rest));
  return words;
}

bool isWhole(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// @param mayBeMissing  then nan stands for none
double valueIn(std::string_view word, std::string_view column, const FilePlace& where,
               bool mayBeMissing = false) {
  const auto number = numberIn(word);
  if (!number || (!std::isfinite(*number) && !mayBeMissing))
    throw ShownError({espalier::Shown::tr("expected a number as %1, found %2"),
                      {std::string(column), inQuotes(word)},
                      where});
  return *number;
}

std::string idOf(std::string_view word, std::string_view column, const FilePlace& where) {
  if (!isWhole(word))
    throw ShownError({espalier::Shown::tr("expected a whole number as %1, found %2"),
                      {std::string(column), inQuotes(word)},
                      where});
  return std::string(word);
}

NodeRow sampleIn(std::string_view line, std::size_t number, const std::string& file) {
  const FilePlace where{file, number};
  const std::vector<std::string_view> words = wordsOf(line);
  if (words.size() < swcColumns)
    throw ShownError(
        {espalier::Shown::tr("expected 7 numbers (id type x y z radius parent), found %1"),
         {std::to_string(words.size())},
         where});
  NodeRow row{.id = idOf(words[0], "id", where), .place = number};
  row.node.position = {valueIn(words[2], "x", where), valueIn(words[3], "y", where),
                       valueIn(words[4], "z", where)};
  const double radius = valueIn(words[5], "radius", where, true);
  if (std::isfinite(radius) && radius > 0) row.node.radius = radius;
  const std::string parent = idOf(words[6], "parent", where);
  if (parent != "-1") row.parent = parent;
  row.node.edge = EdgeType::branching; // until the axes are assembled
  return row;
}

/// The nodes of all trees, each axis in one piece before what branches off it.
std::vector<NodeId> axisByAxis(const Skeleton& skeleton) {
  std::vector<NodeId> order;
  std::vector<NodeId> stack = skeleton.roots();
  std::ranges::reverse(stack);
  while (!stack.empty()) {
    const NodeId id = stack.back();
    stack.pop_back();
    order.push_back(id);
    const std::vector<NodeId>& children = skeleton.children(id); // successors first
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return order;
}

} // namespace

bool isSwc(std::string_view beginning) {
  LineReader lines(beginning);
  bool hasRoot = false;
  while (const auto line = lines.next()) {
    if (lines.offset() == beginning.size() && !beginning.ends_with('\n')) break; // cut short
    const std::string_view text = trimmed(*line);
    if (text.empty() || text.starts_with('#')) continue;
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.size() < swcColumns || !isWhole(words[0]) || !isWhole(words[1]) || !isWhole(words[6]))
      return false;
    if (!std::ranges::all_of(words,
                             [](std::string_view word) { return numberIn(word).has_value(); }))
      return false;
    hasRoot = hasRoot || words[6] == "-1";
  }
  return hasRoot;
}

Imported<Skeleton> readSwc(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  std::vector<NodeRow> rows;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    const std::string_view text = trimmed(*line);
    if (!text.empty() && !text.starts_with('#'))
      rows.push_back(sampleIn(text, lines.number(), file));
  }
  if (rows.empty()) throw ShownError({espalier::Shown::tr("holds no nodes"), {}, FilePlace{file}});
  const Skeleton skeleton = skeletonOfRows(rows, [&](const NodeRow& row) {
    return FilePlace{file, row.place};
  });
  return {withAssembledAxes(skeleton), {noteOnAxes(file)}};
}

void writeSwc(std::ostream& out, const Skeleton& skeleton) {
  out << "# exported by Espalier\n# id type x y z radius parent\n";
  std::vector<std::size_t> numbers(skeleton.idEnd());
  std::size_t last = 0;
  for (const NodeId id : axisByAxis(skeleton)) {
    const Node& node = skeleton[id];
    numbers[indexOf(id)] = ++last;
    std::string line = std::to_string(last) + " 0";
    for (const double coordinate : node.position)
      line += ' ' + plainDecimal(coordinate);
    line += ' ' + plainDecimal(node.radius) + ' ';
    line += node.parent ? std::to_string(numbers[indexOf(*node.parent)]) : "-1";
    out << line << '\n';
  }
}

} // namespace espalier
