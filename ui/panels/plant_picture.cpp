#include "ui/panels/plant_picture.h"

#include <Eigen/Geometry>
#include <QPainter>

#include <algorithm>

namespace espalier {
namespace {

const QColor ink(0x7d, 0x87, 0x90);
constexpr double margin = 3; // [pixels]

UpAxis upOf(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const NodeId id : ids)
    middle += skeleton[id].position / static_cast<double>(ids.size());
  Eigen::Index axis = 2;
  (middle - skeleton[ids.front()].position).cwiseAbs().maxCoeff(&axis);
  return static_cast<UpAxis>(axis);
}

/// Maps places to pixels.
class Side {
public:
  Side(const Eigen::AlignedBox3d& box, UpAxis up, int size)
      : up_(static_cast<Eigen::Index>(up)), middle_(box.center()), size_(size) {
    const Eigen::Index first = up_ == 0 ? 1 : 0;
    const Eigen::Index second = up_ == 2 ? 1 : 2;
    const Eigen::Vector3d sides = box.sizes();
    across_ = sides[second] > sides[first] ? second : first;
    const double most = std::max(sides[up_], sides[across_]);
    scale_ = most > 0 ? (size - 2 * margin) / most : 1;
  }

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] QPointF operator()(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d from = scale_ * (place - middle_);
    return {size_ / 2.0 + from[across_], size_ / 2.0 - from[up_]};
  }

private:
  Eigen::Index up_;
  Eigen::Index across_ = 0;
  Eigen::Vector3d middle_;
  int size_;
  double scale_ = 1; // [pixels / L]
};

QImage emptyPicture(int size) {
  QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  return picture;
}

} // namespace

QImage pictureOf(const Skeleton& skeleton, int size) {
  QImage picture = emptyPicture(size);
  const std::vector<NodeId> ids = skeleton.ids();
  Eigen::AlignedBox3d box;
  for (const NodeId id : ids)
    box.extend(skeleton[id].position);
  if (box.isEmpty() || !box.sizes().allFinite()) return picture;
  const Side side(box, upOf(skeleton), size);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    const double width = std::clamp(2 * node.radius * side.scale(), 1.2, size / 8.0);
    painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(side(skeleton[*node.parent].position), side(node.position));
  }
  return picture;
}

QImage pictureOf(const std::vector<Eigen::Vector3d>& points, UpAxis up, int size) {
  QImage picture = emptyPicture(size);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(point);
  if (box.isEmpty() || !box.sizes().allFinite()) return picture;
  const Side side(box, up, size);
  QPainter painter(&picture);
  painter.setPen(QPen(ink, 1));
  for (const Eigen::Vector3d& point : points)
    painter.drawPoint(side(point));
  return picture;
}

} // namespace espalier
