#include "app/window/preview/sweep_scores.h"

#include "app/window/preview/judge_numbers.h"
#include "ui/document/number_scale.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

namespace espalier {
namespace {

using Values = std::vector<std::optional<double>>; // of a number, by trial; none: not known

struct SweepText {
  Q_DECLARE_TR_FUNCTIONS(SweepScores)
};

bool isLessBetter(const JudgedNumber& number) {
  return number.better == Better::less;
}

/// The best value of a number; none: there is none, or too many have it.
std::optional<double> bestOf(const JudgedNumber& number, const Values& values) {
  std::vector<double> known;
  for (const std::optional<double>& value : values)
    if (value) known.push_back(*value);
  if (known.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(known);
  const double best = isLessBetter(number) ? least : most;
  if (2 * std::ranges::count(known, best) >= std::ssize(known)) return std::nullopt;
  return best;
}

/// Is the best at an end of what was tried?
bool isAtEnd(double best, const Values& values) {
  const auto isBest = [&](const std::optional<double>& value) { return value == best; };
  return isBest(values.front()) || isBest(values.back());
}

QString textOf(const JudgedNumber& number, double value, const Judgment& judgment) {
  const QString text = numberText(value, number.decimals);
  if (number.unit == QStringLiteral("%")) return text + QChar(0x202f) + number.unit;
  return number.all ? SweepText::tr("%1 of %2").arg(text, numberText(*number.all(judgment), 0))
                    : text;
}

QString tipOf(const JudgedNumber& number, bool isEndBest) {
  const QString unit = number.unit.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(number.unit);
  QString tip = QStringLiteral("%1%2: %3.").arg(number.name, unit, number.meaning);
  if (isEndBest)
    tip += ' ' + SweepText::tr(
                     "No star: it is best at an end of the values, to which it leads by itself.");
  return tip;
}

} // namespace

std::vector<std::vector<SweepScore>> sweepScores(const std::vector<Judgment>& judgments,
                                                 bool haveEnds) {
  std::vector<std::vector<SweepScore>> scores(judgments.size());
  if (judgments.empty()) return scores;
  for (const JudgedNumber& number : judgedNumbers({}, true)) {
    if (number.shortName.isEmpty()) continue;
    Values values;
    for (const Judgment& judgment : judgments)
      values.push_back(number.of(judgment));
    const std::optional<double> best = bestOf(number, values);
    const bool isEndBest =
        haveEnds && number.rank == JudgedNumber::Rank::byItself && best && isAtEnd(*best, values);
    for (std::size_t i = 0; i < judgments.size(); ++i)
      if (values[i])
        scores[i].push_back({.name = number.shortName,
                             .text = textOf(number, *values[i], judgments[i]),
                             .isBest = !isEndBest && best == values[i],
                             .tip = tipOf(number, isEndBest)});
  }
  return scores;
}

} // namespace espalier
