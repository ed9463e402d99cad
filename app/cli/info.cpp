#include "app/cli/commands.h"
#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/io/formats.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace espalier {
namespace {

struct Flags {
  std::string file;
  bool isJson = false;
};

/// Prints "key  value" lines; objects are unfolded with dotted keys, findings to their number.
void printLines(const nlohmann::ordered_json& json, const std::string& prefix = {}) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      printLines(value, prefix + key + ".");
      continue;
    }
    std::cout << prefix << key
              << std::string(prefix.size() + key.size() < 24 ? 24 - prefix.size() - key.size() : 1,
                             ' ');
    if (key == "findings")
      std::cout << value.size() << '\n';
    else
      std::cout << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
  }
}

void info(const Flags& flags) {
  const Format& format = formatOf(flags.file);
  nlohmann::ordered_json json = {{"file", flags.file}, {"format", std::string(format.name)}};
  if (format.content == Content::points) {
    const TerminalProgress terminal;
    const auto points = readPoints(flags.file, terminal.progress());
    printNotes(points.notes);
    json.update(statistics(points.value));
  } else {
    const auto structure = readStructure(flags.file);
    printNotes(structure.notes);
    json.update(statistics(structure.value));
  }
  if (flags.isJson)
    std::cout << json.dump(2) << '\n';
  else
    printLines(json);
}

} // namespace

void addInfo(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Tell what a file holds");
  const auto flags = std::make_shared<Flags>();
  command->add_option("file", flags->file, "Points or a structure")->required();
  command->add_flag("--json", flags->isJson, "As JSON");
  command->callback([flags] { info(*flags); });
}

} // namespace espalier
