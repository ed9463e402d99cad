#include "app/cli/batch_manifest.h"

#include "app/cli/arguments.h"
#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"

#include <climits>

#include <algorithm>
#include <set>
#include <string_view>

namespace espalier {
namespace {

constexpr const char* noScan = "no scan is named: write its file";

/// @throws Error if no file can have this name
void requireName(const std::string& name) {
  const bool isPlain = std::ranges::none_of(
      name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' '; });
  if (!isPlain || name == "." || name == "..")
    throw Error("the name " + inQuotes(name) + " is none for a file: leave out slashes");
  constexpr std::size_t longest = NAME_MAX - std::string_view(".doubts.json").size();
  if (name.size() > longest)
    throw Error("the name " + inQuotes(name) + " has " + std::to_string(name.size()) +
                " bytes, too many for a file: leave it at " + std::to_string(longest) +
                " or fewer");
}

std::optional<Eigen::Vector3d> rootOf(const std::string& text) {
  if (text.empty() || text == "lowest") return std::nullopt;
  std::string parted = text;
  std::ranges::replace(parted, ';', ',');
  std::ranges::replace(parted, ' ', ',');
  std::optional<Eigen::Vector3d> place = placeIn(parted);
  if (!place) throw Error("root " + inQuotes(text) + ": write lowest, or three numbers as X Y Z");
  return place;
}

/// A note if there are columns of which nothing is known: a name may be misspelt.
std::vector<ShownMessage> passedOver(const CsvTable& table, const std::string& file) {
  constexpr std::string_view known[] = {"scan", "name", "reference", "root"};
  std::vector<std::string> others = table.names;
  for (const std::string_view name : known)
    if (const auto column = table.column(name)) std::erase(others, table.names[*column]);
  if (others.empty()) return {};
  return {{"passed over %1, which " +
               std::string(others.size() == 1 ? "is no column" : "are no columns") +
               " of a plant: these are scan, name, reference and root",
           {listed(others)},
           FilePlace{file}}};
}

/// The name of a plant, which no other has. @throws Error if it can have none
std::string nameOf(const BatchPlant& plant, std::set<std::string>& names) {
  std::string name = plant.name.empty() ? plant.scan.stem().string() : plant.name;
  if (name.empty()) throw Error(noScan);
  requireName(name);
  if (!names.insert(name).second)
    throw Error("the name " + inQuotes(name) +
                " comes twice: give each plant another in a column name");
  return name;
}

/// @param names of the plants so far; that of this one is added
BatchPlant plantOf(const CsvTable& table, const CsvTable::Row& row,
                   const std::filesystem::path& file, std::set<std::string>& names) {
  const auto field = [&](std::string_view name) {
    const std::optional<std::size_t> column = table.column(name);
    return column ? row.fields[*column] : std::string();
  };
  const auto path = [&](std::string_view name) {
    const std::string text = field(name);
    if (text.empty()) return std::filesystem::path();
    return isStream(file) ? std::filesystem::path(text) : file.parent_path() / text;
  };
  BatchPlant plant{.name = field("name"), .scan = path("scan"), .reference = path("reference")};
  bool isNamed = false;
  try {
    plant.name = nameOf(plant, names);
    isNamed = true;
    if (plant.scan.empty()) throw Error(noScan);
    plant.root = rootOf(field("root"));
  } catch (const Error& problem) {
    plant.problem = inEnglish(FilePlace{file.string(), row.line}) + ": " + problem.what();
  }
  if (isNamed) return plant;
  plant.name = "line " + std::to_string(row.line);
  while (!names.insert(plant.name).second)
    plant.name += '*';
  return plant;
}

} // namespace

Imported<std::vector<BatchPlant>> readManifest(const std::filesystem::path& file) {
  const CsvTable table = readCsv(readText(file), file.string());
  if (!table.column("scan"))
    throw Error(inEnglish(FilePlace{file.string(), 1}) +
                ": there is no column scan: name the columns in the first line, as "
                "scan,name,reference");
  Imported<std::vector<BatchPlant>> result{{}, passedOver(table, file.string())};
  std::vector<BatchPlant>& plants = result.value;
  std::set<std::string> names;
  for (const CsvTable::Row& row : table.rows)
    plants.push_back(plantOf(table, row, file, names));
  if (plants.empty())
    throw Error(file.string() + ": no plant is listed: write a line for each below the first");
  return result;
}

} // namespace espalier
