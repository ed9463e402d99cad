#include "core/evaluate/comparison_json.h"

#include "core/evaluate/traits_json.h"

#include <nlohmann/json.hpp>

#include <numbers>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

Json toJson(const ScoreValues& values) {
  Json json;
  for (const Score& score : scores())
    json[score.key] = values.at(score.key) ? Json(*values.at(score.key)) : Json();
  return json;
}

Json toJson(const AuthorsComparison& authors) {
  return {{"segments",
           {{"result", authors.resultSegments.size()},
            {"reference", authors.referenceSegments.size()}}},
          {"candidates", authors.candidates},
          {"box_distance", authors.boxDistance},
          {"cost", authors.cost},
          {"matched", authors.matches.size()},
          {"mapping", authors.mapping},
          {"geometric", authors.geometric},
          {"structural", authors.structural},
          {"structural_of_all", authors.structuralOfAll},
          {"length_precision", authors.lengthPrecision},
          {"length_recall", authors.lengthRecall}};
}

Json toJson(const PathMatches& paths) {
  return {{"extended", paths.extended},
          {"cost", paths.cost},
          {"geometric", paths.geometric},
          {"length_precision", paths.lengthPrecision},
          {"length_recall", paths.lengthRecall}};
}

Json toJson(const CappedScore& score) {
  return {{"distance", score.distance},     {"matched", score.matched},
          {"mapping", score.mapping},       {"geometric", score.geometric},
          {"structural", score.structural}, {"structural_of_all", score.structuralOfAll}};
}

Json toJson(const std::vector<ToleranceScore>& scores) {
  Json list = Json::array();
  for (const ToleranceScore& score : scores)
    list.push_back({{"distance", score.distance},
                    {"precision", score.precision},
                    {"recall", score.recall},
                    {"f", score.f()}});
  return list;
}

Json toJson(const DistanceSummary& summary) {
  return {{"mean", summary.mean},
          {"percentile_95", summary.percentile95},
          {"far_share", summary.farShare},
          {"far_mean", summary.farMean}};
}

Json toJson(const Registration& registration) {
  const double angle = registration.angle();
  return {{"rotation", angle * 180 / std::numbers::pi},
          {"axis", angle > 0 ? toJson(registration.axis()) : Json()},
          {"turned_about", toJson(registration.middle)},
          {"near_distance", registration.nearDistance},
          {"near_share", registration.near},
          {"reach", registration.reach},
          {"residual_before", registration.residualBefore},
          {"residual_after", registration.residualAfter}};
}

Json toJson(const EditComparison& edit) {
  return {{"distance", edit.distance.distance},
          {"removing_all", edit.distance.removingAll},
          {"inserting_all", edit.distance.insertingAll},
          {"similarity", edit.distance.similarity()},
          {"matched", edit.matched},
          {"removed", edit.removed},
          {"inserted", edit.inserted}};
}

Json toJson(const LandmarkAgreement& agreement) {
  return {{"distance", agreement.distance},
          {"matched", agreement.matched},
          {"precision", agreement.precision()},
          {"recall", agreement.recall()},
          {"f", agreement.f()}};
}

Json toJson(const DiademScore& diadem) {
  return {{"distance", diadem.distance},
          {"landmarks", diadem.landmarks},
          {"matched", diadem.matched},
          {"connected", diadem.connected},
          {"score", diadem.score}};
}

Json toJson(const PathLengthAgreement& paths) {
  return {{"distance", paths.distance},
          {"pairs", paths.pairs},
          {"found", paths.found},
          {"connected", paths.connected},
          {"mean_error", paths.meanError},
          {"median_error", paths.medianError},
          {"within_tenth", paths.withinTenth}};
}

Json toJson(const NetworkAgreement& network) {
  return {{"deviation", network.deviation},
          {"missed_length", network.missedLength},
          {"invented_length", network.inventedLength},
          {"connections", network.connections},
          {"missed_connections", network.missedConnections},
          {"invented_connections", network.inventedConnections}};
}

Json toJson(const RadiusByArc& radii) {
  const auto of = [&](double value) { return radii.compared > 0 ? Json(value) : Json(); };
  return {{"from", radii.from},
          {"to", radii.to},
          {"compared", radii.compared},
          {"mean_error", of(radii.meanError)},
          {"root_mean_square", of(radii.rootMeanSquare)},
          {"relative_root_mean_square", of(radii.relativeRootMeanSquare)}};
}

Json toJson(const StemDiameters& stems) {
  const auto of = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {{"height", stems.height > 0 ? Json(stems.height) : Json()},
          {"diameter", {{"result", of(stems.result)}, {"reference", of(stems.reference)}}},
          {"error", of(stems.error())},
          {"relative_error", of(stems.relativeError())},
          {"missing", stems.missing.empty() ? Json() : Json(stems.missing)}};
}

Json toJson(const ArchitectureAgreement& agreed) {
  Json byOrder = Json::array();
  for (const OrderAgreement& order : agreed.byOrder)
    byOrder.push_back({{"length", order.length}, {"same", order.same}});
  const auto of = [](bool isCompared, double value) { return isCompared ? Json(value) : Json(); };
  const bool isNear = agreed.compared > 0;
  const bool hasEdges = agreed.types.count() > 0;
  return {{"distance", agreed.distance},
          {"compared", agreed.compared},
          {"same_order", of(isNear, agreed.sameOrder)},
          {"same_axis", of(isNear, agreed.sameAxis)},
          {"by_order", byOrder},
          {"edges", agreed.types.count()},
          {"same_edge", of(hasEdges, agreed.types.observed())},
          {"edge_kappa", of(hasEdges, agreed.types.kappa())}};
}

Json toJson(const PartAgreement& part) {
  return {{"from", part.from},
          {"to", part.to},
          {"result_length", part.resultLength},
          {"reference_length", part.referenceLength},
          {"precision", part.precision},
          {"recall", part.recall}};
}

template <class Part> Json listOf(const std::vector<Part>& parts) {
  Json list = Json::array();
  for (const Part& part : parts)
    list.push_back(toJson(part));
  return list;
}

Json toJson(const RadiusAgreement& radii) {
  const auto of = [&](double value) { return radii.compared > 0 ? Json(value) : Json(); };
  return {{"distance", radii.distance},           {"compared", radii.compared},
          {"mean_error", of(radii.meanError)},    {"root_mean_square", of(radii.rootMeanSquare)},
          {"concordance", of(radii.concordance)}, {"by_arc", listOf(radii.byArc)}};
}

Json toJson(const AgreementByPlace& agreed) {
  return {{"distance", agreed.distance},
          {"by_order", listOf(agreed.byOrder)},
          {"by_height", listOf(agreed.byHeight)}};
}

} // namespace

nlohmann::ordered_json toJson(const Comparison& comparison) {
  const auto& registration = comparison.registration;
  Json json;
  json["authors"] = toJson(comparison.authors);
  json["authors"]["one_to_many"] = toJson(comparison.paths);
  json["capped"] = listOf(comparison.capped);
  json["edit_distance"] = comparison.edit ? toJson(*comparison.edit) : Json();
  json["tolerance"] = toJson(comparison.tolerance.scores);
  json["distances"] = {{"step", comparison.tolerance.step},
                       {"to_reference", toJson(comparison.tolerance.toReference)},
                       {"to_result", toJson(comparison.tolerance.toResult)}};
  json["shift"] = toJson(registration ? registration->shift : Eigen::Vector3d::Zero().eval());
  json["registration"] = registration ? toJson(*registration) : Json();
  json["traits"] = {{"result", toJson(comparison.resultTraits)},
                    {"reference", toJson(comparison.referenceTraits)},
                    {"matched_tips", toJson(comparison.tips)},
                    {"matched_branchings", toJson(comparison.branchings)}};
  json["diadem"] = toJson(comparison.diadem);
  json["path_lengths"] = toJson(comparison.pathLengths);
  json["network"] = toJson(comparison.network);
  json["barcode"] = {{"distance", comparison.barcodeDistance}};
  json["radius"] = toJson(comparison.radii);
  json["breast_height"] = toJson(comparison.stems);
  json["architecture"] = toJson(comparison.architecture);
  json["by_place"] = toJson(comparison.byPlace);
  json["wood"] = {{"radius_limits", comparison.radiusLimits},
                  {"result", toJson(comparison.resultWood)},
                  {"reference", toJson(comparison.referenceWood)}};
  json["light"] = {
      {"result", comparison.resultLight ? toJson(*comparison.resultLight) : Json()},
      {"reference", comparison.referenceLight ? toJson(*comparison.referenceLight) : Json()}};
  json["scores"] = toJson(comparison.scores);
  json["warnings"] = eachInEnglish(comparison.warnings);
  return json;
}

} // namespace espalier
