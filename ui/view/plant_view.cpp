#include "ui/view/plant_view.h"

#include "ui/view/area.h"
#include "ui/view/detail_budget.h"
#include "ui/view/navigator.h"
#include "ui/view/overlay_widget.h"
#include "ui/view/picture.h"
#include "ui/view/pointer_input.h"
#include "ui/view/scene.h"
#include "ui/view/view_surface.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>

#include <algorithm>

namespace espalier {
namespace {

constexpr double movingFrame = 34;  // [ms] of drawing: 25 a second with what Qt adds
constexpr double restingFrame = 60; // [ms] a step of completing a still picture
constexpr int restAfter = 120;      // [ms] after the last move

} // namespace

struct PlantView::Parts {
  explicit Parts(PlantView& view)
      : pointer(scene, navigator), surface(makeSurface(scene, client(), &view)),
        overlayWidget(
            new OverlayWidget([this](QPainter& painter) { paintOverlay(painter); }, &view)) {}

  SurfaceClient client();
  void paintOverlay(QPainter& painter);
  void redrawSkeleton() {
    complete = false;
    surface->update();
  }
  void redraw() {
    redrawSkeleton();
    overlayWidget->update();
  }
  void moved() {
    moving = true;
    rest.start();
    redraw();
  }
  void moveTo(const Camera& camera, bool seen) {
    if (seen && wasFramed)
      navigator.flyTo(camera);
    else
      navigator.set(camera);
  }

  /// @param what a box, or places
  template <class What> void frame(const What& what, const PlantView& view) {
    Camera camera = navigator.destination();
    camera.frame(what, view.width() / std::max(1.0, double(view.height())));
    moveTo(camera, view.isVisible());
    wasFramed = true;
  }

  Scene scene;
  Navigator navigator;
  PointerInput pointer;
  Overlay overlay;
  DetailBudget budget;
  QTimer rest; // runs while the camera moves
  bool moving = false;
  bool complete = false;
  bool wasFramed = false;
  QWidget* surface; // owned by the view; goes before what it draws, see ~PlantView
  QWidget* overlayWidget;
};

SurfaceClient PlantView::Parts::client() {
  return {.nextFrame =
              [this](QSize size, double pixelRatio) {
                return PlantRenderer::Frame{.camera = navigator.camera(),
                                            .size = size,
                                            .pixelRatio = pixelRatio,
                                            .points =
                                                budget.points(moving ? movingFrame : restingFrame),
                                            .moving = moving};
              },
          .drawn =
              [this](const PlantRenderer::Result& result, double milliseconds) {
                budget.measured(result.pointsDrawn, milliseconds);
                complete = result.complete;
                // Later, so that what the user does comes first.
                if (!complete && !moving)
                  QTimer::singleShot(0, surface, qOverload<>(&QWidget::update));
              }};
}

void PlantView::Parts::paintOverlay(QPainter& painter) {
  overlay.pivotShown = navigator.gesture() == Navigator::Gesture::turn;
  overlay.paint(painter, scene, navigator.camera(), overlayWidget->size());
}

PlantView::PlantView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>(*this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  parts_->surface->setAttribute(Qt::WA_TransparentForMouseEvents);
  parts_->rest.setSingleShot(true);
  parts_->rest.setInterval(restAfter);
  connect(&parts_->rest, &QTimer::timeout, this, [this] {
    parts_->moving = false;
    parts_->redraw();
  });
  connect(&parts_->navigator, &Navigator::moved, this, [this] { parts_->moved(); });
}

PlantView::~PlantView() {
  delete parts_->overlayWidget;
  delete parts_->surface;
}

void PlantView::setCloud(std::shared_ptr<const PointCloud> cloud) {
  parts_->scene.setCloud(std::move(cloud));
  parts_->redraw();
}

void PlantView::setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions) {
  parts_->scene.contracted.set(std::move(positions));
  parts_->redraw();
}

void PlantView::setSkeleton(const Skeleton& skeleton) {
  parts_->scene.setSkeleton(skeleton);
  parts_->redraw();
}

void PlantView::updateSkeleton(const Skeleton& skeleton, const SkeletonDelta& delta) {
  const bool isFirst = parts_->scene.bounds().isEmpty();
  parts_->scene.skeleton.update(skeleton, delta);
  parts_->redrawSkeleton();
  if (isFirst) parts_->overlayWidget->update(); // there is something to measure now
}

void PlantView::setSelection(const std::vector<NodeId>& nodes) {
  parts_->scene.skeleton.select(nodes);
  parts_->redrawSkeleton();
}

void PlantView::setHovered(const Pick& pick) {
  if (parts_->scene.skeleton.hover(pick)) parts_->redrawSkeleton();
}

void PlantView::hoverAgain() {
  parts_->pointer.hoverAgain();
}

void PlantView::setHiddenNodes(const std::vector<NodeId>& nodes) {
  parts_->scene.skeleton.setHidden(nodes);
  parts_->redrawSkeleton();
}

void PlantView::setNodeColors(std::optional<NodeColors> colors) {
  parts_->scene.skeleton.setColors(std::move(colors), parts_->scene.dark);
  parts_->redraw();
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

void PlantView::setClip(const Clip& clip) {
  if (clip == parts_->scene.clip) return;
  parts_->scene.clip = clip;
  parts_->redraw();
  hoverAgain();
}

const Clip& PlantView::clip() const {
  return parts_->scene.clip;
}

void PlantView::setDepthFade(double strength) {
  parts_->scene.depthFade = std::clamp(strength, 0.0, 1.0);
  parts_->redraw();
}

double PlantView::depthFade() const {
  return parts_->scene.depthFade;
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

void PlantView::setShowRadii(bool trueRadii) {
  parts_->scene.showRadii = trueRadii;
  parts_->redraw();
}

void PlantView::setProjection(Projection projection) {
  Camera camera = parts_->navigator.destination();
  camera.projection = projection;
  parts_->navigator.set(camera);
}

void PlantView::setDark(bool dark) {
  parts_->scene.setDark(dark);
  parts_->redraw();
}

void PlantView::setLengthUnit(const QString& unit) {
  parts_->overlay.unit = unit;
  parts_->redraw();
}

void PlantView::frameAll() {
  const std::vector<Eigen::Vector3d> places = parts_->scene.outline();
  if (!places.empty()) parts_->frame(places, *this);
}

void PlantView::frame(const Eigen::AlignedBox3d& box) {
  if (!box.isEmpty()) parts_->frame(box, *this);
}

void PlantView::look(StandardView view) {
  Camera camera = parts_->navigator.destination();
  camera.face(view);
  parts_->moveTo(camera, isVisible());
}

void PlantView::setPivot(const Eigen::Vector3d& place) {
  Camera camera = parts_->navigator.destination();
  camera.focus = camera.pivot = place;
  parts_->moveTo(camera, isVisible());
}

const Camera& PlantView::camera() const {
  return parts_->navigator.destination();
}

void PlantView::setCamera(const Camera& camera) {
  parts_->navigator.set(camera);
  parts_->wasFramed = true;
}

void PlantView::flyTo(const Camera& camera) {
  parts_->moveTo(camera, isVisible());
  parts_->wasFramed = true;
}

bool PlantView::isStill() const {
  return parts_->complete && !parts_->moving && !parts_->navigator.isFlying();
}

void PlantView::setInputHandler(InputHandler handler) {
  parts_->pointer.setHandler(std::move(handler));
}

void PlantView::setDepth(Depth depth) {
  parts_->pointer.setDepth(depth);
  hoverAgain();
}

Pick PlantView::pick(const QPointF& position) const {
  return parts_->pointer.pick(position);
}

std::optional<QPointF> PlantView::project(const Eigen::Vector3d& place) const {
  const auto found = parts_->pointer.screen().project(place);
  if (!found) return std::nullopt;
  return QPointF(found->pixel.x(), found->pixel.y());
}

std::vector<NodeId> PlantView::nodesInside(const QPolygonF& area, Depth depth) const {
  return espalier::nodesInside(parts_->scene, parts_->pointer.screen(), area, depth);
}

std::vector<Eigen::Index> PlantView::pointsInside(const QPolygonF& area, Depth depth) const {
  return espalier::pointsInside(parts_->scene, parts_->pointer.screen(), area, depth);
}

void PlantView::showBand(const QPolygonF& band) {
  if (band == parts_->overlay.band) return;
  parts_->overlay.band = band;
  parts_->overlayWidget->update();
}

void PlantView::showPreview(const Preview& preview) {
  if (preview == parts_->overlay.preview) return;
  parts_->overlay.preview = preview;
  parts_->overlayWidget->update();
}

QImage PlantView::picture(const QSize& size) {
  Overlay overlay;
  overlay.unit = parts_->overlay.unit;
  return espalier::picture(parts_->scene, parts_->navigator.destination(), overlay, size);
}

bool PlantView::event(QEvent* event) {
  // Escape ends a gesture before any shortcut of the window hears of it.
  if (event->type() == QEvent::ShortcutOverride && parts_->pointer.isBusy() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void PlantView::resizeEvent(QResizeEvent* /*event*/) {
  parts_->surface->setGeometry(rect());
  parts_->overlayWidget->setGeometry(rect());
  parts_->pointer.setSize(size());
  parts_->redraw();
}

void PlantView::mousePressEvent(QMouseEvent* event) {
  parts_->pointer.press(*event);
}

void PlantView::mouseMoveEvent(QMouseEvent* event) {
  parts_->pointer.move(*event);
}

void PlantView::mouseReleaseEvent(QMouseEvent* event) {
  parts_->pointer.release(*event);
  parts_->redraw(); // the pivot is no longer shown
}

void PlantView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto place = parts_->pointer.doubleClick(*event)) setPivot(*place);
}

void PlantView::wheelEvent(QWheelEvent* event) {
  parts_->pointer.wheel(*event);
}

void PlantView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && parts_->pointer.isBusy())
    parts_->pointer.cancel();
  else
    QWidget::keyPressEvent(event);
}

void PlantView::focusOutEvent(QFocusEvent* event) {
  parts_->pointer.cancel();
  QWidget::focusOutEvent(event);
}

void PlantView::enterEvent(QEnterEvent* event) {
  // The keys are those of the plant where the pointer is; what was being typed elsewhere is taken.
  if (isActiveWindow() && QApplication::activePopupWidget() == nullptr)
    setFocus(Qt::MouseFocusReason);
  QWidget::enterEvent(event);
}

void PlantView::leaveEvent(QEvent* event) {
  parts_->pointer.leave();
  QWidget::leaveEvent(event);
}

} // namespace espalier
