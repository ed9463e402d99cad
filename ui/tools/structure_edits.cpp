#include "ui/tools/structure_edits.h"

#include "core/base/error.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {
namespace {

struct StructureEditText {
  Q_DECLARE_TR_FUNCTIONS(StructureEdits)
};

void swapContinuation(PlantDocument& document, const NodeTarget& target) {
  editEach(document, target, StructureEditText::tr("Swap the continuation of %1"), swapSuccessor);
}

void cut(PlantDocument& document, const NodeTarget& target) {
  if (target.edge) {
    const NodeId above = target.edge->child;
    document.edit(StructureEditText::tr("Cut off %1").arg(nodeName(above)),
                  [&](SkeletonEditor& editor) { cutOff(editor, above); });
    document.selection().set({above});
  } else {
    editEach(document, target, StructureEditText::tr("Cut off %1"), cutOff);
  }
}

/// Joins the trees of all to the last one chosen; that of a single one to the nearest other tree.
void join(PlantDocument& document, const NodeTarget& target) {
  const Skeleton& skeleton = document.skeleton();
  std::vector<NodeId> joining = target.nodes;
  const NodeId onto =
      joining.size() == 1 ? nearestInOtherTree(skeleton, joining.front()) : joining.back();
  if (joining.size() > 1) joining.pop_back();
  const auto rootOf = [](const Skeleton& plant, NodeId id) { return upstream(plant, {id}).back(); };
  const auto change = [&](SkeletonEditor& editor) {
    bool isOneJoined = false;
    for (const NodeId id : joining) {
      const bool isInThatTree = rootOf(editor.skeleton(), id) == rootOf(editor.skeleton(), onto);
      if (isInThatTree && isOneJoined) continue; // it came with another one
      joinTree(editor, id, onto);
      isOneJoined = true;
    }
  };
  document.edit(StructureEditText::tr("Join %1 to %2").arg(nodeNames(joining), nodeName(onto)),
                change);
}

void makeRoot(PlantDocument& document, const NodeTarget& target) {
  const Skeleton& skeleton = document.skeleton();
  if (std::ranges::all_of(target.nodes, [&](NodeId id) { return !skeleton[id].parent; }))
    throw Error(
        StructureEditText::tr("%1 is the root already").arg(nodeNames(target.nodes)).toStdString());
  editEach(document, target, StructureEditText::tr("Make %1 the root"), reroot);
}

void merge(PlantDocument& document, const NodeTarget& target) {
  NodeId kept{};
  document.edit(StructureEditText::tr("Merge %1").arg(nodeNames(target.nodes)),
                [&](SkeletonEditor& editor) { kept = mergeNodes(editor, target.nodes); });
  document.selection().set({kept});
}

void turnAround(PlantDocument& document, const NodeTarget& target) {
  const Skeleton& skeleton = document.skeleton();
  const std::vector<NodeId> path = pathOf(skeleton, target.nodes);
  if (path.size() < 2)
    throw Error(StructureEditText::tr("%1 is alone on its axis: select the two ends of a path")
                    .arg(nodeName(path.front()))
                    .toStdString());
  const bool isUpward = skeleton.isAncestor(path.front(), path.back());
  document.edit(StructureEditText::tr("Turn around the path of %1").arg(nodeNames(target.nodes)),
                [&](SkeletonEditor& editor) {
                  reversePath(editor, isUpward ? path.front() : path.back(),
                              isUpward ? path.back() : path.front());
                });
}

/// An edit of the path that is meant, with `text` for its name.
auto onPath(const char* text, void (*change)(SkeletonEditor&, const std::vector<NodeId>&)) {
  return [text, change](PlantDocument& document, const NodeTarget& target) {
    const std::vector<NodeId> path = pathOf(document.skeleton(), target.nodes);
    document.edit(StructureEditText::tr(text).arg(nodeNames(target.nodes)),
                  [&](SkeletonEditor& editor) { change(editor, path); });
  };
}

/// The nodes chosen; of two that are the ends of a path, those between them.
std::vector<NodeId> meantToSmooth(const Skeleton& skeleton, const std::vector<NodeId>& chosen) {
  if (chosen.size() != 2) return chosen;
  const std::vector<NodeId> path = pathOf(skeleton, chosen);
  if (path.size() < 3) return chosen;
  return {path.begin() + 1, path.end() - 1};
}

void smoothOut(PlantDocument& document, const NodeTarget& target) {
  const double width = meanEdgeLength(document.skeleton());
  if (width == 0)
    throw Error(StructureEditText::tr("the plant has no edge to smooth along").toStdString());
  const std::vector<NodeId> nodes = meantToSmooth(document.skeleton(), target.nodes);
  document.edit(StructureEditText::tr("Smooth %1").arg(nodeNames(nodes)),
                [&](SkeletonEditor& editor) { smooth(editor, nodes, width); });
}

auto resampleBy(double factor) {
  return [factor](PlantDocument& document, const NodeTarget& target) {
    const double spacing = pathSpacing(document.skeleton(), target.nodes);
    if (spacing == 0)
      throw Error(StructureEditText::tr("there is no edge between the ends").toStdString());
    resamplePath(document, target.nodes, factor * spacing);
  };
}

std::vector<NodeId> meantToResample(const Skeleton& skeleton, const std::vector<NodeId>& chosen) {
  return chosen.size() > 2 ? chosen : pathOf(skeleton, chosen);
}

} // namespace

std::vector<NodeEdit> treeEdits() {
  const QString menu = StructureEditText::tr("&Tree");
  return {
      {.id = "cut_off",
       .text = StructureEditText::tr("Cut Off"),
       .help = StructureEditText::tr("What the node carries becomes a tree of its own"),
       .icon = "cut",
       .shortcut = Qt::Key_X,
       .apply = cut,
       .menu = menu,
       .takesEdge = true},
      {"join", StructureEditText::tr("Join"),
       StructureEditText::tr(
           "Attaches the tree of the node to the nearest other, or to the last node selected"),
       "join", Qt::Key_J, join, menu},
      {"swap_continuation", StructureEditText::tr("Swap Continuation"),
       StructureEditText::tr("Another child continues the axis of the node"), "", Qt::Key_W,
       swapContinuation, menu},
      {"merge", StructureEditText::tr("Merge Nodes"),
       StructureEditText::tr("Makes one node of several neighbors"), "", QKeySequence(), merge,
       menu},
      {"make_root", StructureEditText::tr("Make Root"),
       StructureEditText::tr("The tree grows from this node"), "", QKeySequence(), makeRoot, menu},
  };
}

std::vector<NodeEdit> pathEdits() {
  const QString menu = pathMenu();
  return {
      {"turn_around", StructureEditText::tr("Turn Around"),
       StructureEditText::tr("The path is attached by its other end"), "", QKeySequence(),
       turnAround, menu},
      {"straighten", StructureEditText::tr("Straighten"),
       StructureEditText::tr("Puts the nodes between the ends on a straight line"), "",
       QKeySequence(),
       onPath(QT_TRANSLATE_NOOP("StructureEdits", "Straighten the path of %1"), straighten), menu},
      {"smooth", StructureEditText::tr("Smooth"),
       StructureEditText::tr(
           "Moves the selected nodes, or those between two, to the mean of their neighbors"),
       "", QKeySequence(), smoothOut, menu},
      {"interpolate_radii", StructureEditText::tr("Interpolate Radii"),
       StructureEditText::tr("Radii between the ends follow from those of the ends"), "",
       QKeySequence(),
       onPath(QT_TRANSLATE_NOOP("StructureEdits", "Interpolate the radii of the path of %1"),
              interpolateRadii),
       menu},
      {"thin_out", StructureEditText::tr("Thin Out"),
       StructureEditText::tr("Removes nodes between the ends; attachments stay"), "",
       QKeySequence(),
       onPath(QT_TRANSLATE_NOOP("StructureEdits", "Thin out the path of %1"), thinOut), menu},
      {"space_evenly", StructureEditText::tr("Space Evenly"),
       StructureEditText::tr("Moves the nodes to equal distances"), "", QKeySequence(),
       resampleBy(1), menu},
      {"more_nodes", StructureEditText::tr("More Nodes"),
       StructureEditText::tr("Twice as many nodes, evenly spaced"), "", QKeySequence(),
       resampleBy(0.5), menu},
      {"fewer_nodes", StructureEditText::tr("Fewer Nodes"),
       StructureEditText::tr("Half as many nodes, evenly spaced"), "", QKeySequence(),
       resampleBy(2), menu},
  };
}

QString pathMenu() {
  return StructureEditText::tr("&Path");
}

void resamplePath(PlantDocument& document, const std::vector<NodeId>& chosen, double step) {
  const std::vector<NodeId> nodes = meantToResample(document.skeleton(), chosen);
  document.edit(StructureEditText::tr("Space the path of %1").arg(nodeNames(chosen)),
                [&](SkeletonEditor& editor) { resample(editor, nodes, step); });
}

double pathSpacing(const Skeleton& skeleton, const std::vector<NodeId>& chosen) {
  const std::vector<NodeId> nodes = meantToResample(skeleton, chosen);
  std::vector<bool> isMeant(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isMeant[indexOf(id)] = true;
  double sum = 0;
  int count = 0;
  for (const NodeId id : nodes) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    if (!parent || !isMeant[indexOf(*parent)]) continue;
    sum += (skeleton[id].position - skeleton[*parent].position).norm();
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

} // namespace espalier
