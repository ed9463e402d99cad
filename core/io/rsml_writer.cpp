#include "core/base/text.h"
#include "core/io/rsml.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <ostream>
#include <vector>

namespace espalier {
namespace {

/// Writes axes, each within the one it branches off.
class RsmlWriter {
public:
  RsmlWriter(std::ostream& out, const Skeleton& skeleton)
      : out_(out), skeleton_(skeleton), axes_(axes(skeleton)), within_(axes_.size()),
        axisOf_(skeleton.idEnd()), pointOf_(skeleton.idEnd()) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const std::optional<NodeId> parent = skeleton[axes_[i].front()].parent;
      if (parent) within_[axisOf_[indexOf(*parent)]].push_back(i); // axes come after their bearers
      std::size_t point = parent ? 1 : 0;                          // 0 lies on the parent
      for (const NodeId id : axes_[i]) {
        axisOf_[indexOf(id)] = i;
        pointOf_[indexOf(id)] = point++;
      }
    }
  }

  void write() {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<rsml xmlns:po=\"http://www.plantontology.org/xml-dtd/po.dtd\">\n"
            "<metadata>\n<version>1</version>\n<unit>unknown</unit>\n<resolution>1</resolution>\n"
            "<software>Espalier</software>\n</metadata>\n<scene>\n";
    std::size_t plants = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (skeleton_[axes_[i].front()].parent) continue;
      out_ << "<plant id=\"p" << ++plants << "\">\n";
      writeTree(i);
      out_ << "</plant>\n";
    }
    out_ << "</scene>\n</rsml>\n";
  }

private:
  void writeTree(std::size_t trunk) {
    struct Step {
      std::size_t axis;
      bool isEnd = false;
    };
    std::vector<Step> stack = {{trunk}};
    while (!stack.empty()) {
      const Step step = stack.back();
      stack.pop_back();
      if (step.isEnd) {
        out_ << "</root>\n";
        continue;
      }
      writeAxis(step.axis);
      stack.push_back({step.axis, true});
      for (auto axis = within_[step.axis].rbegin(); axis != within_[step.axis].rend(); ++axis)
        stack.push_back({*axis});
    }
  }

  void writeAxis(std::size_t i) {
    const Axis& axis = axes_[i];
    const std::optional<NodeId> parent = skeleton_[axis.front()].parent;
    out_ << "<root id=\"r" << i + 1 << "\">\n";
    if (parent)
      out_ << "<properties><parent-node value=\"" << pointOf_[indexOf(*parent)]
           << "\"/></properties>\n";
    out_ << "<geometry><polyline>\n";
    if (parent) writePoint(skeleton_[*parent].position);
    for (const NodeId id : axis)
      writePoint(skeleton_[id].position);
    out_ << "</polyline></geometry>\n";
    const auto hasRadius = [&](NodeId id) { return skeleton_[id].radius > 0; };
    if (!std::ranges::any_of(axis, hasRadius)) return;
    out_ << "<functions><function name=\"diameter\" domain=\"polyline\">\n";
    if (parent) writeDiameter(axis.front());
    for (const NodeId id : axis)
      writeDiameter(id);
    out_ << "</function></functions>\n";
  }

  void writePoint(const Eigen::Vector3d& place) {
    out_ << "<point x=\"" << plainDecimal(place.x()) << "\" y=\"" << plainDecimal(place.y())
         << "\" z=\"" << plainDecimal(place.z()) << "\"/>\n";
  }

  void writeDiameter(NodeId id) {
    out_ << "<sample>" << plainDecimal(2 * skeleton_[id].radius) << "</sample>\n";
  }

  std::ostream& out_;
  const Skeleton& skeleton_;
  std::vector<Axis> axes_;
  std::vector<std::vector<std::size_t>> within_; // axes that branch off each
  std::vector<std::size_t> axisOf_;              // by node
  std::vector<std::size_t> pointOf_;             // by node, in the polyline of its axis
};

} // namespace

void writeRsml(std::ostream& out, const Skeleton& skeleton) {
  RsmlWriter(out, skeleton).write();
}

} // namespace espalier
