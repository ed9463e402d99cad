#include "core/surface/envelopes/enclosing_ball.h"

#include "core/base/random.h"
#include "core/base/shown.h"
#include "core/surface/envelopes/rings.h"

#include <Eigen/QR>

#include <numbers>
#include <numeric>

namespace espalier {
namespace {

/// The smallest ball through up to 4 places.
Ball3 ballThrough(const std::vector<Eigen::Vector3d>& places) {
  if (places.empty()) return {.center = Eigen::Vector3d::Zero(), .radius = -1};
  const Eigen::Index count = static_cast<Eigen::Index>(places.size()) - 1;
  if (count == 0) return {.center = places[0], .radius = 0};
  Eigen::Matrix3Xd from(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    from.col(i) = places[static_cast<std::size_t>(i) + 1] - places[0];
  const Eigen::VectorXd squares = from.colwise().squaredNorm().transpose() / 2;
  const Eigen::Vector3d center =
      from * (from.transpose() * from).completeOrthogonalDecomposition().solve(squares);
  return {.center = places[0] + center, .radius = center.norm()};
}

/// Grows a ball over places, one by one; one outside is on the ball of all before it.
class GrowingBall {
public:
  GrowingBall(const std::vector<Eigen::Vector3d>& places, const Progress& progress)
      : places_(places), progress_(progress) {}

  [[nodiscard]] Ball3 over(std::size_t count) {
    progress_.check();
    Ball3 ball = ballThrough(support_);
    if (support_.size() == 4) return ball;
    for (std::size_t i = 0; i < count; ++i) {
      if ((places_[i] - ball.center).norm() <= ball.radius * (1 + 1e-12)) continue;
      support_.push_back(places_[i]);
      ball = over(i);
      support_.pop_back();
    }
    return ball;
  }

private:
  const std::vector<Eigen::Vector3d>& places_;
  const Progress& progress_;
  std::vector<Eigen::Vector3d> support_; // on the ball, whatever else is
};

} // namespace

Ball3 enclosingBall(const Eigen::Matrix3Xd& points, const Progress& progress) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& point : points.colwise())
    places.emplace_back(point);
  Random random(1);
  for (std::size_t i = places.size(); i > 1; --i)
    std::swap(places[i - 1], places[random.below(i)]);
  return GrowingBall(places, progress).over(places.size());
}

Envelope ballOf(const Ball3& ball) {
  const auto& [center, radius] = ball;
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= ringLevels; ++i) {
    const double angle = std::numbers::pi * i / ringLevels;
    const bool isEnd = i == 0 || i == ringLevels;
    profile.emplace_back(isEnd ? 0 : radius * std::sin(angle),
                         center.z() - radius * std::cos(angle));
  }
  Envelope envelope = envelopeOf(meshOfTurned(profile, center.head<2>()));
  envelope.parameters.push_back({.name = "radius", .label = Shown::tr("radius"), .value = radius});
  addPlace(envelope.parameters, "center", Shown::tr("center"), center);
  envelope.volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
  envelope.area = 4 * std::numbers::pi * radius * radius;
  envelope.diameter = 2 * radius;
  return envelope;
}

Envelope ballEnvelope(const Crown& crown, const Progress& progress) {
  return ballOf(enclosingBall(crown.hull.corners, progress));
}

} // namespace espalier
