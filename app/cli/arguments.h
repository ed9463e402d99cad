#pragma once

#include "core/base/error.h"
#include "core/mtg/mtg_of_skeleton.h"

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

/// The arguments name something that there is not: exit status 2.
class WrongUsage : public Error {
public:
  using Error::Error;
};

/// Ctrl+C was pressed when some results had been written: exit status 130, as for Cancelled.
struct StoppedBetween {
  std::string message; // what there is, and how to go on
};

/// "X,Y,Z" as numbers; none if it is not three of them.
[[nodiscard]] std::optional<Eigen::Vector3d> placeIn(const std::string& text);

/// Which of the names is much like `name`: at most two of its letters, and a third of them, differ.
/// Empty if none is.
[[nodiscard]] std::string nameLike(const std::string& name, const std::vector<std::string>& names);

/// What is wrong with an option that `command` does not have, as "--seet is no option: did you mean
/// --set?"; empty if all are known.
[[nodiscard]] std::string unknownOption(const CLI::App& command,
                                        const std::vector<std::string>& arguments);

/// Lets a value be a number from `least` to `most`, which may be infinite, and nothing else.
[[nodiscard]] CLI::Validator number(double least, double most);
[[nodiscard]] CLI::Validator wholeNumber(double least, double most);

/// Lets a value be one of `names` and nothing else.
[[nodiscard]] CLI::Validator oneOf(const std::vector<std::string>& names);

/// Adds an option that takes one of the names of `choices`; `value` is what it is by default.
template <class Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& value,
                       const std::string& help,
                       const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> names;
  std::string byDefault;
  std::string list;
  for (const auto& [choice, meaning] : choices) {
    names.push_back(choice);
    list += (list.empty() ? ": " : ", ") + choice;
    if (meaning == value) byDefault = choice;
  }
  const auto take = [&value, choices](const std::string& text) {
    for (const auto& [choice, meaning] : choices)
      if (choice == text) value = meaning;
  };
  return command.add_option_function<std::string>(name, take, help + list)
      ->type_name("NAME")
      ->default_str(byDefault)
      ->check(oneOf(names));
}

/// Adds -o, --output, which must be given.
CLI::Option* addOutput(CLI::App& command, std::string& output, const std::string& help);

/// Adds --threads; 0 = all there are.
void addThreads(CLI::App& command, int& threads);

/// Adds --mtg-scales: how an MTG is written of a structure without scales of its own.
void addMtgStyle(CLI::App& command, MtgStyle& style);

/// Adds --no-rotate, of those that lay a plant on a reference.
void addNoRotate(CLI::App& command, bool& isSet);

/// Adds --light and --pixels: whether the STAR is measured, and how finely.
void addLight(CLI::App& command, bool& isMeasured, int& pixels, const std::string& help);

/// Adds --csv and --json, which name files for all numbers.
void addNumberFiles(CLI::App& command, std::string& csv, std::string& json);

/// Adds --unit, for those who read the numbers; empty = not known.
void addUnit(CLI::App& command, std::string& unit, const std::string& help);

} // namespace espalier
