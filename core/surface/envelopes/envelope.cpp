#include "core/surface/envelopes/envelope.h"

#include "core/base/parallel.h"
#include "core/base/plane_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

double outlineArea(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector2d> seen;
  for (const Eigen::Vector3d& corner : mesh.corners)
    seen.emplace_back(corner.head<2>() - mesh.corners.front().head<2>());
  const std::vector<Eigen::Vector2d> outline = planeHull(seen);
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& from = outline[i];
    const Eigen::Vector2d& to = outline[(i + 1) % outline.size()];
    sum += from.x() * to.y() - from.y() * to.x();
  }
  return sum / 2;
}

/// Triangles by the cells of a grid that they lie over, as seen from above.
class TrianglesFromAbove {
public:
  explicit TrianglesFromAbove(const SurfaceMesh& mesh) : mesh_(mesh) {
    Eigen::AlignedBox3d whole;
    for (const Eigen::Vector3d& corner : mesh.corners)
      whole.extend(corner);
    box_ = {whole.min().head<2>(), whole.max().head<2>()};
    tolerance_ = 1e-9 * whole.sizes().norm();
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(mesh.triangles.size()))));
    index();
  }

  /// Whether as many walls as make it inside lie above a place.
  [[nodiscard]] bool isInside(const Eigen::Vector3d& place) const {
    if (!box_.contains(Eigen::Vector2d(place.head<2>()))) return false;
    int walls = 0;
    const std::size_t cell = cellAt(cellOf(along(place, 0)), cellOf(along(place, 1)));
    for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i)
      walls += wallAbove(triangles_[i], place);
    return walls != 0;
  }

private:
  [[nodiscard]] const Eigen::Vector3d& corner(std::size_t triangle, std::size_t i) const {
    return mesh_.corners[static_cast<std::size_t>(mesh_.triangles[triangle][i])];
  }

  /// Where a place is across the grid, in cells.
  [[nodiscard]] double along(const Eigen::Vector3d& place, int axis) const {
    const double size = std::max(box_.sizes()[axis], 1e-300);
    return (place[axis] - box_.min()[axis]) / size * side_;
  }

  [[nodiscard]] int cellOf(double along) const {
    return static_cast<int>(std::clamp(along, 0.0, side_ - 1.0));
  }

  [[nodiscard]] std::size_t cellAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(x);
  }

  /// Counts what lies over each cell, then fills one list of all.
  void index() {
    begins_.assign(cellAt(0, side_) + 1, 0);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      forCellsUnder(i, [&](std::size_t cell) { ++begins_[cell + 1]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    triangles_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      forCellsUnder(i, [&](std::size_t cell) { triangles_[next[cell]++] = i; });
  }

  /// Row by row, as long as the triangle is wide there: of a sliver of a fan, which crosses half
  /// of the grid, its bounding box would be nearly all cells.
  template <class Visit> void forCellsUnder(std::size_t triangle, const Visit& visit) const {
    std::array<Eigen::Vector2d, 3> corners;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = {along(corner(triangle, i), 0), along(corner(triangle, i), 1)};
      low = std::min(low, corners[i].y());
      high = std::max(high, corners[i].y());
    }
    for (int y = cellOf(low - slack); y <= cellOf(high + slack); ++y) {
      const auto [from, to] = widthAt(corners, y - slack, y + 1 + slack);
      for (int x = cellOf(from - slack); x <= cellOf(to + slack) && from <= to; ++x)
        visit(cellAt(x, y));
    }
  }

  /// From where to where a triangle reaches between two heights; nowhere: the first is greater.
  static std::pair<double, double> widthAt(const std::array<Eigen::Vector2d, 3>& corners,
                                           double low, double high) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d& a = corners[i];
      const Eigen::Vector2d step = corners[(i + 1) % 3] - a;
      const auto reachAt = [&](double height) {
        const double share = std::clamp((height - a.y()) / step.y(), 0.0, 1.0);
        least = std::min(least, a.x() + share * step.x());
        most = std::max(most, a.x() + share * step.x());
      };
      if (std::max(a.y(), a.y() + step.y()) < low || std::min(a.y(), a.y() + step.y()) > high)
        continue;
      if (step.y() == 0) {
        least = std::min({least, a.x(), a.x() + step.x()});
        most = std::max({most, a.x(), a.x() + step.x()});
      } else {
        reachAt(low);
        reachAt(high);
      }
    }
    return {least, most};
  }

  /// 1 for a wall above that turns up, -1 for one that turns down, 0 for none.
  [[nodiscard]] int wallAbove(std::size_t triangle, const Eigen::Vector3d& place) const {
    std::array<double, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d& a = corner(triangle, i);
      const Eigen::Vector3d& b = corner(triangle, (i + 1) % 3);
      sides[i] = sideOf(a, b, place);
    }
    const bool isUp = sides[0] > 0 && sides[1] > 0 && sides[2] > 0;
    const bool isDown = sides[0] < 0 && sides[1] < 0 && sides[2] < 0;
    if (!isUp && !isDown) return 0;
    const double sum = sides[0] + sides[1] + sides[2];
    const double z = (sides[1] * corner(triangle, 0).z() + sides[2] * corner(triangle, 1).z() +
                      sides[0] * corner(triangle, 2).z()) /
                     sum;
    if (isUp) return z >= place.z() - tolerance_ ? 1 : 0; // on the surface is inside
    return z > place.z() + tolerance_ ? -1 : 0;
  }

  /// Twice the area to the left of an edge; the same edge turned round has exactly its negative,
  /// and 0 counts as left of the edge that goes up, so that each place is over one triangle.
  static double sideOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                       const Eigen::Vector3d& place) {
    const bool isTurned = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
    const Eigen::Vector3d& from = isTurned ? b : a;
    const Eigen::Vector3d& to = isTurned ? a : b;
    double side =
        (to.x() - from.x()) * (place.y() - from.y()) - (to.y() - from.y()) * (place.x() - from.x());
    if (side == 0) side = std::numeric_limits<double>::min();
    return isTurned ? -side : side;
  }

  static constexpr double slack = 1e-6; // of a cell, for rounding

  const SurfaceMesh& mesh_;
  Eigen::AlignedBox2d box_;
  double tolerance_ = 0;
  int side_ = 1;
  std::vector<std::size_t> begins_;    // of each cell in the list, and its end
  std::vector<std::size_t> triangles_; // of all cells
};

} // namespace

std::vector<EnvelopeParameter> ownParameters(const Envelope& envelope) {
  std::vector<EnvelopeParameter> result = envelope.parameters;
  std::erase_if(result, [&](const EnvelopeParameter& each) { return each.name == "height"; });
  return result;
}

Envelope envelopeOf(SurfaceMesh mesh, std::vector<EnvelopeParameter> parameters) {
  Envelope envelope;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& corner : mesh.corners)
    box.extend(corner);
  envelope.volume = volume(mesh);
  envelope.area = area(mesh);
  envelope.height = box.sizes().z();
  envelope.diameter = 2 * std::sqrt(outlineArea(mesh) / std::numbers::pi);
  envelope.mesh = std::move(mesh);
  envelope.parameters = std::move(parameters);
  return envelope;
}

double valueOf(const std::vector<EnvelopeParameter>& parameters, const std::string& name) {
  const auto found = std::ranges::find(parameters, name, &EnvelopeParameter::name);
  assert(found != parameters.end());
  return found->value;
}

Eigen::Vector3d placeOf(const std::vector<EnvelopeParameter>& parameters, const std::string& name) {
  return {valueOf(parameters, name + "_x"), valueOf(parameters, name + "_y"),
          valueOf(parameters, name + "_z")};
}

void addPlace(std::vector<EnvelopeParameter>& parameters, const std::string& name,
              const std::string& label, const Eigen::Vector3d& place) {
  constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string axis = axes[static_cast<std::size_t>(i)];
    parameters.push_back({.name = name + '_' + axis,
                          .label = label + ' ' + axis,
                          .kind = EnvelopeParameter::Kind::coordinate,
                          .value = place[i]});
  }
}

namespace {

void movePlaces(std::vector<EnvelopeParameter>& parameters, const Eigen::Matrix3d& turn,
                const Eigen::Vector3d& move) {
  for (std::size_t i = 0; i + 2 < parameters.size(); ++i) {
    if (parameters[i].kind != EnvelopeParameter::Kind::coordinate) continue;
    const Eigen::Vector3d place(parameters[i].value, parameters[i + 1].value,
                                parameters[i + 2].value);
    const Eigen::Vector3d moved = turn * place + move;
    for (std::size_t axis = 0; axis < 3; ++axis)
      parameters[i + axis].value = moved[static_cast<Eigen::Index>(axis)];
    i += 2;
  }
}

} // namespace

void moveEnvelope(Envelope& envelope, const Eigen::Matrix3d& turn, const Eigen::Vector3d& move) {
  const auto moveAll = [&](std::vector<Eigen::Vector3d>& corners) {
    for (Eigen::Vector3d& corner : corners)
      corner = turn * corner + move;
  };
  moveAll(envelope.mesh.corners);
  for (std::vector<Eigen::Vector3d>& profile : envelope.profiles)
    moveAll(profile);
  movePlaces(envelope.parameters, turn, move);
  envelope.directions = turn * envelope.directions;
}

double shareInside(const SurfaceMesh& mesh, const Eigen::Matrix3Xd& points,
                   const Progress& progress) {
  if (points.cols() == 0) return 0;
  const TrianglesFromAbove triangles(mesh);
  std::atomic<Eigen::Index> inside = 0;
  parallelFor(
      points.cols(),
      [&](Eigen::Index i) {
        if (triangles.isInside(points.col(i))) ++inside;
      },
      progress, 4096);
  return static_cast<double>(inside) / static_cast<double>(points.cols());
}

} // namespace espalier
