#include "app/window/review/looked_at.h"

#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/skeleton/review_walk.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCoreApplication>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

namespace espalier {
namespace {

struct LookedAtText {
  Q_DECLARE_TR_FUNCTIONS(LookedAt)
};

/// "Show All Again (Alt+H)"
QString nameOf(const QAction& action) {
  const QString name = QString(action.text()).remove('&');
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  return keys.isEmpty() ? name : QString("%1 (%2)").arg(name, keys);
}

/// Why a node is not seen.
enum class Unseen : std::uint8_t { hidden, clipped, offScreen };

/// Why a node is not in a view as it is drawn now, be it in mid-flight; none: it is.
std::optional<Unseen> whyUnseen(const Eigen::Vector3d& place, const PlantView& view) {
  const Camera& camera = view.currentCamera();
  if (!ClipVolume(view.clip(), view.bounds(), place, camera).contains(Eigen::Vector3f::Zero()))
    return Unseen::clipped;
  const auto at = ScreenMap(camera, {view.width(), view.height()}).project(place);
  if (!at || !QRectF(view.rect()).contains(at->pixel.x(), at->pixel.y())) return Unseen::offScreen;
  return std::nullopt;
}

std::optional<Unseen> whyUnseen(NodeId id, const Seen& seen) {
  if (std::ranges::binary_search(seen.hidden, id)) return Unseen::hidden;
  std::optional<Unseen> first;
  for (const PlantView* view : seen.views) {
    const auto reason = whyUnseen(seen.skeleton[id].position, *view);
    if (!reason) return std::nullopt;
    if (!first) first = reason;
  }
  return first;
}

/// A mark is of the edge, too: as what is seen is convex, so are the places of an edge.
std::optional<Unseen> whyEdgeUnseen(NodeId id, const Seen& seen) {
  if (const auto reason = whyUnseen(id, seen)) return reason;
  const std::optional<NodeId> parent = seen.skeleton[id].parent;
  return parent ? whyUnseen(*parent, seen) : std::nullopt;
}

} // namespace

void requireOneLook(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                    const ActionSet& actions) {
  if (!isOneLook(skeleton, nodes))
    throw Error(LookedAtText::tr(
                    "nothing is marked, as %1 nodes are more than one looks at in one go: walk to "
                    "them by %2, or choose Review > %3")
                    .arg(formatCount(nodes.size()), nameOf(*actions["next_not_reviewed"]),
                         nameOf(*actions["mark_all_selected"]))
                    .toStdString());
  if (!actions["layer_skeleton"]->isChecked())
    throw Error(LookedAtText::tr("nothing is marked, as the skeleton is not shown: choose %1")
                    .arg(nameOf(*actions["layer_skeleton"]))
                    .toStdString());
}

QString unseenText(const Seen& seen, const std::vector<NodeId>& nodes) {
  std::map<Unseen, std::size_t> unseen;
  for (const NodeId id : nodes)
    if (const std::optional<Unseen> reason = whyEdgeUnseen(id, seen)) ++unseen[*reason];
  if (unseen.empty()) return {};
  const auto& [reason, count] = *unseen.begin();
  const QString text = reason == Unseen::hidden    ? LookedAtText::tr("%1 hidden")
                       : reason == Unseen::clipped ? LookedAtText::tr("%1 clipped away")
                                                   : LookedAtText::tr("%1 outside the view");
  if (nodes.size() == 1) return text.arg(LookedAtText::tr("%1 was").arg(nodeName(nodes.front())));
  return text.arg((count == 1 ? LookedAtText::tr("%1 of the %2 nodes selected was")
                              : LookedAtText::tr("%1 of the %2 nodes selected were"))
                      .arg(formatCount(count), formatCount(nodes.size())));
}

bool areSeen(const Seen& seen, const std::vector<Eigen::Vector3d>& places) {
  return std::ranges::all_of(places, [&](const Eigen::Vector3d& place) {
    return std::ranges::any_of(seen.views,
                               [&](const PlantView* view) { return !whyUnseen(place, *view); });
  });
}

} // namespace espalier
