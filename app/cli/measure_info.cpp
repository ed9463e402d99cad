#include "app/cli/measure_info.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json spreadJson(const std::optional<Spread>& spread, double unit) {
  if (!spread) return {};
  return {{"low", spread->low / unit},
          {"median", spread->median / unit},
          {"high", spread->high / unit}};
}

std::optional<double> inDegrees(const std::optional<double>& angle) {
  if (!angle) return std::nullopt;
  return *angle * 180 / std::numbers::pi;
}

void addMeasures(const WoodMeasures& measures, double spacing, Json& json) {
  json["spacing"] = spreadJson(measures.spacing, 1);
  json["scatter"] = orNull(measures.scatter);
  json["scatter_in_spacings"] = measures.scatter ? Json(*measures.scatter / spacing) : Json();
  json["thickness"] = spreadJson(measures.thickness, 1);
  json["thickness_in_spacings"] = spreadJson(measures.thickness, spacing);
  json["thickness_measured"] = measures.measured;
  json["arc_degrees"] = orNull(inDegrees(measures.arc));
  json["gaps"] = measures.gaps.size();
  json["largest_gap"] = measures.gaps.empty() ? Json() : Json(measures.gaps.back());
  json["foliage"] = orNull(measures.foliage);
}

/// With three digits; a dash for what is not known.
std::string inThreeDigits(const std::optional<double>& value) {
  if (!value) return "-";
  std::array<char, 32> text = {};
  std::snprintf(text.data(), text.size(), "%.3g", *value);
  return text.data();
}

std::string rowOf(const std::string& name, const WoodMeasures& measures) {
  const auto part = [](const std::optional<Spread>& spread, double Spread::*which) {
    return inThreeDigits(spread ? std::optional(*spread.*which) : std::nullopt);
  };
  const auto arc = inDegrees(measures.arc);
  std::array<char, 256> text = {};
  std::snprintf(
      text.data(), text.size(), "%-22s %9td %8s %8s %8s %8s %8s %7s %6zu %8s\n", name.c_str(),
      measures.points, part(measures.spacing, &Spread::median).c_str(),
      inThreeDigits(measures.scatter).c_str(), part(measures.thickness, &Spread::low).c_str(),
      part(measures.thickness, &Spread::median).c_str(),
      part(measures.thickness, &Spread::high).c_str(),
      arc ? (std::to_string(std::lround(*arc)) + " deg").c_str() : "-", measures.gaps.size(),
      measures.foliage ? (std::to_string(std::lround(100 * *measures.foliage)) + " %").c_str()
                       : "-");
  return text.data();
}

/// "2331.1 to 2331.5": to a hundredth of how high it is, wherever it lies, as on a map.
std::string heightsOf(const MeasuredSlab& slab) {
  const int decimals =
      2 - static_cast<int>(std::floor(std::log10(std::max(slab.to - slab.from, 1e-9))));
  std::array<char, 128> text = {};
  std::snprintf(text.data(), text.size(), "%.*f to %.*f", std::clamp(decimals, 0, 9), slab.from,
                std::clamp(decimals, 0, 9), slab.to);
  return text.data();
}

} // namespace

Json measuresJson(const ScanMeasures& measures) {
  Json json;
  addMeasures(measures.whole, measures.spacing, json);
  auto slabs = Json::array();
  for (const MeasuredSlab& slab : measures.slabs) {
    Json one = {{"from", slab.from}, {"to", slab.to}, {"points", slab.measures.points}};
    addMeasures(slab.measures, measures.spacing, one);
    slabs.push_back(std::move(one));
  }
  json["slabs"] = std::move(slabs);
  return json;
}

std::string measuresText(const ScanMeasures& measures) {
  std::array<char, 256> head = {};
  std::snprintf(head.data(), head.size(),
                "\n%-22s %9s %8s %8s %26s %7s %6s %8s\n%-22s %9s %8s %8s "
                "%8s %8s %8s %7s %6s %8s\n",
                "What the scan is like", "", "distance", "scatter", "thickness of the wood", "seen",
                "", "", "height", "points", "apart", "of them", "thin", "median", "thick", "around",
                "gaps", "foliage");
  std::string text = head.data() + rowOf("all", measures.whole);
  for (auto slab = measures.slabs.rbegin(); slab != measures.slabs.rend(); ++slab)
    text += rowOf(heightsOf(*slab), slab->measures);
  return text;
}

} // namespace espalier
