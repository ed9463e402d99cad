#include "app/cli/arguments.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

std::string rangeText(double least, double most) {
  if (std::isinf(most)) return "of at least " + plainDecimal(least);
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

} // namespace

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

void addUnit(CLI::App& command, std::string& unit, const std::string& help) {
  addChoice(command, "--unit", unit, help, {{"mm", "mm"}, {"cm", "cm"}, {"m", "m"}});
}

} // namespace espalier
