#include "app/window/methods_text.h"

#include "app/window/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace espalier {
namespace {

QString keyOf(const ScoreEntry& entry) {
  return QString::fromStdString(entry.key);
}

QJsonObject jsonOf(const Scores& scores) {
  QJsonObject json;
  for (std::size_t i = 0; i < scores.size(); ++i)
    json[keyOf(scoreEntries()[i])] = scores[i] ? QJsonValue(*scores[i]) : QJsonValue();
  return json;
}

/// None if one is missing: they are of another version.
std::optional<Scores> scoresIn(const QJsonObject& json) {
  Scores scores;
  for (const ScoreEntry& entry : scoreEntries()) {
    const QJsonValue value = json[keyOf(entry)];
    if (value.isUndefined()) return std::nullopt;
    if (!value.isDouble() && !value.isNull()) refuse();
    scores.push_back(value.isDouble() ? std::optional(value.toDouble()) : std::nullopt);
  }
  return scores;
}

} // namespace

std::string textOf(const std::vector<KeptMethod>& methods) {
  if (methods.empty()) return {};
  QJsonArray list;
  for (const KeptMethod& method : methods) {
    QJsonObject json{{"path", method.path}};
    if (method.scores) {
      json["written"] = method.written;
      json["scores"] = jsonOf(*method.scores);
    }
    list.append(json);
  }
  return QJsonDocument(list).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<KeptMethod> methodsFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "MethodsText",
      "the table of methods in this project cannot be read: add the structures again");
  return readKept(refusal, [&] {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isArray()) refuse();
    std::vector<KeptMethod> methods;
    for (const auto& each : document.array()) {
      const QJsonObject json = each.toObject();
      KeptMethod method{.path = json["path"].toString(), .scores = std::nullopt};
      if (method.path.isEmpty()) refuse();
      if (json.contains("scores")) {
        method.scores = scoresIn(json["scores"].toObject());
        if (method.scores) method.written = json["written"].toInteger();
      }
      methods.push_back(std::move(method));
    }
    return methods;
  });
}

} // namespace espalier
