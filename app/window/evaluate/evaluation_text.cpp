#include "app/window/evaluate/evaluation_text.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace espalier {
namespace {

template <class Enum> QString nameIn(const std::vector<std::string>& names, Enum value) {
  return QString::fromStdString(names[static_cast<std::size_t>(value)]);
}

bool flagIn(const QJsonValue& value, bool usual) {
  if (!value.isUndefined() && !value.isBool()) refuse();
  return value.toBool(usual);
}

/// Which of the names it is.
template <class Enum>
Enum namedIn(const QJsonValue& value, const std::vector<std::string>& names, Enum usual) {
  if (value.isUndefined()) return usual;
  const auto found = std::ranges::find(names, value.toString().toStdString());
  if (found == names.end()) refuse();
  return static_cast<Enum>(found - names.begin());
}

EditOptions editIn(const QJsonDocument& document) {
  const EditOptions usual;
  return {.unit = namedIn(document["edit_unit"], editUnitNames(), usual.unit),
          .cost = namedIn(document["edit_cost"], editCostNames(), usual.cost),
          .mergesPaths = flagIn(document["merge_paths"], usual.mergesPaths)};
}

DifferingPart partIn(const QJsonObject& json) {
  DifferingPart part;
  bool isKnown = false;
  for (const Difference kind :
       {Difference::missed, Difference::invented, Difference::wronglyAttached}) {
    if (json["kind"].toString().toStdString() != nameOf(kind)) continue;
    part.kind = kind;
    isKnown = true;
  }
  const QJsonArray at = json["at"].toArray();
  if (!isKnown || at.size() != 3) refuse();
  part.at = {numberIn(at[0]), numberIn(at[1]), numberIn(at[2])};
  return part;
}

std::vector<DifferingPart> partsIn(const QJsonValue& json) {
  std::vector<DifferingPart> parts;
  for (const auto& each : json.toArray())
    parts.push_back(partIn(each.toObject()));
  return parts;
}

QJsonArray jsonOf(const std::vector<DifferingPart>& parts) {
  QJsonArray json;
  for (const DifferingPart& part : parts)
    json.append(QJsonObject{{"kind", QString::fromStdString(nameOf(part.kind))},
                            {"at", QJsonArray{part.at.x(), part.at.y(), part.at.z()}}});
  return json;
}

} // namespace

std::string textOf(const EvaluationText& evaluation) {
  if (evaluation == EvaluationText()) return {};
  QJsonObject ignoredOf;
  for (const auto& [reference, parts] : evaluation.ignoredOf)
    ignoredOf[QString::fromStdString(reference)] = jsonOf(parts);
  const EditOptions& edit = evaluation.edit;
  const QJsonObject json{{"tolerance", evaluation.tolerance},
                         {"laid", evaluation.isLaid},
                         {"turned", evaluation.turns},
                         {"edit_unit", nameIn(editUnitNames(), edit.unit)},
                         {"edit_cost", nameIn(editCostNames(), edit.cost)},
                         {"merge_paths", edit.mergesPaths},
                         {"ignored", jsonOf(evaluation.ignored)},
                         {"ignored_of", ignoredOf}};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

EvaluationText evaluationFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "EvaluationText",
      "how this project compares with its reference cannot be read: choose the tolerance again");
  return readKept(refusal, [&] {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject() || !document["laid"].isBool()) refuse();
    EvaluationText evaluation{.tolerance = numberIn(document["tolerance"]),
                              .isLaid = document["laid"].toBool(),
                              .turns = flagIn(document["turned"], true),
                              .edit = editIn(document)};
    if (evaluation.tolerance < 0) refuse();
    evaluation.ignored = partsIn(document["ignored"]);
    const QJsonObject ignoredOf = document["ignored_of"].toObject();
    for (const QString& reference : ignoredOf.keys())
      evaluation.ignoredOf[reference.toStdString()] = partsIn(ignoredOf[reference]);
    return evaluation;
  });
}

} // namespace espalier
