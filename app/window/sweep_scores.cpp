#include "app/window/sweep_scores.h"

#include "ui/document/number_scale.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>

namespace espalier {
namespace {

using Value = std::function<std::optional<double>(const Judgment&)>;

struct Column {
  QString name;
  bool isLessBetter;
  int decimals;
  Value of;
  Value all = {}; // of how many
};

QString tr(const char* text) {
  return QCoreApplication::translate("SweepScores", text);
}

template <class Member> Value quality(Member member) {
  return [member](const Judgment& judgment) -> std::optional<double> {
    if (!judgment.quality) return std::nullopt;
    return static_cast<double>((*judgment.quality).*member);
  };
}

Value score(const char* key) {
  return [key](const Judgment& judgment) -> std::optional<double> {
    return judgment.scores ? scoreIn(*judgment.scores, key) : std::nullopt;
  };
}

std::vector<Column> columns() {
  using Q = ContractionQuality;
  return {{tr("Residual"), true, 2, quality(&Q::residualThickness)},
          {tr("Lost ends"), true, 0, quality(&Q::lostTips), quality(&Q::tips)},
          {tr("Webbed"), true, 0, quality(&Q::webbedJunctions)},
          {tr("Unexplained"), true, 0, quality(&Q::unexplainedPoints)},
          {tr("F"), false, 3, score("f")},
          {tr("Structural"), false, 3, score("structural")}};
}

/// The best value of a column; none: there is none, or too many have it.
std::optional<double> bestOf(const Column& column, const std::vector<Judgment>& judgments) {
  std::vector<double> values;
  for (const Judgment& judgment : judgments)
    if (const auto value = column.of(judgment)) values.push_back(*value);
  if (values.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(values);
  const double best = column.isLessBetter ? least : most;
  if (2 * std::ranges::count(values, best) >= std::ssize(values)) return std::nullopt;
  return best;
}

QString textOf(const Column& column, double value, const Judgment& judgment) {
  const QString text = numberText(value, column.decimals);
  return column.all ? tr("%1 of %2").arg(text, numberText(*column.all(judgment), 0)) : text;
}

} // namespace

std::vector<std::vector<SweepScore>> sweepScores(const std::vector<Judgment>& judgments) {
  std::vector<std::vector<SweepScore>> scores(judgments.size());
  for (const Column& column : columns()) {
    const std::optional<double> best = bestOf(column, judgments);
    for (std::size_t i = 0; i < judgments.size(); ++i)
      if (const auto value = column.of(judgments[i]))
        scores[i].push_back({.name = column.name,
                             .text = textOf(column, *value, judgments[i]),
                             .isBest = best == value});
  }
  return scores;
}

} // namespace espalier
