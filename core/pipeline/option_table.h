#pragma once

#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace espalier {

/// What default rules derive lengths from.
struct PlantScale {
  double spacing = 0; // mean distance between neighboring points [L]
  double height = 0;  // extent along the up axis [L]
};

/// How a value follows from the plant: the sum of its parts.
struct Rule {
  double fixed = 0;    // for counts and ratios
  double spacings = 0; // in point spacings
  double heights = 0;  // in plant heights

  [[nodiscard]] double value(const PlantScale& scale) const {
    return fixed + spacings * scale.spacing + heights * scale.height;
  }
  [[nodiscard]] bool isFixed() const { return spacings == 0 && heights == 0; }
  [[nodiscard]] std::string text() const; // "7.5 point spacings"
  /// What text() writes of one part, or people: "12.5", "7.5 spacings", "0.01 plant heights".
  [[nodiscard]] static std::optional<Rule> parse(std::string_view text);
  bool operator==(const Rule&) const = default;
};

[[nodiscard]] constexpr Rule fixedAt(double value) {
  return {.fixed = value};
}
[[nodiscard]] constexpr Rule spacings(double count) {
  return {.spacings = count};
}

enum class OptionKind { length, ratio, count, angle, choice, flag };

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
  Rule rule;          // the default; of a choice its place in `choices`, of a flag 0 or 1
  double minimum = 0; // in point spacings for a length, degrees for an angle
  double maximum = 0; // likewise; both follow from the kind for a choice and a flag
  std::string help;   // one line
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

/// The options of one method, tied to the members of its options struct. Angles are in degrees to
/// people, in radians in the struct.
template <class Options> class OptionTable {
public:
  template <class Member> OptionTable& add(Option option, Member Options::*member) {
    const double unit = option.kind == OptionKind::angle ? std::numbers::pi / 180 : 1;
    if (option.kind == OptionKind::flag) option.maximum = 1;
    if (option.kind == OptionKind::choice)
      option.maximum = static_cast<double>(option.choices.size()) - 1;
    descriptions_.push_back(std::move(option));
    setters_.push_back([member, unit](Options& options, double value) {
      options.*member = static_cast<Member>(value * unit);
    });
    return *this;
  }

  [[nodiscard]] const std::vector<Option>& descriptions() const { return descriptions_; }

  /// The struct with `values`, one per option in order.
  [[nodiscard]] Options with(const std::vector<double>& values) const {
    Options options;
    for (std::size_t i = 0; i < setters_.size(); ++i)
      setters_[i](options, values[i]);
    return options;
  }

private:
  std::vector<Option> descriptions_;
  std::vector<std::function<void(Options&, double)>> setters_;
};

} // namespace espalier
