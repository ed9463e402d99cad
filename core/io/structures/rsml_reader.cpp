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
    if (result_.value.isEmpty())
      throw ShownError(
          {espalier::Shown::tr("holds no polylines of roots"), {}, FilePlace{xml_.file()}});
    noteUnit();
    noteWhatIsAmiss();
    return std::move(result_);
  }

private:
  /// A root to be read, and the one it is within.
  struct Step {
    pugi::xml_node element;
    std::optional<std::size_t> bearer; // place in polylines_
  };

  void note(ShownMessage what) {
    what.where = FilePlace{xml_.file()};
    result_.notes.push_back(std::move(what));
  }

  void noteUnit() {
    const pugi::xml_node metadata = xml_.root().child("metadata");
    const std::string_view unit = trimmed(metadata.child_value("unit"));
    if (unit.empty() || unit == "unknown") return;
    note({espalier::Shown::tr("its unit is %1, at a resolution of %2"),
          {inQuotes(unit), inQuotes(trimmed(metadata.child_value("resolution")))}});
  }

  void noteWhatIsAmiss() {
    if (isFlat_) note({espalier::Shown::tr("its points have no z, which is taken as 0")});
    if (bare_ > 0)
      note({bare_ == 1 ? espalier::Shown::tr("1 root has no polyline and is left out")
                       : espalier::Shown::tr("%1 roots have no polyline and are left out"),
            {std::to_string(bare_)}});
    if (strays_ > 0)
      note({strays_ == 1 ? espalier::Shown::tr("1 root names a parent-node that is not there, and "
                                               "is attached to the nearest node")
                         : espalier::Shown::tr("%1 roots name a parent-node that is not there, and "
                                               "are attached to the nearest node"),
            {std::to_string(strays_)}});
    if (!unused_.empty())
      note({espalier::Shown::tr("its functions %1 are left out"),
            {listed({unused_.begin(), unused_.end()})}});
  }

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
      throw ShownError({espalier::Shown::tr("too many roots on long ones have no parent-node"),
                        {},
                        xml_.where(root)});
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
