#pragma once

#include "core/base/rule.h"
#include "core/base/shown.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace espalier {

/// A curve is the exponent between the two lengths before it: from the first, where points lie
/// thinnest, to the second, where they lie densest.
enum class OptionKind { length, ratio, count, angle, curve, choice, flag };

/// One of the words that an option of kind choice takes.
struct Choice {
  std::string name;  // on the command line and in files
  std::string label; // in the form
};

/// One option of a method, described once: form, command line, report and manual are made from it.
struct Option {
  std::string name;  // on the command line and in files
  std::string label; // in the form
  OptionKind kind = OptionKind::ratio;
  /// The default, from the options struct; of a choice its place in `choices`, of a flag 0 or 1.
  Rule rule = {};
  double minimum = 0;               // in point spacings for a length, degrees for an angle
  double maximum = 0;               // likewise; both follow from the kind for a choice and a flag
  std::string help;                 // one line
  std::vector<Choice> choices = {}; // of a choice

  /// Whether people write a word for the value, not a number.
  [[nodiscard]] bool takesWords() const {
    return kind == OptionKind::choice || kind == OptionKind::flag;
  }
  /// The default as people read it: "7.5 point spacings", "uniform", "yes".
  [[nodiscard]] std::string ruleText() const;
  /// The word for a value. pre: takesWords(), the value is in range
  [[nodiscard]] const std::string& wordFor(double value) const;
  /// The value of a word, if it is one of those that the option takes. pre: takesWords()
  [[nodiscard]] std::optional<double> valueOf(std::string_view word) const;
  [[nodiscard]] std::string words() const; // all of them: "uniform, distance"
  /// The bounds of a value in the units it is set in: [L], degrees, or none.
  [[nodiscard]] std::pair<double, double> range(const PlantScale& scale) const;
};

[[nodiscard]] std::string nameOf(OptionKind kind); // "length", "ratio", ...

/// A rule of one part as text() writes it, or people: "12.5", "7.5 spacings", "0.01 plant heights".
[[nodiscard]] std::optional<Rule> ruleIn(std::string_view text);

/// An option without its default, which the options struct has.
template <OptionKind kind>
[[nodiscard]] Option optionOf(const char* name, const char* label, double least, double most,
                              const char* help) {
  return {
      .name = name, .label = label, .kind = kind, .minimum = least, .maximum = most, .help = help};
}

inline constexpr auto lengthOption = optionOf<OptionKind::length>; // in point spacings
inline constexpr auto ratioOption = optionOf<OptionKind::ratio>;
inline constexpr auto countOption = optionOf<OptionKind::count>;
inline constexpr auto angleOption = optionOf<OptionKind::angle>; // in degrees
inline constexpr auto curveOption = optionOf<OptionKind::curve>;

[[nodiscard]] inline Option flagOption(const char* name, const char* label, const char* help) {
  return optionOf<OptionKind::flag>(name, label, 0, 1, help);
}

/// The options of one method, tied to the members of its options struct. Angles are in degrees to
/// people, in radians in the struct.
template <class Options> class OptionTable {
public:
  /// @param defaults other than those of the struct, for methods that share one
  explicit OptionTable(const Options& defaults = {}) : defaults_(defaults) {}

  /// @param path from the struct to the member: that, or one of a member of it
  template <class... Members> OptionTable& add(Option option, Members... path) {
    const double unit = option.kind == OptionKind::angle ? std::numbers::pi / 180 : 1;
    if (option.kind == OptionKind::flag) option.maximum = 1;
    if (option.kind == OptionKind::choice)
      option.maximum = static_cast<double>(option.choices.size()) - 1;
    const auto& usual = memberOf(defaults_, path...);
    using Value = std::remove_cvref_t<decltype(usual)>;
    if constexpr (std::is_same_v<Value, Length>)
      option.rule = usual.rule();
    else if (option.kind == OptionKind::angle)
      option.rule = fixedAt(std::round(static_cast<double>(usual) / unit * 1e9) / 1e9);
    else
      option.rule = fixedAt(static_cast<double>(usual));
    descriptions_.push_back(std::move(option));
    setters_.push_back([path..., unit](Options& options, double value) {
      memberOf(options, path...) = static_cast<Value>(value * unit);
    });
    return *this;
  }

  [[nodiscard]] const std::vector<Option>& descriptions() const { return descriptions_; }

  /// The struct with `values`, one per option in order.
  [[nodiscard]] Options with(const std::vector<double>& values) const {
    Options options = defaults_;
    for (std::size_t i = 0; i < setters_.size(); ++i)
      setters_[i](options, values[i]);
    return options;
  }

private:
  template <class... Members> static auto& memberOf(Options& options, Members... path) {
    return (options.*....*path); // .* path .* path and so on
  }

  Options defaults_;
  std::vector<Option> descriptions_;
  std::vector<std::function<void(Options&, double)>> setters_;
};

} // namespace espalier
