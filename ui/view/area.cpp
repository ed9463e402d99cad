#include "ui/view/area.h"

#include "ui/view/screen_part.h"
#include "ui/view/visibility.h"

#include <QImage>
#include <QPainter>

#include <optional>

namespace espalier {
namespace {

/// An area as a picture of its pixels: whether a point is in it takes no longer the more corners
/// it has. Exact to a pixel.
class AreaMask {
public:
  AreaMask(const QPolygonF& area, const QRectF& part)
      : image_(QSize(1 + int(part.width()), 1 + int(part.height())), QImage::Format_Grayscale8) {
    image_.fill(0);
    QPainter painter(&image_);
    painter.translate(-part.topLeft());
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPolygon(area, Qt::WindingFill);
  }

  /// @param pixel from the corner of the part
  [[nodiscard]] bool contains(const Eigen::Vector2f& pixel) const {
    const float x = pixel.x();
    const float y = pixel.y();
    if (!(x >= 0 && y >= 0 && x < float(image_.width()) && y < float(image_.height())))
      return false;
    return image_.constScanLine(static_cast<int>(y))[static_cast<int>(x)] != 0;
  }

private:
  QImage image_;
};

QRectF screenOf(const ScreenMap& screen) {
  return {0, 0, screen.size().x(), screen.size().y()};
}

} // namespace

std::vector<NodeId> nodesInside(const Scene& scene, const ScreenMap& screen, const QPolygonF& area,
                                Depth depth) {
  std::vector<NodeId> found;
  if (!scene.skeletonVisible || area.isEmpty()) return found;
  const QRectF box = area.boundingRect() & screenOf(screen);
  const ClipVolume clip = scene.clipVolume(screen.camera());
  std::optional<Visibility> visibility; // made once there is something to ask about
  for (std::size_t slot = 0; slot < scene.skeleton.nodes().size(); ++slot) {
    const NodeGlyph& node = scene.skeleton.nodes()[slot];
    if (node.shape == NodeShape::none || !clip.contains(Eigen::Vector3f(node.position.data())))
      continue;
    const auto at = screen.project(scene.skeleton.position(slot));
    if (!at) continue;
    const QPointF pixel(at->pixel.x(), at->pixel.y());
    if (!box.contains(pixel) || !area.containsPoint(pixel, Qt::WindingFill)) continue;
    if (depth == Depth::front && !visibility) visibility.emplace(scene, screen, box);
    if (visibility && visibility->hidesNode(slot, *at)) continue;
    found.push_back(NodeId{static_cast<std::uint32_t>(slot)});
  }
  return found;
}

std::vector<Eigen::Index> pointsInside(const Scene& scene, const ScreenMap& screen,
                                       const QPolygonF& area, Depth depth) {
  std::vector<Eigen::Index> found;
  if (!scene.points.visible || area.isEmpty()) return found;
  const ScreenPart part(screen, scene.origin(), area.boundingRect());
  if (part.box().isEmpty()) return found;
  const ClipVolume clip = scene.clipVolume(screen.camera());
  const FocusDepths focus = scene.focusDepths(screen.camera());
  const AreaMask mask(area, part.box());
  std::optional<Visibility> visibility;
  if (depth == Depth::front) visibility.emplace(scene, screen, part.box());
  const Eigen::Vector2f corner(static_cast<float>(part.box().left()),
                               static_cast<float>(part.box().top()));
  scene.points.boxes.forEachRun(
      [&](const Eigen::AlignedBox3f& box) { return part.mayMeet(box, 0); },
      [&](Eigen::Index begin, Eigen::Index end) {
        for (Eigen::Index i = begin; i < end; ++i) {
          const ScreenPart::Place at = part.place(scene.points.positions->col(i));
          if (!part.isBeforeEye(at) || !mask.contains(at.pixel)) continue;
          if (!scene.isPointShown(i) || !clip.contains(scene.points.positions->col(i))) continue;
          const Eigen::Vector2d pixel = (at.pixel + corner).cast<double>();
          if (visibility && (focus.isPassed(at.depth) || visibility->hidesPoint({pixel, at.depth})))
            continue;
          found.push_back(i);
        }
      });
  return found;
}

std::vector<Eigen::Index> pointsShown(const Scene& scene, const Camera& camera) {
  std::vector<Eigen::Index> shown;
  if (!scene.points.visible) return shown;
  const ClipVolume clip = scene.clipVolume(camera);
  for (Eigen::Index i = 0; i < scene.points.size(); ++i)
    if (scene.isPointShown(i) && clip.contains(scene.points.positions->col(i))) shown.push_back(i);
  return shown;
}

} // namespace espalier
