#include "core/evaluate/traits_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

Json toJson(const AngleSummary& summary) {
  return {{"count", summary.count},
          {"mean", degrees(summary.mean)},
          {"deviation", degrees(summary.deviation)}};
}

Json toJson(const StrahlerOrder& order) {
  return {{"streams", order.streams}, {"length", order.length}};
}

Json toJson(const AxisTraits& axes) {
  return {{"count", axes.count},
          {"mean_length", axes.meanLength},
          {"length_deviation", axes.lengthDeviation},
          {"median_length", axes.medianLength},
          {"mean_chord", axes.meanChord},
          {"mean_insertion", axes.meanInsertion},
          {"mean_base_radius", axes.meanBaseRadius},
          {"mean_top_radius", axes.meanTopRadius}};
}

Json toJson(const StemTraits& stem) {
  return {{"length", stem.length},
          {"lowest_branch", stem.lowestBranch},
          {"highest_branch", stem.highestBranch},
          {"base_radius", stem.baseRadius},
          {"top_radius", stem.topRadius}};
}

Json toJson(const CrownDimensions& crown) {
  return {{"height", crown.height}, {"base_height", crown.baseHeight}, {"depth", crown.depth},
          {"area", crown.area},     {"diameter", crown.diameter},      {"spread", crown.spread}};
}

Json toJson(const DirectionalStar& each) {
  return {{"elevation", degrees(each.elevation)},
          {"azimuth", degrees(each.azimuth)},
          {"weight", each.weight},
          {"silhouette", each.silhouette},
          {"star", each.star}};
}

Json toJson(const StarAtPixels& each) {
  return {{"pixels", each.pixels}, {"star", each.star}};
}

Json toJson(const WoodAmount& wood) {
  return {
      {"edges", wood.edges}, {"length", wood.length}, {"area", wood.area}, {"volume", wood.volume}};
}

Json toJson(const ClassAmount& each) {
  Json json = {{"scale", each.scale}, {"class", each.symbol}};
  json.update(toJson(each.wood));
  return json;
}

Json biomassJson(const PlantMeasures& measures) {
  if (!measures.density.isKnown()) return {};
  const auto listOf = [&](const std::vector<WoodAmount>& amounts) {
    Json list = Json::array();
    for (const WoodAmount& wood : amounts)
      list.push_back(measures.density.biomass(wood));
    return list;
  };
  Json byClass = Json::array();
  for (const ClassAmount& each : measures.wood.byClass)
    byClass.push_back(measures.density.biomass(each.wood));
  return {{"density", measures.density.perCubicMeter},
          {"whole", measures.density.biomass(measures.wood.whole)},
          {"by_order", listOf(measures.wood.byOrder)},
          {"by_radius", listOf(measures.wood.byRadius)},
          {"by_class", std::move(byClass)}};
}

template <class Part> Json traitList(const std::vector<Part>& parts) {
  Json list = Json::array();
  for (const Part& part : parts)
    list.push_back(toJson(part));
  return list;
}

} // namespace

nlohmann::ordered_json toJson(const Traits& traits) {
  return {{"nodes", traits.nodes},
          {"roots", traits.roots},
          {"tips", traits.tips},
          {"branchings", traits.branchings},
          {"segments", traits.segments},
          {"length", traits.length},
          {"median_edge", traits.medianEdge},
          {"extent", Json::array({traits.extent.x(), traits.extent.y(), traits.extent.z()})},
          {"axes_by_order", traits.axesByOrder},
          {"length_by_order", traits.lengthByOrder},
          {"axes", traitList(traits.axes)},
          {"stem", toJson(traits.stem)},
          {"strahler", traitList(traits.strahler)},
          {"branching_angles", traitList(traits.angles.byOrder)},
          {"divergence", toJson(traits.angles.divergence)},
          {"divergences", traits.angles.divergences},
          {"crown", toJson(traits.crown)}};
}

nlohmann::ordered_json toJson(const WoodAmounts& wood) {
  return {{"whole", toJson(wood.whole)},
          {"by_order", traitList(wood.byOrder)},
          {"by_radius", traitList(wood.byRadius)},
          {"by_class", traitList(wood.byClass)}};
}

nlohmann::ordered_json toJson(const PlantMeasures& measures) {
  const std::optional<double>& diameter = measures.stemDiameter;
  const std::string& missing = measures.stemMissing;
  Json wood = {{"radius_limits", measures.radiusLimits}};
  wood.update(toJson(measures.wood));
  const std::optional<VolumeInterval>& volume = measures.volume;
  wood["volume_interval"] =
      volume ? Json{{"least", volume->least}, {"most", volume->most}} : Json();
  wood["volume_of_unknown_error"] = measures.volumeUnknown;
  return {{"traits", toJson(measures.traits)},
          {"breast_height",
           {{"diameter", diameter ? Json(*diameter) : Json()},
            {"missing", missing.empty() ? Json() : Json(missing)}}},
          {"wood", std::move(wood)},
          {"biomass", biomassJson(measures)},
          {"light", measures.light ? toJson(*measures.light) : Json()},
          {"warnings", eachInEnglish(measures.warnings)}};
}

std::vector<std::vector<std::string>> tableOf(const nlohmann::ordered_json& json) {
  std::vector<std::vector<std::string>> rows = {{"name", "value"}};
  const Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    std::string name = path.substr(1); // they begin with a slash
    std::ranges::replace(name, '/', '.');
    rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  return rows;
}

nlohmann::ordered_json toJson(const LightInterception& light) {
  return {{"area", light.area},
          {"star", light.star},
          {"directions", traitList(light.directions)},
          {"convergence", traitList(light.convergence)}};
}

} // namespace espalier
