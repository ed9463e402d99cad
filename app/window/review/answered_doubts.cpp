#include "app/window/review/answered_doubts.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace espalier {
namespace {

Doubt::Kind doubtKindNamed(const QString& name) {
  for (int kind = 0; kind < doubtKinds; ++kind)
    if (name.toStdString() == nameOf(static_cast<Doubt::Kind>(kind)))
      return static_cast<Doubt::Kind>(kind);
  refuse();
}

/// As text: a number of JSON does not hold all digits of an id.
StepId stepIn(const QJsonValue& value) {
  bool isNumber = false;
  const qulonglong id = value.toString().toULongLong(&isNumber);
  if (!isNumber) refuse();
  return StepId(id);
}

Eigen::Vector3d placeIn(const QJsonValue& value) {
  const QJsonArray place = value.toArray();
  if (place.size() != 3) refuse();
  return {numberIn(place[0]), numberIn(place[1]), numberIn(place[2])};
}

QJsonArray jsonOf(const Eigen::Vector3d& place) {
  return {place.x(), place.y(), place.z()};
}

AnsweredDoubt answeredIn(const QJsonObject& json) {
  AnsweredDoubt answered{.kind = doubtKindNamed(json["kind"].toString()),
                         .node = nodeIn(json["node"]),
                         .step = stepIn(json["step"]),
                         .isIgnored = json["ignored"].toBool()};
  answered.learned = {.kind = answered.kind,
                      .said = numberIn(json["said"]),
                      .spacings = numberIn(json["spacings"]),
                      .wasWrong = json["wrong"].toBool()};
  const bool isInRange =
      answered.learned.said >= 0 && answered.learned.said <= 1 && answered.learned.spacings >= 0;
  if (!isInRange) refuse();
  if (answered.kind != Doubt::Kind::missing) return answered;
  answered.tip = placeIn(json["tip"]);
  if (json.contains("foot")) answered.foot = placeIn(json["foot"]);
  if (!json.contains("box")) return answered;
  const QJsonArray box = json["box"].toArray();
  if (box.size() != 2) refuse();
  answered.box = {placeIn(box[0]), placeIn(box[1])};
  return answered;
}

} // namespace

bool isAbout(const AnsweredDoubt& answered, const Doubt& doubt, double near) {
  const bool isMissing = doubt.kind == Doubt::Kind::missing;
  if (isMissing != (answered.kind == Doubt::Kind::missing)) return false;
  if (!isMissing) return answered.node == doubt.node;
  const auto ends = endsOfAdded(doubt);
  return ends && (answered.tip - ends->second).norm() <= near &&
         (!answered.foot || (*answered.foot - ends->first).norm() <= near);
}

bool leavesOut(const AnsweredDoubt& answered) {
  const bool isNoBranch = answered.kind == Doubt::Kind::missing && !answered.learned.wasWrong;
  return answered.isIgnored || isNoBranch;
}

bool isAbout(const AnsweredDoubt& answered, const Finding& finding, double spacing) {
  if (finding.kind != Finding::Kind::unexplainedPoints || !answered.box) return false;
  const Eigen::AlignedBox3d box((*answered.box)[0], (*answered.box)[1]);
  return box.exteriorDistance(finding.place) <= spacing &&
         finding.reach <= box.diagonal().norm() + spacing;
}

std::string textOf(const std::vector<AnsweredDoubt>& answered) {
  if (answered.empty()) return {};
  QJsonArray all;
  for (const AnsweredDoubt& one : answered) {
    QJsonObject json{{"kind", QString::fromStdString(nameOf(one.kind))},
                     {"node", static_cast<qint64>(indexOf(one.node))},
                     {"said", one.learned.said},
                     {"spacings", one.learned.spacings},
                     {"wrong", one.learned.wasWrong},
                     {"step", QString::number(static_cast<qulonglong>(one.step))}};
    if (one.kind == Doubt::Kind::missing) json["tip"] = jsonOf(one.tip);
    if (one.foot) json["foot"] = jsonOf(*one.foot);
    if (one.box) json["box"] = QJsonArray{jsonOf((*one.box)[0]), jsonOf((*one.box)[1])};
    if (one.isIgnored) json["ignored"] = true;
    all.append(json);
  }
  return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<AnsweredDoubt> answeredFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "AnsweredDoubts",
      "the answers in this project cannot be read: what was answered is asked again");
  return readKept(refusal, [&] {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isArray()) refuse();
    std::vector<AnsweredDoubt> answered;
    for (const QJsonValue value : document.array())
      answered.push_back(answeredIn(value.toObject()));
    return answered;
  });
}

} // namespace espalier
