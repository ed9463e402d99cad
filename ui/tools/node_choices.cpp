#include "ui/tools/node_choices.h"

#include "core/base/error.h"
#include "core/skeleton/duplicates.h"
#include "core/skeleton/select.h"
#include "ui/tools/node_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {
namespace {

struct NodeChoiceText {
  Q_DECLARE_TR_FUNCTIONS(NodeChoices)
};

using Nodes = std::vector<NodeId>;

Nodes path(const Skeleton& skeleton, const Nodes& nodes) {
  if (nodes.size() < 2)
    throw Error(
        NodeChoiceText::tr("a path has two ends: select a first and a last node").toStdString());
  return pathBetween(skeleton, nodes.front(), nodes.back());
}

Nodes similar(const Skeleton& skeleton, const Nodes& nodes) {
  constexpr double share = 0.2;
  return ofSimilarRadius(skeleton, nodes, share);
}

Nodes required(Nodes found, const QString& none) {
  if (found.empty()) throw Error(none.toStdString());
  return found;
}

Nodes unreviewed(const Skeleton& skeleton, const Nodes& /*nodes*/) {
  return required(notReviewed(skeleton),
                  NodeChoiceText::tr("all nodes are reviewed: there is nothing to select"));
}

Nodes twins(const Skeleton& skeleton, const Nodes& /*nodes*/) {
  return required(duplicatedNodes(skeleton, duplicateTolerance(skeleton)),
                  NodeChoiceText::tr("no two nodes lie together: there is nothing to select"));
}

Nodes twinBranches(const Skeleton& skeleton, const Nodes& /*nodes*/) {
  return required(
      duplicatedBranches(skeleton, 2 * duplicateTolerance(skeleton)),
      NodeChoiceText::tr("no branch runs along another one: there is nothing to select"));
}

/// From the last node selected; from none, to the root of the first tree.
template <NodeStep step> Nodes stepped(const Skeleton& skeleton, const Nodes& nodes) {
  if (nodes.empty()) {
    const std::vector<NodeId> ids = skeleton.ids();
    const auto root =
        std::ranges::find_if(ids, [&](NodeId id) { return !skeleton[id].parent.has_value(); });
    return {*root};
  }
  if (const auto next = stepFrom(skeleton, nodes.back(), step)) return {*next};
  const QString none = step == NodeStep::child    ? NodeChoiceText::tr("%1 has no child")
                       : step == NodeStep::parent ? NodeChoiceText::tr("%1 is a root")
                                                  : NodeChoiceText::tr("%1 has no sibling");
  throw Error(none.arg(nodeName(nodes.back())).toStdString());
}

} // namespace

std::vector<NodeChoice> nodeChoices() {
  return {
      {"select_downstream",
       NodeChoiceText::tr("Select &Downstream"),
       NodeChoiceText::tr("The node and all that it carries"),
       {Qt::Key_1},
       downstream},
      {"select_to_root",
       NodeChoiceText::tr("Select to &Root"),
       NodeChoiceText::tr("The node and all that carries it"),
       {Qt::Key_2},
       upstream},
      {"select_axis",
       NodeChoiceText::tr("Select A&xis"),
       NodeChoiceText::tr("The whole axis of the node"),
       {Qt::Key_3},
       axesThrough},
      {"select_order",
       NodeChoiceText::tr("Select &Order"),
       NodeChoiceText::tr("All nodes of the same order"),
       {Qt::Key_4},
       ofSameOrder},
      {"select_tree",
       NodeChoiceText::tr("Select &Tree"),
       NodeChoiceText::tr("All that is connected with the node"),
       {Qt::Key_5},
       treesOf},
      {"invert_selection",
       NodeChoiceText::tr("&Invert Selection"),
       NodeChoiceText::tr("All other nodes"),
       {Qt::Key_6},
       inverted,
       false},
      {"select_unreviewed",
       NodeChoiceText::tr("Select &Unreviewed"),
       NodeChoiceText::tr("All nodes that are to do or doubtful"),
       {Qt::Key_7},
       unreviewed,
       false},
      {},
      {"select_path",
       NodeChoiceText::tr("Select &Path Between"),
       NodeChoiceText::tr("All nodes from the first to the last one selected"),
       {Qt::Key_8},
       path},
      {"select_similar",
       NodeChoiceText::tr("Select &Similar Radius"),
       NodeChoiceText::tr("All nodes whose radius is within 20 %"),
       {},
       similar},
      {"grow_selection",
       NodeChoiceText::tr("&Grow Selection"),
       NodeChoiceText::tr("Adds the nodes that are linked to it"),
       {Qt::Key_Plus, Qt::Key_Equal},
       grown},
      {"shrink_selection",
       NodeChoiceText::tr("Shri&nk Selection"),
       NodeChoiceText::tr("Leaves out its nodes at the border"),
       {Qt::Key_Minus},
       shrunk},
      {},
      {"step_to_child",
       NodeChoiceText::tr("To Child"),
       NodeChoiceText::tr(
           "On along the axis, from the node that is selected; from none, to a root"),
       {Qt::Key_Up},
       stepped<NodeStep::child>,
       false,
       true},
      {"step_to_parent",
       NodeChoiceText::tr("To Parent"),
       NodeChoiceText::tr("Back along the axis, or to what bears it"),
       {Qt::Key_Down},
       stepped<NodeStep::parent>,
       false,
       true},
      {"step_to_next_sibling",
       NodeChoiceText::tr("To Next Sibling"),
       NodeChoiceText::tr("To the next child of the same parent"),
       {Qt::Key_Right},
       stepped<NodeStep::nextSibling>,
       false,
       true},
      {"step_to_previous_sibling",
       NodeChoiceText::tr("To Previous Sibling"),
       NodeChoiceText::tr("To the child before of the same parent"),
       {Qt::Key_Left},
       stepped<NodeStep::previousSibling>,
       false,
       true},
      {},
      {"select_duplicates",
       NodeChoiceText::tr("Select Duplicated Nodes"),
       NodeChoiceText::tr("Nodes nearer to each other than a quarter of an edge"),
       {},
       twins,
       false},
      {"select_duplicated_branches",
       NodeChoiceText::tr("Select Duplicated Branches"),
       NodeChoiceText::tr("Branches that run along another one"),
       {},
       twinBranches,
       false},
  };
}

} // namespace espalier
