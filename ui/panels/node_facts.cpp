#include "ui/panels/node_facts.h"

#include "core/skeleton/review_walk.h"
#include "ui/document/plant_document.h"
#include "ui/panels/radius_text.h"

#include <QCoreApplication>

#include <array>

namespace espalier {
namespace {

struct NodeFactText {
  Q_DECLARE_TR_FUNCTIONS(NodeTable)
};

struct Name {
  const char* key;
  const char* text;
};
constexpr std::array<Name, nodeColumns> names = {
    {{"node", QT_TRANSLATE_NOOP("NodeTable", "Node")},
     {"parent", QT_TRANSLATE_NOOP("NodeTable", "Parent")},
     {"edge", QT_TRANSLATE_NOOP("NodeTable", "Edge")},
     {"order", QT_TRANSLATE_NOOP("NodeTable", "Order")},
     {"axis", QT_TRANSLATE_NOOP("NodeTable", "Axis")},
     {"x", QT_TRANSLATE_NOOP("NodeTable", "x")},
     {"y", QT_TRANSLATE_NOOP("NodeTable", "y")},
     {"z", QT_TRANSLATE_NOOP("NodeTable", "z")},
     {"radius", QT_TRANSLATE_NOOP("NodeTable", "Radius")},
     {"length", QT_TRANSLATE_NOOP("NodeTable", "Length")},
     {"class", QT_TRANSLATE_NOOP("NodeTable", "Class")},
     {"index", QT_TRANSLATE_NOOP("NodeTable", "Index")},
     {"mark", QT_TRANSLATE_NOOP("NodeTable", "Mark")},
     {"review", QT_TRANSLATE_NOOP("NodeTable", "Review")},
     {"comment", QT_TRANSLATE_NOOP("NodeTable", "Comment")},
     {"radius_source", QT_TRANSLATE_NOOP("NodeTable", "Radius from")},
     {"radius_least", QT_TRANSLATE_NOOP("NodeTable", "At least")},
     {"radius_most", QT_TRANSLATE_NOOP("NodeTable", "At most")}}};

QString nameOf(ReviewState state) {
  switch (state) {
  case ReviewState::reviewed:
    return NodeFactText::tr("reviewed");
  case ReviewState::doubtful:
    return NodeFactText::tr("doubtful");
  case ReviewState::toDo:
    break;
  }
  return NodeFactText::tr("to do");
}

int at(const std::vector<int>& byId, NodeId id) {
  return indexOf(id) < byId.size() ? byId[indexOf(id)] : 0; // an edit ago
}

} // namespace

QString nameOf(NodeColumn column) {
  return NodeFactText::tr(names[static_cast<std::size_t>(column)].text);
}

QString keyOf(NodeColumn column) {
  return QString::fromLatin1(names[static_cast<std::size_t>(column)].key);
}

bool isLength(NodeColumn column) {
  return (column >= NodeColumn::x && column <= NodeColumn::length) || column == NodeColumn::least ||
         column == NodeColumn::most;
}

bool isNumber(NodeColumn column) {
  switch (column) {
  case NodeColumn::edge:
  case NodeColumn::source:
  case NodeColumn::unit:
  case NodeColumn::mark:
  case NodeColumn::review:
  case NodeColumn::comment:
    return false;
  default:
    return true;
  }
}

void NodeFacts::update() {
  const Skeleton& skeleton = document_.skeleton();
  orders_ = orders(skeleton);
  axes_.assign(skeleton.idEnd(), 0);
  int number = 0;
  for (const Axis& axis : axesInWalkOrder(skeleton)) {
    ++number;
    for (const NodeId id : axis)
      axes_[indexOf(id)] = number;
  }
}

std::optional<double> NodeFacts::number(NodeId id, NodeColumn column) const {
  const Node& node = document_.skeleton()[id];
  switch (column) {
  case NodeColumn::node:
    return static_cast<double>(indexOf(id));
  case NodeColumn::parent:
    if (!node.parent) return std::nullopt;
    return static_cast<double>(indexOf(*node.parent));
  case NodeColumn::order:
    return at(orders_, id);
  case NodeColumn::axis:
    return at(axes_, id);
  case NodeColumn::x:
  case NodeColumn::y:
  case NodeColumn::z:
    return node.position[static_cast<int>(column) - static_cast<int>(NodeColumn::x)];
  case NodeColumn::radius:
    return node.radius;
  case NodeColumn::least:
    if (!node.origin.hasInterval()) return std::nullopt;
    return node.origin.least * node.radius;
  case NodeColumn::most:
    if (!node.origin.hasInterval()) return std::nullopt;
    return node.origin.most * node.radius;
  case NodeColumn::length:
    if (!node.parent) return std::nullopt;
    return (node.position - document_.skeleton()[*node.parent].position).norm();
  case NodeColumn::index:
    if (node.entities.empty() || !node.entities.back().index) return std::nullopt;
    return node.entities.back().index->number(); // 16 of 16.1
  default:
    return std::nullopt;
  }
}

QString NodeFacts::text(NodeId id, NodeColumn column) const {
  const Node& node = document_.skeleton()[id];
  switch (column) {
  case NodeColumn::edge:
    if (!node.parent) return {};
    return QString(QLatin1Char(static_cast<char>(node.edge)));
  case NodeColumn::source:
    return nameOf(node.origin.source);
  case NodeColumn::unit:
    return node.entities.empty() ? QString() : QString::fromStdString(node.entities.back().symbol);
  case NodeColumn::index:
    if (node.entities.empty() || !node.entities.back().index) return {};
    return QString::fromStdString(node.entities.back().index->text());
  case NodeColumn::mark:
    return node.isMarked ? NodeFactText::tr("unit start") : QString();
  case NodeColumn::review:
    return nameOf(node.review.state);
  case NodeColumn::comment:
    return QString::fromStdString(node.review.comment);
  default:
    const std::optional<double> value = number(id, column);
    return value ? QString::number(*value, 'g', 12) : QString();
  }
}

} // namespace espalier
