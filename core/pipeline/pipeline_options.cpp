#include "core/pipeline/pipeline_options.h"

#include "core/base/error.h"
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/typed_value.h"

#include <cmath>
#include <sstream>

namespace espalier {
namespace {

/// With a few digits, for a message.
std::string shortDecimal(double value, int digits = 6) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

/// What the last of three digits is worth. The ends of a range in a message have three, rounded
/// into it, so that they can be typed.
double lastDigit(double end) {
  return end == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(end))) - 2);
}

constexpr double slack = 1e-6; // of a digit: ends of few digits stay as they are

std::string shortLeast(double least) {
  const double digit = lastDigit(least);
  return shortDecimal(std::ceil(least / digit - slack) * digit + 0.0); // no -0
}

std::string shortMost(double most) {
  const double digit = lastDigit(most);
  return shortDecimal(std::floor(most / digit + slack) * digit);
}

/// What is said of a value of a number that is out of range.
const char* outOfRangeText(OptionKind kind) {
  if (kind == OptionKind::count) return Shown::tr("%1 is %2: choose a whole number from %3 to %4");
  if (kind == OptionKind::length)
    return Shown::tr("%1 is %2: choose a value from %3 to %4 (the points are %5 apart)");
  return Shown::tr("%1 is %2: choose a value from %3 to %4");
}

double checkedValue(const Step& step, const Option& option, double value, const PlantScale& scale) {
  const auto [least, most] = option.range(scale);
  const bool isCounted = option.kind == OptionKind::count || option.takesWords();
  const bool isWhole = !isCounted || value == std::round(value);
  if (value >= least && value <= most && isWhole) return value;
  const std::string name = step.name + "." + option.name;
  if (option.takesWords())
    throw ShownError({Shown::tr("%1 takes no %2: choose one of %3"),
                      {name, shortDecimal(value), option.words()}});
  throw ShownError({outOfRangeText(option.kind),
                    {name, shortDecimal(value), shortLeast(least), shortMost(most),
                     shortDecimal(scale.spacing, 3)}});
}

/// The option of that name of the method that is chosen, or else of another of the step. (Those of
/// one name take the same words: the method may be chosen later.)
const Option& optionNamed(const Step& step, const PipelineOptions& options,
                          const std::string& name) {
  const Option* found = nullptr;
  for (const Method& method : step.methods)
    for (const Option& option : method.options)
      if (option.name == name && (!found || &method == &chosenMethod(step, options)))
        found = &option;
  return found ? *found : optionIn(step, chosenMethod(step, options), name);
}

/// What is no value, and the line to type instead.
ShownError noValue(const std::string& name, const std::string& text, OptionKind kind) {
  const std::string_view digits = typedValue(text).digits;
  const std::string number(numberIn(digits) ? digits : "6");
  return ShownError(
      {kind == OptionKind::length
           ? Shown::tr("%1 must be a number, or a length as '6 spacings', '0.01 heights' or '38 "
                       "mm', not %2: write %1=%3, or %1=%3sp for spacings of the points")
           : Shown::tr("%1 must be a number, not %2: write %1=%3"),
       {name, inQuotes(text), number}});
}

/// A length in mm, cm or m where nobody knows what the coordinates are in.
ShownError noUnit(const std::string& name, const std::string& text, const TypedValue& typed) {
  const double length = typed.amount * metersIn(typed.unit);
  return ShownError(
      {Shown::tr("%1=%2: the unit of the scan is not known: say it first (--unit, or Unit in the "
                 "window), or write %1=%3 for a scan in mm, %1=%4 for one in m"),
       {name, text, shortDecimal(1000 * length), shortDecimal(length)}});
}

/// @param meters  in the unit of the scan; 0: not known
Rule ruleOf(const std::string& name, const std::string& typedText, OptionKind kind, double meters) {
  // An angle or a share has no unit of length: '30mm' is not converted, and so refused below.
  const std::string text = kind == OptionKind::length ? inUnitOf(meters, typedText) : typedText;
  const TypedValue typed = typedValue(text);
  const bool isWhole = typed.state == TypedValue::State::complete;
  if (isWhole && kind == OptionKind::length && isMetric(typed.unit))
    throw noUnit(name, text, typed);
  if (isWhole && kind == OptionKind::angle && typed.unit == ValueUnit::degrees)
    return fixedAt(typed.amount);
  const std::optional<Rule> rule = ruleIn(text);
  if (!rule || !(kind == OptionKind::length || rule->isFixed())) throw noValue(name, text, kind);
  return *rule;
}

} // namespace

void PipelineOptions::set(const std::string& assignment, double meters) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw Error("\"" + assignment +
                "\" sets nothing: write STEP.OPTION=VALUE, such as "
                "contract.radius=12.5");
  const std::string step = assignment.substr(0, dot);
  const std::string option = assignment.substr(dot + 1, equals - dot - 1);
  const std::string text = assignment.substr(equals + 1);
  if (option == "method") {
    choose(stepNamed(step), text);
    return;
  }
  setText(stepNamed(step), option, text, meters);
}

void PipelineOptions::choose(const Step& step, const std::string& method) {
  const Method& chosen = methodNamed(step, method);
  if (&chosen != &chosenMethod(step, *this)) settings.erase(step.name);
  methods[step.name] = method;
}

void PipelineOptions::setText(const Step& in, const std::string& option, const std::string& text,
                              double meters) {
  const std::string& step = in.name;
  const Option& known = optionNamed(in, *this, option);
  if (!known.takesWords()) {
    settings[step][option] = ruleOf(step + "." + option, text, known.kind, meters);
    return;
  }
  const std::optional<double> word = known.valueOf(text);
  if (!word)
    throw ShownError({espalier::Shown::tr("%1 takes no \"%2\": choose one of %3"),
                      {step + "." + option, text, known.words()}});
  settings[step][option] = fixedAt(*word);
}

void requireKnown(const PipelineOptions& options) {
  for (const auto& [name, method] : options.methods)
    (void)methodNamed(stepNamed(name), method);
  for (const auto& [name, values] : options.settings) {
    const Step& step = stepNamed(name);
    for (const auto& [option, value] : values)
      (void)optionIn(step, chosenMethod(step, options), option);
  }
}

const Method& chosenMethod(const Step& step, const PipelineOptions& options) {
  const auto choice = options.methods.find(step.name);
  return choice == options.methods.end() ? step.methods.front() : methodNamed(step, choice->second);
}

const Option& optionIn(const Step& step, const Method& method, const std::string& name) {
  std::string names;
  for (const Option& option : method.options) {
    if (option.name == name) return option;
    names += (names.empty() ? "" : ", ") + option.name;
  }
  if (names.empty())
    throw ShownError({espalier::Shown::tr("method %1 of step %2 has no option \"%3\": it has none; "
                                          "choose a method by %2.method"),
                      {method.name, step.name, name}});
  throw ShownError(
      {espalier::Shown::tr("method %1 of step %2 has no option \"%3\": choose one of %4"),
       {method.name, step.name, name, names}});
}

bool isOff(const Step& step, const PipelineOptions& options) {
  return step.isOptional && isNoMethod(chosenMethod(step, options));
}

PipelineOptions withoutTrials(const PipelineOptions& options) {
  PipelineOptions result = options;
  for (const Step& step : pipelineSteps()) {
    if (!chosenMethod(step, options).triesPlant) continue;
    result.methods[step.name] = "none";
    result.settings.erase(step.name);
  }
  return result;
}

ChosenMethod chosenFor(const Step& step, const PipelineOptions& options, const PlantScale& scale) {
  const Method& method = chosenMethod(step, options);
  return {&method, resolvedValues(step, method, options, scale)};
}

bool isSameIn(const Step& step, const PipelineOptions& a, const PipelineOptions& b) {
  const auto settings = [&](const PipelineOptions& options) {
    const auto found = options.settings.find(step.name);
    return found != options.settings.end() ? found->second : std::map<std::string, Rule>();
  };
  return &chosenMethod(step, a) == &chosenMethod(step, b) && settings(a) == settings(b);
}

std::vector<double> valuesAsSet(const Step& step, const Method& method,
                                const PipelineOptions& options, const PlantScale& scale) {
  const auto settings = options.settings.find(step.name);
  std::vector<double> values;
  for (const Option& option : method.options) {
    Rule rule = option.rule;
    if (settings != options.settings.end())
      if (const auto set = settings->second.find(option.name); set != settings->second.end())
        rule = set->second;
    values.push_back(rule.value(scale));
  }
  return values;
}

std::vector<double> resolvedValues(const Step& step, const Method& method,
                                   const PipelineOptions& options, const PlantScale& scale) {
  std::vector<double> values = valuesAsSet(step, method, options, scale);
  const auto settings = options.settings.find(step.name);
  if (settings == options.settings.end()) return values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (settings->second.contains(method.options[i].name))
      values[i] = checkedValue(step, method.options[i], values[i], scale);
  return values;
}

} // namespace espalier
