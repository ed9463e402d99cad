#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// The index of a label as it is typed: "3" of U3, or "16.1" of S16.1, the first at place 16.
///
/// Its text is kept: "03" is no "3". It holds digits, and single dots between them (or a minus sign
/// before a number, which no text of an MTG has but other files may).
class LabelIndex {
public:
  // NOLINTNEXTLINE(google-explicit-constructor): an index is a number nearly always
  LabelIndex(int number) : text_(std::to_string(number)) {}

  /// None if `text` is no index: digits, or such parted by single dots, each part below 2^31.
  [[nodiscard]] static std::optional<LabelIndex> in(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::vector<int> parts() const; // 16 and 1
  [[nodiscard]] int number() const { return parts().front(); }
  [[nodiscard]] bool isDotted() const { return text_.find('.') != std::string::npos; }
  /// Whether the number alone says it all: no dot, no zeros before it.
  [[nodiscard]] bool isPlain() const { return text_ == std::to_string(number()); }

  /// The index after this one: 4, 16.2, 04. None after the largest.
  [[nodiscard]] std::optional<LabelIndex> next() const;

  bool operator==(const LabelIndex&) const = default;

private:
  LabelIndex() = default;

  std::string text_;
};

/// The indices of a group of labels, from which the next one follows.
class IndicesInUse {
public:
  void take(const LabelIndex& index);

  /// Above all that were taken: 4 after 3. If all have a dot, the first of the next place: 17.1
  /// after 16.2. None after the largest.
  [[nodiscard]] std::optional<LabelIndex> next() const;

  /// The next at the place of the highest one: 16.3 after 16.2. None without one with a dot.
  [[nodiscard]] std::optional<LabelIndex> nextAtPlace() const;

private:
  std::optional<LabelIndex> highest_;
  std::optional<LabelIndex> highestDotted_;
  bool areAllDotted_ = true;
};

} // namespace espalier
