#include "core/base/paced_check.h"
#include "core/surface/envelopes/asymmetric_hull.h"
#include "core/surface/envelopes/least_at.h"
#include "core/surface/envelopes/outline.h"

#include <Eigen/QR>

#include <numbers>
#include <optional>

namespace espalier {
namespace {

/// The level axes of a hull, as they are sought.
struct LevelAxes {
  Eigen::Vector2d center;
  double azimuth = 0;

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& place) const {
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    const Eigen::Vector2d from = place - center;
    return {c * from.x() + s * from.y(), c * from.y() - s * from.x()};
  }
};

struct FittedRadii {
  Eigen::Vector4d inverseSquares; // ahead, left, behind, right
  double error = 0;
};

/// The quarters of ellipses about given axes that lie nearest to an outline.
FittedRadii radiiAbout(const LevelAxes& axes, const std::vector<Eigen::Vector2d>& outline) {
  const auto count = static_cast<Eigen::Index>(outline.size());
  Eigen::MatrixX4d squares = Eigen::MatrixX4d::Zero(count, 4);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector2d at = axes(outline[static_cast<std::size_t>(i)]);
    squares(i, at.x() >= 0 ? 0 : 2) = at.x() * at.x();
    squares(i, at.y() >= 0 ? 1 : 3) = at.y() * at.y();
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  FittedRadii fitted{.inverseSquares = squares.colPivHouseholderQr().solve(ones), .error = 0};
  fitted.error = (squares * fitted.inverseSquares - ones).squaredNorm();
  if (fitted.inverseSquares.minCoeff() <= 0) fitted.error = 1e9;
  return fitted;
}

/// Even places on the outline of a crown, in units of the root of its area about its middle.
std::vector<Eigen::Vector2d> evenPlaces(const Outline& outline) {
  const OutlineReach reach(outline, outline.middle);
  std::vector<Eigen::Vector2d> places;
  constexpr int count = 360;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2 * std::numbers::pi * i / count;
    places.emplace_back(reach.at(azimuth) / std::sqrt(outline.area) *
                        Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth)));
  }
  return places;
}

/// Center, azimuth and radii. Where an outline is no such line, its extents are taken.
void fitWidestLine(AsymmetricHull& hull, const Outline& outline, const Progress& progress) {
  const std::vector<Eigen::Vector2d> places = evenPlaces(outline);
  const double unit = std::sqrt(outline.area);
  const auto axesAt = [](const Eigen::VectorXd& at) {
    return LevelAxes{.center = at.head<2>(), .azimuth = at[2]};
  };
  Eigen::VectorXd best = Eigen::Vector3d(0, 0, std::atan2(outline.along.y(), outline.along.x()));
  for (const double step : {0.2, 0.02})
    best = leastAt(
        [&](const Eigen::VectorXd& at) {
          if (at.head<2>().norm() > 0.5) return 1e9;
          return radiiAbout(axesAt(at), places).error;
        },
        best, Eigen::Vector3d(step, step, 2 * step), 400, progress);
  const FittedRadii fitted = radiiAbout(axesAt(best), places);
  hull.center = outline.middle + unit * best.head<2>();
  hull.azimuth = std::remainder(best[2], 2 * std::numbers::pi);
  for (std::size_t i = 0; i < 4; ++i) {
    const double inverse = fitted.inverseSquares[static_cast<Eigen::Index>(i)];
    hull.radii[i] = unit / std::sqrt(std::max(inverse, 0.05));
  }
}

/// Where the points are highest, or lowest.
Eigen::Vector3d endOf(const Crown& crown, double z, double tolerance) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0;
  for (const auto& point : crown.points.colwise()) {
    if (std::abs(point.z() - z) > tolerance) continue;
    sum += point.head<2>();
    ++count;
  }
  return {sum.x() / count, sum.y() / count, z};
}

/// How far out a place is, as a share of the widest line.
double shareOut(const AsymmetricHull& hull, const Eigen::Vector2d& along) {
  return std::hypot(along.x() / hull.radii[along.x() >= 0 ? 0 : 2],
                    along.y() / hull.radii[along.y() >= 0 ? 1 : 3]);
}

LevelAxes axesOf(const AsymmetricHull& hull) {
  return {.center = hull.center, .azimuth = hull.azimuth};
}

/// The ends stand within the widest line.
void drawInside(const AsymmetricHull& hull, Eigen::Vector3d& end) {
  const double out = shareOut(hull, axesOf(hull)(end.head<2>()));
  if (out <= 0.95) return;
  end.head<2>() = hull.center + 0.95 / out * (end.head<2>() - hull.center);
}

/// The outermost points of a crown, by azimuth and height.
std::vector<Eigen::Vector3d> outerPoints(const Crown& crown, const AsymmetricHull& hull,
                                         const Progress& progress) {
  constexpr int around = 36;
  constexpr int levels = 24;
  struct Cell {
    double out = -1;
    Eigen::Vector3d point;
  };
  std::vector<Cell> cells(static_cast<std::size_t>(around) * levels);
  const LevelAxes axes = axesOf(hull);
  const double height = hull.top.z() - hull.bottom.z();
  PacedCheck check(progress);
  for (const auto& point : crown.points.colwise()) {
    check.after(50);
    const Eigen::Vector2d at = axes(point.head<2>());
    const double turns = std::atan2(at.y(), at.x()) / (2 * std::numbers::pi) + 0.5;
    const int sector = std::min(static_cast<int>(turns * around), around - 1);
    const int level = std::clamp(static_cast<int>((point.z() - hull.bottom.z()) / height * levels),
                                 0, levels - 1);
    Cell& cell = cells[static_cast<std::size_t>(sector * levels + level)];
    const double out = shareOut(hull, at);
    if (out > cell.out) cell = {out, point};
  }
  std::vector<Eigen::Vector3d> points;
  for (const Cell& cell : cells)
    if (cell.out >= 0) points.push_back(cell.point);
  return points;
}

/// A point as seen from one end, straight out to the widest line.
struct SeenFromEnd {
  double out = 0;        // share of the path to the line
  std::size_t along = 0; // the places between which it meets the line
  std::size_t across = 1;
  double alongShare = 0; // of the height of the first
  [[nodiscard]] double lineHeight(const std::array<double, 4>& heights) const {
    return alongShare * heights[along] + (1 - alongShare) * heights[across];
  }
};

/// Solves where the ray from the end through the point meets the line: a quadratic per quarter.
SeenFromEnd seenFrom(const Eigen::Vector3d& end, const Eigen::Vector3d& point,
                     const AsymmetricHull& hull) {
  const LevelAxes axes = axesOf(hull);
  const Eigen::Vector2d from = axes(end.head<2>());
  const Eigen::Vector2d shift = axes(point.head<2>()) - from;
  SeenFromEnd seen;
  double reach = 0;
  for (const auto& [along, across] :
       {std::pair<std::size_t, std::size_t>{0, 1}, {2, 1}, {2, 3}, {0, 3}}) {
    const Eigen::Array2d radii(hull.radii[along], hull.radii[across]);
    const Eigen::Array2d start = from.array() / radii;
    const Eigen::Array2d step = shift.array() / radii;
    const double a = step.square().sum();
    const double b = (start * step).sum();
    const double c = start.square().sum() - 1;
    if (a <= 0 || b * b < a * c) continue;
    const double share = (std::sqrt(b * b - a * c) - b) / a;
    const Eigen::Vector2d at = from + share * shift;
    const bool isAhead = along == 0 ? at.x() >= -1e-9 * radii[0] : at.x() <= 1e-9 * radii[0];
    const bool isLeft = across == 1 ? at.y() >= -1e-9 * radii[1] : at.y() <= 1e-9 * radii[1];
    if (!isAhead || !isLeft || share <= reach) continue;
    reach = share;
    seen = {.out = 1 / share,
            .along = along,
            .across = across,
            .alongShare = std::min(1.0, (at.x() / radii[0]) * (at.x() / radii[0]))};
  }
  return seen;
}

/// Finds heights and exponents on outer points.
class ShapeFit {
public:
  ShapeFit(const AsymmetricHull& hull, const std::vector<Eigen::Vector3d>& points) : hull_(hull) {
    for (const Eigen::Vector3d& point : points)
      seen_.push_back(
          {point.z(), seenFrom(hull.top, point, hull), seenFrom(hull.bottom, point, hull)});
  }

  /// @param at heights as shares between the ends, then the logarithms of the exponents
  [[nodiscard]] AsymmetricHull hullAt(const Eigen::VectorXd& at) const {
    AsymmetricHull hull = hull_;
    const double bottom = hull.bottom.z();
    const double size = hull.top.z() - bottom;
    for (std::size_t i = 0; i < 4; ++i)
      hull.heights[i] =
          bottom + size * std::clamp(at[static_cast<Eigen::Index>(i)], 1e-3, 1 - 1e-3);
    hull.topShape = std::clamp(std::exp(at[4]), 0.3, 20.0);
    hull.bottomShape = std::clamp(std::exp(at[5]), 0.3, 20.0);
    return hull;
  }

  [[nodiscard]] double error(const Eigen::VectorXd& at) const {
    const AsymmetricHull hull = hullAt(at);
    double sum = 0;
    for (const Seen& each : seen_) {
      const double off = outTo(each, hull) - 1;
      sum += off * off;
    }
    return sum;
  }

private:
  struct Seen {
    double z;
    SeenFromEnd fromTop;
    SeenFromEnd fromBottom;
  };

  /// 1 on the hull, less inside.
  static double outTo(const Seen& each, const AsymmetricHull& hull) {
    const double line = each.fromTop.lineHeight(hull.heights);
    if (each.z >= line)
      return outAt(each.fromTop.out, (each.z - line) / (hull.top.z() - line), hull.topShape);
    const double below = each.fromBottom.lineHeight(hull.heights);
    const double down = std::max(0.0, (below - each.z) / (below - hull.bottom.z()));
    return outAt(each.fromBottom.out, down, hull.bottomShape);
  }
  static double outAt(double out, double up, double shape) {
    return std::pow(std::pow(out, shape) + std::pow(up, shape), 1 / shape);
  }

  const AsymmetricHull& hull_;
  std::vector<Seen> seen_;
};

} // namespace

AsymmetricHull fitAsymmetricHull(const Crown& crown, const Progress& progress) {
  AsymmetricHull hull;
  fitWidestLine(hull, outlineOf(crown), progress);
  const double height = topOf(crown) - bottomOf(crown);
  hull.top = endOf(crown, topOf(crown), 0.002 * height);
  hull.bottom = endOf(crown, bottomOf(crown), 0.002 * height);
  drawInside(hull, hull.top);
  drawInside(hull, hull.bottom);
  const ShapeFit fit(hull, outerPoints(crown, hull, progress));
  Eigen::VectorXd best = (Eigen::VectorXd(6) << 0.5, 0.5, 0.5, 0.5, 0.5, 0.5).finished();
  double least = std::numeric_limits<double>::infinity();
  for (const double start : {0.5, 0.2, 0.8}) { // where the crown is widest
    Eigen::VectorXd at = (Eigen::VectorXd(6) << start, start, start, start, 0.5, 0.5).finished();
    for (const double step : {0.3, 0.1})
      at = leastAt([&](const Eigen::VectorXd& each) { return fit.error(each); }, at,
                   Eigen::VectorXd::Constant(6, step), 800, progress);
    if (fit.error(at) >= least) continue;
    least = fit.error(at);
    best = at;
  }
  return fit.hullAt(best);
}

} // namespace espalier
