#include "app/window/judge_numbers.h"

#include "ui/document/length_unit.h"

#include <QCoreApplication>

#include <utility>

namespace espalier {
namespace {

using Better = JudgeRow::Better;

template <class Value> auto ofQuality(Value ContractionQuality::*value, double factor = 1) {
  return [value, factor](const Judgment& judgment) -> std::optional<double> {
    if (!judgment.quality) return std::nullopt;
    return factor * static_cast<double>((*judgment.quality).*value);
  };
}

template <class Value> auto ofSkeleton(Value ContractionQuality::*value) {
  return [value](const Judgment& judgment) -> std::optional<double> {
    if (!judgment.quality || judgment.quality->nodes == 0) return std::nullopt;
    return static_cast<double>((*judgment.quality).*value);
  };
}

auto ofScores(const char* key) {
  return [key](const Judgment& judgment) -> std::optional<double> {
    return judgment.scores ? scoreIn(*judgment.scores, key) : std::nullopt;
  };
}

/// Of a length of a whole plant: to some mm, if it is known what it is in.
int decimalsOf(const QString& unit) {
  return unit == symbol(LengthUnit::meter) ? 2 : unit == symbol(LengthUnit::centimeter) ? 1 : 0;
}

std::vector<JudgedNumber> numbersOfQuality(const QString& unit) {
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("JudgedNumbers", text);
  };
  using Q = ContractionQuality;
  return {
      {tr("Residual thickness"), tr("spacings"),
       tr("How far contracted points lie from the axis through those about them: the root mean "
          "square about each point, and of these the median"),
       Better::less, 2, ofQuality(&Q::residualThickness)},
      {tr("On a line"), tr("%"), tr("Share of points whose contracted neighbors lie on a line"),
       Better::more, 1, ofQuality(&Q::shareOnLine, 100)},
      {tr("Ends of the scan"),
       {},
       tr("Ends of branches, as the points tell"),
       Better::neither,
       0,
       ofQuality(&Q::tips)},
      {tr("Lost ends"),
       {},
       tr("Ends of branches that nothing is near to any more"),
       Better::less,
       0,
       ofQuality(&Q::lostTips)},
      {tr("Webbed places"),
       {},
       tr("Places where contracted points lie together that are far apart along the plant"),
       Better::less,
       0,
       ofQuality(&Q::webbedJunctions)},
      {tr("Unexplained points"),
       {},
       tr("Points that lie off all edges of the skeleton"),
       Better::less,
       0,
       ofSkeleton(&Q::unexplainedPoints)},
      {tr("Length of the skeleton"), unit, tr("Of all its edges"), Better::neither,
       decimalsOf(unit), ofSkeleton(&Q::skeletonLength)},
      {tr("Nodes"), {}, tr("Nodes of the skeleton"), Better::neither, 0, ofSkeleton(&Q::nodes)},
  };
}

std::vector<JudgedNumber> numbersOfReference() {
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("JudgedNumbers", text);
  };
  return {{tr("F of length"),
           {},
           tr("Agreement of length with the reference, within the tolerance of the evaluation"),
           Better::more,
           3,
           ofScores("f")},
          {tr("Geometric index"),
           {},
           tr("Of the authors' comparison with the reference"),
           Better::more,
           3,
           ofScores("geometric")},
          {tr("Structural index"),
           {},
           tr("Of the authors' comparison with the reference"),
           Better::more,
           3,
           ofScores("structural")}};
}

} // namespace

std::vector<JudgedNumber> judgedNumbers(const QString& unit, bool hasReference) {
  std::vector<JudgedNumber> numbers = numbersOfQuality(unit);
  if (hasReference)
    for (JudgedNumber& number : numbersOfReference())
      numbers.push_back(std::move(number));
  return numbers;
}

} // namespace espalier
