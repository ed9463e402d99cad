#include "app/window/view/hull_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/mtg/feature_edits.h"
#include "core/surface/subtree_hulls.h"
#include "ui/document/plant_document.h"
#include "ui/panels/unit_rows.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QMenu>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace espalier {
namespace {

std::string textOf(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 7)
          .ptr; // more digits than the points have
  return {text.data(), end};
}

} // namespace

HullFlow::HullFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Hulls"));
  parts_.actions.add({.id = "wrap_hull",
                      .text = tr("Convex Hull of Branch"),
                      .help = tr("Wraps the points of all that the node carries, and keeps the "
                                 "volume as its feature hull_volume"),
                      .keys = QKeySequence(Qt::SHIFT | Qt::Key_V),
                      .refusal = Refusal::atPointer,
                      .menu = "skeleton/hulls"},
                     [this] { wrap(); });
  parts_.actions.add({.id = "remove_hull",
                      .text = tr("Remove Convex Hull"),
                      .help = tr("Takes the hull and its volume off the node"),
                      .refusal = Refusal::atPointer,
                      .menu = "skeleton/hulls"},
                     [this] { unwrap(); });
  parts_.actions.place("context/hulls", [this](QMenu& menu) {
    if (!parts_.editing.nodeUnder()) return;
    menu.addSeparator();
    parts_.actions.fill(menu, "skeleton/hulls");
  });
  timer_.setSingleShot(true);
  timer_.setInterval(50); // [ms]: a drag is followed when it rests
  connect(&timer_, &QTimer::timeout, this, &HullFlow::work);
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, this, &HullFlow::follow);
  const auto anew = [this] {
    asked_.clear();
    follow();
  };
  connect(&document, &PlantDocument::skeletonReplaced, this, anew);
  connect(&document, &PlantDocument::scanChanged, this, anew);
  connect(&document, &PlantDocument::unitChanged, this, &HullFlow::follow);
  connect(&parts_.distances, &ScanDistances::changed, this, &HullFlow::follow);
  connect(&job_, &JobSlot::failed, this, &HullFlow::noted);
  connect(&job_, &JobSlot::finished, this, [this] {
    if (std::exchange(isJobOutdated_, false)) work();
  });
  refreshEnabled();
}

/// The node under the pointer if nothing is selected; of those selected, the ones that bear the
/// others: a branch that is selected as a whole has one hull.
std::vector<NodeId> HullFlow::chosen() const {
  const Selection& selection = parts_.document.selection();
  std::vector<NodeId> nodes = selection.nodes();
  if (nodes.empty())
    if (const std::optional<NodeId> under = parts_.editing.nodeUnder()) nodes = {*under};
  if (nodes.empty())
    throw Error(tr("put the pointer on a branch, or select its first node").toStdString());
  const Skeleton& skeleton = parts_.document.skeleton();
  std::erase_if(nodes, [&](NodeId id) {
    const std::optional<NodeId> parent = skeleton[id].parent;
    return parent && selection.contains(*parent);
  });
  return nodes;
}

void HullFlow::wrap() {
  parts_.document.requireEditable();
  if (parts_.document.scan() == nullptr)
    throw Error(tr("there are no points to wrap: open the scan first").toStdString());
  asked_ = chosen();
  work();
}

void HullFlow::unwrap() {
  parts_.document.requireEditable();
  const std::vector<NodeId> have = nodesWithFeature(parts_.document.skeleton(), feature);
  std::vector<NodeId> nodes = chosen();
  std::erase_if(nodes, [&](NodeId id) { return !std::ranges::binary_search(have, id); });
  if (nodes.empty())
    throw Error(
        tr("this node has no convex hull: choose the one that the branch begins at").toStdString());
  parts_.document.edit(tr("Remove convex hull"), [&](SkeletonEditor& editor) {
    for (const NodeId id : nodes)
      setNodeFeature(editor, id, {{feature, "REAL"}, {}}, baseOf(parts_.document));
  });
}

void HullFlow::follow() {
  refreshEnabled();
  timer_.start();
}

/// Makes the hulls that are asked for, and those that the plant has.
void HullFlow::work() {
  timer_.stop();
  const Skeleton& skeleton = parts_.document.skeleton();
  std::erase_if(asked_, [&](NodeId id) { return !skeleton.contains(id); });
  nodes_ = nodesWithFeature(skeleton, feature);
  for (const NodeId id : asked_)
    if (!std::ranges::binary_search(nodes_, id)) nodes_.push_back(id);
  parts_.distances.setWanted(ScanDistances::Use::hulls, !nodes_.empty());
  if (job_.isBusy()) {
    isJobOutdated_ = true;
    job_.cancel();
    return;
  }
  const std::shared_ptr<const PointDistances> distances = parts_.distances.now();
  if (nodes_.empty() || !distances) { // changed() follows when they are ready
    show({});
    return;
  }
  job_.start(
      tr("Convex hulls"),
      [distances, skeleton, nodes = nodes_](const Progress& progress) {
        return subtreeHulls(*distances, skeleton, nodes, progress);
      },
      [this](const Hulls& hulls) { take(hulls); });
}

void HullFlow::take(const Hulls& hulls) {
  show(hulls);
  if (!asked_.empty()) job_.afterwards([this, hulls] { keepVolumes(hulls); });
}

/// Of those asked for, as one step.
void HullFlow::keepVolumes(const Hulls& hulls) {
  const std::vector<NodeId> asked = std::exchange(asked_, {});
  std::vector<std::pair<NodeId, double>> volumes;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (hulls[i] && std::ranges::find(asked, nodes_[i]) != asked.end() &&
        parts_.document.skeleton().contains(nodes_[i]))
      volumes.emplace_back(nodes_[i], hulls[i]->volume);
  if (volumes.empty()) {
    emit noted(tr("No hull: the points of this branch lie in a plane, or there are fewer than 4"));
    return;
  }
  const auto change = [&](SkeletonEditor& editor) {
    for (const auto& [id, volume] : volumes)
      setNodeFeature(editor, id, {{feature, "REAL"}, textOf(volume)}, baseOf(parts_.document));
  };
  parts_.actions.guarded(
      [&] {
        parts_.document.edit(tr("Convex hull of branch"), change);
        return true;
      },
      Refusal::atPointer);
}

void HullFlow::show(const Hulls& hulls) {
  std::vector<ShownHull> shown;
  for (const std::optional<ConvexHull>& hull : hulls)
    if (hull) shown.push_back({*hull, formatVolume(hull->volume, parts_.document.unit())});
  parts_.view.setHulls(std::move(shown));
}

void HullFlow::refreshEnabled() {
  const bool hasBoth = parts_.document.scan() != nullptr && !parts_.document.skeleton().isEmpty();
  parts_.actions["wrap_hull"]->setEnabled(hasBoth);
  parts_.actions["remove_hull"]->setEnabled(!parts_.document.skeleton().isEmpty());
}

} // namespace espalier
