#include "ui/panels/score_text.h"

#include "ui/document/number_scale.h"

#include <QCoreApplication>

#include <cmath>

namespace espalier {

QString scoreText(const std::string& text) {
  return QCoreApplication::translate("Scores", text.c_str());
}

QString labelOf(const Score& score) {
  return scoreText(score.label);
}

QString symbolOf(const Score& score) {
  return scoreText(score.symbol);
}

QString titled(const QString& text) {
  return text.left(1).toUpper() + text.mid(1);
}

QString titleOf(ScoreGroup group) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Scores", text); };
  switch (group) {
  case ScoreGroup::nearness:
    return tr("Near each other");
  case ScoreGroup::segments:
  case ScoreGroup::capped:
    return tr("Segments");
  case ScoreGroup::landmarks:
  case ScoreGroup::network:
  case ScoreGroup::architecture:
    return tr("Attachment");
  case ScoreGroup::edits:
    return tr("Edits");
  case ScoreGroup::radii:
    return tr("Radii");
  case ScoreGroup::files:
    return tr("As they were");
  }
  return {};
}

QString tipOf(const Score& score) {
  return QStringLiteral("%1: %2").arg(titled(labelOf(score)), scoreText(score.help));
}

QString textOf(const std::optional<double>& value, ScoreUnit counted, LengthUnit unit) {
  if (!value) return QStringLiteral("–");
  if (counted == ScoreUnit::share) return QString::number(*value, 'f', 3);
  if (counted == ScoreUnit::length) return formatLength(*value, unit, 3);
  return numberText(*value, *value == std::round(*value) ? 0 : 2);
}

} // namespace espalier
