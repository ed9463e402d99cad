#include "app/cli/statistics.h"

#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/registry.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/bounds.h"
#include "core/skeleton/checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Eigen::Vector3d& place) {
  return Json::array({place.x(), place.y(), place.z()});
}

Json toJson(const Eigen::AlignedBox3d& box) {
  return {{"minimum", toJson(box.min())}, {"maximum", toJson(box.max())}};
}

/// Those that have vertices, coarsest first.
Json classesOf(const Mtg& mtg) {
  std::map<std::pair<int, std::string_view>, std::size_t> counts;
  for (const MtgVertex& vertex : mtg.vertices)
    ++counts[{vertex.scale, vertex.symbol}];
  auto classes = Json::array();
  for (const auto& [key, count] : counts)
    classes.push_back({{"symbol", key.second}, {"scale", key.first}, {"vertices", count}});
  return classes;
}

/// Their names, how many points each has, and where its scanner stood, if that is known.
Json stationsIn(const PointCloud& cloud) {
  std::vector<std::size_t> points(cloud.stations().size());
  if (!points.empty())
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      ++points[cloud.stationOf(i)];
  auto stations = Json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Station& station = cloud.stations()[i];
    stations.push_back({{"name", station.name}, {"points", points[i]}});
    if (station.scanner) stations.back()["scanner"] = toJson(*station.scanner);
  }
  return stations;
}

} // namespace

Json statistics(const PointCloud& cloud) {
  const PlantScale scale = scaleOf(cloud, {}, UpAxis::z);
  return {{"points", cloud.size()},
          {"bounds", toJson(cloud.bounds())},
          {"spacing", scale.spacing},
          {"thickness", scale.thickness},
          {"scatter", scale.scatter},
          {"far_points", farPoints(cloud).size()},
          {"repeated_points", repeatedPoints(cloud).size()},
          {"has_colors", !cloud.colors().empty()},
          {"has_intensities", !cloud.intensities().empty()},
          {"stations", stationsIn(cloud)}};
}

Json statistics(const Mtg& mtg) {
  std::vector<std::size_t> vertices = {1};
  std::size_t successors = 0;
  std::size_t branchings = 0;
  for (const MtgVertex& vertex : mtg.vertices) {
    const auto scale = static_cast<std::size_t>(vertex.scale);
    vertices.resize(std::max(vertices.size(), scale + 1));
    if (scale > 0) ++vertices[scale]; // there is one scene, whether the file names it or not
    if (vertex.parent) ++(vertex.edge == EdgeType::successor ? successors : branchings);
  }
  auto features = Json::array();
  for (const MtgFeature& feature : mtg.features)
    features.push_back({{"name", feature.name}, {"type", feature.type}});
  return {{"vertices_per_scale", vertices},
          {"classes", classesOf(mtg)},
          {"features", std::move(features)},
          {"successor_edges", successors},
          {"branching_edges", branchings}};
}

Json statistics(const Skeleton& skeleton) {
  std::size_t tips = 0;
  std::size_t successors = 0;
  std::size_t branchings = 0;
  double largestRadius = 0;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (skeleton.children(id).empty()) ++tips;
    if (node.parent) ++(node.edge == EdgeType::successor ? successors : branchings);
    largestRadius = std::max(largestRadius, node.radius);
  }
  const std::vector<int> order = orders(skeleton);
  std::vector<std::size_t> axesPerOrder;
  double total = 0;
  for (const Axis& axis : axes(skeleton)) {
    const auto own = static_cast<std::size_t>(order[indexOf(axis.front())]);
    axesPerOrder.resize(std::max(axesPerOrder.size(), own + 1));
    ++axesPerOrder[own];
    total += length(skeleton, axis);
  }
  auto findings = Json::array();
  for (const Finding& finding : check(skeleton))
    findings.push_back({{"kind", nameOf(finding.kind)},
                        {"node", indexOf(finding.node)},
                        {"text", describe(finding, skeleton)}});
  return {{"nodes", skeleton.size()},
          {"roots", skeleton.roots().size()},
          {"tips", tips},
          {"successor_edges", successors},
          {"branching_edges", branchings},
          {"length", total},
          {"axes_per_order", axesPerOrder},
          {"largest_radius", largestRadius},
          {"bounds", skeleton.isEmpty() ? Json(nullptr) : toJson(bounds(skeleton))},
          {"findings", std::move(findings)}};
}

namespace {

/// Ends between these probabilities are listed: an expert may look at them first.
constexpr double leastDoubtful = 0.2;
constexpr double mostDoubtful = 0.8;

Json toJson(const std::vector<EndDecision>& ends) {
  auto doubtful = Json::array();
  int removed = 0;
  double expected = 0; // wrong ones
  for (const EndDecision& end : ends) {
    removed += !end.stays;
    expected += end.stays ? 1 - end.probability : end.probability;
    if (end.probability < leastDoubtful || end.probability > mostDoubtful) continue;
    doubtful.push_back({{"probability", end.probability},
                        {"stays", end.stays},
                        {"foot", toJson(end.path.front())},
                        {"tip", toJson(end.path.back())}});
  }
  return {{"asked", ends.size()},
          {"removed", removed},
          {"expected_wrong", expected},
          {"doubtful", std::move(doubtful)}};
}

Json toJson(const std::vector<GapDecision>& gaps) {
  auto doubtful = Json::array();
  double expected = 0; // wrong ones
  for (const GapDecision& gap : gaps) {
    const double probability = gap.alternatives[gap.chosen].probability;
    expected += 1 - probability;
    if (probability > mostDoubtful) continue;
    auto alternatives = Json::array();
    for (const GapAlternative& link : gap.alternatives)
      alternatives.push_back({{"probability", link.probability},
                              {"from", toJson(link.from)},
                              {"to", toJson(link.to)}});
    doubtful.push_back(
        {{"chosen", gap.chosen}, {"nodes", gap.nodes}, {"alternatives", std::move(alternatives)}});
  }
  return {{"asked", gaps.size()}, {"expected_wrong", expected}, {"doubtful", std::move(doubtful)}};
}

/// How many radii are from where.
Json radiusSources(const Skeleton& skeleton) {
  int measured = 0;
  int corrected = 0;
  int extrapolated = 0;
  for (const NodeId id : skeleton.ids()) {
    measured += skeleton[id].origin.source == RadiusSource::measured;
    corrected += skeleton[id].origin.source == RadiusSource::corrected;
    extrapolated += skeleton[id].origin.source == RadiusSource::extrapolated;
  }
  return {{"measured", measured}, {"corrected", corrected}, {"extrapolated", extrapolated}};
}

} // namespace

Json statistics(const Reconstruction& reconstruction,
                const std::vector<std::pair<std::string, double>>& stageSeconds) {
  auto steps = Json::array();
  for (const StepRecord& record : reconstruction.steps) {
    Json step = {{"step", record.step}, {"method", record.method}, {"options", Json::object()}};
    const Method& method = methodNamed(stepNamed(record.step), record.method);
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      const auto& [name, value] = record.values[i];
      if (method.options[i].takesWords())
        step["options"][name] = method.options[i].wordFor(value);
      else
        step["options"][name] = value;
    }
    if (!record.notes.empty()) step["notes"] = eachInEnglish(record.notes);
    steps.push_back(std::move(step));
  }
  Json ends = reconstruction.ends ? toJson(*reconstruction.ends) : Json(nullptr);
  Json gaps = reconstruction.gaps ? toJson(*reconstruction.gaps) : Json(nullptr);
  auto seconds = Json::object();
  for (const auto& [stage, spent] : stageSeconds)
    seconds[stage] = spent;
  return {{"scale",
           {{"spacing", reconstruction.scale.spacing},
            {"height", reconstruction.scale.height},
            {"thickness", reconstruction.scale.thickness},
            {"scatter", reconstruction.scale.scatter}}},
          {"steps", std::move(steps)},
          {"radius_sources", radiusSources(*reconstruction.skeleton)},
          {"ends", std::move(ends)},
          {"gaps", std::move(gaps)},
          {"seconds", std::move(seconds)}};
}

Json statistics(const ContractionQuality& quality, bool hasSkeleton) {
  Json json = {{"residual_thickness", quality.residualThickness},
               {"share_on_line", quality.shareOnLine},
               {"tips", quality.tips},
               {"lost_tips", quality.lostTips},
               {"webbed_junctions", quality.bridgedJunctions}};
  if (!hasSkeleton) return json;
  json["skeleton_length"] = quality.skeletonLength;
  json["unexplained_points"] = quality.unexplainedPoints;
  json["nodes"] = quality.nodes;
  return json;
}

} // namespace espalier
