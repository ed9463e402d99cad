#include "tests/support/clouds.h"

#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier::test {
namespace {

Eigen::Vector3d forkPlace() {
  return {0, 0, 2};
}

std::array<Eigen::Vector3d, 2> armTips() {
  constexpr double angle = 35 * std::numbers::pi / 180;
  const double across = 1.5 * std::sin(angle);
  const double up = 1.5 * std::cos(angle);
  return {forkPlace() + Eigen::Vector3d(across, 0, up),
          forkPlace() + Eigen::Vector3d(-across, 0, up)};
}

double distance(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                const Eigen::Vector3d& to) {
  const Eigen::Vector3d along = to - from;
  const double fraction = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - fraction * along).norm();
}

} // namespace

Eigen::Matrix3Xf cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                          double spacing, std::uint64_t seed) {
  Random random(seed);
  const double length = (to - from).norm();
  const Eigen::Vector3d axis = (to - from) / length;
  const Eigen::Vector3d right = axis.unitOrthogonal();
  const Eigen::Vector3d up = axis.cross(right);
  const int rings = std::max(1, static_cast<int>(std::lround(length / spacing)));
  const int around =
      std::max(3, static_cast<int>(std::lround(2 * std::numbers::pi * radius / spacing)));
  Eigen::Matrix3Xf points(3, rings * around);
  for (int i = 0; i < points.cols(); ++i) {
    const double height = (i / around + random.uniform()) / rings * length;
    const double angle = 2 * std::numbers::pi * (i % around + random.uniform()) / around;
    const Eigen::Vector3d point =
        from + height * axis + radius * (std::cos(angle) * right + std::sin(angle) * up);
    points.col(i) = point.cast<float>();
  }
  return points;
}

double heightOf(const Eigen::Matrix3Xf& points, UpAxis up) {
  const auto heights = points.row(static_cast<Eigen::Index>(up));
  return static_cast<double>(heights.maxCoeff()) - static_cast<double>(heights.minCoeff());
}

Eigen::Matrix3Xf both(const Eigen::Matrix3Xf& a, const Eigen::Matrix3Xf& b) {
  Eigen::Matrix3Xf result(3, a.cols() + b.cols());
  result << a, b;
  return result;
}

Eigen::Matrix3Xf forkCloud(std::uint64_t seed) {
  Eigen::Matrix3Xf points = cylinder(Eigen::Vector3d::Zero(), forkPlace(), 0.04, 0.02, seed);
  for (const Eigen::Vector3d& tip : armTips())
    points = both(points, cylinder(forkPlace(), tip, 0.04, 0.02, ++seed));
  return points;
}

double farthestFromFork(const Skeleton& skeleton) {
  double farthest = 0;
  for (const NodeId id : skeleton.ids()) {
    const Eigen::Vector3d& place = skeleton[id].position;
    farthest = std::max(farthest, std::min({distance(place, Eigen::Vector3d::Zero(), forkPlace()),
                                            distance(place, forkPlace(), armTips()[0]),
                                            distance(place, forkPlace(), armTips()[1])}));
  }
  return farthest;
}

bool stopsWhenAsked(const std::function<void(const Progress&)>& work) {
  std::stop_source source;
  source.request_stop();
  try {
    work(Progress(source.get_token(), {}));
  } catch (const Cancelled&) {
    return true;
  }
  return false;
}

} // namespace espalier::test
