#include "app/cli/arguments.h"

#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>
#include <utility>

namespace espalier {
namespace {

std::string rangeText(double least, double most) {
  if (std::isinf(most)) return "of at least " + plainDecimal(least);
  constexpr double tiny = 1e-9; // ends that are there for the arithmetic alone
  constexpr double huge = 1e9;
  if (least > 0 && least <= tiny && most >= huge) return "above 0";
  return "from " + plainDecimal(least) + " to " + plainDecimal(most);
}

CLI::Validator bounded(double least, double most, bool isWhole) {
  const auto check = [=](std::string& text) -> std::string {
    const auto value = numberIn(text);
    const bool fits = value && std::isfinite(*value) && *value >= least && *value <= most;
    // Digits only: what else reads as a whole number, as 1e3, the conversion that follows refuses.
    const bool isOfKind = !isWhole || text.find_first_not_of("0123456789") == std::string::npos;
    if (fits && isOfKind) return {};
    return inQuotes(text) + " is given: choose a " + (isWhole ? "whole " : "") + "number " +
           rangeText(least, most);
  };
  return {check, ""};
}

/// How many letters must be added, left out or changed to make one of the other (Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// The long name of an option of `command` that is much like `name`. Empty if none is.
std::string optionLike(const std::string& name, const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  const std::string like = nameLike(name.substr(2), names);
  return like.empty() ? like : "--" + like;
}

} // namespace

std::string nameLike(const std::string& name, const std::vector<std::string>& names) {
  std::string best;
  std::size_t least = std::min<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& each : names)
    if (const std::size_t far = distance(name, each); far < least) {
      best = each;
      least = far;
    }
  return best;
}

std::optional<Eigen::Vector3d> placeIn(const std::string& text) {
  Eigen::Vector3d place;
  const char* at = text.data();
  const char* end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(at, end, place[axis]);
    const bool isLast = axis == 2;
    const bool endsWell = isLast ? next == end : next != end && *next == ',';
    if (error != std::errc() || !endsWell || !std::isfinite(place[axis])) return std::nullopt;
    at = next + (isLast ? 0 : 1);
  }
  return place;
}

std::string unknownOption(const CLI::App& command, const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--") break; // what follows are files
    const std::string name = argument.substr(0, argument.find('='));
    if (!name.starts_with("--") || command.get_option_no_throw(name) != nullptr) continue;
    const std::string like = optionLike(name, command);
    return name + " is no option" + (like.empty() ? "" : ": did you mean " + like + "?");
  }
  return {};
}

CLI::Validator number(double least, double most) {
  return bounded(least, most, false);
}

CLI::Validator wholeNumber(double least, double most) {
  return bounded(least, most, true);
}

CLI::Validator oneOf(const std::vector<std::string>& names) {
  const auto check = [names](std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return {};
    return inQuotes(text) + " is given: choose one of " + CLI::detail::join(names, ", ");
  };
  return {check, ""};
}

CLI::Option* addOutput(CLI::App& command, std::string& output, const std::string& help) {
  return command.add_option("-o,--output", output, help)->type_name("FILE")->required();
}

void addThreads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Use at most this many threads")
      ->type_name("N")
      ->default_str("all")
      ->check(wholeNumber(1, 1024));
}

void addMtgStyle(CLI::App& command, MtgStyle& style) {
  addChoice(command, "--mtg-scales", style,
            "Scales of an MTG that is written of a structure without its own",
            {{"plant-node", MtgStyle::plantNode}, {"plant-axis-node", MtgStyle::plantAxisNode}});
}

void addNoRotate(CLI::App& command, bool& isSet) {
  command.add_flag("--no-rotate", isSet,
                   "Shift the plant only; without it the plant is turned, too, where that lowers "
                   "the mean distance by a tenth");
}

void addLight(CLI::App& command, bool& isMeasured, int& pixels, const std::string& help) {
  command.add_flag("--light", isMeasured, help);
  command
      .add_option("--pixels", pixels,
                  "Pixels along the longer side of each picture for --light, 8 to 16384")
      ->type_name("N")
      ->check(wholeNumber(8, 16384))
      ->capture_default_str();
}

void addNumberFiles(CLI::App& command, std::string& csv, std::string& json) {
  command.add_option("--csv", csv, "File to write all numbers to, as a table")->type_name("FILE");
  command.add_option("--json", json, "File to write all numbers to")->type_name("FILE");
}

void addUnit(CLI::App& command, std::string& unit, const std::string& help) {
  addChoice(command, "--unit", unit, help, {{"mm", "mm"}, {"cm", "cm"}, {"m", "m"}});
}

} // namespace espalier
