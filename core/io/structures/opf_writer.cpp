#include "core/base/text.h"
#include "core/io/bytes/xml.h"
#include "core/io/structures/opf.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <cmath>
#include <map>
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

pugi::xml_node addVertex(pugi::xml_node bearer, const char* name, const std::string& symbol,
                         int scale, int id) {
  pugi::xml_node element = bearer.append_child(name);
  addAttribute(element, "class", symbol);
  addAttribute(element, "scale", std::to_string(scale));
  addAttribute(element, "id", std::to_string(id));
  return element;
}

constexpr int sceneId = 1; // of the element around all

/// Adds what comes before the vertices.
/// @return the element around all of them
pugi::xml_node addScene(pugi::xml_document& document, const std::map<std::string, bool>& features) {
  pugi::xml_node opf = document.append_child("opf");
  addAttribute(opf, "version", "2.0");
  addAttribute(opf, "editable", "true");
  for (const char* none : {"meshBDD", "materialBDD", "shapeBDD"})
    opf.append_child(none);
  pugi::xml_node attributes = opf.append_child("attributeBDD");
  for (const auto& [name, isNumber] : features) {
    pugi::xml_node attribute = attributes.append_child("attribute");
    addAttribute(attribute, "name", name);
    addAttribute(attribute, "class", isNumber ? "Double" : "String");
  }
  return addVertex(opf, "topology", "Scene", 0, sceneId);
}

/// The elements of nodes, each within that of the node it is attached to.
class NodeElements {
public:
  NodeElements(pugi::xml_node scene, const Skeleton& skeleton)
      : scene_(scene), skeleton_(skeleton), scale_(scaleOfNodes(skeleton)),
        symbols_(skeleton.idEnd()), elements_(skeleton.idEnd()) {}

  void addAll() {
    std::vector<NodeId> open = skeleton_.roots();
    std::ranges::reverse(open);
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      add(id);
      const std::vector<NodeId>& children = skeleton_.children(id);
      // Branches are written before the successor, as usual.
      open.insert(open.end(), children.begin(), children.end());
    }
  }

private:
  void add(NodeId id) {
    const Node& node = skeleton_[id];
    pugi::xml_node element = node.parent ? elements_[indexOf(*node.parent)] : scene_;
    bool isPart = !node.parent;
    for (const Entity& entity : entitiesOf(node)) {
      element = addVertex(element,
                          isPart                             ? "decomp"
                          : node.edge == EdgeType::branching ? "branch"
                                                             : "follow",
                          entity.symbol, entity.scale, ++lastId_);
      for (const FeatureValue& value : entity.values)
        addText(element, elementName(value.feature), value.text);
      symbols_[indexOf(id)] = entity.symbol;
      isPart = true;
    }
    addText(element, "XX", plainDecimal(node.position.x()));
    addText(element, "YY", plainDecimal(node.position.y()));
    addText(element, "ZZ", plainDecimal(node.position.z()));
    if (node.radius > 0) addText(element, "radius", plainDecimal(node.radius));
    elements_[indexOf(id)] = element;
  }

  /// Those of a node, the last of the scale of nodes.
  [[nodiscard]] std::vector<Entity> entitiesOf(const Node& node) const {
    std::vector<Entity> entities = node.entities;
    if (entities.empty() && !node.parent && scale_ > plantScale)
      entities.push_back({.scale = plantScale, .symbol = "P"});
    if (entities.empty() || entities.back().scale != scale_) {
      const std::string inherited = node.parent ? symbols_[indexOf(*node.parent)] : "N";
      entities.push_back({.scale = scale_, .symbol = inherited});
    }
    return entities;
  }

  pugi::xml_node scene_;
  const Skeleton& skeleton_;
  int scale_;                            // of the nodes
  std::vector<std::string> symbols_;     // of the nodes, by id
  std::vector<pugi::xml_node> elements_; // by node
  int lastId_ = sceneId;
};

} // namespace

void writeOpf(std::ostream& out, const Skeleton& skeleton) {
  pugi::xml_document document;
  NodeElements(addScene(document, featuresOf(skeleton)), skeleton).addAll();
  writeXml(out, document);
}

void writeOpf(std::ostream& out, const Mtg& mtg) {
  pugi::xml_document document;
  const pugi::xml_node scene = addScene(document, featuresOf(mtg));
  std::vector<pugi::xml_node> lastOf; // by column: the element of its last vertex
  int id = sceneId;
  const MtgRows rows = mtgRows(mtg);
  for (const MtgRow& row : rows.rows) {
    const MtgVertex& vertex = mtg.vertices[indexOf(row.vertex)];
    const std::size_t bearer = row.continues ? row.column + 1 : row.column; // columns up to its own
    pugi::xml_node element = bearer == 0 ? scene : lastOf[bearer - 1];
    lastOf.resize(row.column);
    if (vertex.scale > 0) { // the scene is the element around all
      const char* name = row.edge == '/' ? "decomp" : row.edge == '+' ? "branch" : "follow";
      element = addVertex(element, name, vertex.symbol, vertex.scale, ++id);
      eachValue(vertex, mtg, [&](const std::string& feature, const std::string& text) {
        addText(element, elementName(feature), text);
      });
    }
    lastOf.push_back(element);
  }
  writeXml(out, document);
}

} // namespace espalier
