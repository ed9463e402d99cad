#include "app/report/choice_record.h"

#include "app/report/report_sections.h"
#include "core/base/error.h"

#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace espalier {
namespace {

QString encoded(const QImage& picture) {
  if (picture.isNull()) return {};
  QByteArray bytes;
  QBuffer buffer(&bytes);
  picture.save(&buffer, "PNG");
  return QString::fromLatin1(bytes.toBase64());
}

QJsonObject jsonOf(const ChoiceState& state) {
  QJsonArray numbers;
  for (const auto& [name, value] : state.numbers)
    numbers.append(QJsonArray{name, value});
  return {{"name", state.name},
          {"options", state.options},
          {"picture", encoded(state.picture)},
          {"numbers", numbers},
          {"taken", state.isTaken}};
}

ChoiceState stateFrom(const QJsonObject& json) {
  ChoiceState state{.name = json["name"].toString(),
                    .options = json["options"].toString(),
                    .picture = QImage::fromData(
                        QByteArray::fromBase64(json["picture"].toString().toLatin1()), "PNG"),
                    .numbers = {},
                    .isTaken = json["taken"].toBool()};
  for (const QJsonValue& number : json["numbers"].toArray())
    state.numbers.emplace_back(number.toArray().at(0).toString(),
                               number.toArray().at(1).toString());
  return state;
}

/// A row for each number, a column for each state.
ReportTable tableOf(const ChoiceRecord& record) {
  ReportTable table;
  table.columns.push_back({reportText("number"), false});
  for (const ChoiceState& state : record.states)
    table.columns.push_back(
        {state.isTaken ? reportText("%1 (in use then)").arg(state.name) : state.name});
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

} // namespace

std::string writeChoices(const std::vector<ChoiceRecord>& records) {
  QJsonArray all;
  for (const ChoiceRecord& record : records) {
    QJsonArray states;
    for (const ChoiceState& state : record.states)
      states.append(jsonOf(state));
    all.append(QJsonObject{{"title", record.title}, {"time", record.time}, {"states", states}});
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
  for (const QJsonValue& each : json.array()) {
    const QJsonObject object = each.toObject();
    ChoiceRecord record{
        .title = object["title"].toString(), .time = object["time"].toString(), .states = {}};
    for (const QJsonValue& state : object["states"].toArray())
      record.states.push_back(stateFrom(state.toObject()));
    records.push_back(std::move(record));
  }
  return records;
}

ReportSection choicesSection(const std::vector<ChoiceRecord>& records) {
  ReportSection section{.title = reportText("How options were chosen"), .blocks = {}};
  for (const ChoiceRecord& record : records) {
    section.blocks.push_back(ReportParagraph{reportText("%1, %2").arg(record.title, record.time)});
    ReportFigures figures{.across = 2, .figures = {}};
    for (const ChoiceState& state : record.states)
      if (!state.picture.isNull())
        figures.figures.push_back(
            {.image = state.picture,
             .title = state.name,
             .text = state.options.isEmpty() ? reportText("all as usual") : state.options});
    if (!figures.figures.empty()) section.blocks.push_back(std::move(figures));
    section.blocks.push_back(tableOf(record));
  }
  return section;
}

} // namespace espalier
