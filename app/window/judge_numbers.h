#pragma once

#include "app/window/judged_state.h"
#include "ui/panels/judge_table.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// A number that a state of the plant is judged by, and how it is told.
struct JudgedNumber {
  QString name;
  QString unit;
  QString meaning;
  JudgeRow::Better better;
  int decimals;
  std::function<std::optional<double>(const Judgment&)> of; // none: not known
};

/// Those that tell of the contraction and the skeleton and, with a reference, its scores.
/// @param unit of lengths; may be empty
[[nodiscard]] std::vector<JudgedNumber> judgedNumbers(const QString& unit, bool hasReference);

} // namespace espalier
