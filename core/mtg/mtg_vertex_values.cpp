#include "core/mtg/mtg_vertex_values.h"

#include "core/base/text.h"
#include "core/mtg/mtg_geometry.h"

#include <algorithm>
#include <string>

namespace espalier {
namespace {

std::size_t featureNamed(Mtg& mtg, const std::string& name, const std::string& type) {
  const auto found = std::ranges::find(mtg.features, name, &MtgFeature::name);
  if (found != mtg.features.end()) return static_cast<std::size_t>(found - mtg.features.begin());
  mtg.features.push_back({name, type});
  return mtg.features.size() - 1;
}

void setValue(std::vector<std::string>& values, std::size_t feature, const std::string& text) {
  if (feature >= values.size()) {
    if (text.empty()) return;
    values.resize(feature + 1);
  }
  values[feature] = text;
}

void setValues(Mtg& mtg, std::vector<std::string>& values,
               const std::vector<FeatureValue>& wanted) {
  for (const FeatureValue& value : wanted)
    setValue(values, featureNamed(mtg, value.feature, value.type.empty() ? "ALPHA" : value.type),
             value.text);
}

} // namespace

std::vector<std::size_t> geometricFeatures(const Mtg& mtg, const MtgVertex& vertex) {
  const MtgGeometry geometry(mtg);
  std::vector<std::size_t> features;
  for (const auto& feature : {geometry.position[0], geometry.position[1], geometry.position[2],
                              geometry.radiusFeature(vertex)})
    if (feature) features.push_back(*feature);
  return features;
}

void writeEntity(Mtg& mtg, VertexId id, const Entity& entity,
                 const std::vector<std::size_t>& kept) {
  if (std::ranges::find(mtg.classes, entity.symbol, &MtgClass::symbol) == mtg.classes.end())
    mtg.classes.push_back({entity.symbol, entity.scale});
  std::vector<std::string> values = mtg.vertices[indexOf(id)].values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::ranges::find(kept, i) == kept.end()) values[i].clear();
  setValues(mtg, values, entity.values);
  std::vector<std::vector<std::string>> later(entity.later.size());
  for (std::size_t i = 0; i < later.size(); ++i)
    setValues(mtg, later[i], entity.later[i]);
  MtgVertex& vertex = mtg.vertices[indexOf(id)];
  vertex.symbol = entity.symbol;
  vertex.index = entity.index;
  vertex.alias = entity.alias;
  vertex.values = std::move(values);
  vertex.later = std::move(later);
}

void writePosition(Mtg& mtg, VertexId id, const Eigen::Vector3d& position) {
  const MtgGeometry geometry(mtg);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t feature = geometry.position[axis]
                                    ? *geometry.position[axis]
                                    : featureNamed(mtg, std::string(2, "XYZ"[axis]), "REAL");
    const double coordinate = position[static_cast<Eigen::Index>(axis)];
    MtgVertex& vertex = mtg.vertices[indexOf(id)];
    if (feature >= vertex.values.size() || numberIn(vertex.values[feature]) != coordinate)
      setValue(vertex.values, feature, plainDecimal(coordinate));
  }
}

void writeRadius(Mtg& mtg, VertexId id, double radius) {
  const MtgGeometry geometry(mtg);
  MtgVertex& vertex = mtg.vertices[indexOf(id)];
  if (radius == 0) {
    for (const auto& feature : {geometry.radius, geometry.diameter})
      if (feature) setValue(vertex.values, *feature, {});
    return;
  }
  auto feature = geometry.radiusFeature(vertex);
  if (!feature) feature = geometry.radius ? geometry.radius : geometry.diameter;
  const bool isDiameter = feature && feature == geometry.diameter;
  const std::size_t at = feature ? *feature : featureNamed(mtg, "radius", "REAL");
  setValue(mtg.vertices[indexOf(id)].values, at, plainDecimal(isDiameter ? 2 * radius : radius));
}

} // namespace espalier
