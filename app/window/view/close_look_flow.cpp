#include "app/window/view/close_look_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/view/two_views_flow.h"
#include "core/base/error.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/path_edits.h"
#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace espalier {
namespace {

constexpr double edgesAround = 5;     // mean edges that are shown about what is looked at
constexpr double spacingsAround = 45; // the same of a preview: five edges of the usual bins

/// The node with its parent and its children.
void addWithNeighbors(std::vector<NodeId>& nodes, const Skeleton& skeleton, NodeId id) {
  nodes.push_back(id);
  if (skeleton[id].parent) nodes.push_back(*skeleton[id].parent);
  nodes.insert(nodes.end(), skeleton.children(id).begin(), skeleton.children(id).end());
}

/// The wood whose surface is nearest to a place.
struct NearestWood {
  NodeId node;
  double distance; // [L]
};

NearestWood nearestWood(const Skeleton& skeleton, const std::vector<NodeId>& among,
                        const Eigen::Vector3d& place) {
  NearestWood nearest{among.front(), std::numeric_limits<double>::infinity()};
  for (const NodeId id : among) {
    const std::optional<Frustum> body = frustumOf(skeleton, id);
    if (!body) continue;
    const double share = body->nearestShare(place);
    const double distance = (body->at(share) - place).norm() - body->radiusAt(share);
    if (distance < nearest.distance) nearest = {id, distance};
  }
  return nearest;
}

/// A point that no wood explains, with all that are connected with it up to the wood, and that
/// wood: a branch that is missing.
void addMissing(Sight& sight, const Skeleton& skeleton, const Scan& scan) {
  constexpr std::size_t most = 2000; // points
  const Eigen::Vector3d place = sight.places.front();
  const double reach = CheckOptions().pointReach * scan.spacing();
  const Eigen::Vector3d origin = scan.cloud()->origin();
  std::vector<NodeId> near; // wood that the points may come to
  const double wide = 20 * meanEdgeLength(skeleton);
  for (const NodeId id : skeleton.ids())
    if ((skeleton[id].position - place).norm() <= wide) near.push_back(id);
  if (near.empty() || nearestWood(skeleton, near, place).distance <= reach) return;
  std::set<Eigen::Index> met;
  std::vector<Eigen::Vector3d> open = {place};
  NearestWood foot{near.front(), std::numeric_limits<double>::infinity()};
  while (!open.empty() && met.size() < most) {
    const Eigen::Vector3d at = open.back();
    open.pop_back();
    const auto gap = static_cast<float>(CheckOptions().clusterGap * scan.spacing());
    for (const Neighbor& point : scan.index().within((at - origin).cast<float>(), gap)) {
      if (!met.insert(point.index).second) continue;
      const Eigen::Vector3d next = scan.cloud()->position(point.index);
      const NearestWood wood = nearestWood(skeleton, near, next);
      if (wood.distance < foot.distance) foot = wood;
      if (wood.distance <= reach || (next - place).norm() > wide) continue;
      open.push_back(next);
      sight.places.push_back(next);
    }
  }
  sight.nodes.push_back(foot.node);
  if (const auto parent = skeleton[foot.node].parent) sight.nodes.push_back(*parent);
}

/// What is nearest around the pointer: one who points beside a twig means it, and not what is
/// selected elsewhere.
Pick besidePointer(const PlantView& view, const QPointF& pointer) {
  constexpr int directions = 12;
  for (const double away : {12.0, 24.0, 36.0}) { // [logical pixels]; nearer ones are picked
    Pick point;
    for (int turn = 0; turn < directions; ++turn) {
      const double angle = 2 * std::numbers::pi * turn / directions;
      Pick pick = view.pick(pointer + away * QPointF(std::cos(angle), std::sin(angle)));
      if (pick.node || pick.edge) return pick;
      if (pick.point) point = pick;
    }
    if (point.point) return point;
  }
  return {};
}

/// Of a point alone, with what is around it.
Sight sightOfPoint(const Eigen::Vector3d& place, const Scan& scan, bool isOfOther) {
  return {.nodes = {},
          .places = {place},
          .margin = spacingsAround * scan.spacing(),
          .isOfOther = isOfOther};
}

} // namespace

Sight sightOf(const Skeleton& skeleton, const Pick& pick, const Scan* scan) {
  Sight sight{.nodes = {}, .margin = edgesAround * meanEdgeLength(skeleton)};
  if (pick.node && skeleton.contains(*pick.node)) {
    addWithNeighbors(sight.nodes, skeleton, *pick.node);
  } else if (pick.edge && skeleton.contains(pick.edge->child)) {
    sight.nodes.push_back(pick.edge->child);
    if (const auto parent = skeleton[pick.edge->child].parent) sight.nodes.push_back(*parent);
  } else if (pick.point && pick.isOfOther && scan != nullptr) {
    sight = sightOfPoint(*pick.point, *scan, true);
  } else if (pick.point && skeleton.isEmpty() && scan != nullptr) {
    sight = sightOfPoint(pick.pointOfThing.value_or(*pick.point), *scan, false);
  } else if (pick.point && !skeleton.isEmpty()) {
    sight.places.push_back(pick.pointOfThing.value_or(*pick.point));
    if (scan != nullptr) addMissing(sight, skeleton, *scan);
  }
  return sight;
}

Sight sightOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Sight sight{.nodes = {}, .margin = edgesAround * meanEdgeLength(skeleton)};
  for (const NodeId id : nodes)
    addWithNeighbors(sight.nodes, skeleton, id);
  const std::set<NodeId> once(sight.nodes.begin(), sight.nodes.end());
  sight.nodes.assign(once.begin(), once.end());
  return sight;
}

CloseLookFlow::CloseLookFlow(const Parts& parts) : parts_(parts) {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("View"));
  actions.add(
      {.id = "look_closely",
       .text = tr("Look Closely"),
       .help = tr("Shows what is under the pointer, or selected, from where it is seen best"),
       .keys = Qt::Key_Z,
       .refusal = Refusal::atPointer,
       .menu = "view/look"},
      [this] { look(); });
  actions.add({.id = "look_back",
               .text = tr("Look Back"),
               .help = tr("Goes back to where one looked closely from"),
               .keys = QKeySequence(Qt::SHIFT | Qt::Key_Z),
               .refusal = Refusal::atPointer,
               .menu = "view/look"},
              [this] { goBack(); });
}

void CloseLookFlow::look() {
  const Skeleton& skeleton = parts_.document.skeleton();
  PlantView& from = parts_.editing.activeView();
  Sight sight = sightOf(skeleton, parts_.editing.under(), parts_.document.scan());
  if (const auto pointer = parts_.editing.pointer(); pointer && sight.isEmpty())
    sight = sightOf(skeleton, besidePointer(from, *pointer), parts_.document.scan());
  if (sight.isEmpty()) sight = sightOf(skeleton, parts_.document.selection().nodes());
  if (sight.isEmpty())
    throw Error(tr("put the pointer on the plant, or select nodes to look at").toStdString());
  PlantView& to = parts_.twoViews.showsWhole(from) ? parts_.view : from;
  constexpr std::size_t most = 50;
  if (before_.size() == most) before_.erase(before_.begin());
  before_.push_back({&to, to.camera()});
  to.flyTo(to.cameraToSee(sight), focusOn(skeleton, sight));
}

void CloseLookFlow::goBack() {
  std::erase_if(before_, [](const Place& place) { return place.view.isNull(); });
  if (before_.empty())
    throw Error(tr("there is no view to go back to: look closely first").toStdString());
  const Place place = before_.back();
  before_.pop_back();
  place.view->flyTo(place.camera);
}

} // namespace espalier
