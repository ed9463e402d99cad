#include "core/cloud/wood_around.h"

#include "core/base/circle_fit.h"
#include "core/base/moments.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr std::array balls = {2.0, 2.8, 4.0, 5.6, 8.0, 11.3, 16.0, 22.6, 32.0}; // [spacings]
constexpr double freeBall = 8;     // [spacings]: in larger ones, only what is joined counts
constexpr double cube = 2;         // [spacings]
constexpr double mostRatio = 0.35; // of the second deviation to the first, of points along a line
constexpr double flattest = 0.2;   // of the third deviation to the first, of points on a sheet
constexpr int fewest = 6;          // points that may show a line
constexpr int enough = 24;         // points that lie along none by chance

using Around = std::vector<Eigen::Vector3d>; // [L], about the place

/// The points that cubes which touch join with the place.
class JoinedCubes {
public:
  JoinedCubes(const Around& around, double edge, double radius)
      : edge_(edge), half_(static_cast<int>(std::ceil(radius / edge)) + 1), wide_(2 * half_ + 1),
        state_(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(wide_) *
                   static_cast<std::size_t>(wide_),
               State::empty) {
    for (const Eigen::Vector3d& point : around)
      state_[cubeOf(point)] = State::filled;
    join();
  }

  [[nodiscard]] bool holds(const Eigen::Vector3d& point) const {
    return state_[cubeOf(point)] == State::joined;
  }

private:
  enum class State : char { empty, filled, joined };

  [[nodiscard]] std::size_t cubeOf(const Eigen::Vector3d& point) const {
    std::size_t at = 0;
    for (const double coordinate : point)
      at = at * static_cast<std::size_t>(wide_) +
           static_cast<std::size_t>(std::lround(coordinate / edge_) + half_);
    return at;
  }

  /// The outermost cubes are empty, so that each that is filled has all 26 beside it.
  void join() {
    const std::ptrdiff_t row = wide_;
    std::vector<std::size_t> met = {cubeOf(Eigen::Vector3d::Zero())};
    state_[met.front()] = State::joined;
    for (std::size_t next = 0; next < met.size(); ++next)
      for (std::ptrdiff_t x = -1; x <= 1; ++x)
        for (std::ptrdiff_t y = -1; y <= 1; ++y)
          for (std::ptrdiff_t z = -1; z <= 1; ++z) {
            const auto beside = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(met[next]) +
                                                         (x * row + y) * row + z);
            if (state_[beside] != State::filled) continue;
            state_[beside] = State::joined;
            met.push_back(beside);
          }
  }

  double edge_;
  int half_;
  int wide_;
  std::vector<State> state_;
};

Around pointsAround(const Eigen::Matrix3Xf& points, const SpatialIndex& index, Eigen::Index place,
                    double spacing, double ball) {
  const Eigen::Vector3f at = points.col(place);
  const double radius = ball * spacing;
  Around around;
  for (const Neighbor& neighbor : index.within(at, static_cast<float>(radius)))
    around.emplace_back(points.col(neighbor.index).cast<double>() - at.cast<double>());
  if (ball <= freeBall) return around;
  const JoinedCubes joined(around, cube * spacing, radius);
  std::erase_if(around, [&](const Eigen::Vector3d& point) { return !joined.holds(point); });
  return around;
}

/// By the moments of squared distances from the center, of `count` points of which three are spent
/// on the circle.
double scatterAbout(const Eigen::Vector2d& center, const std::vector<Eigen::Vector2d>& section) {
  const auto count = static_cast<double>(section.size());
  double sum = 0;
  double squares = 0;
  for (const Eigen::Vector2d& point : section) {
    const double squared = (point - center).squaredNorm();
    sum += squared;
    squares += squared * squared;
  }
  const double mean = sum / count;
  const double variance = std::max(squares / count - mean * mean, 0.0) * count / (count - 3);
  return std::sqrt((mean - std::sqrt(std::max(mean * mean - variance, 0.0))) / 2);
}

/// What a circle across points along a line shows.
void lookAcross(const Around& around, const Eigen::Matrix3d& directions, double spacing,
                WoodAround& wood) {
  constexpr std::size_t fewestScattered = 8;
  constexpr std::size_t fewestAround = 48;
  constexpr double thinnest = 3; // [spacings]
  constexpr int sectors = 16;
  if (around.size() < fewestScattered) return;
  std::vector<Eigen::Vector2d> section;
  section.reserve(around.size());
  for (const Eigen::Vector3d& point : around)
    section.emplace_back(directions.col(0).dot(point), directions.col(1).dot(point));
  const auto circle = fitCircle(section);
  if (!circle) return;
  if (!wood.scatter) wood.scatter = scatterAbout(circle->center, section);
  if (section.size() < fewestAround || 2 * circle->radius < thinnest * spacing ||
      circle->error > circle->radius / 3)
    return;
  const auto filled = std::lround(circle->coverage * sectors); // the ends of an arc fill half each
  wood.arc = 2 * std::numbers::pi / sectors *
             static_cast<double>(filled < sectors ? std::max(filled - 1, 1L) : filled);
}

/// About the paraboloid through points on a sheet; none of too few.
std::optional<double> scatterOfSheet(const Around& around, const Eigen::Matrix3d& directions) {
  constexpr int unknowns = 6;
  if (std::ssize(around) < 2 * unknowns) return std::nullopt;
  using Row = Eigen::Matrix<double, unknowns, 1>;
  Eigen::Matrix<double, unknowns, unknowns> normal =
      Eigen::Matrix<double, unknowns, unknowns>::Zero();
  Row right = Row::Zero();
  double squares = 0;
  double scale = 0; // so that all terms are of one size
  for (const Eigen::Vector3d& point : around)
    scale = std::max(scale, point.squaredNorm());
  scale = std::sqrt(scale);
  if (!(scale > 0)) return 0;
  for (const Eigen::Vector3d& point : around) {
    const double u = directions.col(2).dot(point) / scale;
    const double v = directions.col(1).dot(point) / scale;
    const double height = directions.col(0).dot(point) / scale;
    Row row;
    row << 1, u, v, u * u, u * v, v * v;
    normal.noalias() += row * row.transpose();
    right += row * height;
    squares += height * height;
  }
  const Row fitted = normal.ldlt().solve(right);
  const double left = std::max(squares - fitted.dot(right), 0.0);
  return scale * std::sqrt(left / static_cast<double>(std::ssize(around) - unknowns));
}

/// The points in a ball, and their principal components, the least first.
struct SeenInBall {
  Around around;
  Eigen::Matrix3d directions;
  Eigen::Vector3d variances; // [L^2]

  [[nodiscard]] bool isKnown() const { return std::ssize(around) >= fewest; }
  [[nodiscard]] bool isLine() const {
    return isKnown() && variances[1] <= mostRatio * mostRatio * variances[2];
  }
  [[nodiscard]] bool isSheet() const {
    return isKnown() && variances[0] <= flattest * flattest * variances[2];
  }
};

SeenInBall seenIn(const Eigen::Matrix3Xf& points, const SpatialIndex& index, Eigen::Index place,
                  double spacing, double ball) {
  SeenInBall seen{.around = pointsAround(points, index, place, spacing, ball)};
  if (!seen.isKnown()) return seen;
  Moments moments;
  for (const Eigen::Vector3d& point : seen.around)
    moments.add(point);
  const auto components = moments.components();
  seen.directions = components.eigenvectors();
  seen.variances = components.eigenvalues().cwiseMax(0);
  return seen;
}

} // namespace

WoodAround woodAround(const Eigen::Matrix3Xf& points, const SpatialIndex& index, Eigen::Index place,
                      double spacing, const WoodLook& look) {
  WoodAround wood;
  std::optional<SeenInBall> before; // a line that is to be confirmed
  for (const double ball : balls) {
    if (ball > look.farthest) break;
    SeenInBall seen = seenIn(points, index, place, spacing, ball);
    const bool isLine = seen.isLine();
    const bool isSure = before || !look.confirms || std::ssize(seen.around) >= enough;
    if (isLine && isSure) {
      const SeenInBall& first = before ? *before : seen;
      wood.thickness = 2 * std::sqrt(first.variances[0] + first.variances[1]);
      lookAcross(first.around, first.directions, spacing, wood);
      return wood;
    }
    before.reset();
    if (isLine)
      before = std::move(seen);
    else if (!wood.scatter && seen.isSheet())
      wood.scatter = scatterOfSheet(seen.around, seen.directions);
  }
  return wood;
}

} // namespace espalier
