#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/kind_info.h"
#include "app/cli/measure_info.h"
#include "app/cli/project_info.h"
#include "app/cli/read_flags.h"
#include "app/cli/scan_info.h"
#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/base/open_for_reading.h"
#include "core/base/printable.h"
#include "core/io/formats.h"
#include "core/io/glance.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/project/project.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

struct InfoFlags {
  std::string file;
  bool isJson = false;
  bool isHeaderOnly = false; // of a scan: its points are not read
  ReadFlags read;            // which of them are
};

/// Numbers with as many digits as a person reads; arrays as "[1, 2, 3]".
std::string shown(const Json& value) {
  if (value.is_string()) return printable(value.get<std::string>());
  if (value.is_array()) {
    std::string list;
    for (const Json& each : value)
      list += (list.empty() ? "" : ", ") + shown(each);
    return '[' + list + ']';
  }
  if (value.is_object()) { // its name, and what else is said of it
    std::string text;
    for (const auto& [key, part] : value.items())
      text += (text.empty()                          ? ""
               : text.find('(') == std::string::npos ? " ("
                                                     : ", ") +
              (text.empty() ? "" : key + ' ') + shown(part);
    return text + (value.size() > 1 ? ")" : "");
  }
  if (!value.is_number_float()) return value.dump();
  std::ostringstream text;
  text.precision(9); // millimeters of coordinates in the hundreds of kilometers
  text << value.get<double>();
  return text.str();
}

/// Prints "key  value" lines; objects are unfolded with dotted keys, findings to their number.
void printLines(const Json& json, const std::string& prefix = {}) {
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
      std::cout << shown(value) << '\n';
  }
}

/// An MTG is reported as it is, with all its scales; its skeleton only if it has one.
Json infoOnMtg(const std::string& file, const Format& format) {
  const std::string name = std::filesystem::path(file).filename().string();
  std::ifstream in = openForReading(file);
  const Imported<Mtg> mtg = format.readMtg(in, name);
  printNotes(mtg.notes);
  Imported<Skeleton> skeleton;
  const bool isPlaced = hasPositions(mtg.value, name);
  if (isPlaced)
    skeleton = skeletonOf(mtg.value, name);
  else
    printNotes({name + ": has no positions, so there is no skeleton to measure"});
  printNotes(skeleton.notes);
  Json json = statistics(skeleton.value);
  json.update(statistics(mtg.value));
  json["has_positions"] = isPlaced;
  return json;
}

/// What is to be printed: as JSON, and what text has beside its lines.
struct Info {
  Json json;
  std::string table;
};

/// What a scan says of itself, and what its points do.
Info infoOnScan(const InfoFlags& flags) {
  const ReadOptions reading = flags.read.options();
  PointGlance glance = glanceAt(flags.file, reading.columns);
  if (flags.isHeaderOnly) return {scanInfo(glance), {}};
  const TerminalProgress terminal;
  const auto points = readPoints(flags.file, reading, terminal.progress().part(0, 0.7));
  printNotes(points.notes);
  glance.bounds = points.value.bounds(); // of all that was read, in place of a sample
  Json json = scanInfo(glance);
  json.erase("points_estimated");
  json.erase("bounds_of_sample");
  json.update(statistics(points.value));
  addKind(points.value, terminal.progress().part(0.7, 0.85, "Measure"), json);
  const ScanMeasures measures =
      scanMeasures(points.value, {}, upIn(json), terminal.progress().part(0.85, 1, "Measure"));
  if (points.isPart(reading)) json["part"] = partInfo(reading, points);
  if (flags.isJson) json["measures"] = measuresJson(measures);
  return {std::move(json), measuresText(measures)};
}

Info infoOn(const InfoFlags& flags, const Format& format) {
  const std::string& file = flags.file;
  if (format.content != Content::points) requireNoneOf(flags.read, file, "a structure");
  if (format.readMtg != nullptr) return {infoOnMtg(file, format), {}};
  if (format.content == Content::structure) {
    const auto structure = readStructure(file);
    printNotes(structure.notes);
    return {statistics(structure.value.skeleton), {}};
  }
  return infoOnScan(flags);
}

void info(const InfoFlags& flags) {
  requireReadable(flags.file);
  Json json = {{"file", flags.file}};
  std::string table;
  if (isProject(flags.file)) {
    requireNoneOf(flags.read, flags.file, "a project");
    json["format"] = "Espalier project";
    json.update(infoOnProject(flags.file));
  } else {
    const Format& format = formatOf(flags.file);
    json["format"] = std::string(format.name);
    Info found = infoOn(flags, format);
    json.update(found.json);
    table = std::move(found.table);
  }
  if (flags.isJson) {
    std::cout << textOf(json);
    return;
  }
  printLines(json);
  std::cout << table;
}

} // namespace

void addInfo(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Show what a file holds");
  const auto flags = std::make_shared<InfoFlags>();
  command
      ->add_option("FILE", flags->file,
                   "Points or a structure, of any format that can be read, or a project")
      ->required();
  command->add_flag("--json", flags->isJson, "Print JSON instead of text");
  CLI::Option* header =
      command->add_flag("--header", flags->isHeaderOnly,
                        "Of a scan, show only what its header and a few places of it say: at "
                        "once, however large it is");
  flags->read.addTo(*command);
  for (const char* name : {"--most", "--box"})
    header->excludes(command->get_option(name));
  command->callback([flags] { info(*flags); });
  command->footer("Lengths are in the unit of the file.");
}

} // namespace espalier
