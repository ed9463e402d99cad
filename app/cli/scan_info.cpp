#include "app/cli/scan_info.h"

#include "core/pipeline/typed_value.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

Json placeJson(const Eigen::Vector3d& place) {
  return Json::array({place.x(), place.y(), place.z()});
}

void addBounds(const PointGlance& glance, Json& json) {
  if (glance.bounds.isEmpty()) return;
  json["bounds"] = {{"minimum", placeJson(glance.bounds.min())},
                    {"maximum", placeJson(glance.bounds.max())}};
  json["bounds_of_sample"] = glance.areBoundsOfSample;
  if (!glance.unit.value.empty())
    json["size_in_meters"] = placeJson(glance.bounds.sizes() * metersIn(glance.unit.value));
}

void addGuess(const std::string& key, const GlanceGuess& guess, Json& json) {
  json[key] = guess.value.empty() ? Json() : Json(guess.value);
  json[key + "_stated"] = guess.isStated;
  json[key + "_reason"] = inEnglish(guess.reason);
}

} // namespace

Json scanInfo(const PointGlance& glance) {
  Json json;
  if (!glance.version.sentence.empty()) json["version"] = inEnglish(glance.version);
  json["compressed"] = glance.isCompressed;
  json["points"] = glance.points;
  json["points_estimated"] = glance.arePointsEstimated;
  if (glance.stations > 0) json["stations"] = glance.stations;
  auto columns = Json::array();
  auto leftOut = Json::array();
  for (const GlanceColumn& column : glance.columns) {
    if (!column.isTaken)
      leftOut.push_back(column.name);
    else if (column.type.empty())
      columns.push_back({{"name", column.name}});
    else
      columns.push_back({{"name", column.name}, {"type", column.type}});
  }
  for (const ShownMessage& other : glance.leftOut)
    leftOut.push_back(inEnglish(other));
  json["columns"] = std::move(columns);
  json["left_out"] = std::move(leftOut);
  addBounds(glance, json);
  addGuess("unit", glance.unit, json);
  addGuess("up", glance.up, json);
  if (glance.isReadWhole) json["read_whole"] = true;
  return json;
}

} // namespace espalier
