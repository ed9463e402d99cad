#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/base/text.h"
#include "core/io/bytes/xml.h"
#include "core/io/structures/rsml.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Polyline = std::vector<NodeId>; // of a root, by point

class RsmlReader {
public:
  explicit RsmlReader(const XmlFile& xml) : xml_(xml) {}

  Imported<Skeleton> read() {
    readRoots();
    if (result_.value.isEmpty()) throw Error(xml_.file() + ": holds no polylines of roots");
    const pugi::xml_node metadata = xml_.root().child("metadata");
    if (const std::string_view unit = trimmed(metadata.child_value("unit"));
        !unit.empty() && unit != "unknown")
      note("its unit is " + inQuotes(unit) + ", at a resolution of " +
           inQuotes(trimmed(metadata.child_value("resolution"))));
    if (isFlat_) note("its points have no z, which is taken as 0");
    if (bare_ > 0)
      note(counted(bare_, "root has no polyline and is", "roots have no polyline and are") +
           " left out");
    if (strays_ > 0)
      note(counted(strays_, "root names a parent-node that is not there, and is attached",
                   "roots name a parent-node that is not there, and are attached") +
           " to the nearest node");
    if (!unused_.empty())
      note("its functions " + listed({unused_.begin(), unused_.end()}) + " are left out");
    return std::move(result_);
  }

private:
  /// A root to be read, and the one it is within.
  struct Step {
    pugi::xml_node element;
    std::optional<std::size_t> bearer; // place in polylines_
  };

  void note(const std::string& text) { result_.notes.push_back(xml_.file() + ": " + text); }

  /// Not by recursion: how deep roots are nested is up to the file.
  void readRoots() {
    std::vector<Step> stack;
    const auto addAll = [&](pugi::xml_node parent, std::optional<std::size_t> bearer) {
      for (pugi::xml_node root = parent.last_child(); root; root = root.previous_sibling())
        if (std::string_view(root.name()) == "root") stack.push_back({root, bearer});
    };
    for (pugi::xml_node scene = xml_.root().last_child(); scene; scene = scene.previous_sibling())
      if (std::string_view(scene.name()) == "scene")
        for (pugi::xml_node plant = scene.last_child(); plant; plant = plant.previous_sibling())
          if (std::string_view(plant.name()) == "plant") addAll(plant, std::nullopt);
    while (!stack.empty()) {
      const Step step = stack.back();
      stack.pop_back();
      addAll(step.element, readRoot(step));
    }
  }

  /// @return what roots within this one are attached to
  std::optional<std::size_t> readRoot(const Step& step) {
    const std::vector<Eigen::Vector3d> points = pointsOf(step.element);
    if (points.empty()) {
      ++bare_;
      return step.bearer;
    }
    const std::vector<double> radii = radiiOf(step.element);
    Polyline polyline;
    std::optional<NodeId> parent = bearerOf(step, points.front());
    EdgeType edge = parent ? EdgeType::branching : EdgeType::successor;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool isOnParent = i == 0 && parent && result_.value[*parent].position == points[i];
      if (!isOnParent) {
        const double radius = i < radii.size() ? radii[i] : 0;
        parent = result_.value.add(
            {.position = points[i], .radius = radius, .parent = parent, .edge = edge});
        edge = EdgeType::successor;
      }
      polyline.push_back(*parent);
    }
    polylines_.push_back(std::move(polyline));
    return polylines_.size() - 1;
  }

  std::vector<Eigen::Vector3d> pointsOf(pugi::xml_node root) {
    std::vector<Eigen::Vector3d> points;
    for (const pugi::xml_node point : root.child("geometry").child("polyline").children("point")) {
      const auto coordinate = [&](const char* name) {
        return xml_.numberIn(point, point.attribute(name).value(), name);
      };
      const bool hasZ = point.attribute("z");
      isFlat_ = isFlat_ || !hasZ;
      points.emplace_back(coordinate("x"), coordinate("y"), hasZ ? coordinate("z") : 0.0);
    }
    return points;
  }

  /// By point; empty if they are not stated.
  std::vector<double> radiiOf(pugi::xml_node root) {
    std::vector<double> radii;
    for (const pugi::xml_node function : root.child("functions").children("function")) {
      const std::string name = lowerCase(function.attribute("name").value());
      const std::string_view domain = function.attribute("domain").as_string("polyline");
      if (name != "diameter" || domain != "polyline" || !radii.empty()) {
        unused_.insert(name);
        continue;
      }
      for (const pugi::xml_node sample : function.children("sample")) {
        const auto value = sample.attribute("value");
        const double diameter =
            xml_.numberIn(sample, value ? value.value() : sample.child_value(), "diameter");
        radii.push_back(std::max(0.0, diameter / 2));
      }
    }
    return radii;
  }

  std::optional<NodeId> bearerOf(const Step& step, const Eigen::Vector3d& start) {
    if (!step.bearer) return std::nullopt;
    const Polyline& bearer = polylines_[*step.bearer];
    if (const auto property = step.element.child("properties").child("parent-node")) {
      const auto value = property.attribute("value");
      const double number =
          xml_.numberIn(property, value ? value.value() : property.child_value(), "parent-node");
      if (number >= 0 && number < static_cast<double>(bearer.size()))
        return bearer[static_cast<std::size_t>(number)];
      ++strays_;
    }
    return nearest(step.element, bearer, start);
  }

  NodeId nearest(pugi::xml_node root, const Polyline& bearer, const Eigen::Vector3d& place) {
    constexpr std::size_t most = 100'000'000; // about a second
    compared_ += bearer.size();
    if (compared_ > most)
      throw Error(xml_.where(root) + "too many roots on long ones have no parent-node");
    const auto distance = [&](NodeId id) {
      return (result_.value[id].position - place).squaredNorm();
    };
    return *std::ranges::min_element(bearer, {}, distance);
  }

  const XmlFile& xml_;
  Imported<Skeleton> result_;
  std::vector<Polyline> polylines_; // of the roots read so far
  std::set<std::string> unused_;    // names of functions
  bool isFlat_ = false;
  std::size_t bare_ = 0;
  std::size_t strays_ = 0;
  std::size_t compared_ = 0;
};

} // namespace

bool isRsml(std::string_view beginning) {
  return isXml(beginning, "rsml");
}

Imported<Skeleton> readRsml(std::istream& in, const std::string& file) {
  const XmlFile xml(readAll(in), file, "rsml");
  return RsmlReader(xml).read();
}

} // namespace espalier
