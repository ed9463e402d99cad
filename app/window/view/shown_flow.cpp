#include "app/window/view/shown_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/view/empty_view.h"
#include "core/base/error.h"
#include "core/skeleton/axes.h"
#include "ui/document/plant_document.h"
#include "ui/panels/clip_panel.h"
#include "ui/view/moved_clip.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <unordered_set>

namespace espalier {

ShownFlow::ShownFlow(const Parts& parts)
    : document_(parts.document), view_(parts.view), actions_(parts.actions),
      editing_(parts.editing), window_(parts.window) {
  view_.setFocusFade(window_.settings.value("view/focus_fade", view_.focusFade()).toDouble());
  addActions();
  makePanel();
  connect(&document_, &PlantDocument::skeletonReplaced, this, [this] {
    hidden_.clear(); // the view has forgotten them, too
    refreshEnabled();
    emit hiddenChanged();
  });
  for (auto signal :
       {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged, &PlantDocument::unitChanged})
    connect(&document_, signal, this, &ShownFlow::refreshPanel);
  connect(&view_, &PlantView::clipChanged, this, [this] {
    refreshPanel();
    refreshEnabled();
  });
  refreshEnabled();
  sayWhyEmpty(view_, actions_);
}

void ShownFlow::addActions() {
  actions_.beginSection(tr("View"));
  actions_.add({.id = "hide",
                .text = tr("Hide"),
                .help = tr("Hides the selected nodes, or the axis under the pointer, and the "
                           "points of their wood"),
                .keys = Qt::Key_H,
                .refusal = Refusal::atPointer,
                .menu = "view/hide"},
               [this] { hide(); });
  actions_.add({.id = "isolate",
                .text = tr("Isolate"),
                .help = tr("Hides all but the selected nodes, or the axis under the pointer, "
                           "and the points of their wood"),
                .keys = QKeySequence(Qt::SHIFT | Qt::Key_H),
                .refusal = Refusal::atPointer,
                .menu = "view/hide"},
               [this] { isolate(); });
  actions_.add({.id = "show_all",
                .text = tr("Show All Again"),
                .help = tr("Shows what is hidden or clipped"),
                .keys = QKeySequence(Qt::ALT | Qt::Key_H),
                .menu = "view/show_all"},
               [this] { showAll(); });
  actions_.add({.id = "select_shown_points",
                .text = tr("Select Points Shown"),
                .help = tr("Selects all points that are not hidden, in the slab and the box of "
                           "Clipping")},
               [this] { selectShownPoints(); });
  actions_.place("context/shown", {"", "hide", "isolate", "show_all"});
}

void ShownFlow::makePanel() {
  panel_ = new ClipPanel;
  PanelDock::Place place = besideThePlant;
  place.isTab = false;
  const PanelDock* dock =
      addDock(new PanelDock(window_,
                            {.id = "clipping",
                             .title = tr("Clipping"),
                             .text = tr("Clipping…"),
                             .help = tr("Shows a slab or a box of the plant, and fades its back"),
                             .keys = {},
                             .menu = "view/clipping",
                             .manual = "looking.md#hide-and-clip"},
                            place, panel_, this));
  connect(dock, &PanelDock::shown, this, [this](bool isShown) {
    if (isShown) refreshPanel();
    view_.setClipHandlesShown(isShown);
  });
  connect(panel_, &ClipPanel::changed, this, &ShownFlow::clipAsPanelSays);
  connect(panel_, &ClipPanel::showAllRequested, actions_["show_all"], &QAction::trigger);
}

std::vector<NodeId> ShownFlow::meant() const {
  if (!document_.selection().isEmpty()) return document_.selection().nodes();
  const std::optional<NodeId> under = editing_.nodeUnder();
  if (under)
    for (const Axis& axis : axes(document_.skeleton()))
      if (std::ranges::find(axis, *under) != axis.end()) return axis;
  throw Error(tr("put the pointer on a branch, or select nodes").toStdString());
}

void ShownFlow::hide() {
  std::vector<NodeId> nodes = meant();
  nodes.insert(nodes.end(), hidden_.begin(), hidden_.end());
  setHidden(nodes);
}

void ShownFlow::isolate() {
  const std::vector<NodeId> kept = meant();
  const std::unordered_set<NodeId> stays(kept.begin(), kept.end());
  std::vector<NodeId> nodes = document_.skeleton().ids();
  std::erase_if(nodes, [&](NodeId id) { return stays.contains(id); });
  setHidden(nodes);
}

std::vector<NodeId> ShownFlow::shownNodes() const {
  std::vector<NodeId> nodes = document_.skeleton().ids();
  std::erase_if(nodes, [&](NodeId id) { return std::ranges::binary_search(hidden_, id); });
  return nodes;
}

void ShownFlow::setHidden(const std::vector<NodeId>& nodes) {
  hidden_ = nodes;
  std::ranges::sort(hidden_);
  const auto [first, last] = std::ranges::unique(hidden_);
  hidden_.erase(first, last);
  std::erase_if(hidden_, [&](NodeId id) { return !document_.skeleton().contains(id); });
  view_.setHiddenNodes(hidden_);
  // What is not seen is not to be edited by a key.
  std::vector<NodeId> chosen = document_.selection().nodes();
  std::erase_if(chosen, [&](NodeId id) { return std::ranges::binary_search(hidden_, id); });
  document_.selection().set(std::move(chosen));
  view_.hoverAgain();
  refreshEnabled();
  emit hiddenChanged();
}

void ShownFlow::showAll() {
  view_.setClip({});
  view_.setDepthFade(0);
  view_.focusOff();
  setHidden({});
  refreshPanel();
}

QString ShownFlow::reveal(const std::vector<NodeId>& nodes,
                          const std::vector<Eigen::Vector3d>& places, const Camera& camera) {
  QStringList done;
  std::vector<NodeId> stillHidden = hidden_;
  std::erase_if(stillHidden,
                [&](NodeId id) { return std::ranges::find(nodes, id) != nodes.end(); });
  if (stillHidden.size() < hidden_.size()) {
    done.append(tr("what was hidden here is shown again"));
    setHidden(stillHidden);
  }
  std::vector<Eigen::Vector3d> meant = places;
  for (const NodeId id : nodes)
    meant.push_back(document_.skeleton()[id].position);
  const Clip before = view_.clip();
  const Clip after = movedToShow(before, meant, view_.bounds(), camera);
  if (after.slab != before.slab) done.append(tr("the slab was moved to what you fly to"));
  if (before.box &&
      (after.box->min() != before.box->min() || after.box->max() != before.box->max()))
    done.append(tr("the box was moved to what you fly to"));
  if (done.isEmpty()) return {};
  view_.setClip(after);
  QString text = done.join(tr("; "));
  text[0] = text[0].toUpper();
  return withKeys(text + tr("   {show_all} shows all of the plant"), actions_);
}

void ShownFlow::clipAsPanelSays() {
  const ClipPanel::Values values = panel_->values();
  Clip clip;
  if (values.hasSlab) clip.slab = Clip::Slab{values.nearest, values.farthest};
  if (values.hasBox) clip.box = values.box;
  view_.setClip(clip);
  view_.setDepthFade(values.fade);
  view_.setFocusFade(values.around);
  window_.settings.setValue("view/focus_fade", values.around);
  refreshEnabled();
}

void ShownFlow::refreshPanel() {
  panel_->setBounds(view_.bounds());
  panel_->setUnit(symbol(document_.unit()));
  const Clip& clip = view_.clip();
  const Clip::Slab slab = clip.slab.value_or(Clip::Slab{});
  panel_->setValues({.hasSlab = clip.slab.has_value(),
                     .nearest = slab.nearest,
                     .farthest = slab.farthest,
                     .hasBox = clip.box.has_value(),
                     .box = clip.box.value_or(Eigen::AlignedBox3d()),
                     .fade = view_.depthFade(),
                     .around = view_.focusFade()});
}

void ShownFlow::selectShownPoints() {
  document_.pointSelection().set(PointSet::of(view_.pointsShown()));
  const std::size_t count = document_.pointSelection().points().size();
  emit noted(count == 0 ? tr("No point is shown")
                        : tr("%1 points selected").arg(formatCount(count)));
}

void ShownFlow::setPlantShown(bool isShown) {
  for (const char* id : {"hide", "isolate", "show_clipping", "select_shown_points"})
    actions_[id]->setEnabled(isShown);
}

QString ShownFlow::count() const {
  return hidden_.empty() ? QString() : tr("%1 hidden").arg(formatCount(hidden_.size()));
}

void ShownFlow::setPointsIsolated(bool areIsolated) {
  arePointsIsolated_ = areIsolated;
  refreshEnabled();
}

void ShownFlow::refreshEnabled() {
  const bool isPart =
      !hidden_.empty() || arePointsIsolated_ || !view_.clip().isAll() || view_.depthFade() > 0;
  actions_["show_all"]->setEnabled(isPart);
  emit countChanged();
}

} // namespace espalier
