#include "app/window/preview/options_text.h"

#include "ui/document/number_scale.h"
#include "ui/document/shown_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace espalier {
namespace {

struct OptionsText {
  Q_DECLARE_TR_FUNCTIONS(OptionsText)
};

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
  if (isOther) parts.append(shownText(method.label).toLower());
  const std::vector<double> now = valuesAsSet(step, method, after, scale);
  const std::vector<double> then =
      valuesAsSet(step, method, isOther ? PipelineOptions() : before, scale);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != then[i])
      parts.append(shownText(method.options[i].label).toLower() + ' ' +
                   valueText(method.options[i], now[i], unit));
  return parts.join(QStringLiteral(", "));
}

constexpr std::string_view axisNames = "xyz"; // in the order of UpAxis

/// How the plant stands otherwise.
QStringList changesOfScan(const PipelineOptions& before, const PipelineOptions& after) {
  QStringList parts;
  if (after.up != before.up)
    parts.append(
        OptionsText::tr("Up: %1").arg(QChar(axisNames[static_cast<std::size_t>(after.up)])));
  if (after.root != before.root)
    parts.append(after.root ? OptionsText::tr("Root: picked")
                            : OptionsText::tr("Root: lowest point"));
  return parts;
}

/// What is otherwise of the scan and of each step.
QStringList changes(const PipelineOptions& before, const PipelineOptions& after,
                    const PlantScale& scale, const QString& unit) {
  QStringList parts = changesOfScan(before, after);
  if (scale.spacing <= 0) return parts;
  for (const Step& step : pipelineSteps())
    if (const QString change = changeOf(step, before, after, scale, unit); !change.isEmpty())
      parts.append(shownText(step.label) + QStringLiteral(": ") + change);
  return parts;
}

const QString betweenParts = QStringLiteral("; ");

} // namespace

QString changeText(const PipelineOptions& before, const PipelineOptions& after,
                   const PlantScale& scale, const QString& unit) {
  return changes(before, after, scale, unit).join(betweenParts);
}

QString shortChangeText(const PipelineOptions& before, const PipelineOptions& after,
                        const PlantScale& scale, const QString& unit, qsizetype most) {
  const QStringList parts = changes(before, after, scale, unit);
  QString text = parts.value(0);
  for (qsizetype i = 1; i < parts.size(); ++i) {
    if (text.size() + parts[i].size() > most) return text + QStringLiteral("; …");
    text += betweenParts + parts[i];
  }
  return text;
}

QString valueText(const Option& option, double value, const QString& unit) {
  if (option.takesWords()) return QString::fromStdString(option.wordFor(value));
  const bool isLength = option.kind == OptionKind::length && !unit.isEmpty();
  return shortNumber(value) + (isLength                           ? QChar(0x202f) + unit
                               : option.kind == OptionKind::angle ? QStringLiteral("°")
                                                                  : QString());
}

} // namespace espalier
