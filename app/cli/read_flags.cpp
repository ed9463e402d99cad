#include "app/cli/read_flags.h"

#include "app/cli/arguments.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

namespace espalier {
namespace {

/// The fields of "x,y,z", as they stand between commas.
std::vector<std::string> partedByCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text + ',');
  for (std::string part; std::getline(in, part, ',');)
    parts.emplace_back(trimmed(part));
  return parts;
}

Eigen::AlignedBox3d boxIn(const std::string& text) {
  const std::size_t third = [&] {
    std::size_t comma = std::string::npos;
    for (int i = 0; i < 3; ++i)
      comma = text.find(',', comma + 1);
    return comma;
  }();
  const auto corner = placeIn(text.substr(0, third));
  const auto other = third == std::string::npos ? std::nullopt : placeIn(text.substr(third + 1));
  if (!corner || !other)
    throw WrongUsage("--box " + inQuotes(text) +
                     ": write two opposite corners, as X,Y,Z,X,Y,Z, in the unit of the file");
  Eigen::AlignedBox3d box(*corner);
  box.extend(*other);
  return box;
}

std::vector<PointField> columnsIn(const std::string& text) {
  const auto refusal = [&](const std::string& what) {
    return WrongUsage("--columns " + inQuotes(text) + ": " + what);
  };
  std::vector<PointField> columns;
  for (const std::string& name : partedByCommas(text)) {
    const PointField field = pointFieldNamed(name);
    const bool isKnown = field != PointField::none && field != PointField::packedColor;
    if (!isKnown && name != "-")
      throw refusal(inQuotes(name) + " is no column: write x, y, z, intensity, red, green, blue, "
                                     "station, or - for one to leave out");
    if (isKnown && std::ranges::count(columns, field) > 0)
      throw refusal(inQuotes(name) + " is named twice");
    columns.push_back(isKnown ? field : PointField::none);
  }
  for (const PointField field : {PointField::x, PointField::y, PointField::z})
    if (std::ranges::count(columns, field) == 0) throw refusal("x, y and z are needed");
  return columns;
}

nlohmann::ordered_json cornerJson(const Eigen::Vector3d& place) {
  return nlohmann::ordered_json::array({place.x(), place.y(), place.z()});
}

} // namespace

void ReadFlags::addTo(CLI::App& command) {
  constexpr auto largest = static_cast<double>(std::numeric_limits<std::uint32_t>::max());
  command
      .add_option("--most", most,
                  "Read so many points of the scan at most, always the same ones, chosen over all "
                  "of it: of COPC whole levels, the coarsest first, of others by lot")
      ->type_name("N")
      ->check(wholeNumber(1, largest));
  command
      .add_option("--box", box,
                  "Read only what lies between two opposite corners, as X,Y,Z,X,Y,Z in the frame "
                  "and unit of the file")
      ->type_name("CORNERS");
  command
      .add_option("--columns", columns,
                  "What the columns of a text file hold, as x,y,z,-,intensity,red,green,blue with "
                  "- for those to leave out (default: found out)")
      ->type_name("NAMES");
}

ReadOptions ReadFlags::options() const {
  ReadOptions options{.most = most};
  if (!box.empty()) options.box = boxIn(box);
  if (!columns.empty()) options.columns = columnsIn(columns);
  return options;
}

void requireNoneOf(const ReadFlags& flags, const std::string& file, const std::string& what) {
  if (flags.most > 0 || !flags.box.empty() || !flags.columns.empty())
    throw Error(file + ": is " + what + ": --most, --box and --columns are for points");
}

nlohmann::ordered_json partInfo(const ReadOptions& options, const ImportedCloud& scan) {
  if (!scan.isPart(options)) return nullptr;
  nlohmann::ordered_json json = {{"points_in_file", scan.listed}};
  if (options.most > 0) json["most"] = options.most;
  if (options.box)
    json["box"] = {{"minimum", cornerJson(options.box->min())},
                   {"maximum", cornerJson(options.box->max())}};
  return json;
}

} // namespace espalier
