#include "core/base/text.h"
#include "core/io/bytes/xml.h"
#include "core/io/structures/rsml.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <vector>

namespace espalier {
namespace {

void addMetadata(pugi::xml_node rsml) {
  pugi::xml_node metadata = rsml.append_child("metadata");
  addText(metadata, "version", "1");
  addText(metadata, "unit", "unknown");
  addText(metadata, "resolution", "1");
  addText(metadata, "software", "Espalier");
}

/// The elements of axes, each within that of the axis it branches off.
class RootElements {
public:
  RootElements(pugi::xml_node scene, const Skeleton& skeleton)
      : scene_(scene), skeleton_(skeleton), rootOf_(skeleton.idEnd()), pointOf_(skeleton.idEnd()) {}

  void add(const Axis& axis) { // after the one that bears it
    const std::optional<NodeId> parent = skeleton_[axis.front()].parent;
    pugi::xml_node bearer = parent ? rootOf_[indexOf(*parent)] : newPlant();
    pugi::xml_node root = bearer.append_child("root");
    addAttribute(root, "id", "r" + std::to_string(++roots_));
    std::size_t point = parent ? 1 : 0; // 0 lies on the parent
    for (const NodeId id : axis) {
      rootOf_[indexOf(id)] = root;
      pointOf_[indexOf(id)] = point++;
    }
    if (parent)
      addAttribute(root.append_child("properties").append_child("parent-node"), "value",
                   std::to_string(pointOf_[indexOf(*parent)]));
    addPolyline(root, axis, parent);
    addDiameters(root, axis, parent);
  }

private:
  pugi::xml_node newPlant() {
    pugi::xml_node plant = scene_.append_child("plant");
    addAttribute(plant, "id", "p" + std::to_string(++plants_));
    return plant;
  }

  void addPolyline(pugi::xml_node root, const Axis& axis, std::optional<NodeId> parent) const {
    pugi::xml_node polyline = root.append_child("geometry").append_child("polyline");
    const auto addPoint = [&](NodeId id) {
      const Eigen::Vector3d& place = skeleton_[id].position;
      pugi::xml_node point = polyline.append_child("point");
      addAttribute(point, "x", plainDecimal(place.x()));
      addAttribute(point, "y", plainDecimal(place.y()));
      addAttribute(point, "z", plainDecimal(place.z()));
    };
    if (parent) addPoint(*parent);
    std::ranges::for_each(axis, addPoint);
  }

  void addDiameters(pugi::xml_node root, const Axis& axis, std::optional<NodeId> parent) const {
    const auto hasRadius = [&](NodeId id) { return skeleton_[id].radius > 0; };
    if (std::ranges::none_of(axis, hasRadius)) return;
    pugi::xml_node function = root.append_child("functions").append_child("function");
    addAttribute(function, "name", "diameter");
    addAttribute(function, "domain", "polyline");
    const auto addSample = [&](NodeId id) {
      addText(function, "sample", plainDecimal(2 * skeleton_[id].radius));
    };
    if (parent) addSample(axis.front());
    std::ranges::for_each(axis, addSample);
  }

  pugi::xml_node scene_;
  const Skeleton& skeleton_;
  std::vector<pugi::xml_node> rootOf_; // by node
  std::vector<std::size_t> pointOf_;   // by node, in the polyline of its axis
  std::size_t plants_ = 0;
  std::size_t roots_ = 0;
};

} // namespace

void writeRsml(std::ostream& out, const Skeleton& skeleton) {
  pugi::xml_document document;
  pugi::xml_node rsml = document.append_child("rsml");
  addAttribute(rsml, "xmlns:po", "http://www.plantontology.org/xml-dtd/po.dtd");
  addMetadata(rsml);
  RootElements roots(rsml.append_child("scene"), skeleton);
  for (const Axis& axis : axes(skeleton))
    roots.add(axis);
  writeXml(out, document);
}

} // namespace espalier
