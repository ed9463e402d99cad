#pragma once

#include "core/evaluate/scores.h"
#include "core/evaluate/study/ranking.h"
#include "ui/document/length_unit.h"

#include <QString>

#include <optional>

namespace espalier {

// Texts of the table of scores in the language of the reader.
[[nodiscard]] QString labelOf(const Score& score);
[[nodiscard]] QString symbolOf(const Score& score);

/// With a capital, where it begins a line.
[[nodiscard]] QString titled(const QString& text);
[[nodiscard]] QString titleOf(ScoreGroup group); // what a panel writes above its scores

/// What a score is: its label, and its help.
[[nodiscard]] QString tipOf(const Score& score);

/// "95 % interval: 0.902 to 0.921", and what it is of.
[[nodiscard]] QString intervalText(const ScoreInterval& interval);

/// "0.912", "12.4 mm" or "17"; a dash for none.
[[nodiscard]] QString textOf(const std::optional<double>& value, ScoreUnit counted,
                             LengthUnit unit);

} // namespace espalier
