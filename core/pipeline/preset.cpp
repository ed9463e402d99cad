#include "core/pipeline/preset.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <istream>
#include <ostream>

namespace espalier {

PipelineOptions readPreset(std::istream& in) {
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object())
    throw Error("a preset is a JSON object of steps, such as {\"contract\": {\"radius\": 12.5}}");
  PipelineOptions options;
  for (const auto& [step, choices] : json.items()) {
    (void)stepNamed(step);
    if (!choices.is_object()) throw Error("\"" + step + "\" must hold an object of options");
    for (const auto& [name, value] : choices.items()) {
      if (name == "method" && value.is_string()) {
        (void)methodNamed(stepNamed(step), value.get<std::string>());
        options.methods[step] = value.get<std::string>();
      } else if (value.is_number()) {
        options.settings[step][name] = value.get<double>();
      } else {
        throw Error("\"" + step + "." + name + "\" must be a number");
      }
    }
  }
  return options;
}

void writePreset(std::ostream& out, const PipelineOptions& options) {
  auto json = nlohmann::ordered_json::object();
  for (const Step& step : pipelineSteps()) {
    if (const auto method = options.methods.find(step.name); method != options.methods.end())
      json[step.name]["method"] = method->second;
    if (const auto settings = options.settings.find(step.name); settings != options.settings.end())
      for (const auto& [name, value] : settings->second)
        json[step.name][name] = value;
  }
  out << json.dump(2) << '\n';
}

} // namespace espalier
