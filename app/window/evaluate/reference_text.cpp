#include "app/window/evaluate/reference_text.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <vector>

namespace espalier {
namespace {

Node nodeIn(const QJsonArray& json, const std::vector<NodeId>& before) {
  if (json.size() != 6) refuse();
  const QString edge = json[1].toString();
  Node node{.position = {numberIn(json[2]), numberIn(json[3]), numberIn(json[4])},
            .radius = numberIn(json[5]),
            .parent = std::nullopt,
            .edge = edge == "+" ? EdgeType::branching : EdgeType::successor};
  if ((edge != "+" && edge != "<") || node.radius < 0) refuse();
  const double parent = numberIn(json[0]);
  if (parent == -1) return node;
  if (parent < 0 || parent >= static_cast<double>(before.size())) refuse();
  node.parent = before[static_cast<std::size_t>(parent)];
  return node;
}

QJsonObject jsonOf(const Reference& reference) {
  const Skeleton& skeleton = reference.skeleton;
  QJsonArray nodes;
  std::vector<qint64> numbers(skeleton.idEnd(), -1);
  for (const NodeId id : skeleton.ids()) { // parents before their children
    const Node& node = skeleton[id];
    numbers[indexOf(id)] = nodes.size();
    nodes.append(QJsonArray{node.parent ? numbers[indexOf(*node.parent)] : qint64{-1},
                            QString(QChar(static_cast<char>(node.edge))), node.position.x(),
                            node.position.y(), node.position.z(), node.radius});
  }
  QJsonObject json{{"path", reference.path}, {"nodes", nodes}};
  if (reference.isVersion) json["version"] = true;
  if (reference.isOfScan) json["of_scan"] = true;
  if (!reference.before.empty()) json["before"] = jsonOf(reference.before.front());
  return json;
}

Reference referenceIn(const QJsonObject& json) {
  const QJsonArray nodes = json["nodes"].toArray();
  if (nodes.isEmpty()) refuse();
  Reference reference{.skeleton = {},
                      .path = json["path"].toString(),
                      .isVersion = json["version"].toBool(),
                      .isOfScan = json["of_scan"].toBool()};
  std::vector<NodeId> ids;
  for (const auto& each : nodes)
    ids.push_back(reference.skeleton.add(nodeIn(each.toArray(), ids)));
  if (reference.isVersion && json.contains("before")) {
    reference.before.push_back(referenceIn(json["before"].toObject()));
    if (reference.before.front().isVersion) refuse(); // which stands in the place of no other
  }
  return reference;
}

} // namespace

std::string textOf(const Reference& reference) {
  if (reference.skeleton.isEmpty()) return {};
  return QJsonDocument(jsonOf(reference)).toJson(QJsonDocument::Compact).toStdString();
}

Reference referenceFrom(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "ReferenceText", "the reference in this project cannot be read: load it from its file");
  return readKept(refusal, [&] {
    return referenceIn(QJsonDocument::fromJson(QByteArray::fromStdString(text)).object());
  });
}

} // namespace espalier
