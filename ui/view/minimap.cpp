#include "ui/view/minimap.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

// [logical pixels]
constexpr QSize mapSize(168, 126);
constexpr QSize leastView(560, 420);
constexpr int minimapMargin = 12;
constexpr double slack = 2; // that a plant may reach beyond what the view shows of it

constexpr std::size_t mostEdges = 5000; // more cannot be distinguished, and take their time

} // namespace

Minimap::Minimap(const Scene& scene, QWidget* view) : QWidget(view), scene_(scene) {
  setObjectName("minimap");
  setAccessibleName(tr("Minimap"));
  setToolTip(tr("All of the plant; drag the frame to move the view"));
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::NoFocus); // the keys stay those of the plant
  later_.setSingleShot(true);
  later_.setInterval(150); // [ms]: a drag of a node is not slowed down
  connect(&later_, &QTimer::timeout, this, [this] {
    places_ = scene_.outline();
    frameAll();
    update();
    emit drawnAnew();
  });
}

bool Minimap::fits(const QSize& view) {
  return view.width() >= leastView.width() && view.height() >= leastView.height();
}

void Minimap::place(const QSize& view) {
  setGeometry(boxIn(corner_, mapSize, view, minimapMargin).toRect());
  viewAspect_ = view.width() / std::max(1.0, double(view.height()));
  update();
}

void Minimap::giveWay(const OnScreen& plant, const QSize& view, const std::vector<Corner>& taken) {
  corner_ = freestCorner({mapSize, minimapMargin, corner_}, plant, view, taken);
  place(view);
}

void Minimap::noteChange() {
  if (!later_.isActive()) later_.start();
}

void Minimap::showCamera(const Camera& camera) {
  const bool isTurned =
      camera.yaw != camera_.yaw || camera.pitch != camera_.pitch || camera.upAxis != camera_.upAxis;
  camera_ = camera;
  if (isTurned) frameAll();
  update();
}

bool Minimap::showsMore() const {
  const QRectF seen = frame().adjusted(-slack, -slack, slack, slack);
  return std::ranges::any_of(places_, [&](const Eigen::Vector3d& place) {
    const std::optional<QPointF> pixel = pixelOf(place);
    return pixel && !seen.contains(*pixel);
  });
}

void Minimap::frameAll() {
  map_ = camera_;
  map_.projection = Projection::parallel;
  if (!places_.empty()) map_.frame(places_, double(mapSize.width()) / mapSize.height());
  // A straight stick, seen from above, has no size.
  const Eigen::AlignedBox3d bounds = scene_.bounds();
  if (!bounds.isEmpty()) map_.distance = std::max(map_.distance, 0.1 * bounds.diagonal().norm());
  plant_ = {};
}

ScreenMap Minimap::screen() const {
  return {map_, {double(width()), double(height())}};
}

std::optional<QPointF> Minimap::pixelOf(const Eigen::Vector3d& place) const {
  const auto found = screen().project(place);
  return found ? std::optional(QPointF(found->pixel.x(), found->pixel.y())) : std::nullopt;
}

void Minimap::drawPlant() {
  const Palette colors = espalier::palette(scene_.dark);
  plant_ = QImage(size() * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
  plant_.setDevicePixelRatio(devicePixelRatioF());
  plant_.fill(toQt(colors.backgroundTop, 225));
  QPainter painter(&plant_);
  const ScreenMap map = screen();
  const auto at = [&](const Eigen::Vector3d& place) {
    const auto found = map.project(place);
    return found ? QPointF(found->pixel.x(), found->pixel.y()) : QPointF(-1, -1);
  };
  QPolygonF dots;
  for (const Eigen::Vector3d& place : places_)
    dots.append(at(place));
  painter.setPen(QPen(toQt(colors.text, 80), 1));
  painter.drawPoints(dots);
  const std::vector<EdgeGlyph>& edges = scene_.skeleton.edges();
  if (!scene_.skeletonVisible || edges.size() > mostEdges) return;
  QList<QLineF> lines;
  const Eigen::Vector3d& origin = scene_.skeleton.origin();
  for (const EdgeGlyph& edge : edges)
    if (edge.shape != EdgeShape::none)
      lines.append({at(origin + Eigen::Vector3f(edge.parent.data()).cast<double>()),
                    at(origin + Eigen::Vector3f(edge.child.data()).cast<double>())});
  painter.setPen(QPen(toQt(colors.successor, 110), 1));
  painter.drawLines(lines);
}

QRectF Minimap::frame() const {
  const std::optional<QPointF> middle = pixelOf(camera_.focus);
  const double half = camera_.halfHeight() / map_.halfHeight() * height() / 2;
  const QPointF reach(half * viewAspect_, half);
  return {middle.value_or(QPointF()) - reach, middle.value_or(QPointF()) + reach};
}

void Minimap::paintEvent(QPaintEvent* /*event*/) {
  if (plant_.isNull() || plant_.devicePixelRatio() != devicePixelRatioF()) drawPlant();
  const Palette colors = espalier::palette(scene_.dark);
  QPainter painter(this);
  painter.drawImage(QPointF(0, 0), plant_);
  painter.setPen(QPen(toQt(colors.text, 90), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  // A view that shows more than all of the plant is framed by the edge of the map.
  const QRectF shown = frame() & QRectF(rect()).adjusted(2, 2, -2, -2);
  painter.setPen(QPen(toQt(colors.contracted), 2));
  painter.setBrush(toQt(colors.contracted, 26));
  painter.drawRect(shown);
}

void Minimap::moveTo(const QPointF& place) {
  const auto focus = screen().project(camera_.focus);
  if (!focus) return;
  emit moveAsked(screen().place({place.x(), place.y()}, focus->depth));
}

void Minimap::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF middle = frame().center();
  const bool isOnFrame = (frame() & QRectF(rect())).contains(event->position());
  // All of the plant in the frame: there is nothing to hold on to but the place itself.
  const bool isHeld = isOnFrame && frame().width() < width();
  before_ = camera_;
  held_ = isHeld ? event->position() - middle : QPointF();
  if (!isHeld) moveTo(event->position());
}

void Minimap::mouseMoveEvent(QMouseEvent* event) {
  if (held_) moveTo(event->position() - *held_);
}

void Minimap::cancel() {
  held_.reset();
  emit canceled(before_);
}

void Minimap::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) held_.reset();
}

void Minimap::enterEvent(QEnterEvent* event) {
  emit entered();
  QWidget::enterEvent(event);
}

} // namespace espalier
