#include "core/surface/convex_hull.h"

#include "core/base/error.h"

#include <Eigen/Eigenvalues>

#include <map>
#include <utility>

// Its headers for C++ are not C++20.
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace espalier {
namespace {

/// Whether points fill space: else there is no body, and Qhull would only say so at length.
bool areSolid(const Eigen::Matrix3Xd& centered) {
  const Eigen::Matrix3d spread = centered * centered.transpose();
  const Eigen::Vector3d squares =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return squares[0] > 1e-18 * squares[2]; // not thinner than a billionth of its length
}

/// Qhull's facets about some points, all of them triangles.
class Facets {
public:
  explicit Facets(Eigen::Matrix3Xd points) : points_(std::move(points)) { // it keeps its place
    qh_zero(&qh_, stderr);
    std::string command = "qhull Qt Pp";
    if (qh_new_qhull(&qh_, 3, static_cast<int>(points_.cols()), points_.data(), False,
                     command.data(), nullptr, nullptr) != qh_ERRnone) {
      free();
      throw Error("the convex hull of the points could not be found");
    }
    qh_getarea(&qh_, qh_.facet_list);
  }
  ~Facets() { free(); }
  Facets(const Facets&) = delete;
  Facets& operator=(const Facets&) = delete;

  [[nodiscard]] double volume() const { return qh_.totvol; }
  [[nodiscard]] double area() const { return qh_.totarea; }

  /// The points of each triangle, counterclockwise as seen from outside.
  [[nodiscard]] std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> result;
    for (const facetT* facet = qh_.facet_list; facet->next != nullptr; facet = facet->next) {
      std::array<int, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = qh_pointid(&qh_, SETelemt_(facet->vertices, i, vertexT)->point);
      const auto at = [&](std::size_t i) { return points_.col(triangle[i]); };
      const Eigen::Map<const Eigen::Vector3d> out(facet->normal);
      if ((at(1) - at(0)).cross(at(2) - at(0)).dot(out) < 0) std::swap(triangle[1], triangle[2]);
      result.push_back(triangle);
    }
    return result;
  }

private:
  void free() {
    qh_freeqhull(&qh_, !qh_ALL); // large blocks, then the small ones
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }

  Eigen::Matrix3Xd points_;
  qhT qh_{};
};

} // namespace

std::optional<ConvexHull> convexHull(const Eigen::Matrix3Xd& points) {
  if (points.cols() < 4) return {};
  const Eigen::Vector3d center = points.rowwise().mean();
  const Eigen::Matrix3Xd centered = points.colwise() - center; // far origins cost digits
  if (!areSolid(centered)) return {};
  Facets facets(centered);
  ConvexHull hull{
      .triangles = facets.triangles(), .volume = facets.volume(), .area = facets.area()};
  std::map<int, int> cornerOf; // by point
  for (std::array<int, 3>& triangle : hull.triangles)
    for (int& corner : triangle)
      corner = cornerOf.try_emplace(corner, static_cast<int>(cornerOf.size())).first->second;
  hull.corners.resize(3, static_cast<Eigen::Index>(cornerOf.size()));
  for (const auto& [point, corner] : cornerOf)
    hull.corners.col(corner) = points.col(point);
  return hull;
}

} // namespace espalier
