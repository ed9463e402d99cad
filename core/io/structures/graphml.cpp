#include "core/io/structures/graphml.h"

#include "core/base/listed.h"
#include "core/base/text.h"
#include "core/io/bytes/xml.h"
#include "core/io/structures/node_rows.h"
#include "core/skeleton/assemble_axes.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace espalier {
namespace {

/// The data of an element, by names of keys.
using Data = std::map<std::string, std::string>;

struct Edge {
  std::size_t source = 0; // rows
  std::size_t target = 0;
  bool isDirected = true;
  std::optional<EdgeType> type;
  pugi::xml_node element;
};

/// Reads nodes and edges of a graph into rows.
class GraphReader {
public:
  explicit GraphReader(const XmlFile& xml) : xml_(xml) {
    for (const pugi::xml_node key : xml.root().children("key")) {
      const std::string id = key.attribute("id").value();
      keys_[id] = lowerCase(key.attribute("attr.name").as_string(id.c_str()));
      if (const auto byDefault = key.child("default"))
        defaults_[keys_[id]] = trimmed(byDefault.child_value());
    }
    graph_ = xml.root().child("graph");
    if (!graph_)
      throw ShownError({espalier::Shown::tr("holds no graph"), {}, FilePlace{xml.file()}});
    for (const pugi::xml_node node : graph_.children("node"))
      addNode(node);
    if (rows_.empty())
      throw ShownError({espalier::Shown::tr("holds no nodes"), {}, FilePlace{xml.file()}});
    for (const pugi::xml_node edge : graph_.children("edge"))
      addEdge(edge);
  }

  Imported<Skeleton> read() {
    Imported<Skeleton> result;
    leaveOutSynapses(result.notes);
    attachRows();
    result.value =
        skeletonOfRows(rows_, [this](const NodeRow& row) { return xml_.where(nodes_[row.place]); });
    if (!hasTypes_ && !edges_.empty()) {
      result.value = withAssembledAxes(result.value);
      result.notes.push_back(noteOnAxes(xml_.file()));
    }
    if (!unused_.empty())
      result.notes.push_back({espalier::Shown::tr("its data %1 are left out"),
                              {listed({unused_.begin(), unused_.end()})},
                              FilePlace{xml_.file()}});
    return result;
  }

private:
  void addNode(pugi::xml_node element) {
    static const std::set<std::string> names = {"x", "y", "z", "radius", "diameter"};
    const Data data = dataOf(element, names);
    NodeRow row{.id = element.attribute("id").value(), .place = nodes_.size()};
    constexpr std::array axes = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = data.find(axes[axis]);
      if (value == data.end())
        throw ShownError({espalier::Shown::tr(
                              "the node %1 has no %2: its position is expected as data x, y and z"),
                          {inQuotes(row.id), axes[axis]},
                          xml_.where(element)});
      row.node.position[static_cast<Eigen::Index>(axis)] =
          xml_.numberIn(element, value->second, axes[axis]);
    }
    row.node.radius = radiusOf(element, data);
    if (row.id.empty())
      throw ShownError({espalier::Shown::tr("the node has no id"), {}, xml_.where(element)});
    if (!index_.emplace(row.id, rows_.size()).second)
      throw ShownError(
          {espalier::Shown::tr("the id %1 occurs twice"), {inQuotes(row.id)}, xml_.where(element)});
    rows_.push_back(std::move(row));
    nodes_.push_back(element);
  }

  [[nodiscard]] double radiusOf(pugi::xml_node element, const Data& data) const {
    for (const auto& [name, factor] : {std::pair{"radius", 1.0}, std::pair{"diameter", 0.5}})
      if (const auto value = data.find(name); value != data.end() && !value->second.empty())
        return std::max(0.0, factor * xml_.numberIn(element, value->second, name));
    return 0;
  }

  void addEdge(pugi::xml_node element) {
    Edge edge{.element = element};
    edge.source =
        rowNamed(element, "source",
                 espalier::Shown::tr("the source of the edge, %1, is no node of the graph"));
    edge.target =
        rowNamed(element, "target",
                 espalier::Shown::tr("the target of the edge, %1, is no node of the graph"));
    const std::string_view byDefault = graph_.attribute("edgedefault").as_string("directed");
    edge.isDirected = element.attribute("directed").as_bool(byDefault != "undirected");
    static const std::set<std::string> names = {"type", "edge_type", "edgetype"};
    for (const auto& [name, value] : dataOf(element, names)) {
      const std::string type = lowerCase(value);
      edge.type = type == "+" || type == "branching" || type == "branch" ? EdgeType::branching
                                                                         : EdgeType::successor;
      hasTypes_ = true;
    }
    edges_.push_back(edge);
  }

  [[nodiscard]] std::size_t rowNamed(pugi::xml_node edge, const char* end,
                                     const char* isNone) const {
    const std::string id = edge.attribute(end).value();
    const auto row = index_.find(id);
    if (row == index_.end()) throw ShownError({isNone, {inQuotes(id)}, xml_.where(edge)});
    return row->second;
  }

  /// The data of an element under the keys of these names, or their defaults.
  Data dataOf(pugi::xml_node element, const std::set<std::string>& names) {
    Data data;
    for (const std::string& name : names)
      if (const auto byDefault = defaults_.find(name); byDefault != defaults_.end())
        data.insert(*byDefault);
    for (const pugi::xml_node item : element.children("data")) {
      const auto key = keys_.find(item.attribute("key").value());
      const std::string name =
          key == keys_.end() ? lowerCase(item.attribute("key").value()) : key->second;
      if (names.contains(name))
        data[name] = trimmed(item.child_value());
      else
        unused_.insert(name);
    }
    return data;
  }

  void leaveOutSynapses(std::vector<ShownMessage>& notes) {
    const auto isDirected = [](const Edge& edge) { return edge.isDirected; };
    if (std::ranges::all_of(edges_, isDirected) || std::ranges::none_of(edges_, isDirected)) return;
    const std::size_t count = std::erase_if(edges_, isDirected);
    notes.push_back(
        {count == 1 ? espalier::Shown::tr("1 directed edge among undirected ones is left out")
                    : espalier::Shown::tr("%1 directed edges among undirected ones are left out"),
         {std::to_string(count)},
         FilePlace{xml_.file()}});
  }

  /// Whether each node has one parent at most if edges lead from it, or to it.
  [[nodiscard]] std::optional<Edge> secondParent(std::size_t Edge::*child) const {
    std::vector<bool> hasParent(rows_.size());
    for (const Edge& edge : edges_) {
      if (hasParent[edge.*child]) return edge;
      hasParent[edge.*child] = true;
    }
    return std::nullopt;
  }

  void attachRows() {
    const bool isDirected = edges_.empty() || edges_.front().isDirected;
    auto parent = isDirected ? &Edge::source : &Edge::target;
    auto child = isDirected ? &Edge::target : &Edge::source;
    if (const auto edge = secondParent(child)) {
      if (secondParent(parent))
        throw ShownError({espalier::Shown::tr("the node %1 has two parents: a skeleton is a tree"),
                          {inQuotes(rows_[(*edge).*child].id)},
                          xml_.where(edge->element)});
      std::swap(parent, child);
    }
    for (const Edge& edge : edges_) {
      NodeRow& row = rows_[edge.*child];
      row.parent = rows_[edge.*parent].id;
      row.node.edge = hasTypes_ ? edge.type.value_or(EdgeType::successor) : EdgeType::branching;
    }
  }

  const XmlFile& xml_;
  pugi::xml_node graph_;
  std::map<std::string, std::string> keys_; // names, in small letters, by id
  Data defaults_;
  std::vector<NodeRow> rows_;
  std::vector<pugi::xml_node> nodes_; // by row
  std::unordered_map<std::string, std::size_t> index_;
  std::vector<Edge> edges_;
  std::set<std::string> unused_; // names of data
  bool hasTypes_ = false;
};

void addKey(pugi::xml_node graphml, const char* name, const char* owner, const char* type) {
  pugi::xml_node key = graphml.append_child("key");
  addAttribute(key, "id", name);
  addAttribute(key, "for", owner);
  addAttribute(key, "attr.name", name);
  addAttribute(key, "attr.type", type);
}

void addData(pugi::xml_node element, const char* key, const std::string& text) {
  pugi::xml_node data = element.append_child("data");
  addAttribute(data, "key", key);
  data.text().set(text.c_str());
}

} // namespace

bool isGraphml(std::string_view beginning) {
  return isXml(beginning, "graphml");
}

Imported<Skeleton> readGraphml(std::istream& in, const std::string& file) {
  const XmlFile xml(readAll(in), file, "graphml");
  return GraphReader(xml).read();
}

void writeGraphml(std::ostream& out, const Skeleton& skeleton) {
  pugi::xml_document document;
  pugi::xml_node graphml = document.append_child("graphml");
  addAttribute(graphml, "xmlns", "http://graphml.graphdrawing.org/xmlns");
  for (const char* name : {"x", "y", "z", "radius"})
    addKey(graphml, name, "node", "double");
  addKey(graphml, "type", "edge", "string");
  pugi::xml_node graph = graphml.append_child("graph");
  addAttribute(graph, "id", "plant");
  addAttribute(graph, "edgedefault", "directed");
  std::vector<std::string> names(skeleton.idEnd());
  std::size_t last = 0;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    names[indexOf(id)] = "n" + std::to_string(++last);
    pugi::xml_node element = graph.append_child("node");
    addAttribute(element, "id", names[indexOf(id)]);
    addData(element, "x", plainDecimal(node.position.x()));
    addData(element, "y", plainDecimal(node.position.y()));
    addData(element, "z", plainDecimal(node.position.z()));
    if (node.radius > 0) addData(element, "radius", plainDecimal(node.radius));
    if (!node.parent) continue;
    pugi::xml_node edge = graph.append_child("edge");
    addAttribute(edge, "source", names[indexOf(*node.parent)]);
    addAttribute(edge, "target", names[indexOf(id)]);
    addData(edge, "type", std::string(1, static_cast<char>(node.edge)));
  }
  writeXml(out, document);
}

} // namespace espalier
