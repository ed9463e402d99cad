#include "app/window/evaluation_text.h"

#include "core/base/error.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace espalier {
namespace {

[[noreturn]] void refuse() {
  throw Error(QCoreApplication::translate("EvaluationText",
                                          "how this project compares with its reference cannot be "
                                          "read: choose the tolerance again")
                  .toStdString());
}

double numberIn(const QJsonValue& value) {
  const double number = value.toDouble(std::nan(""));
  if (!std::isfinite(number)) refuse();
  return number;
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

} // namespace

std::string textOf(const EvaluationText& evaluation) {
  if (evaluation == EvaluationText()) return {};
  QJsonArray ignored;
  for (const DifferingPart& part : evaluation.ignored)
    ignored.append(QJsonObject{{"kind", QString::fromStdString(nameOf(part.kind))},
                               {"at", QJsonArray{part.at.x(), part.at.y(), part.at.z()}}});
  const QJsonObject json{
      {"tolerance", evaluation.tolerance}, {"laid", evaluation.isLaid}, {"ignored", ignored}};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

EvaluationText evaluationFrom(const std::string& text) {
  if (text.empty()) return {};
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
  if (!document.isObject() || !document["laid"].isBool()) refuse();
  EvaluationText evaluation{.tolerance = numberIn(document["tolerance"]),
                            .isLaid = document["laid"].toBool()};
  if (evaluation.tolerance < 0) refuse();
  for (const auto& each : document["ignored"].toArray())
    evaluation.ignored.push_back(partIn(each.toObject()));
  return evaluation;
}

} // namespace espalier
