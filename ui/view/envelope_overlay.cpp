#include "ui/view/envelope_overlay.h"

#include "ui/view/overlay_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace espalier {
namespace {

/// The corners of a surface as they are seen; empty if one is behind the eye.
std::vector<Eigen::Vector2d> pixelsOf(const SurfaceMesh& mesh, const ScreenMap& screen) {
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(mesh.corners.size());
  for (const Eigen::Vector3d& corner : mesh.corners) {
    const auto at = screen.project(corner);
    if (!at) return {};
    pixels.push_back(at->pixel);
  }
  return pixels;
}

/// How much of the light a surface keeps back, by the cosine between its normal and the sight.
std::uint8_t glassAt(double facing) {
  constexpr double through = 22; // where it faces the eye, of 255
  constexpr double rim = 150;
  const double away = 1 - std::min(std::abs(facing), 1.0);
  return static_cast<std::uint8_t>(through + rim * away * away * away);
}

/// A picture of how much light is kept back.
struct Veil {
  int left, top, width, height; // [pixels]
  std::vector<std::uint8_t> values;

  /// The greater of what is there and `value`, in all pixels whose middle is in a triangle.
  void cover(std::array<Eigen::Vector2d, 3> corners, std::uint8_t value) {
    for (Eigen::Vector2d& corner : corners)
      corner -= Eigen::Vector2d(left + 0.5, top + 0.5);
    const auto [a, b, c] = corners;
    const auto span = [](double p, double q, double r, int size) {
      return std::pair(std::clamp(static_cast<int>(std::ceil(std::min({p, q, r}))), 0, size),
                       std::clamp(static_cast<int>(std::floor(std::max({p, q, r}))) + 1, 0, size));
    };
    const auto [firstX, endX] = span(a.x(), b.x(), c.x(), width);
    const auto [firstY, endY] = span(a.y(), b.y(), c.y(), height);
    const auto over = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to, double x,
                         double y) {
      return (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
    };
    for (int y = firstY; y < endY; ++y)
      for (int x = firstX; x < endX; ++x)
        if (over(a, b, x, y) <= 0 && over(b, c, x, y) <= 0 && over(c, a, x, y) <= 0) {
          std::uint8_t& pixel = values[static_cast<std::size_t>(y) * width + x];
          pixel = std::max(pixel, value);
        }
  }
};

/// The near side of a surface, of what lies in the view.
Veil veilOf(const SurfaceMesh& mesh, const std::vector<Eigen::Vector2d>& pixels,
            const ScreenMap& screen) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& pixel : pixels)
    box.extend(pixel);
  box = box.intersection(Eigen::AlignedBox2d(Eigen::Vector2d::Zero(), screen.size()));
  if (box.isEmpty()) return {};
  Veil veil{.left = static_cast<int>(std::floor(box.min().x())),
            .top = static_cast<int>(std::floor(box.min().y())),
            .width = static_cast<int>(std::ceil(box.sizes().x())) + 1,
            .height = static_cast<int>(std::ceil(box.sizes().y())) + 1,
            .values = {}};
  veil.values.assign(static_cast<std::size_t>(veil.width) * veil.height, 0);
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& {
      return mesh.corners[static_cast<std::size_t>(triangle[i])];
    };
    const auto pixel = [&](std::size_t i) { return pixels[static_cast<std::size_t>(triangle[i])]; };
    const Eigen::Vector2d ab = pixel(1) - pixel(0);
    const Eigen::Vector2d ac = pixel(2) - pixel(0);
    if (ab.x() * ac.y() - ab.y() * ac.x() >= 0) continue; // y points down: this is the far side
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const Eigen::Vector3d sight =
        screen.isPerspective() ? Eigen::Vector3d(corner(0) - screen.eye()) : screen.forward();
    const double length = normal.norm() * sight.norm();
    if (length > 0) veil.cover({pixel(0), pixel(1), pixel(2)}, glassAt(normal.dot(sight) / length));
  }
  return veil;
}

QImage imageOf(const Veil& veil, const QColor& color) {
  QImage image(veil.width, veil.height, QImage::Format_ARGB32_Premultiplied);
  std::array<QRgb, 256> colors;
  for (int a = 0; a < 256; ++a)
    colors[static_cast<std::size_t>(a)] =
        qPremultiply(qRgba(color.red(), color.green(), color.blue(), a));
  for (int y = 0; y < veil.height; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < veil.width; ++x)
      line[x] = colors[veil.values[static_cast<std::size_t>(y) * veil.width + x]];
  }
  return image;
}

} // namespace

void EnvelopeGlass::draw(const SurfaceMesh& mesh, const ScreenMap& screen, bool dark) {
  image_ = QImage();
  const std::vector<Eigen::Vector2d> pixels = pixelsOf(mesh, screen);
  if (pixels.empty()) return;
  const Eigen::Vector2d top =
      *std::ranges::min_element(pixels, {}, [](const Eigen::Vector2d& pixel) { return pixel.y(); });
  top_ = QPointF(top.x(), top.y());
  const Veil veil = veilOf(mesh, pixels, screen);
  if (veil.values.empty()) return;
  image_ = imageOf(veil, toQt(palette(dark).contracted));
  corner_ = QPointF(veil.left, veil.top);
}

void EnvelopeGlass::paint(QPainter& painter, const ShownEnvelope& envelope, const ScreenMap& screen,
                          bool dark) {
  const bool isDrawn = mesh_ == envelope.mesh && camera_ == screen.camera() &&
                       size_ == screen.size() && dark_ == dark;
  if (!isDrawn) draw(*envelope.mesh, screen, dark);
  mesh_ = envelope.mesh;
  camera_ = screen.camera();
  size_ = screen.size();
  dark_ = dark;
  if (image_.isNull()) return;
  painter.drawImage(corner_, image_);
  if (!envelope.label.isEmpty()) paintLabel(painter, top_, envelope.label, palette(dark));
}

std::optional<std::size_t> EnvelopeHandles::at(const Handles& handles, const ScreenMap& screen,
                                               const QPointF& place) {
  constexpr double reach = 10; // [logical pixels]
  std::optional<std::size_t> nearest;
  double least = reach;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto seen = screen.project(handles[i].place);
    if (!seen) continue;
    const double away = (seen->pixel - Eigen::Vector2d(place.x(), place.y())).norm();
    if (away > least) continue;
    least = away;
    nearest = i;
  }
  return nearest;
}

bool EnvelopeHandles::hover(std::optional<std::size_t> handle) {
  if (handle == hovered_) return false;
  hovered_ = handle;
  return true;
}

bool EnvelopeHandles::press(const Handles& handles, const ScreenMap& screen, const QPointF& place) {
  dragged_ = at(handles, screen, place);
  if (!dragged_) return false;
  const auto seen = screen.project(handles[*dragged_].place);
  grip_ = QPointF(seen->pixel.x(), seen->pixel.y()) - place;
  return true;
}

Eigen::Vector3d EnvelopeHandles::drag(const Handles& handles, const ScreenMap& screen,
                                      const QPointF& place) const {
  const ShownHandle& handle = handles[*dragged_];
  const QPointF to = place + grip_;
  const auto ray = screen.ray({to.x(), to.y()});
  if (handle.isFree) // in the plane that faces the eye
    return screen.place({to.x(), to.y()}, screen.project(handle.place)->depth);
  // In the plane that it moves in; where that is seen edge on, in one that faces the eye.
  constexpr double edgeOn = 0.2;
  Eigen::Vector3d normal = handle.up.cross(handle.outward);
  if (std::abs(normal.dot(ray.direction())) < edgeOn)
    normal = (ray.direction() - ray.direction().dot(handle.up) * handle.up);
  if (normal.norm() < edgeOn) return handle.place; // it moves along the sight
  const double way = (handle.place - ray.origin()).dot(normal) / ray.direction().dot(normal);
  const Eigen::Vector3d moved = ray.pointAt(way) - handle.place;
  return handle.place + moved.dot(handle.up) * handle.up +
         moved.dot(handle.outward) * handle.outward;
}

void EnvelopeHandles::paint(QPainter& painter, const Handles& handles, const ScreenMap& screen,
                            bool dark) const {
  const Palette colors = palette(dark);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto seen = screen.project(handles[i].place);
    if (!seen) continue;
    const QPointF middle(seen->pixel.x(), seen->pixel.y());
    const bool isMeant = dragged_ ? dragged_ == i : hovered_ == i;
    const double radius = isMeant ? 7.5 : 5;
    painter.setPen(QPen(toQt(colors.backgroundBottom), 2));
    painter.setBrush(toQt(colors.contracted));
    painter.drawEllipse(middle, radius, radius);
    if (isMeant) paintLabel(painter, middle - QPointF(0, 6), handles[i].label, colors);
  }
}

} // namespace espalier
