#pragma once

#include "core/evaluate/evaluation.h"
#include "ui/document/length_unit.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

enum class ScoreKind : std::uint8_t { share, length, count };

/// A number that tells how a structure agrees with the reference.
struct ScoreEntry {
  std::string key; // stable: projects keep it
  QString group;   // what it stands under; empty: in tables alone
  QString name;    // in its group
  QString column;  // by itself, and short; empty: in the panel alone
  QString help;    // what it is, in words
  ScoreKind kind;
  std::function<std::optional<double>(const Evaluation&)> value; // none: it cannot be told
};

/// All of them, those of a group one after the other, the first first.
[[nodiscard]] const std::vector<ScoreEntry>& scoreEntries();

/// By scoreEntries().
using Scores = std::vector<std::optional<double>>;
[[nodiscard]] Scores scoresOf(const Evaluation& evaluation);
/// pre: there is an entry of this key
[[nodiscard]] std::optional<double> scoreIn(const Scores& scores, std::string_view key);

/// "0.912", "12.4 mm" or "17"; a dash for none.
[[nodiscard]] QString textOf(const std::optional<double>& score, ScoreKind kind, LengthUnit unit);

} // namespace espalier
