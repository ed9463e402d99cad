#include "core/graph/normals.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/graph/components.h"

#include <queue>

#include <cmath>
#include <tuple>
#include <vector>

namespace espalier {
namespace {

/// The point of each component that is farthest from its mean, and that mean.
struct Outermost {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double squaredDistance = -1;
  std::uint32_t point = 0;
};

std::vector<Outermost> outermostPoints(const Eigen::Matrix3Xf& points,
                                       const Components& components) {
  std::vector<Outermost> all(components.count());
  const auto size = static_cast<std::uint32_t>(points.cols());
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t of = components.ofPoint[i];
    all[of].mean += points.col(i).cast<double>() / static_cast<double>(components.sizes[of]);
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    Outermost& one = all[components.ofPoint[i]];
    const double squared = (points.col(i).cast<double>() - one.mean).squaredNorm();
    if (squared <= one.squaredDistance) continue;
    one.squaredDistance = squared;
    one.point = i;
  }
  return all;
}

struct Step {
  float weight;
  std::uint32_t to;
  std::uint32_t from;
  [[nodiscard]] bool operator>(const Step& other) const {
    return std::tuple(weight, to, from) > std::tuple(other.weight, other.to, other.from);
  }
};

} // namespace

Eigen::Matrix3Xf normals(const Eigen::Matrix3Xf& points, const Neighborhoods& neighborhoods,
                         const Progress& progress) {
  Eigen::Matrix3Xf result(3, points.cols());
  const auto find = [&](Eigen::Index i) {
    Moments moments(points.col(i).cast<double>());
    moments.add(Eigen::Vector3f(points.col(i)));
    for (const std::uint32_t other : neighborhoods.of(i))
      moments.add(Eigen::Vector3f(points.col(other)));
    result.col(i) = moments.components().eigenvectors().col(0).cast<float>();
  };
  parallelFor(points.cols(), find, progress);
  return result;
}

Eigen::Matrix3Xf orientedNormals(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& normals,
                                 const NeighborhoodGraph& graph, const Progress& progress) {
  Eigen::Matrix3Xf result = normals;
  std::vector<bool> isTurned(static_cast<std::size_t>(points.cols()), false);
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
  Eigen::Index done = 0;
  const auto settle = [&](std::uint32_t point, const Eigen::Vector3f& like) {
    isTurned[point] = true;
    if (result.col(point).dot(like) < 0) result.col(point) *= -1;
    for (const NeighborhoodGraph::Link& link : graph.links(point)) {
      if (isTurned[link.to]) continue;
      const float agreement = std::abs(result.col(point).dot(result.col(link.to)));
      queue.push({1 - agreement, link.to, point});
    }
    if (++done % 4096 == 0)
      progress.update(static_cast<double>(done) / static_cast<double>(points.cols()));
  };
  for (const Outermost& start : outermostPoints(points, connectedComponents(graph))) {
    const Eigen::Vector3d away = points.col(start.point).cast<double>() - start.mean;
    settle(start.point, away.cast<float>());
    while (!queue.empty()) {
      const Step next = queue.top();
      queue.pop();
      if (!isTurned[next.to]) settle(next.to, result.col(next.from));
    }
  }
  progress.update(1);
  return result;
}

} // namespace espalier
