#include "app/window/review/findings_text.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace espalier {
namespace {

Finding::Kind kindNamed(const QString& name) {
  for (int kind = 0; kind < findingKinds; ++kind)
    if (name.toStdString() == nameOf(static_cast<Finding::Kind>(kind)))
      return static_cast<Finding::Kind>(kind);
  refuse();
}

Finding findingIn(const QJsonObject& json) {
  const QJsonArray nodes = json["nodes"].toArray();
  if (nodes.isEmpty()) refuse();
  Finding finding{.kind = kindNamed(json["kind"].toString()), .node = nodeIn(nodes[0])};
  for (qsizetype i = 1; i < nodes.size(); ++i)
    finding.others.push_back(nodeIn(nodes[i]));
  if (finding.kind != Finding::Kind::unexplainedPoints) return finding;
  const QJsonArray place = json["place"].toArray();
  if (place.size() != 3) refuse();
  finding.place = {numberIn(place[0]), numberIn(place[1]), numberIn(place[2])};
  finding.reach = numberIn(json["reach"]);
  return finding;
}

} // namespace

std::string textOf(const std::vector<Finding>& findings) {
  if (findings.empty()) return {};
  QJsonArray all;
  for (const Finding& finding : findings) {
    QJsonArray nodes;
    for (const NodeId id : nodesOf(finding))
      nodes.append(static_cast<qint64>(indexOf(id)));
    QJsonObject json{{"kind", QString::fromStdString(nameOf(finding.kind))}, {"nodes", nodes}};
    if (finding.kind == Finding::Kind::unexplainedPoints) {
      json["place"] = QJsonArray{finding.place.x(), finding.place.y(), finding.place.z()};
      json["reach"] = finding.reach;
    }
    all.append(json);
  }
  return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<Finding> findingsFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "FindingsText", "what is ignored in this project cannot be read: all findings are shown");
  return readKept(refusal, [&] {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isArray()) refuse();
    std::vector<Finding> findings;
    for (const QJsonValue each : document.array())
      findings.push_back(findingIn(each.toObject()));
    return findings;
  });
}

std::string textOf(const std::map<std::string, double>& limits) {
  if (limits.empty()) return {};
  QJsonObject all;
  for (const auto& [name, value] : limits)
    all[QString::fromStdString(name)] = value;
  return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::map<std::string, double> limitsFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "FindingsText",
      "the limits of the checks in this project cannot be read: the usual ones hold");
  return readKept(refusal, [&] {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) refuse();
    const QJsonObject all = document.object();
    std::map<std::string, double> limits;
    for (auto each = all.begin(); each != all.end(); ++each)
      limits[each.key().toStdString()] = numberIn(each.value());
    return limits;
  });
}

} // namespace espalier
