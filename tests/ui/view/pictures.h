#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/palette.h"

#include <Eigen/Core>
#include <QImage>
#include <QPointF>

#include <memory>
#include <vector>

namespace espalier::test {

// Colors of the light palette.
inline const Color black = palette(false).successor;
inline const Color plain = palette(false).point;
inline const Color accent = palette(false).contracted;
inline const Color paleAccent = {0x8d, 0xbf, 0xa4}; // half of it background: points of a preview

/// How many pixels of a picture, at most `reach` from a place, are about of this color.
[[nodiscard]] int countPixels(const QImage& picture, const QPointF& place, int reach,
                              const Color& color, int tolerance = 40);

/// The same anywhere in the picture.
[[nodiscard]] int countPixels(const QImage& picture, const Color& color, int tolerance = 40);

/// How many pixels differ at all; all of them if the sizes do.
[[nodiscard]] int countDifferences(const QImage& a, const QImage& b);

[[nodiscard]] std::shared_ptr<const PointCloud>
cloudOf(const std::vector<Eigen::Vector3d>& positions);

/// A block of points, 40 x 40 x 40 in a cube of side 1 about `middle`.
[[nodiscard]] std::shared_ptr<const PointCloud> block(const Eigen::Vector3d& middle);

} // namespace espalier::test
