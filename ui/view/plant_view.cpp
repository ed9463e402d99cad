#include "ui/view/plant_view.h"

#include "ui/view/area.h"
#include "ui/view/picture.h"
#include "ui/view/plant_view_parts.h"
#include "ui/view/turntable.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace espalier {
namespace {

constexpr int restAfter = 120;    // [ms] after the last move
constexpr int settledAfter = 200; // [ms] after the last change

} // namespace

SurfaceClient PlantView::Parts::client() {
  return {.nextFrame =
              [this](QSize size, double pixelRatio) {
                const Pace& now = moving ? pace : completing;
                return PlantRenderer::Frame{
                    .camera = navigator.camera(),
                    .size = size,
                    .pixelRatio = pixelRatio,
                    .points = budget().points(now.frame / seenViews(), now.fewest),
                    .moving = moving,
                    .divider = divider};
              },
          .drawn =
              [this](const PlantRenderer::Result& result, double milliseconds) {
                // Relief alone says nothing of other frames.
                if (!result.reliefDrawn) budget().measured(result.pointsDrawn, milliseconds);
                complete = result.complete;
                // Later, so that what the user does comes first.
                if (!complete && !moving)
                  QTimer::singleShot(0, surface, qOverload<>(&QWidget::update));
              },
          .isStereo = [this] { return shared->isStereo; }};
}

double PlantView::Parts::seenViews() const {
  const auto isSeen = [](const Parts* each) { return each->owner.isVisible(); };
  return std::max(1.0, double(std::ranges::count_if(shared->views, isSeen)));
}

void PlantView::Parts::setUpOverlay() {
  overlay.unit = shared->unit;
  overlay.hulls = shared->hulls;
  overlay.envelope = shared->envelope;
  overlay.attachment = shared->attachment;
  overlay.ghosts = shared->ghosts;
  overlay.rootMark = shared->rootMark;
  overlay.hasLegends = isFirst();
  overlay.divider = divider;
  overlay.seen = shared->seenSides();
}

void PlantView::Parts::paintOverlay(QPainter& painter) {
  if (!navigator.isFlying()) ++framesAtRest;
  setUpOverlay();
  overlay.pivotShown = navigator.gesture() == Navigator::Gesture::turn;
  painter.setRenderHint(QPainter::Antialiasing);
  clipHandles.paint(painter, sight(), scene.dark); // under the legends
  overlay.paint(painter, scene, navigator.camera(), overlayWidget->size());
  if (shared->envelope)
    envelopeHandles.paint(painter, shared->envelope->handles, pointer.screen(), scene.dark);
}

PlantView::PlantView(QWidget* parent) : PlantView(std::make_shared<Shared>(), parent) {}

PlantView::PlantView(const PlantView& first, QWidget* parent)
    : PlantView(first.parts_->shared, parent) {
  parts_->pointer.setDepth(first.parts_->pointer.depth());
  parts_->clipHandles.setShown(first.parts_->clipHandles.isShown());
  if (first.parts_->minimap != nullptr) setMinimapShown(true);
  setCamera(first.camera());
}

PlantView::PlantView(std::shared_ptr<Shared> shared, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(*this, std::move(shared))) {
  setMouseTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Plant in 3D"));
  setMinimumSize(160, 120);
  parts_->surface->setAttribute(Qt::WA_TransparentForMouseEvents);
  parts_->settling.setSingleShot(true);
  parts_->settling.setInterval(settledAfter);
  connect(&parts_->settling, &QTimer::timeout, this, [this] {
    parts_->spanSeen();
    parts_->giveWay();
    emit settled();
  });
  parts_->rest.setSingleShot(true);
  parts_->rest.setInterval(restAfter);
  connect(&parts_->rest, &QTimer::timeout, this, [this] {
    parts_->moving = false;
    parts_->redrawThis();
    parts_->pointer.hoverAgain(); // something else has come under it
  });
  connect(&parts_->navigator, &Navigator::moved, this, [this] { parts_->moved(); });
}

PlantView::~PlantView() {
  delete parts_->overlayWidget;
  delete parts_->surface;
}

void PlantView::setCloud(std::shared_ptr<const PointCloud> cloud) {
  parts_->scene.setCloud(std::move(cloud));
  parts_->scene.setFocus(std::nullopt);
  parts_->shared->knownViews.forget();
  parts_->redraw();
}

InView PlantView::inView() const {
  return espalier::inView(parts_->scene, parts_->pointer.screen());
}

void PlantView::setWord(const QString& word) {
  if (word == parts_->overlay.word) return;
  parts_->overlay.word = word;
  setAccessibleDescription(word);
  parts_->overlayWidget->update();
}

void PlantView::setPointsLeftOut(const PointSet& points) {
  parts_->scene.setLeftOut(points);
  parts_->redraw();
}

void PlantView::setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions) {
  parts_->scene.setContracted(std::move(positions));
  parts_->redraw();
}

void PlantView::setSkeleton(const Skeleton& skeleton) {
  parts_->scene.setSkeleton(skeleton);
  parts_->scene.setFocus(std::nullopt);
  parts_->redraw();
}

void PlantView::updateSkeleton(const Skeleton& skeleton, const SkeletonDelta& delta) {
  const bool isFirst = parts_->scene.bounds().isEmpty();
  parts_->scene.skeleton.update(skeleton, delta);
  parts_->redrawSkeleton();
  if (isFirst) parts_->redraw(); // there is something to measure now
}

void PlantView::setSelection(const std::vector<NodeId>& nodes) {
  parts_->scene.skeleton.select(nodes);
  parts_->redrawSkeleton();
}

void PlantView::setHovered(const Pick& pick) {
  if (parts_->scene.skeleton.hover(pick)) parts_->redrawSkeleton();
}

void PlantView::hoverAgain() {
  for (Parts* view : parts_->shared->views)
    view->pointer.hoverAgain();
}

void PlantView::frameAll() {
  if (parts_->isFirst()) focusOff(); // another view leaves the first where it is
  const std::vector<Eigen::Vector3d> places = parts_->scene.outline();
  if (!places.empty()) parts_->frame(places, *this);
}

void PlantView::faceAll() {
  const std::vector<Eigen::Vector3d> places = parts_->scene.outline();
  Camera camera = parts_->navigator.destination();
  camera.faceBroadside(places);
  parts_->moveTo(camera, isVisible());
  frameAll();
}

void PlantView::frame(const Eigen::AlignedBox3d& box) {
  if (parts_->isFirst()) focusOff();
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

const Camera& PlantView::currentCamera() const {
  return parts_->navigator.camera();
}

void PlantView::setCamera(const Camera& camera) {
  parts_->navigator.set(parts_->upright(camera));
  parts_->wasFramed = true;
}

void PlantView::flyTo(const Camera& camera) {
  flyTo(camera, std::nullopt);
}

void PlantView::flyTo(const Camera& camera, const std::optional<Focus>& focus) {
  parts_->scene.setFocus(focus);
  parts_->redraw();
  parts_->moveTo(parts_->upright(camera), isVisible());
  parts_->wasFramed = true;
}

Camera PlantView::cameraToSee(const Sight& sight) const {
  KnownViews& known = parts_->shared->knownViews;
  KnownViews::Situation now{.place = {},
                            .projection = camera().projection,
                            .up = parts_->scene.up,
                            .aspect = width() / std::max(1.0, double(height()))};
  for (const NodeId id : sight.nodes)
    now.place.extend(parts_->scene.skeleton.position(indexOf(id)));
  if (const auto before = known.find(sight, now)) return *before;
  Camera chosen = espalier::cameraToSee(parts_->scene, camera(), sight, size());
  known.keep(sight, now, chosen);
  return chosen;
}

void PlantView::steer(const Steering& by) {
  if (!isInGesture()) parts_->navigator.steer(by);
}

bool PlantView::isStill() const {
  return parts_->complete && !parts_->moving && !parts_->navigator.isFlying();
}

int PlantView::framesAtRest() const {
  return parts_->framesAtRest;
}

void PlantView::setInputHandler(InputHandler handler) {
  parts_->pointer.setHandler(std::move(handler));
}

void PlantView::setDepth(Depth depth) {
  for (Parts* view : parts_->shared->views)
    view->pointer.setDepth(depth);
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

int PlantView::coveredBy(const QRect& part) const {
  const OnScreen found = plantOnScreen(parts_->scene, parts_->pointer.screen());
  const auto isIn = [&](const QPointF& place) { return QRectF(part).contains(place); };
  const auto isBarIn = [&](const ColorBar* bar) {
    return bar->isVisible() && bar->geometry().intersects(part);
  };
  const Minimap* map = parts_->minimap;
  const bool isMapIn = map != nullptr && map->isVisible() && map->geometry().intersects(part);
  constexpr int asMuch = 1000; // places: what a color bar or the minimap counts for
  constexpr int selected = 20; // likewise: what is selected
  return static_cast<int>(
      std::ranges::count_if(found.plant, isIn) +
      selected * std::ranges::count_if(found.selected, isIn) +
      asMuch * (std::ranges::count_if(parts_->colorBars, isBarIn) + (isMapIn ? 1 : 0)));
}

std::vector<NodeId> PlantView::nodesInside(const QPolygonF& area, Depth depth) const {
  const ScreenMap screen = parts_->pointer.screen();
  auto found = espalier::nodesInside(parts_->scene, screen, area, depth);
  std::erase_if(found, [&](NodeId id) {
    const Eigen::Vector3d place = parts_->scene.skeleton.position(indexOf(id));
    return !parts_->scene.showsPlant(place, screen.project(place)->pixel.x() / width(),
                                     parts_->divider);
  });
  return found;
}

std::vector<Eigen::Index> PlantView::pointsInside(const QPolygonF& area, Depth depth) const {
  return espalier::pointsInside(parts_->scene, parts_->pointer.screen(), area, depth);
}

std::vector<Eigen::Index> PlantView::pointsShown() const {
  return espalier::pointsShown(parts_->scene, parts_->pointer.screen().camera());
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

Overlay PlantView::Parts::overlayOfPicture() const {
  Overlay result;
  result.unit = shared->unit;
  result.hulls = shared->hulls;
  result.envelope = shared->envelope;
  result.attachment = shared->attachment;
  result.ghosts = shared->ghosts;
  result.divider = divider;
  result.seen = SeenSides::of(divider);
  result.legendsIn = overlay.legendsIn;
  return result;
}

QImage PlantView::picture(const QSize& size, double pixelRatio) {
  return espalier::picture(parts_->scene, parts_->navigator.destination(),
                           parts_->overlayOfPicture(), size, pixelRatio);
}

std::unique_ptr<Turntable> PlantView::turntable(const TurntableOptions& options) const {
  return std::make_unique<Turntable>(parts_->scene, parts_->navigator.destination(),
                                     parts_->overlayOfPicture(), options);
}

std::size_t PlantView::graphicsBytes() const {
  return bytesIn(*parts_->shared->buffers);
}

bool PlantView::isInGesture() const {
  return parts_->pointer.isBusy() || parts_->clipHandles.isDragging() ||
         parts_->envelopeHandles.dragged().has_value() || parts_->draggedColorBar() != nullptr ||
         (parts_->minimap != nullptr && parts_->minimap->isDragging());
}

bool PlantView::event(QEvent* event) {
  // Escape ends a gesture before any shortcut of the window hears of it.
  if (event->type() == QEvent::ShortcutOverride && isInGesture() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  switch (event->type()) {
  case QEvent::TouchBegin:
  case QEvent::TouchUpdate:
  case QEvent::TouchEnd:
  case QEvent::TouchCancel:
    return parts_->takeTouch(*static_cast<QTouchEvent*>(event));
  default: // of a pen, too, of which Qt makes a mouse
    return QWidget::event(event);
  }
}

void PlantView::resizeEvent(QResizeEvent* /*event*/) {
  parts_->surface->setGeometry(rect());
  parts_->overlayWidget->setGeometry(rect());
  parts_->pointer.setSize(size());
  if (parts_->minimap != nullptr) parts_->minimap->place(size());
  parts_->redrawThis();
}

void PlantView::mousePressEvent(QMouseEvent* event) {
  if (parts_->clipHandles.isDragging() || pressClip(*event)) return;
  if (parts_->envelopeHandles.dragged() || pressEnvelope(*event)) return;
  parts_->pointer.press(*event);
}

void PlantView::mouseMoveEvent(QMouseEvent* event) {
  parts_->pointerAt = event->globalPosition().toPoint();
  if (moveClip(*event) || moveEnvelope(*event)) return;
  parts_->pointer.move(*event);
}

void PlantView::mouseReleaseEvent(QMouseEvent* event) {
  if (releaseClip(*event) || releaseEnvelope(*event)) return;
  parts_->pointer.release(*event);
  parts_->redrawThis(); // the pivot is no longer shown
}

void PlantView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto place = parts_->pointer.doubleClick(*event)) setPivot(*place);
}

void PlantView::wheelEvent(QWheelEvent* event) {
  parts_->pointer.wheel(*event);
}

void PlantView::keyPressEvent(QKeyEvent* event) {
  ColorBar* bar = parts_->draggedColorBar();
  if (event->key() == Qt::Key_Escape && bar != nullptr)
    bar->cancel();
  else if (event->key() == Qt::Key_Escape && parts_->minimap != nullptr &&
           parts_->minimap->isDragging())
    parts_->minimap->cancel();
  else if (event->key() == Qt::Key_Escape && parts_->clipHandles.isDragging())
    setClip(parts_->clipHandles.cancel());
  else if (event->key() == Qt::Key_Escape && parts_->envelopeHandles.dragged())
    parts_->giveBackEnvelope();
  else if (event->key() == Qt::Key_Escape && parts_->pointer.isBusy())
    parts_->pointer.cancel();
  else
    QWidget::keyPressEvent(event);
}

void PlantView::focusOutEvent(QFocusEvent* event) {
  if (parts_->clipHandles.isDragging()) setClip(parts_->clipHandles.cancel());
  parts_->giveBackEnvelope();
  parts_->pointer.cancel();
  QWidget::focusOutEvent(event);
}

void PlantView::enterEvent(QEnterEvent* event) {
  // The keys are those of the plant where the pointer is; what was being typed elsewhere is taken.
  // It also enters where it rests, as a list of choices closes that was opened by the keyboard.
  const QPoint at = event->globalPosition().toPoint();
  const bool hasMoved = std::exchange(parts_->pointerAt, at) != at;
  if (hasMoved && isActiveWindow() && QApplication::activePopupWidget() == nullptr)
    setFocus(Qt::MouseFocusReason);
  QWidget::enterEvent(event);
}

void PlantView::leaveEvent(QEvent* event) {
  parts_->pointerAt = QCursor::pos();
  if (!parts_->clipHandles.isDragging()) parts_->hoverClip(std::nullopt);
  if (!parts_->envelopeHandles.dragged()) parts_->hoverEnvelope(std::nullopt);
  parts_->pointer.leave();
  QWidget::leaveEvent(event);
}

} // namespace espalier
