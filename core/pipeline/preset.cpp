#include "core/pipeline/preset.h"

#include "core/base/printable.h"
#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <istream>
#include <iterator>
#include <optional>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

void readStep(const std::string& step, const Json& choices, PipelineOptions& options) {
  (void)stepNamed(step);
  if (!choices.is_object())
    throw ShownError({Shown::tr("\"%1\" must hold an object of options"), {step}});
  if (const auto method = choices.find("method"); method != choices.end() && method->is_string()) {
    (void)methodNamed(stepNamed(step), method->get<std::string>());
    options.methods[step] = method->get<std::string>();
  }
}

bool takesWords(const Step& step, const std::string& name) {
  return std::ranges::any_of(step.methods, [&](const Method& method) {
    return std::ranges::any_of(method.options, [&](const Option& option) {
      return option.name == name && option.takesWords();
    });
  });
}

/// A value as a preset has it: a number, a rule, a word, or true or false.
Json toJson(const PipelineOptions& options, const Step& step, const std::string& name,
            const Rule& rule, const std::string& unit) {
  if (!rule.isFixed()) return rule.text();
  const double value = rule.fixed;
  for (const Option& option : chosenMethod(step, options).options) {
    if (option.name != name) continue;
    if (option.kind == OptionKind::flag) return value != 0;
    if (option.kind == OptionKind::choice) return option.wordFor(value);
    if (option.kind == OptionKind::length && !unit.empty()) return plainDecimal(value) + " " + unit;
  }
  return value;
}

void readOption(const std::string& step, const std::string& name, const Json& value, double meters,
                PipelineOptions& options) {
  if (name == "method" && value.is_string()) return;
  if (takesWords(stepNamed(step), name)) {
    options.setText(stepNamed(step), name,
                    value.is_string() ? value.get<std::string>() : value.dump());
    return;
  }
  if (value.is_string()) {
    options.setText(stepNamed(step), name, value.get<std::string>(), meters);
    return;
  }
  if (!value.is_number())
    throw ShownError({Shown::tr("\"%1\" must be a number"), {step + "." + name}});
  options.settings[step][name] = fixedAt(value.get<double>());
}

std::size_t lineAt(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(
                 text.begin(),
                 text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
}

/// Where the key `step`, or `name` in its object, stands in the text of a JSON object; its end if
/// it is written in another way, as with \u.
std::size_t placeOf(std::string_view text, const std::string& step, const std::string& name) {
  int depth = 0;
  std::string outer; // the last key at depth 1
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{' || text[at] == '[') ++depth;
    if (text[at] == '}' || text[at] == ']') --depth;
    if (text[at] != '"') continue;
    const std::size_t start = at + 1;
    for (++at; at < text.size() && text[at] != '"'; ++at)
      if (text[at] == '\\') ++at;
    const std::size_t next = text.find_first_not_of(" \t\r\n", std::min(at + 1, text.size()));
    if (next == std::string_view::npos || text[next] != ':') continue; // a value
    const std::string key(text.substr(start, at - start));
    if (depth == 1) outer = key;
    const bool isIt =
        name.empty() ? depth == 1 && key == step : depth == 2 && outer == step && key == name;
    if (isIt) return start;
  }
  return text.size();
}

/// Where a number begins that is too large for a double; the end of the text if none is.
std::size_t placeOfVastNumber(std::string_view text) {
  constexpr std::string_view signs = "+-.0123456789eE";
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"')
      for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    if (at >= text.size() || signs.substr(1, 12).find(text[at]) == std::string_view::npos) continue;
    const std::size_t end = std::min(text.find_first_not_of(signs, at), text.size());
    const auto number = numberIn(text.substr(at, end - at));
    if (number && std::isinf(*number)) return at;
    at = end - 1;
  }
  return text.size();
}

/// Where a step, or an option of it, is in the file.
using Where =
    std::function<std::optional<FilePlace>(const std::string& step, const std::string& name)>;

template <class Work>
void located(const Where& where, const std::string& step, const std::string& name,
             const Work& work) {
  try {
    work();
  } catch (const ShownError& error) {
    throw ShownError({error.message().sentence, error.message().values, where(step, name)});
  }
}

PipelineOptions optionsIn(const Json& json, const Where& where, bool mustExist, double meters) {
  PipelineOptions options;
  for (const auto& [name, content] : json.items()) {
    const std::string& step = name; // Clang 14 captures no structured bindings
    const Json& choices = content;
    located(where, step, choices.is_object() && choices.contains("method") ? "method" : "",
            [&] { readStep(step, choices, options); });
    for (const auto& choice : choices.items())
      located(where, step, choice.key(), [&] {
        readOption(step, choice.key(), choice.value(), meters, options);
        if (!mustExist || choice.key() == "method") return;
        PipelineOptions alone{.methods = options.methods};
        readOption(step, choice.key(), choice.value(), meters, alone);
        requireKnown(alone);
      });
  }
  return options;
}

constexpr const char* notAPreset = espalier::Shown::tr(
    "a preset is a JSON object of steps, such as {\"contract\": {\"radius\": 12.5}}");

/// A step, or an option of it, that stands twice in a text: of these JSON has the last, without a
/// word.
struct KeyTwice {
  std::string step;
  std::string option; // empty: the step itself
};

/// @throws as Json::parse()
Json parsed(const std::string& text, std::optional<KeyTwice>& twice) {
  std::set<std::pair<std::string, std::string>> seen;
  std::string step;
  return Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& key) {
    if (event != Json::parse_event_t::key || depth > 2) return true;
    const auto name = key.get<std::string>();
    if (depth == 1) step = name;
    const std::pair place(step, depth == 1 ? std::string() : name);
    if (!seen.insert(place).second && !twice) twice = KeyTwice{place.first, place.second};
    return true;
  });
}

} // namespace

PipelineOptions readPreset(std::istream& in) {
  const auto json = Json::parse(in, nullptr, false);
  if (!json.is_object()) throw ShownError({notAPreset});
  const auto nowhere = [](const std::string&, const std::string&) { return std::nullopt; };
  return optionsIn(json, nowhere, false, 0);
}

PipelineOptions readPreset(std::istream& in, const std::string& file, double meters) {
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!isUtf8(text) || text.find('\0') != std::string::npos)
    throw ShownError(
        {espalier::Shown::tr("is no text in UTF-8, but perhaps in UTF-16: save it as UTF-8"),
         {},
         FilePlace{file}});
  const auto at = [&](std::size_t place) { return FilePlace{file, lineAt(text, place)}; };
  Json json;
  std::optional<KeyTwice> twice;
  try {
    json = parsed(text, twice);
  } catch (const Json::parse_error& error) {
    throw ShownError(
        {espalier::Shown::tr("a preset is a JSON object of steps, such as {\"contract\": "
                             "{\"radius\": 12.5}}; the JSON breaks off here"),
         {},
         at(error.byte > 0 ? error.byte - 1 : 0)});
  } catch (const Json::out_of_range&) { // the one that parsing knows: a number
    throw ShownError(
        {espalier::Shown::tr("a number is too large: write one below 1e12, as no length is larger"),
         {},
         at(placeOfVastNumber(text))});
  }
  if (!json.is_object()) throw ShownError({notAPreset, {}, at(0)});
  const auto where = [&](const std::string& step, const std::string& name) {
    return at(placeOf(text, step, name));
  };
  if (twice)
    throw ShownError({espalier::Shown::tr("\"%1\" stands here and once more: keep one of them"),
                      {twice->option.empty() ? twice->step : twice->option},
                      where(twice->step, twice->option)});
  return optionsIn(json, where, true, meters);
}

void writePreset(std::ostream& out, const PipelineOptions& options, const std::string& unit) {
  auto json = Json::object();
  for (const Step& step : pipelineSteps()) {
    if (const auto method = options.methods.find(step.name); method != options.methods.end())
      json[step.name]["method"] = method->second;
    if (const auto settings = options.settings.find(step.name); settings != options.settings.end())
      for (const auto& [name, value] : settings->second)
        json[step.name][name] = toJson(options, step, name, value, unit);
  }
  out << json.dump(2) << '\n';
}

} // namespace espalier
