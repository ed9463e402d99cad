#include "core/surface/envelopes/envelope.h"

#include "core/base/parallel.h"
#include "core/base/plane_hull.h"

#include <Eigen/Geometry>

#include <atomic>
#include <numbers>
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
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      add(i);
  }

  /// Whether as many walls as make it inside lie above a place.
  [[nodiscard]] bool isInside(const Eigen::Vector3d& place) const {
    if (!box_.contains(Eigen::Vector2d(place.head<2>()))) return false;
    int walls = 0;
    for (const std::size_t triangle : cells_[cellAt(column(place, 0), column(place, 1))])
      walls += wallAbove(triangle, place);
    return walls != 0;
  }

private:
  [[nodiscard]] const Eigen::Vector3d& corner(std::size_t triangle, std::size_t i) const {
    return mesh_.corners[static_cast<std::size_t>(mesh_.triangles[triangle][i])];
  }

  [[nodiscard]] int column(const Eigen::Vector3d& place, int axis) const {
    const double size = std::max(box_.sizes()[axis], 1e-300);
    const double share = (place[axis] - box_.min()[axis]) / size;
    return std::clamp(static_cast<int>(share * side_), 0, side_ - 1);
  }

  [[nodiscard]] std::size_t cellAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(x);
  }

  void add(std::size_t triangle) {
    Eigen::AlignedBox3d over;
    for (std::size_t i = 0; i < 3; ++i)
      over.extend(corner(triangle, i));
    for (int y = column(over.min(), 1); y <= column(over.max(), 1); ++y)
      for (int x = column(over.min(), 0); x <= column(over.max(), 0); ++x)
        cells_[cellAt(x, y)].push_back(triangle);
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

  const SurfaceMesh& mesh_;
  Eigen::AlignedBox2d box_;
  double tolerance_ = 0;
  int side_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

} // namespace

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
