#include "core/contract/ball_centers.h"

#include "core/base/moments.h"

#include <array>
#include <vector>

namespace espalier {
namespace {

Moments momentsOf(const std::vector<Eigen::Vector3f>& members) {
  Moments moments(members.front().cast<double>());
  for (const Eigen::Vector3f& point : members)
    moments.add(point);
  return moments;
}

std::optional<WoodCircle> circleOf(const std::vector<Eigen::Vector3f>& members,
                                   const Moments& moments, double radius) {
  constexpr double leastLinearity = 0.4;
  const auto components = moments.components();
  const Eigen::Vector3d& variances = components.eigenvalues();
  if (variances[2] - variances[1] < leastLinearity * variances[2]) return std::nullopt;
  return circleAround(members, components.eigenvectors().col(2), radius);
}

Eigen::Vector3d center(const std::vector<Eigen::Vector3f>& members, double radius) {
  const Moments moments = momentsOf(members);
  const std::optional<WoodCircle> circle = circleOf(members, moments, radius);
  return circle ? circle->center : moments.mean();
}

} // namespace

std::optional<WoodCircle> circleOfBall(const std::vector<Eigen::Vector3f>& members, double radius) {
  return circleOf(members, momentsOf(members), radius);
}

void putCenters(const GeodesicBalls& balls, const Eigen::Matrix3Xf& points,
                const GeodesicBalls::Lanes& radii, bool fitsCircles, Eigen::Matrix3Xf& centers) {
  if (fitsCircles) {
    std::array<std::vector<Eigen::Vector3f>, GeodesicBalls::most> members;
    balls.forEachMember([&](std::size_t ball, std::uint32_t point, float /*distance*/) {
      members[ball].emplace_back(points.col(point));
    });
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      centers.col(balls.centers()[i]) =
          center(members[i], static_cast<double>(radii[static_cast<Eigen::Index>(i)]))
              .cast<float>();
    return;
  }
  std::array<Eigen::Vector3d, GeodesicBalls::most> sums;
  sums.fill(Eigen::Vector3d::Zero());
  std::array<int, GeodesicBalls::most> counts{};
  balls.forEachMember([&](std::size_t ball, std::uint32_t point, float /*distance*/) {
    sums[ball] += points.col(point).cast<double>();
    ++counts[ball];
  });
  for (std::size_t i = 0; i < balls.centers().size(); ++i)
    centers.col(balls.centers()[i]) = (sums[i] / counts[i]).cast<float>();
}

} // namespace espalier
