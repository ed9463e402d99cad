#include "core/io/structures/treefile.h"

#include "core/base/listed.h"
#include "core/base/text.h"
#include "core/io/structures/node_rows.h"
#include "core/skeleton/assemble_axes.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <vector>

namespace espalier {
namespace {

constexpr std::string_view leadingFields = "x,y,z,radius";
constexpr std::string_view parentField = "parent_id";

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    fields.push_back(trimmed(line.substr(start, end - start)));
    start = end + 1;
  }
  return fields;
}

/// The fields of a segment, as the line of names lists them.
struct Fields {
  std::size_t count = 0;
  std::optional<std::size_t> parent; // place of parent_id
};

struct Layout {
  Fields first;  // of the first segment of a tree
  Fields others; // of all others
  std::vector<std::string> extra;
};

Fields namesOf(std::string_view names, std::vector<std::string>& extra) {
  Fields fields;
  std::set<std::string_view> known(extra.begin(), extra.end());
  std::vector<std::string> added; // apart: `known` views the names in `extra`
  for (const std::string_view name : fieldsOf(names)) {
    const std::size_t at = fields.count++;
    if (name == parentField)
      fields.parent = at;
    else if (at >= 4 && !name.empty() && known.insert(name).second)
      added.emplace_back(name);
  }
  extra.insert(extra.end(), added.begin(), added.end());
  return fields;
}

Layout layoutOf(std::string_view line, const FilePlace& where) {
  const std::string_view names = trimmed(line);
  if (!names.starts_with(leadingFields))
    throw ShownError(
        {espalier::Shown::tr("expected the names of the fields, x,y,z,radius,parent_id, found %1"),
         {inQuotes(names)},
         where});
  Layout layout;
  const std::size_t second = names.find(leadingFields, leadingFields.size());
  std::string_view head = trimmed(names.substr(0, second));
  if (head.ends_with(',')) head.remove_suffix(1);
  layout.first = namesOf(head, layout.extra);
  layout.others =
      second == std::string_view::npos ? layout.first : namesOf(names.substr(second), layout.extra);
  return layout;
}

/// The nodes of a line, which is a tree.
class Tree {
public:
  Tree(std::string_view line, const Layout& layout, FilePlace where)
      : values_(fieldsOf(line)), layout_(layout), where_(std::move(where)) {
    const std::size_t first = layout.first.count;
    const bool isWhole =
        values_.size() >= first && (values_.size() - first) % layout.others.count == 0;
    if (!isWhole)
      throw ShownError(
          {espalier::Shown::tr("expected %1 fields and then a multiple of %2, found %3"),
           {std::to_string(first), std::to_string(layout.others.count),
            std::to_string(values_.size())},
           where_});
    count_ = 1 + (values_.size() - first) / layout.others.count;
    if (count_ > 1 && !layout.others.parent)
      throw ShownError(
          {espalier::Shown::tr("the tree has several segments, and no parent_id to join them"),
           {},
           where_});
  }

  /// @param tree  number of the tree, which its ids begin with
  void addTo(std::vector<NodeRow>& rows, std::size_t tree, std::size_t line) const {
    for (std::size_t i = 0; i < count_; ++i)
      rows.push_back(row(i, std::to_string(tree) + '.', line));
  }

private:
  [[nodiscard]] NodeRow row(std::size_t i, const std::string& prefix, std::size_t line) const {
    const Fields& fields = i == 0 ? layout_.first : layout_.others;
    const std::size_t start = i == 0 ? 0 : layout_.first.count + (i - 1) * layout_.others.count;
    const auto number = [&](std::size_t field, std::string_view name) {
      return numberOf(i, values_[start + field], name);
    };
    NodeRow row{.id = prefix + std::to_string(i), .place = line};
    row.node.position = {number(0, "x"), number(1, "y"), number(2, "z")};
    row.node.radius = std::max(0.0, number(3, "radius"));
    row.node.edge = EdgeType::branching; // until the axes are assembled
    if (!fields.parent) return row;
    const double parent = number(*fields.parent, parentField);
    if (parent == -1) return row;
    if (!(parent >= 0 && parent < static_cast<double>(count_)) || parent != std::floor(parent))
      throw ShownError({espalier::Shown::tr(
                            "segment %1: its parent_id is %2, but the tree has segments 0 to %3"),
                        {std::to_string(i), inQuotes(values_[start + *fields.parent]),
                         std::to_string(count_ - 1)},
                        where_});
    row.parent = prefix + std::to_string(static_cast<std::size_t>(parent));
    return row;
  }

  [[nodiscard]] double numberOf(std::size_t segment, std::string_view field,
                                std::string_view name) const {
    const auto number = numberIn(field);
    if (!number || !std::isfinite(*number))
      throw ShownError({espalier::Shown::tr("segment %1: expected a number as %2, found %3"),
                        {std::to_string(segment), std::string(name), inQuotes(field)},
                        where_});
    return *number;
  }

  std::vector<std::string_view> values_;
  const Layout& layout_;
  FilePlace where_;
  std::size_t count_ = 0;
};

void writeTree(std::ostream& out, const Skeleton& skeleton, NodeId root,
               std::vector<std::size_t>& numbers) {
  std::vector<NodeId> order = {root};
  for (std::size_t next = 0; next < order.size(); ++next) {
    const Node& node = skeleton[order[next]];
    numbers[indexOf(order[next])] = next;
    std::string segment = next > 0 ? ", " : "";
    for (const double coordinate : node.position)
      segment += plainDecimal(coordinate) + ',';
    segment += plainDecimal(node.radius) + ',';
    segment += next > 0 ? std::to_string(numbers[indexOf(*node.parent)]) : "-1";
    out << segment;
    const std::vector<NodeId>& children = skeleton.children(order[next]);
    order.insert(order.end(), children.begin(), children.end());
  }
  out << '\n';
}

} // namespace

bool isTreefile(std::string_view beginning) {
  LineReader lines(beginning);
  while (const auto line = lines.next())
    if (!line->empty() && !line->starts_with('#'))
      return line->starts_with(leadingFields) && line->find(parentField) != std::string_view::npos;
  return false;
}

Imported<Skeleton> readTreefile(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  std::optional<Layout> layout;
  std::vector<NodeRow> rows;
  std::size_t trees = 0;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty() || line->starts_with('#')) continue;
    const FilePlace where{file, lines.number()};
    if (layout)
      Tree(*line, *layout, where).addTo(rows, trees++, lines.number());
    else
      layout = layoutOf(*line, where);
  }
  if (rows.empty()) throw ShownError({espalier::Shown::tr("holds no trees"), {}, FilePlace{file}});
  const Skeleton skeleton = skeletonOfRows(rows, [&](const NodeRow& row) {
    return FilePlace{file, row.place};
  });
  Imported<Skeleton> result{withAssembledAxes(skeleton), {noteOnAxes(file)}};
  if (!layout->extra.empty())
    result.notes.push_back({espalier::Shown::tr("its fields %1 are left out"),
                            {listed(layout->extra)},
                            FilePlace{file}});
  return result;
}

void writeTreefile(std::ostream& out, const Skeleton& skeleton) {
  out << "# Tree file, exported by Espalier\n" << leadingFields << ',' << parentField << '\n';
  std::vector<std::size_t> numbers(skeleton.idEnd()); // of segments in their trees
  for (const NodeId root : skeleton.roots())
    writeTree(out, skeleton, root, numbers);
}

} // namespace espalier
