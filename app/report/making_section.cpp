#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "core/pipeline/methods.h"
#include "ui/document/shown_text.h"

namespace espalier {
namespace {

/// As a report shows it: 38 mm, 7.5 point spacings, fast.
QString shownSetting(const Option& option, const Rule& rule, const ReportNumbers& numbers) {
  if (option.takesWords()) return QString::fromStdString(option.wordFor(rule.fixed));
  if (!rule.isFixed()) return QString::fromStdString(rule.text());
  if (option.kind == OptionKind::length) return numbers.givenLength(rule.fixed);
  return numbers.given(rule.fixed) + (option.kind == OptionKind::angle ? "°" : "");
}

/// As it is typed in a command.
QString typedSetting(const Option& option, const Rule& rule) {
  return QString::fromStdString(option.takesWords() ? option.wordFor(rule.fixed)
                                : rule.isFixed()    ? plainDecimal(rule.fixed)
                                                    : rule.text());
}

/// What a step was set with, other than usual.
void addChoices(const Step& step, const ReportParts& parts, ReportTable& table,
                QStringList& command) {
  const PipelineOptions& made = *parts.about.made;
  const Method& method = chosenMethod(step, made);
  const auto add = [&](const std::string& name, const QString& label, const QString& shown,
                       const QString& typed, const QString& usual) {
    table.rows.push_back({{shownText(step.label) + ": " + label}, {shown}, {usual}});
    command.append("--set " +
                   typedWord(QString::fromStdString(step.name + '.' + name) + '=' + typed));
  };
  if (&method != &step.methods.front())
    add("method", ReportText::tr("method"), shownText(method.label),
        QString::fromStdString(method.name), shownText(step.methods.front().label));
  const auto settings = made.settings.find(step.name);
  if (settings == made.settings.end()) return;
  for (const Option& option : method.options)
    if (const auto value = settings->second.find(option.name); value != settings->second.end())
      add(option.name, shownText(option.label), shownSetting(option, value->second, parts.numbers),
          typedSetting(option, value->second), QString::fromStdString(option.ruleText()));
}

} // namespace

ReportSection makingSection(const ReportParts& parts) {
  const ReportAbout& about = parts.about;
  ReportTable table;
  table.caption = ReportText::tr("What is set other than by default");
  table.columns = {{ReportText::tr("option"), false},
                   {ReportText::tr("value"), false},
                   {ReportText::tr("default"), false}};
  QStringList command = {QStringLiteral("espalier reconstruct"),
                         about.scan ? typedName(*about.scan) : QStringLiteral("SCAN"),
                         QStringLiteral("-o plant.mtg")};
  if (!about.unit.isEmpty()) command.append("--unit " + about.unit);
  if (about.made->up != UpAxis::z)
    command.append(QStringLiteral("--up ") + QLatin1Char("xyz"[static_cast<int>(about.made->up)]));
  if (const std::optional<Eigen::Vector3d>& root = about.made->root)
    command.append("--root=" + typedNumbers(*root));
  for (const Step& step : pipelineSteps())
    addChoices(step, parts, table, command);
  ReportSection section{ReportText::tr("How the plant was reconstructed"), {}};
  if (table.rows.empty())
    section.blocks.emplace_back(
        ReportParagraph{ReportText::tr("By the default methods, all options by their rules.")});
  else
    section.blocks.emplace_back(std::move(table));
  if (!about.made->leftOut.isEmpty() || !about.made->organs.isEmpty())
    section.blocks.emplace_back(ReportParagraph{
        ReportText::tr(
            "Points were set aside, or their organs set, by hand: the command knows nothing of "
            "that."),
        ReportParagraph::Look::note});
  section.blocks.emplace_back(ReportParagraph{command.join(' '), ReportParagraph::Look::code});
  return section;
}

} // namespace espalier
