#include "ui/view/plant_view_parts.h"
#include "ui/view/seen_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {

void PlantView::setHiddenNodes(const std::vector<NodeId>& nodes) {
  parts_->scene.skeleton.setHidden(nodes);
  parts_->redrawSkeleton();
}

void PlantView::setNodeColors(std::optional<NodeColors> colors) {
  parts_->scene.setNodeColors(std::move(colors));
  parts_->redraw();
}

void PlantView::setReference(const Skeleton& reference) {
  showAttachment(std::nullopt);
  parts_->scene.reference.select({});
  parts_->scene.setReference(reference);
  parts_->redraw();
}

void PlantView::setMovedScan(const std::optional<ShownScan>& scan) {
  if (!scan && !parts_->scene.moved.isShown()) return;
  parts_->scene.setMovedScan(scan);
  parts_->redraw();
}

void PlantView::setReferenceColors(std::optional<NodeColors> colors) {
  parts_->scene.setReferenceColors(std::move(colors));
  parts_->redraw();
}

void PlantView::setReferenceSelection(const std::vector<NodeId>& nodes) {
  parts_->scene.reference.select(nodes);
  parts_->redrawSkeleton();
}

void PlantView::Parts::giveWay() {
  if (!mayBeInTheWay || owner.isInGesture()) return;
  mayBeInTheWay = false;
  setUpOverlay();
  const OnScreen plant = plantOnScreen(scene, pointer.screen());
  overlay.giveWay(scene, plant, owner.size(), QFontMetricsF(owner.font(), overlayWidget));
  overlayWidget->update();
  refreshColorBars();
  if (minimap != nullptr) minimap->giveWay(plant, owner.size(), overlay.corners());
}

void PlantView::Parts::refreshColorBars() {
  const std::vector<Legend> legends =
      isFirst() ? legendsOf(scene, shared->unit, shared->seenSides()) : std::vector<Legend>();
  const std::vector<LegendBox> boxes = legendBoxes(
      legends, owner.size(), QFontMetricsF(owner.font(), overlayWidget), overlay.legendsIn);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < legends.size() && !scene.bounds().isEmpty(); ++i) {
    if (!legends[i].categories.empty()) continue;
    if (shown == colorBars.size()) colorBars.push_back(makeColorBar());
    const auto chosen = scene.colorScales.ranges.find(legends[i].id);
    const bool isChosen = chosen != scene.colorScales.ranges.end();
    colorBars[shown++]->showLegend(
        legends[i], boxes[i], isChosen ? std::optional(chosen->second) : std::nullopt, scene.dark);
  }
  for (; shown < colorBars.size(); ++shown)
    colorBars[shown]->hide();
}

ColorBar* PlantView::Parts::makeColorBar() {
  auto* bar = new ColorBar(&owner);
  connect(bar, &ColorBar::entered, &owner, [this] { pointer.leave(); });
  connect(bar, &ColorBar::rangeChosen, &owner,
          [this](const QString& id, std::optional<ValueRange> range, bool isFinal) {
            ColorScales scales = scene.colorScales;
            scales.ranges.erase(id);
            if (range) scales.ranges.emplace(id, *range);
            scene.setColorScales(scales);
            redraw();
            if (isFinal) emit owner.colorScalesChanged();
          });
  return bar;
}

ColorBar* PlantView::Parts::draggedColorBar() const {
  const auto dragged = std::ranges::find_if(colorBars, &ColorBar::isDragging);
  return dragged != colorBars.end() ? *dragged : nullptr;
}

void PlantView::Parts::refreshMinimap() {
  if (minimap == nullptr) return;
  minimap->showCamera(navigator.camera());
  minimap->setVisible(Minimap::fits(owner.size()) && minimap->showsMore());
}

void PlantView::setMinimapShown(bool isShown) {
  for (Parts* view : parts_->shared->views) {
    if (isShown == (view->minimap != nullptr)) continue;
    delete std::exchange(view->minimap, isShown ? view->makeMinimap() : nullptr);
    view->refreshMinimap();
  }
}

Minimap* PlantView::Parts::makeMinimap() {
  auto* map = new Minimap(scene, &owner);
  map->place(owner.size());
  connect(map, &Minimap::drawnAnew, &owner, [this] { refreshMinimap(); });
  map->noteChange();
  connect(map, &Minimap::entered, &owner, [this] { pointer.leave(); });
  connect(map, &Minimap::moveAsked, &owner, [this](const Eigen::Vector3d& focus) {
    Camera camera = navigator.camera();
    camera.focus = focus;
    navigator.set(camera);
  });
  connect(map, &Minimap::canceled, &owner, [this](const Camera& before) { navigator.set(before); });
  return map;
}

/// Only where they would be clearly others: a small step of the camera changes no color.
void PlantView::Parts::spanSeen() {
  if (!isFirst()) return;
  const std::optional<ValueRange> now = scene.seenRange;
  const std::optional<ValueRange> seen =
      shared->doColorsSpanSeen && shared->views.size() == 1 // else all have the same colors
          ? seenRange(scene, pointer.screen())
          : std::nullopt;
  if (!now && !seen) return;
  constexpr double little = 0.15; // of the range
  if (now && seen) {
    const double change = std::abs(now->from - seen->from) + std::abs(now->to - seen->to);
    if (change < little * (now->to - now->from)) return;
  }
  scene.setSeenRange(seen);
  redraw();
}

void PlantView::setColorsSpanSeen(bool doSpan) {
  if (doSpan == parts_->shared->doColorsSpanSeen) return;
  parts_->shared->doColorsSpanSeen = doSpan;
  parts_->spanSeen();
}

void PlantView::setColorScales(const ColorScales& scales) {
  if (scales == parts_->scene.colorScales) return;
  parts_->scene.setColorScales(scales);
  parts_->redraw();
}

const ColorScales& PlantView::colorScales() const {
  return parts_->scene.colorScales;
}

bool PlantView::typeColorRange() {
  const auto shown = std::ranges::find_if(parts_->colorBars, &QWidget::isVisible);
  if (shown == parts_->colorBars.end()) return false;
  (*shown)->type(ColorBar::End::to);
  return true;
}

void PlantView::setFaded(const std::optional<std::vector<NodeId>>& allBut) {
  parts_->scene.skeleton.setFaded(allBut);
  parts_->redrawSkeleton();
}

void PlantView::setPointStates(std::shared_ptr<const std::vector<PointState>> states) {
  Q_ASSERT(!states || std::ssize(*states) == parts_->scene.points.size());
  parts_->scene.setPointStates(std::move(states));
  parts_->redraw();
}

void PlantView::setPointValues(std::optional<PointValues> values) {
  Q_ASSERT(!values || std::ssize(*values->values) == parts_->scene.points.size());
  parts_->scene.setPointValues(std::move(values));
  parts_->redraw();
}

Eigen::AlignedBox3d PlantView::bounds() const {
  return parts_->scene.bounds();
}

void PlantView::setLayerVisible(Layer layer, bool visible) {
  switch (layer) {
  case Layer::points:
    parts_->scene.points.visible = visible;
    break;
  case Layer::contracted:
    parts_->scene.contracted.visible = visible;
    break;
  case Layer::skeleton:
    parts_->scene.skeletonVisible = visible;
    break;
  case Layer::reference:
    parts_->scene.referenceVisible = visible;
    break;
  }
  parts_->redraw();
}

void PlantView::setPointColor(PointColor color) {
  parts_->scene.setPointColor(color);
  parts_->redraw();
}

void PlantView::setPointSize(int pixels) {
  parts_->scene.pointSize = std::clamp(pixels, 1, 10);
  parts_->redraw();
}

void PlantView::setHulls(std::vector<ShownHull> hulls) {
  parts_->shared->hulls = std::move(hulls);
  for (Parts* each : parts_->shared->views)
    each->overlayWidget->update();
}

void PlantView::showAttachment(const std::optional<ShownAttachment>& attachment) {
  if (!attachment && !parts_->shared->attachment) return;
  parts_->shared->attachment = attachment;
  for (Parts* each : parts_->shared->views)
    each->overlayWidget->update();
}

void PlantView::showGhosts(std::vector<ShownGhost> ghosts) {
  if (ghosts.empty() && parts_->shared->ghosts.empty()) return;
  parts_->shared->ghosts = std::move(ghosts);
  for (Parts* each : parts_->shared->views)
    each->overlayWidget->update();
}

void PlantView::setShowRadii(bool trueRadii) {
  parts_->scene.showRadii = trueRadii;
  parts_->redraw();
}

void PlantView::setStereo(bool isStereo) {
  parts_->shared->isStereo = isStereo;
  parts_->redraw();
}

void PlantView::setProjection(Projection projection) {
  for (Parts* view : parts_->shared->views) {
    Camera camera = view->navigator.destination();
    camera.projection = projection;
    view->navigator.set(camera);
  }
}

void PlantView::setDark(bool dark) {
  parts_->scene.setDark(dark);
  parts_->redraw();
}

void PlantView::setLengthUnit(const QString& unit) {
  parts_->shared->unit = unit;
  parts_->redraw();
}

void PlantView::setUp(UpAxis up) {
  if (up == parts_->scene.up) return;
  parts_->scene.setUp(up);
  for (Parts* view : parts_->shared->views) {
    Camera camera = view->navigator.destination();
    camera.upAxis = up;
    camera.focus = camera.pivot; // what one looks at stays in the middle
    view->navigator.set(camera);
  }
  parts_->redraw();
}

void PlantView::setRootMark(const std::optional<Eigen::Vector3d>& place) {
  parts_->shared->rootMark = place;
  for (Parts* view : parts_->shared->views)
    view->overlayWidget->update();
}

} // namespace espalier
