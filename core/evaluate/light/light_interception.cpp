#include "core/evaluate/light/light_interception.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/evaluate/light/sky.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace espalier {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The corners from their middle.
/// @throws ShownError if one is no number
std::vector<Vector3d> centeredCorners(const SurfaceMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : mesh.corners) {
    box.extend(corner);
    if (!corner.allFinite())
      throw ShownError({espalier::Shown::tr(
          "the surface has a corner that is no number: correct the radii and positions")});
  }
  std::vector<Vector3d> corners = mesh.corners;
  for (Vector3d& corner : corners)
    corner -= box.center();
  return corners;
}

/// A picture of which pixels are covered.
class Picture {
public:
  Picture(int width, int height)
      : width_(width), height_(height),
        isCovered_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}

  /// Covers the pixels whose centers, at halves, lie in the triangle.
  void draw(Vector2d a, Vector2d b, Vector2d c) {
    const double low = std::min({a.y(), b.y(), c.y()});
    const double high = std::max({a.y(), b.y(), c.y()});
    const int first = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
    const int last = std::min(height_ - 1, static_cast<int>(std::floor(high - 0.5)));
    for (int row = first; row <= last; ++row) {
      const double y = row + 0.5;
      double from = 1e300;
      double to = -1e300;
      const auto cross = [&](const Vector2d& p, const Vector2d& q) { // where an edge meets the row
        if ((p.y() < y && q.y() < y) || (p.y() > y && q.y() > y)) return;
        if (p.y() == q.y()) {
          from = std::min({from, p.x(), q.x()});
          to = std::max({to, p.x(), q.x()});
          return;
        }
        const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        from = std::min(from, x);
        to = std::max(to, x);
      };
      cross(a, b);
      cross(b, c);
      cross(c, a);
      const int left = std::max(0, static_cast<int>(std::ceil(from - 0.5)));
      const int right = std::min(width_ - 1, static_cast<int>(std::floor(to - 0.5)));
      if (left > right) continue;
      const auto begin = isCovered_.begin() + static_cast<std::ptrdiff_t>(row) * width_;
      std::fill(begin + left, begin + right + 1, std::uint8_t{1});
    }
  }

  [[nodiscard]] std::size_t covered() const {
    return static_cast<std::size_t>(
        std::count(isCovered_.begin(), isCovered_.end(), std::uint8_t{1}));
  }

private:
  int width_;
  int height_;
  std::vector<std::uint8_t> isCovered_;
};

/// Area of what is seen along `direction` [L^2].
double silhouette(const std::vector<Vector3d>& corners,
                  const std::vector<std::array<int, 3>>& triangles, const Vector3d& direction,
                  int pixels) {
  const Vector3d right = direction.unitOrthogonal();
  const Vector3d up = direction.cross(right);
  std::vector<Vector2d> seen(corners.size());
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i] = {corners[i].dot(right), corners[i].dot(up)};
    box.extend(seen[i]);
  }
  const double pixel = box.sizes().maxCoeff() / pixels;
  if (!(pixel > 0)) return 0;
  const Eigen::Vector2i size = (box.sizes() / pixel).array().ceil().cast<int>().max(1);
  for (Vector2d& place : seen)
    place = (place - box.min()) / pixel;
  Picture picture(size.x(), size.y());
  const auto at = [&](int corner) { return seen[static_cast<std::size_t>(corner)]; };
  for (const auto& [a, b, c] : triangles)
    picture.draw(at(a), at(b), at(c));
  return static_cast<double>(picture.covered()) * pixel * pixel;
}

} // namespace

LightInterception lightInterception(const SurfaceMesh& mesh, const LightOptions& options,
                                    const Progress& progress) {
  if (options.pixels < 8 || options.pixels > 16384)
    throw Error(std::to_string(options.pixels) + " pixels: choose from 8 to 16384");
  LightInterception light{.area = area(mesh)};
  if (!(light.area > 0))
    throw ShownError({espalier::Shown::tr("the surface has no area: estimate radii first")});
  const std::vector<Vector3d> corners = centeredCorners(mesh);
  const std::vector<SkyDirection>& sky = overcastSky();
  for (const int part : {8, 4, 2, 1})
    light.convergence.push_back({.pixels = options.pixels / part});

  const std::size_t parts = light.convergence.size();
  std::vector<double> areas(sky.size() *
                            parts); // of silhouettes, all parts of a direction together
  parallelFor(
      static_cast<Eigen::Index>(areas.size()),
      [&](Eigen::Index i) {
        const auto k = static_cast<std::size_t>(i);
        areas[k] = silhouette(corners, mesh.triangles, sky[k / parts].direction,
                              light.convergence[k % parts].pixels);
      },
      progress, 1);
  for (std::size_t i = 0; i < sky.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k)
      light.convergence[k].star += sky[i].weight * areas[i * parts + k] / light.area;
    const double seen = areas[i * parts + parts - 1];
    light.directions.push_back({.elevation = sky[i].elevation,
                                .azimuth = sky[i].azimuth,
                                .weight = sky[i].weight,
                                .silhouette = seen,
                                .star = seen / light.area});
  }
  light.star = light.convergence.back().star;
  return light;
}

} // namespace espalier
