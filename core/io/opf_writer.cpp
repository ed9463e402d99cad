#include "core/base/text.h"
#include "core/io/opf.h"
#include "core/io/xml.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <vector>

namespace espalier {
namespace {

constexpr int plantScale = 1; // of a skeleton that is of no MTG
constexpr int nodeScale = 2;

/// A name that an element may have and that stands for nothing else.
std::string elementName(const std::string& feature) {
  const auto isLetter = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
  };
  std::string name;
  for (const char c : feature)
    name += isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' ? c : '_';
  static const std::set<std::string> taken = {"decomp", "follow", "branch", "geometry"};
  if (name.empty() || !isLetter(name.front()) || taken.contains(name)) return '_' + name;
  return name;
}

int scaleOfNodes(const Skeleton& skeleton) {
  int scale = 0;
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities)
      scale = std::max(scale, entity.scale);
  return scale > 0 ? scale : nodeScale;
}

void addFeature(const std::string& name, const std::string& text,
                std::map<std::string, bool>& features) {
  const auto number = numberIn(text);
  const auto [place, isNew] = features.emplace(elementName(name), true);
  place->second = place->second && number && std::isfinite(*number);
}

/// Which features there are, and whether all values of each are numbers.
std::map<std::string, bool> featuresOf(const Skeleton& skeleton) {
  std::map<std::string, bool> features;
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities)
      for (const FeatureValue& value : entity.values)
        addFeature(value.feature, value.text, features);
  for (const char* name : {"XX", "YY", "ZZ", "radius"})
    features[name] = true;
  return features;
}

/// The values of a vertex that OPF can keep.
template <class Visit> void eachValue(const MtgVertex& vertex, const Mtg& mtg, const Visit& visit) {
  for (std::size_t i = 0; i < std::min(vertex.values.size(), mtg.features.size()); ++i)
    if (!isMissingMtgValue(vertex.values[i])) visit(mtg.features[i].name, vertex.values[i]);
}

std::map<std::string, bool> featuresOf(const Mtg& mtg) {
  std::map<std::string, bool> features;
  for (const MtgVertex& vertex : mtg.vertices)
    eachValue(vertex, mtg, [&](const std::string& name, const std::string& text) {
      addFeature(name, text, features);
    });
  return features;
}

void writeValue(std::ostream& out, const std::string& name, const std::string& text) {
  out << '<' << name << '>' << xmlText(text) << "</" << name << ">\n";
}

void openElement(std::ostream& out, const char* name, const std::string& symbol, int scale,
                 int id) {
  out << '<' << name << " class=\"" << xmlText(symbol) << "\" scale=\"" << scale << "\" id=\"" << id
      << "\">\n";
}

constexpr const char* sceneElement = "<topology class=\"Scene\" scale=\"0\" id=\"1\">\n";

void writeHead(std::ostream& out, const std::map<std::string, bool>& features) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<opf version=\"2.0\" editable=\"true\">\n"
         "<meshBDD/>\n<materialBDD/>\n<shapeBDD/>\n<attributeBDD>\n";
  for (const auto& [name, isNumber] : features)
    out << "<attribute name=\"" << name << "\" class=\"" << (isNumber ? "Double" : "String")
        << "\"/>\n";
  out << "</attributeBDD>\n";
}

/// Writes the nodes, each within the one it hangs on.
class OpfTopologyWriter {
public:
  OpfTopologyWriter(std::ostream& out, const Skeleton& skeleton)
      : out_(out), skeleton_(skeleton), scale_(scaleOfNodes(skeleton)), symbols_(skeleton.idEnd()) {
  }

  void write() {
    out_ << sceneElement;
    // What is to be written, last first: a node, or the ends of the elements of one.
    struct Step {
      NodeId node;
      bool isEnd = false;
    };
    std::vector<Step> stack;
    const std::vector<NodeId> roots = skeleton_.roots();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      stack.push_back({*root});
    while (!stack.empty()) {
      const Step step = stack.back();
      stack.pop_back();
      if (step.isEnd) {
        close();
        continue;
      }
      open(step.node);
      stack.push_back({step.node, true});
      const std::vector<NodeId>& children = skeleton_.children(step.node);
      for (const NodeId child : children) // branches are written before the successor, as usual
        stack.push_back({child});
    }
    out_ << "</topology>\n</opf>\n";
  }

private:
  void open(NodeId id) {
    const Node& node = skeleton_[id];
    std::vector<Entity> entities = node.entities;
    if (entities.empty() && !node.parent && scale_ > plantScale)
      entities.push_back({.scale = plantScale, .symbol = "P"});
    if (entities.empty() || entities.back().scale != scale_) {
      const std::string inherited = node.parent ? symbols_[indexOf(*node.parent)] : "N";
      entities.push_back({.scale = scale_, .symbol = inherited});
    }
    symbols_[indexOf(id)] = entities.back().symbol;
    std::vector<std::string> names;
    for (const Entity& entity : entities) {
      const bool isPart = !names.empty() || !node.parent;
      names.emplace_back(isPart                             ? "decomp"
                         : node.edge == EdgeType::branching ? "branch"
                                                            : "follow");
      openEntity(names.back(), entity);
    }
    writeValue(out_, "XX", plainDecimal(node.position.x()));
    writeValue(out_, "YY", plainDecimal(node.position.y()));
    writeValue(out_, "ZZ", plainDecimal(node.position.z()));
    if (node.radius > 0) writeValue(out_, "radius", plainDecimal(node.radius));
    open_.push_back(std::move(names));
  }

  void openEntity(const std::string& name, const Entity& entity) {
    openElement(out_, name.c_str(), entity.symbol, entity.scale, ++lastId_);
    for (const FeatureValue& value : entity.values)
      writeValue(out_, elementName(value.feature), value.text);
  }

  void close() {
    for (auto name = open_.back().rbegin(); name != open_.back().rend(); ++name)
      out_ << "</" << *name << ">\n";
    open_.pop_back();
  }

  std::ostream& out_;
  const Skeleton& skeleton_;
  int scale_;                                  // of the nodes
  std::vector<std::string> symbols_;           // of the nodes, by id
  std::vector<std::vector<std::string>> open_; // elements, by node
  int lastId_ = 1;
};

} // namespace

void writeOpf(std::ostream& out, const Skeleton& skeleton) {
  writeHead(out, featuresOf(skeleton));
  OpfTopologyWriter(out, skeleton).write();
}

void writeOpf(std::ostream& out, const Mtg& mtg) {
  const MtgRows rows = mtgRows(mtg);
  writeHead(out, featuresOf(mtg));
  out << sceneElement;
  std::vector<std::size_t> lastOf; // by column: how many elements are open within its last vertex
  std::vector<const char*> open;
  const auto closeTo = [&](std::size_t depth) {
    for (; open.size() > depth; open.pop_back())
      out << "</" << open.back() << ">\n";
  };
  int id = 1;
  for (const MtgRow& row : rows.rows) {
    const MtgVertex& vertex = mtg.vertices[indexOf(row.vertex)];
    const std::size_t bearer = row.continues ? row.column + 1 : row.column; // columns up to its own
    closeTo(bearer == 0 ? 0 : lastOf[bearer - 1]);
    lastOf.resize(row.column);
    if (vertex.scale > 0) { // the scene is the element around all
      open.push_back(row.edge == '/' ? "decomp" : row.edge == '+' ? "branch" : "follow");
      openElement(out, open.back(), vertex.symbol, vertex.scale, ++id);
      eachValue(vertex, mtg, [&](const std::string& name, const std::string& text) {
        writeValue(out, elementName(name), text);
      });
    }
    lastOf.push_back(open.size());
  }
  closeTo(0);
  out << "</topology>\n</opf>\n";
}

} // namespace espalier
