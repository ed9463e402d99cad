#include "ui/panels/score_text.h"

#include "ui/document/number_scale.h"
#include "ui/document/shown_text.h"

#include <QCoreApplication>

#include <cmath>

namespace espalier {
namespace {

struct Titles {
  Q_DECLARE_TR_FUNCTIONS(ScoreGroups)
};

} // namespace

QString labelOf(const Score& score) {
  return shownText(score.label);
}

QString symbolOf(const Score& score) {
  return shownText(score.symbol);
}

QString titled(const QString& text) {
  return text.left(1).toUpper() + text.mid(1);
}

QString titleOf(ScoreGroup group) {
  switch (group) {
  case ScoreGroup::nearness:
    return Titles::tr("Near each other");
  case ScoreGroup::segments:
  case ScoreGroup::capped:
    return Titles::tr("Segments");
  case ScoreGroup::landmarks:
  case ScoreGroup::network:
  case ScoreGroup::architecture:
    return Titles::tr("Attachment");
  case ScoreGroup::edits:
    return Titles::tr("Edits");
  case ScoreGroup::radii:
    return Titles::tr("Radii");
  case ScoreGroup::files:
    return Titles::tr("As they were");
  }
  return {};
}

QString tipOf(const Score& score) {
  return Titles::tr("%1: %2").arg(titled(labelOf(score)), shownText(score.help));
}

QString intervalText(const ScoreInterval& interval) {
  const auto share = [](double value) { return QString::number(value, 'f', 3); };
  return Titles::tr(
             "95 % interval: %1 to %2, from drawing segments of the reference again and again")
      .arg(share(interval.low), share(interval.high));
}

QString textOf(const std::optional<double>& value, ScoreUnit counted, LengthUnit unit) {
  if (!value) return QStringLiteral("–");
  if (counted == ScoreUnit::share) return QString::number(*value, 'f', 3);
  if (counted == ScoreUnit::length) return formatLength(*value, unit, 3);
  return numberText(*value, *value == std::round(*value) ? 0 : 2);
}

} // namespace espalier
