#include "app/cli/crown_envelope.h"

#include "app/cli/arguments.h"
#include "core/base/error.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/typed_value.h"

#include <cstdio>
#include <numbers>
#include <vector>

namespace espalier {

EnvelopedPlant ofPoints(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                        const Progress& progress) {
  return {.places = placesOf(cloud, leftOut), .scale = scaleOf(cloud, leftOut, up, progress)};
}

EnvelopedPlant ofSkeleton(const Skeleton& skeleton, UpAxis up) {
  return {.places = placesOf(skeleton), .scale = scaleOf(skeleton, up), .isOfSkeleton = true};
}

std::vector<double> valuesSet(const EnvelopeKind& kind, const std::vector<std::string>& settings,
                              const EnvelopedPlant& plant, const std::string& unit) {
  try {
    return envelopeValues(kind, settings, plant.scale, metersIn(unit));
  } catch (const Error& problem) {
    throw WrongUsage(problem.what());
  }
}

CLI::Option* addEnvelopeKind(CLI::App& command, const std::string& option, std::string& name,
                             const std::string& help) {
  std::vector<std::string> names;
  std::string list;
  for (const EnvelopeKind& kind : envelopeKinds()) {
    names.push_back(kind.form.name);
    list += (list.empty() ? ": " : ", ") + kind.form.name;
  }
  return command.add_option(option, name, help + list)->type_name("NAME")->check(oneOf(names));
}

void printEnvelope(const Envelope& envelope, const std::string& unit) {
  const auto line = [&](const std::string& label, double value, const char* power) {
    const std::string in = unit.empty() ? "" : " " + unit + power;
    std::printf("%-28s %12.7g%s\n", label.c_str(), value, in.c_str());
  };
  line("volume", envelope.volume, "^3");
  line("area", envelope.area, "^2");
  line("height", envelope.height, "");
  line("crown diameter", envelope.diameter, "");
  using Kind = EnvelopeParameter::Kind;
  for (const EnvelopeParameter& each : ownParameters(envelope)) {
    if (each.kind == Kind::angle)
      std::printf("%-28s %12.7g deg\n", each.label.c_str(), each.value * 180 / std::numbers::pi);
    else if (each.kind == Kind::number)
      std::printf("%-28s %12.7g\n", each.label.c_str(), each.value);
    else
      line(each.label, each.value, "");
  }
}

} // namespace espalier
