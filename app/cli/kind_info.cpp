#include "app/cli/kind_info.h"

#include "core/pipeline/kind_of_scan.h"
#include "core/pipeline/typed_value.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <memory>

namespace espalier {
namespace {

double rounded(double share) { // to a percent: it is no measurement
  return std::round(100 * share) / 100;
}

std::string unitIn(const nlohmann::ordered_json& json) {
  const bool isKnown = json.contains("unit") && json["unit"].is_string();
  return isKnown ? json["unit"].get<std::string>() : std::string();
}

} // namespace

UpAxis upIn(const nlohmann::ordered_json& json) {
  if (!json.contains("up") || !json["up"].is_string()) return UpAxis::z;
  return json["up"] == "x" ? UpAxis::x : json["up"] == "y" ? UpAxis::y : UpAxis::z;
}

void addKind(const PointCloud& cloud, const Progress& progress, nlohmann::ordered_json& json) {
  const std::optional<KindOfScan> kind =
      kindOfScan(std::make_shared<const PointCloud>(cloud), PipelineOptions{.up = upIn(json)},
                 metersIn(unitIn(json)), progress);
  if (!kind) return;
  const NamedPreset& preset = presetFor(kind->likely.kind);
  json["kind"] = {{"likely", preset.label},
                  {"preset", preset.name},
                  {"probability", rounded(kind->likely.probability)}};
  constexpr std::array names = {"wood", "petioles", "blades", "needles"};
  for (std::size_t i = 0; i < names.size(); ++i)
    json["kind"][names[i]] = rounded(kind->shares[i]);
}

} // namespace espalier
