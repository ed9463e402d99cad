#include "core/surface/envelopes/extruded_hull.h"

#include "core/base/plane_hull.h"
#include "core/surface/envelopes/outline.h"
#include "core/surface/envelopes/rings.h"

#include <numbers>
#include <set>

namespace espalier {
namespace {

/// The crown from the side: from where to where it reaches along a level direction, by height.
class SideProfile {
public:
  SideProfile(const Crown& crown, const Eigen::Vector2d& along) {
    std::vector<Eigen::Vector2d> seen;
    for (const auto& corner : crown.hull.corners.colwise())
      seen.emplace_back(along.dot(corner.head<2>()), corner.z());
    corners_ = planeHull(seen);
  }

  [[nodiscard]] const std::vector<Eigen::Vector2d>& corners() const { return corners_; }

  /// Ascending: where its sides bend.
  [[nodiscard]] std::vector<double> heights() const {
    std::set<double> all;
    for (const Eigen::Vector2d& corner : corners_)
      all.insert(corner.y());
    return {all.begin(), all.end()};
  }

  /// From the left side to the right one at a height it has.
  [[nodiscard]] std::pair<double, double> at(double z) const {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Eigen::Vector2d& a = corners_[i];
      const Eigen::Vector2d& b = corners_[(i + 1) % corners_.size()];
      if (z < std::min(a.y(), b.y()) || z > std::max(a.y(), b.y())) continue;
      const double share = a.y() == b.y() ? 0 : (z - a.y()) / (b.y() - a.y());
      for (const double x : {a.x() + share * (b.x() - a.x()),
                             a.y() == b.y() ? b.x() : a.x() + share * (b.x() - a.x())}) {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    return {left, right};
  }

private:
  std::vector<Eigen::Vector2d> corners_; // along, z
};

} // namespace

Envelope extrudedHull(const Crown& crown, const ExtrudedHullOptions& options,
                      const Progress& progress) {
  const Outline outline = outlineOf(crown);
  Eigen::Vector2d along = boxAround(outline).along;
  if (options.isAcross) along = Eigen::Vector2d(-along.y(), along.x());
  const SideProfile side(crown, along);
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const Eigen::Vector2d& corner : outline.corners) {
    left = std::min(left, along.dot(corner));
    right = std::max(right, along.dot(corner));
  }
  // Level lines that the outline is moved along, so that its ends lie on the side profile.
  const auto placed = [&](const Eigen::Vector2d& corner, double from, double to) {
    const double scale = (to - from) / (right - left);
    const Eigen::Vector2d across =
        corner - along.dot(corner) * along - (outline.middle - along.dot(outline.middle) * along);
    const Eigen::Vector2d still = outline.middle - along.dot(outline.middle) * along;
    return Eigen::Vector2d(still + scale * across +
                           (from + scale * (along.dot(corner) - left)) * along);
  };
  const std::vector<double> heights = side.heights();
  std::vector<Ring> rings;
  for (const double z : heights) {
    progress.check();
    const auto [from, to] = side.at(z);
    if (to - from <= 1e-9 * (right - left)) continue;
    Ring& ring = rings.emplace_back();
    for (const Eigen::Vector2d& corner : outline.corners) {
      const Eigen::Vector2d at = placed(corner, from, to);
      ring.emplace_back(at.x(), at.y(), z);
    }
  }
  const auto end = [&](double z) {
    const auto [from, to] = side.at(z);
    const Eigen::Vector2d at = placed(outline.middle, from, to);
    return Eigen::Vector3d(at.x(), at.y(), z);
  };
  Envelope envelope = envelopeOf(meshOfRings(end(heights.front()), rings, end(heights.back())));
  using Kind = EnvelopeParameter::Kind;
  const auto count = [](std::size_t corners) { return static_cast<double>(corners); };
  envelope.parameters = {
      {"azimuth", "azimuth of the side profile", Kind::angle, std::atan2(along.y(), along.x())},
      {"outline_corners", "corners of the outline", Kind::number, count(outline.corners.size())},
      {"profile_corners", "corners of the side profile", Kind::number,
       count(side.corners().size())},
      {"inside", "share of the points inside", Kind::number,
       shareInside(envelope.mesh, crown.points, progress)}};
  return envelope;
}

} // namespace espalier
