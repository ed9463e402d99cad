#include "app/cli/evaluate_numbers.h"

#include "app/about/version.h"
#include "app/report/comparison_report.h"
#include "core/evaluate/study/ranking.h"
#include "core/skeleton/axes.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

Json curveOf(const std::vector<ToleranceScore>& curve) {
  Json list = Json::array();
  for (const ToleranceScore& score : curve)
    list.push_back({{"distance", score.distance},
                    {"precision", score.precision},
                    {"recall", score.recall},
                    {"f", score.f()}});
  return list;
}

Json errorsOf(const ReportData& data) {
  const Differences& found = data.differences;
  const std::vector<int> ofResult = orders(data.result);
  const std::vector<int> ofReference = orders(data.reference);
  Json parts = Json::array();
  for (const DifferingPart& part : found.parts) {
    const NodeId node =
        part.kind == Difference::wronglyAttached ? part.attached : part.nodes.front();
    const std::vector<int>& order = part.kind == Difference::missed ? ofReference : ofResult;
    parts.push_back({{"kind", nameOf(part.kind)},
                     {"length", part.length},
                     {"order", order[indexOf(node)]},
                     {"place", Json::array({part.at.x(), part.at.y(), part.at.z()})}});
  }
  return {{"distance", found.tolerance},
          {"missed", found.missed},
          {"invented", found.invented},
          {"parts", parts}};
}

Json fileOf(const std::string& path) {
  return {{"file", path}, {"sha256", reportedFile(path).fingerprint.toStdString()}};
}

} // namespace

void addMeasured(Json& json, const ReportData& data) {
  json["curve"] = curveOf(data.curve);
  json["errors"] = errorsOf(data);
  Json intervals = toJson(data.intervals, {""});
  Json& kept = json["intervals"];
  for (const char* key : {"distance", "draws", "confidence", "seed"})
    kept[key] = intervals[key];
  kept["scores"] = intervals["results"][0]["scores"];
}

void addOrigin(Json& json, const NumberedFiles& files) {
  json["version"] = programVersion();
  json["unit"] = files.unit.empty() ? Json() : Json(files.unit);
  Json& inputs = json["inputs"];
  if (files.isRanking) {
    inputs["results"] = Json::array();
    for (const std::string& result : files.results)
      inputs["results"].push_back(fileOf(result));
  } else {
    inputs["result"] = fileOf(files.results.front());
  }
  inputs["reference"] = fileOf(files.reference);
  if (!files.scan.empty()) inputs["scan"] = fileOf(files.scan);
}

} // namespace espalier
