#include "app/cli/batch_manifest.h"

#include "app/cli/pipeline_flags.h"
#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/io/csv.h"

#include <algorithm>
#include <set>

namespace espalier {
namespace {

/// @throws Error if no file can have this name
void requireName(const std::string& name) {
  const bool isPlain = std::ranges::none_of(
      name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' '; });
  if (!isPlain || name == "." || name == "..")
    throw Error("the name " + inQuotes(name) + " is none for a file: leave out slashes");
}

std::optional<Eigen::Vector3d> rootOf(std::string text) {
  if (text.empty() || text == "lowest") return std::nullopt;
  std::ranges::replace(text, ';', ',');
  std::ranges::replace(text, ' ', ',');
  return parsePlace(text, "root");
}

/// A note if there are columns of which nothing is known: a name may be misspelt.
std::vector<std::string> passedOver(const CsvTable& table, const std::string& file) {
  constexpr std::string_view known[] = {"scan", "name", "reference", "root"};
  std::vector<std::string> others = table.names;
  for (const std::string_view name : known)
    if (const auto column = table.column(name)) std::erase(others, table.names[*column]);
  if (others.empty()) return {};
  std::string list;
  for (const std::string& name : others)
    list += (list.empty() ? "" : ", ") + inQuotes(name);
  return {file + ": passed over " + list +
          (others.size() == 1 ? ", which is no column" : ", which are no columns") +
          " of a plant: these are scan, name, reference and root"};
}

} // namespace

Imported<std::vector<BatchPlant>> readManifest(const std::filesystem::path& file) {
  std::ifstream in = openForReading(file);
  const CsvTable table = readCsv(readAll(in), file.string());
  if (!table.column("scan"))
    throw Error(place(file.string(), 1) +
                "there is no column scan: name the columns in the first line, as "
                "scan,name,reference");
  std::set<std::string> names;
  Imported<std::vector<BatchPlant>> result{{}, passedOver(table, file.string())};
  std::vector<BatchPlant>& plants = result.value;
  for (const CsvTable::Row& row : table.rows) {
    const auto field = [&](std::string_view name) {
      const std::optional<std::size_t> column = table.column(name);
      return column ? row.fields[*column] : std::string();
    };
    const auto path = [&](const std::string& name) {
      return name.empty() ? std::filesystem::path() : file.parent_path() / name;
    };
    try {
      BatchPlant plant{.name = field("name"),
                       .scan = path(field("scan")),
                       .reference = path(field("reference")),
                       .root = rootOf(field("root"))};
      if (plant.scan.empty()) throw Error("no scan is named: write its file");
      if (plant.name.empty()) plant.name = plant.scan.stem().string();
      requireName(plant.name);
      if (!names.insert(plant.name).second)
        throw Error("the name " + inQuotes(plant.name) +
                    " comes twice: give each plant another in a column name");
      plants.push_back(std::move(plant));
    } catch (const Error& problem) {
      throw Error(place(file.string(), row.line) + problem.what());
    }
  }
  if (plants.empty())
    throw Error(file.string() + ": no plant is listed: write a line for each below the first");
  return result;
}

} // namespace espalier
