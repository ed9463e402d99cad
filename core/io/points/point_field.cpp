#include "core/io/points/point_field.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <string>

namespace espalier {
namespace {

struct NamedField {
  std::string_view name;
  PointField field;
};

constexpr auto namedFields = std::to_array<NamedField>({
    {"x", PointField::x},
    {"y", PointField::y},
    {"z", PointField::z},
    {"xx", PointField::x},
    {"yy", PointField::y},
    {"zz", PointField::z},
    {"intensity", PointField::intensity},
    {"i", PointField::intensity},
    {"scalar_intensity", PointField::intensity},
    {"reflectance", PointField::intensity},
    {"scalar_reflectance", PointField::intensity},
    {"red", PointField::red},
    {"green", PointField::green},
    {"blue", PointField::blue},
    {"r", PointField::red},
    {"g", PointField::green},
    {"b", PointField::blue},
    {"diffuse_red", PointField::red},
    {"diffuse_green", PointField::green},
    {"diffuse_blue", PointField::blue},
    {"rgb", PointField::packedColor},
    {"rgba", PointField::packedColor},
    {"station", PointField::station},
    {"scalar_station", PointField::station},
});

/// In the order of PointField.
constexpr auto shownNames = std::to_array<std::string_view>(
    {"-", "x", "y", "z", "intensity", "red", "green", "blue", "rgb", "station"});

} // namespace

std::string_view nameOf(PointField field) {
  return shownNames[indexOf(field)];
}

PointField pointFieldNamed(std::string_view name) {
  const std::string key = lowerCase(name);
  const auto* found = std::ranges::find(namedFields, key, &NamedField::name);
  return found == namedFields.end() ? PointField::none : found->field;
}

} // namespace espalier
