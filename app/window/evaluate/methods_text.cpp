#include "app/window/evaluate/methods_text.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace espalier {
namespace {

QJsonObject jsonOf(const ScoreValues& scores) {
  QJsonObject json;
  for (const auto& [key, value] : scores)
    json[QString::fromStdString(key)] = value ? QJsonValue(*value) : QJsonValue();
  return json;
}

/// None if one is missing: they are of another version.
std::optional<ScoreValues> scoresIn(const QJsonObject& json) {
  ScoreValues values;
  bool isWhole = true;
  for (const Score& score : scores()) {
    const QJsonValue value = json[QString::fromStdString(score.key)];
    isWhole = isWhole && !value.isUndefined();
    if (!value.isDouble() && !value.isNull() && !value.isUndefined()) refuse();
    values[score.key] = value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
  }
  return isWhole ? std::optional(values) : std::nullopt;
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
