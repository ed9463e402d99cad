#include "app/window/options_text.h"

#include "ui/document/number_scale.h"

#include <QObject>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// To three digits, without zeros at the end.
QString shortNumber(double value) {
  const int decimals =
      value == 0 ? 0 : std::clamp(2 - int(std::floor(std::log10(std::abs(value)))), 0, 6);
  QString text = numberText(value, decimals);
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
    text.chop(1);
  return text;
}

/// What a step does otherwise, without its name; empty: nothing.
QString changeOf(const Step& step, const PipelineOptions& before, const PipelineOptions& after,
                 const PlantScale& scale, const QString& unit) {
  const Method& method = chosenMethod(step, after);
  QStringList parts;
  const bool isOther = method.name != chosenMethod(step, before).name;
  if (isOther) parts.append(QString::fromStdString(method.label).toLower());
  const std::vector<double> now = resolvedValues(step, method, after, scale);
  const std::vector<double> then =
      resolvedValues(step, method, isOther ? PipelineOptions() : before, scale);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != then[i])
      parts.append(QString::fromStdString(method.options[i].label).toLower() + ' ' +
                   valueText(method.options[i], now[i], unit));
  return parts.join(QStringLiteral(", "));
}

} // namespace

QString changeText(const PipelineOptions& before, const PipelineOptions& after,
                   const PlantScale& scale, const QString& unit) {
  QStringList steps;
  for (const Step& step : pipelineSteps())
    if (const QString change = changeOf(step, before, after, scale, unit); !change.isEmpty())
      steps.append(QString::fromStdString(step.label) + QStringLiteral(": ") + change);
  return steps.join(QStringLiteral("; "));
}

QString valueText(const Option& option, double value, const QString& unit) {
  if (option.takesWords()) return QString::fromStdString(option.wordFor(value));
  const bool isLength = option.kind == OptionKind::length && !unit.isEmpty();
  return shortNumber(value) + (isLength                           ? QChar(0x202f) + unit
                               : option.kind == OptionKind::angle ? QStringLiteral("°")
                                                                  : QString());
}

} // namespace espalier
