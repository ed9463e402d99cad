#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "core/pipeline/option_text.h"
#include "core/pipeline/registry.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

struct MethodsFlags {
  std::string name; // of a step or method; empty: all
  bool isJson = false;
};

bool isWanted(const MethodsFlags& flags, const Step& step, const Method& method) {
  return flags.name.empty() || flags.name == step.name || flags.name == method.name;
}

void printText(const MethodsFlags& flags) {
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods) {
      if (!isWanted(flags, step, method)) continue;
      const bool isDefault = &method == &step.methods.front();
      std::cout << step.name << '.' << method.name << (isDefault ? "  (default)" : "") << "\n  "
                << method.help << '\n';
      if (!method.source.empty()) std::cout << "  Source: " << method.source << '\n';
      for (const Option& option : method.options)
        std::cout << "    " << step.name << '.' << option.name << "  " << summaryOf(option)
                  << "\n        " << option.help << '\n';
      std::cout << '\n';
    }
  std::cout
      << "A length can be set as 12.5, in the unit of the scan, as 6sp (point spacings), 0.02h "
         "(plant\nheights), 3th (thicknesses of thin wood), 2sc (scatters) or, with --unit, as "
         "38mm, 3.8cm,\n0.038m; an angle as 30 or 30deg, in degrees.\n";
}

Json toJson(const Option& option) {
  Json json = {{"name", option.name},         {"label", option.label},
               {"kind", nameOf(option.kind)}, {"rule", option.ruleText()},
               {"minimum", option.minimum},   {"maximum", option.maximum},
               {"range", rangeText(option)},  {"help", option.help}};
  for (const Choice& choice : option.choices)
    json["choices"].push_back({{"name", choice.name}, {"label", choice.label}});
  return json;
}

void printJson(const MethodsFlags& flags) {
  auto json = Json::array();
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods) {
      if (!isWanted(flags, step, method)) continue;
      auto options = Json::array();
      for (const Option& option : method.options)
        options.push_back(toJson(option));
      json.push_back({{"step", step.name},
                      {"method", method.name},
                      {"label", method.label},
                      {"is_default", &method == &step.methods.front()},
                      {"help", method.help},
                      {"source", method.source},
                      {"options", std::move(options)}});
    }
  std::cout << json.dump(2) << '\n';
}

void methods(const MethodsFlags& flags) {
  bool isKnown = flags.name.empty();
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      isKnown = isKnown || isWanted(flags, step, method);
  if (!isKnown)
    throw WrongUsage("there is no step or method \"" + flags.name +
                     R"(": "espalier methods" lists all there are)");
  if (flags.isJson)
    printJson(flags);
  else
    printText(flags);
}

} // namespace

void addMethods(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("methods", "List every step, method and option with its default rule");
  const auto flags = std::make_shared<MethodsFlags>();
  command->add_option("NAME", flags->name, "A step or method")->default_str("all");
  command->add_flag("--json", flags->isJson, "Print JSON instead of text");
  command->callback([flags] { methods(*flags); });
  command->footer(
      "A length is set in the unit of the scan, in spacings of its points (6sp, \"6\n"
      "spacings\"), in heights of the plant (0.02h, \"0.02 heights\"), in thicknesses of\n"
      "its thin wood (3th, \"3 thicknesses\"), in scatters of its points across the\n"
      "wood (2sc, \"2 scatters\") or, where --unit says what the scan is in, in mm, cm\n"
      "or m (38mm); an angle in degrees (30, 30deg).\n\n"
      "Examples:\n"
      "  espalier methods contract\n"
      "  espalier reconstruct pine.las -o pine.mtg --set contract.radius=6sp");
}

} // namespace espalier
