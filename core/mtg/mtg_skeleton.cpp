#include "core/mtg/mtg_skeleton.h"

#include "core/mtg/mtg_geometry.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace espalier {
namespace {

std::optional<int> finestPositionedScale(const Mtg& mtg, const MtgGeometry& geometry,
                                         const std::string& file) {
  std::optional<int> finest;
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.scale > finest.value_or(std::numeric_limits<int>::min()) &&
        mtgPosition(vertex, geometry, file))
      finest = vertex.scale;
  return finest;
}

/// A vertex with a position, up or down the axis, and how many edges away it is.
struct Neighbor {
  std::optional<Eigen::Vector3d> position;
  double edges = 0;
};

/// The positions of vertices of a scale: their own, else evenly between those around them.
struct Positions {
  std::vector<std::optional<Eigen::Vector3d>> own;
  std::vector<Neighbor> below;
  std::vector<Neighbor> above;

  Positions(const Mtg& mtg, int scale, const MtgGeometry& geometry, const std::string& file)
      : own(mtg.vertices.size()), below(mtg.vertices.size()), above(mtg.vertices.size()) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const MtgVertex& vertex = mtg.vertices[i];
      if (vertex.scale != scale) continue;
      own[i] = mtgPosition(vertex, geometry, file);
      if (own[i])
        below[i] = above[i] = {own[i], 0};
      else if (vertex.parent)
        below[i] = {below[indexOf(*vertex.parent)].position,
                    below[indexOf(*vertex.parent)].edges + 1};
    }
    for (std::size_t i = own.size(); i-- > 0;) { // backwards: the first successor has the last word
      const MtgVertex& vertex = mtg.vertices[i];
      if (vertex.scale != scale || !vertex.parent || vertex.edge != EdgeType::successor) continue;
      const std::size_t parent = indexOf(*vertex.parent);
      if (!own[parent] && above[i].position)
        above[parent] = {above[i].position, above[i].edges + 1};
    }
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> at(std::size_t i) const {
    if (own[i] || !below[i].position || !above[i].position) return own[i];
    const double fraction = below[i].edges / (below[i].edges + above[i].edges);
    return *below[i].position + fraction * (*above[i].position - *below[i].position);
  }
};

/// What is attached to a vertex is attached to this node, by this edge unless its own is branching.
struct Link {
  std::optional<NodeId> node;
  EdgeType edge = EdgeType::successor;
};

struct Counts {
  std::size_t unplaced = 0;
  std::size_t negative = 0;
};

double radiusOf(const MtgVertex& vertex, const MtgGeometry& geometry, const std::string& file,
                Counts& counts) {
  const auto diameter = mtgNumber(vertex, geometry.diameter, file);
  const double radius = mtgNumber(vertex, geometry.radius, file).value_or(diameter.value_or(0) / 2);
  if (radius >= 0) return radius;
  ++counts.negative;
  return 0;
}

std::vector<ShownMessage> notesOn(const Counts& counts, std::size_t interpolated,
                                  const std::string& file) {
  std::vector<ShownMessage> notes;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0)
      notes.push_back({count == 1 ? one : many, {std::to_string(count)}, FilePlace{file}});
  };
  add(interpolated,
      espalier::Shown::tr("1 vertex has no position and is put evenly between neighbors"),
      espalier::Shown::tr("%1 vertices have no position and are put evenly between neighbors"));
  add(counts.unplaced, espalier::Shown::tr("1 vertex has no position and is passed over"),
      espalier::Shown::tr("%1 vertices have no position and are passed over"));
  add(counts.negative, espalier::Shown::tr("1 radius is negative and is taken as not known"),
      espalier::Shown::tr("%1 radii are negative and are taken as not known"));
  return notes;
}

/// The vertices that `part` is in and `before` is not, coarsest first.
std::vector<VertexId> startsOf(const Mtg& mtg, VertexId part, std::optional<VertexId> before) {
  const auto complexOf = [&](VertexId id) { return mtg.vertices[indexOf(id)].complex; };
  const auto scaleOf = [&](VertexId id) { return mtg.vertices[indexOf(id)].scale; };
  std::vector<VertexId> starts;
  std::optional<VertexId> other = before ? complexOf(*before) : std::nullopt;
  for (auto unit = complexOf(part); unit; unit = complexOf(*unit)) {
    while (other && scaleOf(*other) > scaleOf(*unit))
      other = complexOf(*other);
    if (other == unit) break; // and so are all coarser ones
    starts.push_back(*unit);
  }
  std::ranges::reverse(starts);
  return starts;
}

/// Values of a vertex by the names of their features.
std::vector<FeatureValue> valuesOf(const Mtg& mtg, const std::vector<std::string>& values,
                                   const std::vector<std::size_t>& without) {
  std::vector<FeatureValue> result;
  for (std::size_t i = 0; i < std::min(values.size(), mtg.features.size()); ++i)
    if (!values[i].empty() && std::ranges::find(without, i) == without.end())
      result.push_back({mtg.features[i].name, values[i]});
  return result;
}

Entity labelOf(const MtgVertex& vertex) {
  return {
      .scale = vertex.scale, .symbol = vertex.symbol, .index = vertex.index, .alias = vertex.alias};
}

/// Adds to the view what its nodes carry.
void addEntities(const Mtg& mtg, const MtgGeometry& geometry, MtgView& view) {
  std::vector<char> isCarried(mtg.vertices.size(), 0);
  for (std::size_t i = 0; i < view.vertices.size(); ++i) {
    const NodeId id{static_cast<std::uint32_t>(i)};
    const VertexId own = view.vertices[i];
    const auto parent = view.skeleton[id].parent;
    view.starts.push_back(
        startsOf(mtg, own, parent ? std::optional(view.vertices[indexOf(*parent)]) : std::nullopt));
    std::vector<Entity> entities;
    for (const VertexId unit : view.starts.back()) {
      entities.push_back(isCarried[indexOf(unit)] ? labelOf(mtg.vertices[indexOf(unit)])
                                                  : entityOf(mtg, unit));
      isCarried[indexOf(unit)] = 1;
    }
    std::vector<std::size_t> geometric;
    for (const auto& feature : {geometry.position[0], geometry.position[1], geometry.position[2],
                                geometry.radiusFeature(mtg.vertices[indexOf(own)])})
      if (feature) geometric.push_back(*feature);
    entities.push_back(entityOf(mtg, own, geometric));
    view.skeleton.setEntities(id, std::move(entities));
  }
}

void refuseManyScales(const Mtg& mtg, const std::string& file) {
  std::set<int> scales;
  for (const MtgVertex& vertex : mtg.vertices)
    if (scales.insert(vertex.scale).second && scales.size() > mostScales)
      throw ShownError({espalier::Shown::tr(
                            "its vertices are of more than %1 scales: check the section CLASSES"),
                        {std::to_string(mostScales)},
                        FilePlace{file}});
}

} // namespace

bool hasPositions(const Mtg& mtg, const std::string& file) {
  return finestPositionedScale(mtg, MtgGeometry(mtg), file).has_value();
}

Entity entityOf(const Mtg& mtg, VertexId id, const std::vector<std::size_t>& without) {
  const MtgVertex& vertex = mtg.vertices[indexOf(id)];
  Entity entity = labelOf(vertex);
  entity.values = valuesOf(mtg, vertex.values, without);
  for (const std::vector<std::string>& values : vertex.later)
    entity.later.push_back(valuesOf(mtg, values, {}));
  return entity;
}

Imported<MtgView> viewOf(const Mtg& mtg, const std::string& file) {
  const MtgGeometry geometry(mtg);
  const std::optional<int> scale = finestPositionedScale(mtg, geometry, file);
  if (!scale)
    throw ShownError({espalier::Shown::tr("none of its vertices has a position, in features XX, YY "
                                          "and ZZ: it describes a plant without its shape, which "
                                          "can be shown, reported (info) and written as MTG or "
                                          "OPF"),
                      {},
                      FilePlace{file}});
  refuseManyScales(mtg, file);
  Imported<MtgView> result{{.scale = *scale}, {}};
  MtgView& view = result.value;
  const Positions positions(mtg, *scale, geometry, file);
  Counts counts;
  std::vector<Link> links(mtg.vertices.size());
  for (std::size_t i = 0; i < mtg.vertices.size(); ++i) {
    const MtgVertex& vertex = mtg.vertices[i];
    if (vertex.scale != *scale) continue;
    Link link = vertex.parent ? links[indexOf(*vertex.parent)] : Link{};
    if (vertex.parent && vertex.edge == EdgeType::branching) link.edge = EdgeType::branching;
    if (const auto position = positions.at(i)) {
      const double radius = radiusOf(vertex, geometry, file, counts);
      link = {view.skeleton.add(
                  {*position, radius, link.node, link.node ? link.edge : EdgeType::successor}),
              EdgeType::successor};
      view.vertices.push_back(VertexId{static_cast<std::uint32_t>(i)});
      if (!positions.own[i]) view.interpolated.push_back(*link.node);
    } else {
      ++counts.unplaced;
    }
    links[i] = link;
  }
  addEntities(mtg, geometry, view);
  result.notes = notesOn(counts, view.interpolated.size(), file);
  return result;
}

MtgView openedView(const Mtg& mtg) {
  const std::string file = "MTG";
  if (hasPositions(mtg, file)) return viewOf(mtg, file).value;
  MtgView view;
  for (const MtgClass& each : mtg.classes)
    view.scale = std::max(view.scale, each.scale);
  return view;
}

Imported<Skeleton> skeletonOf(const Mtg& mtg, const std::string& file) {
  Imported<MtgView> view = viewOf(mtg, file);
  return {std::move(view.value.skeleton), std::move(view.notes)};
}

} // namespace espalier
