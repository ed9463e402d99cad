#pragma once

#include "app/window/preview/judged_state.h"
#include "core/evaluate/scores.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {

/// A number that a state of the plant is judged by, and how it is shown.
struct JudgedNumber {
  /// Whether it says which of several values of an option is best.
  enum class Rank : std::uint8_t {
    none,
    byItself,   // but at an end of them, to which it may only lead
    byReference // wherever it is
  };

  QString name;
  QString unit;
  QString meaning;
  Better better;
  int decimals;
  std::function<std::optional<double>(const Judgment&)> of; // none: not known
  Rank rank = Rank::none;
  QString shortName = {};                                         // on cards; empty: it is on none
  std::function<std::optional<double>(const Judgment&)> all = {}; // of how many; none: of no number

  [[nodiscard]] QString nameInUnit() const;
};

/// Those of the contraction and the skeleton and, with a reference, its scores.
/// @param unit of lengths; may be empty
[[nodiscard]] std::vector<JudgedNumber> judgedNumbers(const QString& unit, bool hasReference);

/// Those that are known, as a record keeps them: the name with the unit, and the value.
[[nodiscard]] std::vector<std::pair<QString, QString>>
recorded(const std::vector<JudgedNumber>& numbers, const Judgment& judgment);

/// What these numbers mean, by the same names.
[[nodiscard]] std::vector<std::pair<QString, QString>>
meaningsOf(const std::vector<JudgedNumber>& numbers);

constexpr QSize recordedPicture(480, 480);

/// What is seen in PlantView::paperOf().
[[nodiscard]] QString paperKey(bool hasContracted);

} // namespace espalier
