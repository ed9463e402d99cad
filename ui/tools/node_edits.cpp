#include "ui/tools/node_edits.h"

#include "core/base/error.h"
#include "core/mtg/unit_scales.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/beside_points.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/propose_child.h"
#include "core/skeleton/recenter.h"
#include "ui/document/length_unit.h"
#include "ui/tools/structure_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {
namespace {

struct NodeEditText {
  Q_DECLARE_TR_FUNCTIONS(NodeEdits)
};

bool isContained(PlantDocument& document, NodeId id) {
  return document.skeleton().contains(id);
}

/// What a lone root grows by, and how far a new child looks for points.
double snapReach(const PlantDocument& document) {
  if (!document.scan()) return 1;
  const double size = document.scan()->bounds().sizes().maxCoeff();
  return size > 0 ? size / 50 : 1;
}

/// One edge farther along the points, from the end of an axis; none where there are none.
std::optional<Eigen::Vector3d> alongThePoints(const PlantDocument& document,
                                              const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  if (!document.scan() || !node.parent || !skeleton.children(id).empty()) return std::nullopt;
  const Eigen::Vector3d direction = node.position - skeleton[*node.parent].position;
  if (direction.isZero(0)) return std::nullopt;
  const double wood = std::max(1.5 * node.radius, 3 * document.scan()->spacing());
  return document.scan()->along(node.position, direction,
                                {.step = meanEdgeLength(skeleton), .reach = wood});
}

void newChild(PlantDocument& document, const NodeTarget& target) {
  const auto snap = [&](const Eigen::Vector3d& place) {
    return document.scan() ? document.scan()->onPoints(place, snapReach(document)) : place;
  };
  std::vector<NodeId> added;
  editEach(document, target, NodeEditText::tr("New child of %1"),
           [&](SkeletonEditor& editor, NodeId id) {
             const auto ahead = alongThePoints(document, editor.skeleton(), id);
             added.push_back(
                 addChild(editor, id,
                          ahead ? *ahead
                                : proposeChild(editor.skeleton(), id, target.viewDirection,
                                               snapReach(document), snap)));
           });
  document.selection().set(added);
}

/// The same, but not beyond the points: this key is pressed many times in a row.
void extendAgain(PlantDocument& document, const NodeTarget& target) {
  const Skeleton& skeleton = document.skeleton();
  const auto isAtEndOfPoints = [&](NodeId id) {
    const bool isEnd = skeleton[id].parent && skeleton.children(id).empty();
    return isEnd && !alongThePoints(document, skeleton, id);
  };
  if (document.scan() && std::ranges::all_of(target.nodes, isAtEndOfPoints))
    throw Error(
        NodeEditText::tr("the points end here: New Child adds a node all the same").toStdString());
  newChild(document, target);
}

void split(PlantDocument& document, const NodeTarget& target) {
  std::vector<NodeId> added;
  if (target.edge) {
    const auto at = [&](SkeletonEditor& editor) {
      added.push_back(splitEdge(editor, target.edge->child, target.edge->fraction));
    };
    document.edit(NodeEditText::tr("Split the edge of %1").arg(nodeName(target.edge->child)), at);
  } else {
    editEach(
        document, target, NodeEditText::tr("Split the edge of %1"),
        [&](SkeletonEditor& editor, NodeId id) { added.push_back(splitEdge(editor, id, 0.5)); });
  }
  document.selection().set(added);
}

void remove(PlantDocument& document, const NodeTarget& target) {
  editEach(document, target, NodeEditText::tr("Remove %1"), removeNode);
}

void removeBranch(PlantDocument& document, const NodeTarget& target) {
  editEach(document, target, NodeEditText::tr("Remove the subtree of %1"), removeSubtree);
}

void makeAxial(PlantDocument& document, const NodeTarget& target) {
  editEach(document, target, NodeEditText::tr("Make %1 axial"),
           [](SkeletonEditor& editor, NodeId id) { setEdgeType(editor, id, EdgeType::successor); });
}

void makeBranching(PlantDocument& document, const NodeTarget& target) {
  editEach(document, target, NodeEditText::tr("Make %1 branching"),
           [](SkeletonEditor& editor, NodeId id) { setEdgeType(editor, id, EdgeType::branching); });
}

/// How far the points of a stem go on below its root, along it; none where they do not.
std::optional<Eigen::Vector3d> footOnPoints(const PlantDocument& document, const Skeleton& skeleton,
                                            NodeId root) {
  const auto above = skeleton[root].parent ? std::nullopt : nextOnAxis(skeleton, root);
  if (!above) return std::nullopt;
  const double radius = std::max(skeleton[root].radius, skeleton[*above].radius);
  const double spacing = document.scan()->spacing();
  const Eigen::Vector3d top = skeleton[root].position;
  const Eigen::Vector3d down = top - skeleton[*above].position;
  if (down.isZero(0)) return std::nullopt;
  std::optional<Eigen::Vector3d> foot;
  constexpr int most = 1000; // steps
  for (int step = 0; step < most; ++step) {
    const Eigen::Vector3d from = foot.value_or(top);
    const auto ahead = document.scan()->along(
        from, foot ? Eigen::Vector3d(*foot - top) : down,
        {.step = std::max(radius, 4 * spacing), .reach = std::max(1.5 * radius, 3 * spacing)});
    if (!ahead || (*ahead - from).dot(down) <= 0) break;
    foot = ahead;
  }
  return foot;
}

void requireRadius(const Skeleton& skeleton, NodeId id) {
  if (skeleton[id].radius == 0)
    throw Error(NodeEditText::tr("%1 has no radius yet: type one in the inspector")
                    .arg(nodeName(id))
                    .toStdString());
}

void scaleRadius(PlantDocument& document, const NodeTarget& target, const QString& text,
                 double factor) {
  editEach(document, target, text, [factor](SkeletonEditor& editor, NodeId id) {
    requireRadius(editor.skeleton(), id);
    editor.setRadius(id, factor * editor.skeleton()[id].radius);
  });
}

void requireScan(const PlantDocument& document) {
  if (!document.scan())
    throw Error(
        NodeEditText::tr("there are no points to stick to: open the scan first").toStdString());
}

void extendFoot(PlantDocument& document, const NodeTarget& target) {
  requireScan(document);
  bool isFound = false;
  editEach(document, target, NodeEditText::tr("Extend the foot at %1"),
           [&](SkeletonEditor& editor, NodeId id) {
             const auto foot = footOnPoints(document, editor.skeleton(), id);
             if (!foot) return;
             isFound = true;
             moveNode(editor, id, *foot);
           });
  if (!isFound)
    throw Error(NodeEditText::tr("no points go on below %1: choose the root of a stem")
                    .arg(nodeNames(target.nodes))
                    .toStdString());
}

void stick(PlantDocument& document, const NodeTarget& target) {
  requireScan(document);
  editEach(document, target, NodeEditText::tr("Stick %1 to the points"),
           [&](SkeletonEditor& editor, NodeId id) {
             moveNode(editor, id, document.scan()->onPoints(editor.skeleton()[id].position));
           });
}

void stickBranch(PlantDocument& document, const NodeTarget& target) {
  requireScan(document);
  const auto stickAll = [&](SkeletonEditor& editor, NodeId top) {
    std::vector<NodeId> carried = {top};
    for (std::size_t next = 0; next < carried.size(); ++next) {
      const NodeId id = carried[next];
      moveNode(editor, id, document.scan()->onPoints(editor.skeleton()[id].position));
      const std::vector<NodeId>& children = editor.skeleton().children(id);
      carried.insert(carried.end(), children.begin(), children.end());
    }
  };
  editEach(document, target, NodeEditText::tr("Stick the subtree of %1 to the points"), stickAll);
}

void center(PlantDocument& document, const NodeTarget& target) {
  requireScan(document);
  bool isFound = false;
  const Skeleton before = document.skeleton(); // sections lie across it as it is
  editEach(document, target, NodeEditText::tr("Center %1"), [&](SkeletonEditor& editor, NodeId id) {
    const Eigen::Vector3d& place = before[id].position;
    const double reach = sectionReach(document, id);
    std::optional<Eigen::Vector3d> middle =
        sectionCenter(before, id, document.scan()->near(place, reach));
    if (!middle) // they show too little of a circle, or are of a blade, which is wider
      if (const auto shift = shiftToPoints(before, id, document.scan()->near(place, 2 * reach),
                                           document.scan()->spacing()))
        middle = place + *shift;
    if (!middle) return;
    isFound = true;
    moveNode(editor, id, *middle);
  });
  if (!isFound)
    throw Error((target.nodes.size() == 1
                     ? NodeEditText::tr("the points around %1 show no middle: move it by hand")
                     : NodeEditText::tr("the points around %1 show no middle: move them by hand"))
                    .arg(nodeNames(target.nodes))
                    .toStdString());
}

void markUnitStart(PlantDocument& document, const NodeTarget& target) {
  const bool areMarked = std::ranges::all_of(
      target.nodes, [&](NodeId id) { return document.skeleton()[id].isMarked; });
  const QString text = areMarked ? NodeEditText::tr("Take the mark off %1")
                                 : NodeEditText::tr("Mark a unit start at %1");
  document.edit(text.arg(nodeNames(target.nodes)),
                [&](SkeletonEditor& editor) { toggleMarks(editor, target.nodes); });
}

/// Those that end the menu.
std::vector<NodeEdit> lastEdits() {
  return {
      {"mark_unit_start", NodeEditText::tr("Mark Unit Start"),
       NodeEditText::tr("A unit of a coarser scale is to start here; once more takes the mark off"),
       "", Qt::Key_U, markUnitStart},
      {"remove", NodeEditText::tr("Remove Node"),
       NodeEditText::tr("Its children are attached to its parent"), "remove",
       QKeySequence(Qt::Key_Delete), remove},
      {"remove_subtree", NodeEditText::tr("Remove Subtree"),
       NodeEditText::tr("With all that the node carries"), "",
       QKeySequence(Qt::SHIFT | Qt::Key_Delete), removeBranch},
  };
}

} // namespace

QString nodeName(NodeId id) {
  return NodeEditText::tr("node %1").arg(indexOf(id));
}

QString nodeNames(const std::vector<NodeId>& ids) {
  return ids.size() == 1 ? nodeName(ids.front())
                         : NodeEditText::tr("%1 nodes").arg(formatCount(ids.size()));
}

double sectionReach(const PlantDocument& document, NodeId id) {
  return std::max(2 * document.skeleton()[id].radius, 8 * document.scan()->spacing());
}

void editEach(PlantDocument& document, const NodeTarget& target, const QString& text,
              const std::function<void(SkeletonEditor&, NodeId)>& change) {
  document.edit(text.arg(nodeNames(target.nodes)), [&](SkeletonEditor& editor) {
    for (const NodeId id : target.nodes)
      if (editor.skeleton().contains(id)) change(editor, id);
  });
}

NodeTarget targetOf(PlantDocument& document, const Pick& under,
                    const Eigen::Vector3d& viewDirection) {
  NodeTarget target{
      .nodes = document.selection().nodes(), .edge = under.edge, .viewDirection = viewDirection};
  if (target.edge && !isContained(document, target.edge->child)) target.edge.reset();
  if (under.node && isContained(document, *under.node) &&
      !document.selection().contains(*under.node))
    target.nodes = {*under.node};
  return target;
}

std::vector<NodeEdit> nodeEdits() {
  const auto scaleBy = [](const char* text, double factor) {
    return [text, factor](PlantDocument& document, const NodeTarget& target) {
      scaleRadius(document, target, NodeEditText::tr(text), factor);
    };
  };
  std::vector<NodeEdit> edits = {
      {"new_child", NodeEditText::tr("New Child"),
       NodeEditText::tr("Adds a child, on the points ahead"), "add", Qt::Key_N, newChild},
      {.id = "extend_again",
       .text = NodeEditText::tr("Extend Again"),
       .help = NodeEditText::tr("One more child of the node that was added last, or is selected"),
       .icon = "",
       .shortcut = Qt::Key_Space,
       .apply = extendAgain,
       .isOfSelected = true},
      {"extend_foot", NodeEditText::tr("Extend Foot"),
       NodeEditText::tr("Moves the root down along its stem, as far as its points go"), "",
       QKeySequence(Qt::SHIFT | Qt::Key_Space), extendFoot},
      {.id = "split_edge",
       .text = NodeEditText::tr("Split Edge"),
       .help = NodeEditText::tr("Puts a node on the edge: where the pointer is, or in the middle"),
       .icon = "split",
       .shortcut = Qt::Key_E,
       .apply = split,
       .takesEdge = true},
      {"make_axial", NodeEditText::tr("Make Axial"),
       NodeEditText::tr("Continues the axis of the parent (<)"), "axial", Qt::Key_M, makeAxial},
      {"make_branching", NodeEditText::tr("Make Branching"),
       NodeEditText::tr("Begins an axis of its own (+)"), "branching",
       QKeySequence(Qt::SHIFT | Qt::Key_M), makeBranching},
      {"stick", NodeEditText::tr("Stick to Points"),
       NodeEditText::tr("Moves the node to the middle of its 5 nearest points"), "stick", Qt::Key_T,
       stick},
      {"stick_subtree", NodeEditText::tr("Stick Subtree to Points"),
       NodeEditText::tr("The same for all that the node carries"), "", Qt::Key_G, stickBranch},
      {"center", NodeEditText::tr("Move to Section Center"),
       NodeEditText::tr(
           "Moves the node to the middle of the points around it, of a circle where they show one"),
       "", QKeySequence(Qt::SHIFT | Qt::Key_T), center},
      {"radius_up", NodeEditText::tr("Increase Radius"), NodeEditText::tr("5 % more"), "",
       Qt::Key_A, scaleBy(QT_TRANSLATE_NOOP("NodeEdits", "Increase the radius of %1"), 1.05)},
      {"radius_down", NodeEditText::tr("Decrease Radius"), NodeEditText::tr("5 % less"), "",
       Qt::Key_Q, scaleBy(QT_TRANSLATE_NOOP("NodeEdits", "Decrease the radius of %1"), 0.95)},
  };
  for (const std::vector<NodeEdit>& others : {treeEdits(), pathEdits(), lastEdits()})
    edits.insert(edits.end(), others.begin(), others.end());
  return edits;
}

void scaleRadii(PlantDocument& document, const std::vector<NodeId>& nodes, double factor,
                Gesture gesture) {
  const auto scale = [&](SkeletonEditor& editor) {
    for (const NodeId id : nodes) {
      requireRadius(editor.skeleton(), id);
      editor.setRadius(id, factor * editor.skeleton()[id].radius);
    }
  };
  document.edit(NodeEditText::tr("Change the radius of %1").arg(nodeNames(nodes)), scale, gesture);
}

void setRadius(PlantDocument& document, const std::vector<NodeId>& nodes, double radius) {
  document.edit(NodeEditText::tr("Set the radius of %1").arg(nodeNames(nodes)),
                [&](SkeletonEditor& editor) {
                  for (const NodeId id : nodes)
                    editor.setRadius(id, radius);
                });
}

} // namespace espalier
