#include "core/mtg/mtg_skeleton.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace espalier {
namespace {

using Feature = std::optional<std::size_t>; // place in Mtg::features

/// Where positions and radii are.
struct Geometry {
  std::array<Feature, 3> position;
  Feature radius;
  Feature diameter;
};

Feature featureNamed(const Mtg& mtg, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < mtg.features.size(); ++i)
      if (lowerCase(mtg.features[i].name) == name) return i;
  return std::nullopt;
}

Geometry geometryOf(const Mtg& mtg) {
  return {{featureNamed(mtg, {"xx", "x"}), featureNamed(mtg, {"yy", "y"}),
           featureNamed(mtg, {"zz", "z"})},
          featureNamed(mtg, {"radius"}),
          featureNamed(mtg, {"diameter"})};
}

/// The value of a feature; none if there is no finite one.
std::optional<double> valueOf(const MtgVertex& vertex, const Feature& feature,
                              const std::string& file) {
  if (!feature || *feature >= vertex.values.size()) return std::nullopt;
  const std::string& text = vertex.values[*feature];
  if (isMissingMtgValue(text)) return std::nullopt;
  const auto number = numberIn(text);
  if (!number)
    throw Error(file + ": " + inQuotes(text) + " stands for a coordinate or radius of a vertex " +
                vertex.symbol + ", expected a number");
  if (!std::isfinite(*number)) return std::nullopt;
  return number;
}

std::optional<Eigen::Vector3d> positionOf(const MtgVertex& vertex, const Geometry& geometry,
                                          const std::string& file) {
  Eigen::Vector3d position;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = valueOf(vertex, geometry.position[axis], file);
    if (!value) return std::nullopt;
    position[static_cast<Eigen::Index>(axis)] = *value;
  }
  return position;
}

std::optional<int> finestPositionedScale(const Mtg& mtg, const Geometry& geometry,
                                         const std::string& file) {
  std::optional<int> finest;
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.scale > finest.value_or(-1) && positionOf(vertex, geometry, file))
      finest = vertex.scale;
  return finest;
}

/// What hangs on a vertex hangs on this node, by this edge unless its own is branching.
struct Link {
  std::optional<NodeId> node;
  EdgeType edge = EdgeType::successor;
};

struct Counts {
  std::size_t unplaced = 0;
  std::size_t negative = 0;
};

double radiusOf(const MtgVertex& vertex, const Geometry& geometry, const std::string& file,
                Counts& counts) {
  const auto diameter = valueOf(vertex, geometry.diameter, file);
  const double radius = valueOf(vertex, geometry.radius, file).value_or(diameter.value_or(0) / 2);
  if (radius >= 0) return radius;
  ++counts.negative;
  return 0;
}

std::vector<std::string> notesOn(const Counts& counts, const std::string& file) {
  std::vector<std::string> notes;
  if (counts.unplaced > 0)
    notes.push_back(file + ": " + std::to_string(counts.unplaced) +
                    " vertices have no position and are passed over");
  if (counts.negative > 0)
    notes.push_back(file + ": " + std::to_string(counts.negative) +
                    " radii are negative and are taken as not known");
  return notes;
}

} // namespace

bool hasPositions(const Mtg& mtg, const std::string& file) {
  return finestPositionedScale(mtg, geometryOf(mtg), file).has_value();
}

Imported<Skeleton> skeletonOf(const Mtg& mtg, const std::string& file) {
  const Geometry geometry = geometryOf(mtg);
  const std::optional<int> scale = finestPositionedScale(mtg, geometry, file);
  if (!scale)
    throw Error(file + ": none of its vertices has a position, in features XX, YY and ZZ: it "
                       "describes a plant without its shape");
  Imported<Skeleton> result;
  Counts counts;
  std::vector<Link> links(mtg.vertices.size());
  for (std::size_t i = 0; i < mtg.vertices.size(); ++i) {
    const MtgVertex& vertex = mtg.vertices[i];
    if (vertex.scale != scale) continue;
    Link link = vertex.parent ? links[indexOf(*vertex.parent)] : Link{};
    if (vertex.parent && vertex.edge == EdgeType::branching) link.edge = EdgeType::branching;
    if (const auto position = positionOf(vertex, geometry, file)) {
      const double radius = radiusOf(vertex, geometry, file, counts);
      link = {result.value.add(
                  {*position, radius, link.node, link.node ? link.edge : EdgeType::successor}),
              EdgeType::successor};
    } else {
      ++counts.unplaced;
    }
    links[i] = link;
  }
  result.notes = notesOn(counts, file);
  return result;
}

} // namespace espalier
