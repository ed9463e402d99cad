#include "app/report/choice_record.h"

#include "app/report/report_sections.h"
#include "core/base/error.h"
#include "ui/view/picture.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace espalier {
namespace {

QString encoded(const QImage& picture) {
  if (picture.isNull()) return {};
  return QString::fromLatin1(pngOf(picture).toBase64());
}

using Pairs = std::vector<std::pair<QString, QString>>;

QJsonArray jsonOf(const Pairs& pairs) {
  QJsonArray json;
  for (const auto& [name, value] : pairs)
    json.append(QJsonArray{name, value});
  return json;
}

Pairs pairsFrom(const QJsonValue& json) {
  Pairs pairs;
  for (const QJsonValue pair : json.toArray())
    pairs.emplace_back(pair.toArray().at(0).toString(), pair.toArray().at(1).toString());
  return pairs;
}

QJsonObject jsonOf(const ChoiceState& state) {
  return {{"name", state.name},
          {"options", state.options},
          {"picture", encoded(state.picture)},
          {"numbers", jsonOf(state.numbers)},
          {"taken", state.isTaken}};
}

ChoiceState stateFrom(const QJsonObject& json) {
  return {.name = json["name"].toString(),
          .options = json["options"].toString(),
          .picture = QImage::fromData(QByteArray::fromBase64(json["picture"].toString().toLatin1()),
                                      "PNG"),
          .numbers = pairsFrom(json["numbers"]),
          .isTaken = json["taken"].toBool()};
}

/// A row for each number, a column for each state.
ReportTable tableOf(const ChoiceRecord& record) {
  ReportTable table;
  table.columns.push_back({ReportText::tr("number"), false});
  for (const ChoiceState& state : record.states)
    table.columns.push_back(
        {state.isTaken ? ReportText::tr("%1 (in use then)").arg(state.name) : state.name});
  const auto longest = std::ranges::max_element(
      record.states, {}, [](const ChoiceState& state) { return state.numbers.size(); });
  if (longest == record.states.end()) return table;
  for (const auto& [name, unused] : longest->numbers) {
    std::vector<ReportCell> row{{name}};
    for (const ChoiceState& state : record.states) {
      const auto found =
          std::ranges::find(state.numbers, name, [](const auto& number) { return number.first; });
      row.push_back({found != state.numbers.end() ? found->second : QStringLiteral("–")});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What the numbers of a table mean, unless it is said already.
void addTerms(ReportTerms& terms, const ChoiceRecord& record, const ReportTable& table) {
  for (const auto& [name, meaning] : record.meanings) {
    const bool isUsed = std::ranges::any_of(
        table.rows, [&term = name](const auto& row) { return row.front().text == term; });
    if (!isUsed ||
        std::ranges::find(terms.terms, name, &ReportTerms::Term::name) != terms.terms.end())
      continue;
    terms.terms.push_back({.name = name, .text = meaning, .source = {}});
  }
}

} // namespace

std::string writeChoices(const std::vector<ChoiceRecord>& records) {
  QJsonArray all;
  for (const ChoiceRecord& record : records) {
    QJsonArray states;
    for (const ChoiceState& state : record.states)
      states.append(jsonOf(state));
    all.append(QJsonObject{{"title", record.title},
                           {"time", record.time},
                           {"seen", record.seen},
                           {"meanings", jsonOf(record.meanings)},
                           {"states", states}});
  }
  return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<ChoiceRecord> readChoices(const std::string& text) {
  QJsonParseError problem;
  const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(text), &problem);
  if (!json.isArray())
    throw Error("the record of choices cannot be read: " +
                (problem.error != QJsonParseError::NoError ? problem.errorString().toStdString()
                                                           : std::string("it is no list")));
  std::vector<ChoiceRecord> records;
  for (const QJsonValue each : json.array()) {
    const QJsonObject object = each.toObject();
    ChoiceRecord record{.title = object["title"].toString(),
                        .time = object["time"].toString(),
                        .seen = object["seen"].toString(),
                        .meanings = pairsFrom(object["meanings"]),
                        .states = {}};
    for (const QJsonValue state : object["states"].toArray())
      record.states.push_back(stateFrom(state.toObject()));
    records.push_back(std::move(record));
  }
  return records;
}

ReportSection choicesSection(const std::vector<ChoiceRecord>& records) {
  ReportSection section{.title = ReportText::tr("How options were chosen"), .blocks = {}};
  ReportTerms terms; // those of all records, once
  for (const ChoiceRecord& record : records) {
    const QString title = ReportText::tr("%1, %2.").arg(record.title, record.time);
    ReportFigures figures{.across = record.states.size() > 2 ? 3 : 2, .figures = {}};
    for (const ChoiceState& state : record.states)
      if (!state.picture.isNull())
        figures.figures.push_back(
            {.image = state.picture, .title = state.name, .text = state.options});
    section.blocks.emplace_back(ReportParagraph{
        figures.figures.empty() ? title : QStringLiteral("%1 %2").arg(title, record.seen)});
    if (!figures.figures.empty()) section.blocks.emplace_back(std::move(figures));
    ReportTable table = tableOf(record);
    addTerms(terms, record, table);
    section.blocks.emplace_back(std::move(table));
  }
  if (!terms.terms.empty()) section.blocks.emplace_back(std::move(terms));
  return section;
}

} // namespace espalier
