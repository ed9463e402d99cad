#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <vector>

// Its headers for C++ are not C++20.
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace espalier {

/// Points about their mean, for far origins cost digits, and how far they reach along the axes of
/// their spread, which are in order of it.
template <int dimension> struct Spread {
  using Points = Eigen::Matrix<double, dimension, Eigen::Dynamic>;

  explicit Spread(const Points& points) : centered(points.colwise() - points.rowwise().mean()) {
    const Eigen::Matrix<double, dimension, dimension> squares = centered * centered.transpose();
    along = Eigen::SelfAdjointEigenSolver<decltype(squares)>(squares).eigenvectors().transpose() *
            centered;
  }

  /// Else there is no body, and Qhull would only say so at length.
  [[nodiscard]] bool isSolid() const {
    const Eigen::Vector<double, dimension> sizes =
        along.rowwise().maxCoeff() - along.rowwise().minCoeff();
    return sizes.minCoeff() > 1e-9 * sizes.maxCoeff();
  }

  /// The points farthest apart along the widest axis; one if all lie at a place.
  [[nodiscard]] std::vector<Eigen::Index> ends() const {
    Eigen::Index first = 0;
    Eigen::Index last = 0;
    if (along.row(dimension - 1).minCoeff(&first) == along.row(dimension - 1).maxCoeff(&last))
      return {first};
    return {first, last};
  }

  Points centered;
  Points along;
};

/// Qhull's facets about some points: triangles in space, edges in the plane. Each has its own
/// state, so that many threads may make some. Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa,
/// "The Quickhull algorithm for convex hulls", ACM Transactions on Mathematical Software 22, 1996
/// (libqhull_r).
class Facets {
public:
  /// @param points a column each, which are solid (see Spread)
  explicit Facets(Eigen::MatrixXd points);
  ~Facets();
  Facets(const Facets&) = delete;
  Facets& operator=(const Facets&) = delete;

  [[nodiscard]] std::vector<Eigen::Index> corners() const; // the points that are some

  // In space:
  [[nodiscard]] double volume() const { return qh_.totvol; }
  [[nodiscard]] double area() const { return qh_.totarea; }
  /// The points of each triangle, counterclockwise as seen from outside.
  [[nodiscard]] std::vector<std::array<int, 3>> triangles() const;

private:
  void free();

  Eigen::MatrixXd points_; // it keeps its place
  mutable qhT qh_{};       // Qhull does not know const
};

} // namespace espalier
