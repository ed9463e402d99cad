#include "app/window/preview/judge_numbers.h"

#include "ui/document/length_unit.h"
#include "ui/document/number_scale.h"
#include "ui/document/shown_text.h"
#include "ui/panels/score_text.h"

#include <QCoreApplication>

#include <utility>

namespace espalier {
namespace {

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

/// Of a length of a whole plant: to some mm, if it is known what it is in.
int decimalsOf(const QString& unit) {
  return unit == symbol(LengthUnit::meter) ? 2 : unit == symbol(LengthUnit::centimeter) ? 1 : 0;
}

struct JudgedNumbers {
  Q_DECLARE_TR_FUNCTIONS(JudgedNumbers)
};

std::vector<JudgedNumber> numbersOfQuality(const QString& unit) {
  using Q = ContractionQuality;
  using Rank = JudgedNumber::Rank;
  return {
      {JudgedNumbers::tr("Residual thickness"), JudgedNumbers::tr("spacings"),
       JudgedNumbers::tr(
           "How far contracted points lie from the axis through those near them: the root mean "
           "square near each place of the plant, and of these the median"),
       Better::less, 2, ofQuality(&Q::residualThickness), Rank::byItself,
       JudgedNumbers::tr("Thickness")},
      {JudgedNumbers::tr("On a line"), JudgedNumbers::tr("%"),
       JudgedNumbers::tr("Share of points whose contracted neighbors lie on a line"), Better::more,
       1, ofQuality(&Q::shareOnLine, 100), Rank::byItself, JudgedNumbers::tr("On a line")},
      {.name = JudgedNumbers::tr("Ends of the scan"),
       .unit = {},
       .meaning = JudgedNumbers::tr("Ends of branches, as the points show"),
       .better = Better::neither,
       .decimals = 0,
       .of = ofQuality(&Q::tips)},
      {JudgedNumbers::tr("Lost ends"),
       {},
       JudgedNumbers::tr(
           "Ends of branches with no tip of the skeleton within 7 spacings, or without a skeleton "
           "no contracted point"),
       Better::less,
       0,
       ofQuality(&Q::lostTips),
       Rank::byItself,
       JudgedNumbers::tr("Lost ends"),
       ofQuality(&Q::tips)},
      {JudgedNumbers::tr("Bridged places"),
       {},
       JudgedNumbers::tr(
           "Places where contracted points lie together that are far apart along the plant"),
       Better::less,
       0,
       ofQuality(&Q::bridgedJunctions),
       Rank::byItself,
       JudgedNumbers::tr("Bridged")},
      {JudgedNumbers::tr("Unexplained points"),
       {},
       JudgedNumbers::tr(
           "Points that are contracted to more than 3 spacings off the wood of the skeleton"),
       Better::less,
       0,
       ofSkeleton(&Q::unexplainedPoints),
       Rank::byItself,
       JudgedNumbers::tr("Unexplained")},
      {.name = JudgedNumbers::tr("Length of the skeleton"),
       .unit = unit,
       .meaning = JudgedNumbers::tr("Of all its edges"),
       .better = Better::neither,
       .decimals = decimalsOf(unit),
       .of = ofSkeleton(&Q::skeletonLength)},
      {.name = JudgedNumbers::tr("Nodes"),
       .unit = {},
       .meaning = JudgedNumbers::tr("Nodes of the skeleton"),
       .better = Better::neither,
       .decimals = 0,
       .of = ofSkeleton(&Q::nodes)},
  };
}

std::vector<JudgedNumber> numbersOfReference() {
  std::vector<JudgedNumber> numbers;
  for (const Score* score : leadingFirst(scoresIn(inBrief))) {
    const bool isOnCards = (score->uses & onCards) != 0;
    numbers.push_back(
        {.name = titled(labelOf(*score)),
         .unit = {},
         .meaning = shownText(score->help),
         .better = score->better,
         .decimals = 3,
         .of = [key = score->key](const Judgment& judgment) -> std::optional<double> {
           return judgment.scores ? judgment.scores->at(key) : std::nullopt;
         },
         .rank = isOnCards ? JudgedNumber::Rank::byReference : JudgedNumber::Rank::none,
         .shortName = isOnCards ? symbolOf(*score) : QString()});
  }
  return numbers;
}

} // namespace

QString JudgedNumber::nameInUnit() const {
  return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

std::vector<JudgedNumber> judgedNumbers(const QString& unit, bool hasReference) {
  std::vector<JudgedNumber> numbers = numbersOfQuality(unit);
  if (hasReference)
    for (JudgedNumber& number : numbersOfReference())
      numbers.push_back(std::move(number));
  return numbers;
}

std::vector<std::pair<QString, QString>> recorded(const std::vector<JudgedNumber>& numbers,
                                                  const Judgment& judgment) {
  std::vector<std::pair<QString, QString>> known;
  for (const JudgedNumber& number : numbers)
    if (const std::optional<double> value = number.of(judgment))
      known.emplace_back(number.nameInUnit(), numberText(*value, number.decimals));
  return known;
}

std::vector<std::pair<QString, QString>> meaningsOf(const std::vector<JudgedNumber>& numbers) {
  std::vector<std::pair<QString, QString>> meanings;
  meanings.reserve(numbers.size());
  for (const JudgedNumber& number : numbers)
    meanings.emplace_back(number.nameInUnit(), number.meaning);
  return meanings;
}

QString paperKey(bool hasContracted) {
  const QString points = hasContracted ? JudgedNumbers::tr("Green: the contracted points.")
                                       : JudgedNumbers::tr("Gray: the scanned points.");
  return points + ' ' +
         JudgedNumbers::tr("Black: the skeleton, with edges that branch off in vermillion.");
}

} // namespace espalier
