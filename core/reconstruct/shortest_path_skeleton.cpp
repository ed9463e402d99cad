#include "core/reconstruct/shortest_path_skeleton.h"

#include "core/reconstruct/point_tree.h"
#include "core/reconstruct/reached_points.h"
#include "core/reconstruct/thick_wood.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

using Children = PointTree::Children;

constexpr int mostRounds = 10;
constexpr double allometry = 1.1; // of the radius, by the longest path down

/// Mean distance of the lowest twentieth of the plant from its axis.
double radiusAtFoot(const PointTree& tree) {
  const double part = tree.longestDown().front() / 20;
  std::vector<double> fromRoot(tree.size(), 0);
  std::vector<Eigen::Vector3d> foot = {tree.positions.front()};
  for (std::size_t i = 1; i < tree.size(); ++i) {
    fromRoot[i] = fromRoot[tree.parents[i]] + tree.edge(i).norm();
    if (fromRoot[i] <= part) foot.push_back(tree.positions[i]);
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& position : foot)
    mean += position / static_cast<double>(foot.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& position : foot)
    spread += (position - mean) * (position - mean).transpose();
  const Eigen::Vector3d axis =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  double distance = 0;
  for (const Eigen::Vector3d& position : foot)
    distance += (position - mean).cross(axis).norm() / static_cast<double>(foot.size());
  return distance;
}

double distanceFromSegment(const Eigen::Vector3d& place, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to) {
  const Eigen::Vector3d along = to - from;
  const double squared = along.squaredNorm();
  const double fraction =
      squared > 0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0;
  return (place - from - fraction * along).norm();
}

class Simplifier {
public:
  Simplifier(PointTree tree, const ShortestPathOptions& options)
      : tree_(std::move(tree)), options_(options), footRadius_(radiusAtFoot(tree_)),
        height_(tree_.longestDown().front()) {}

  PointTree simplified(const Progress& progress) {
    prune();
    for (int round = 0; round < mostRounds; ++round) {
      progress.update(static_cast<double>(round) / mostRounds);
      const std::size_t before = tree_.size();
      straighten();
      mergeSiblings();
      prune();
      if (tree_.size() == before) break;
    }
    return std::move(tree_);
  }

private:
  /// [L] of the wood around a node, from which the longest path down is `down`.
  [[nodiscard]] double radius(double down) const {
    const double share = height_ > 0 ? down / height_ : 0;
    return std::max<double>(options_.leastRadius, footRadius_ * std::pow(share, allometry));
  }

  /// Takes away what is a small share of the wood it stands on, or ends inside it.
  void prune() {
    const std::vector<double> down = tree_.longestDown();
    Children children = tree_.children();
    for (std::size_t node = 0; node < tree_.size(); ++node) {
      const std::uint32_t longest = longestChild(children[node], down);
      std::erase_if(children[node], [&](std::uint32_t child) {
        const double length = down[child] + tree_.edge(child).norm();
        return child != longest &&
               (length < options_.leastShare * down[node] || length < radius(down[node]));
      });
    }
    tree_ = renumbered(tree_.positions, children);
  }

  [[nodiscard]] std::uint32_t longestChild(const std::vector<std::uint32_t>& children,
                                           const std::vector<double>& down) const {
    std::uint32_t best = PointTree::none;
    double most = -1;
    for (const std::uint32_t child : children)
      if (const double length = down[child] + tree_.edge(child).norm(); length > most) {
        most = length;
        best = child;
      }
    return best;
  }

  /// Takes away nodes without branches that lie within the wood about the line past them.
  void straighten() {
    const std::vector<double> down = tree_.longestDown();
    Children children = tree_.children();
    for (std::size_t node = 0; node < tree_.size(); ++node)
      for (std::uint32_t& child : children[node])
        while (children[child].size() == 1) {
          const std::uint32_t next = children[child].front();
          const Eigen::Vector3d& from = tree_.positions[node];
          const Eigen::Vector3d& to = tree_.positions[next];
          if ((to - from).norm() > options_.spacing ||
              distanceFromSegment(tree_.positions[child], from, to) >= radius(down[child]))
            break;
          child = next;
        }
    tree_ = renumbered(tree_.positions, children);
  }

  void mergeSiblings() {
    std::vector<double> down = tree_.longestDown();
    Children children = tree_.children();
    // From the root up: what two siblings carried are siblings then, and may be one, too.
    std::vector<std::uint32_t> order = {0};
    for (std::size_t next = 0; next < order.size(); ++next) {
      std::vector<std::uint32_t>& here = children[order[next]];
      for (std::size_t a = 0; a < here.size(); ++a)
        for (std::size_t b = a + 1; b < here.size();) {
          if (areOne(order[next], here[a], here[b], down[order[next]])) {
            mergeInto(here[a], here[b], down, children);
          } else if (runsPast(order[next], here[a], here[b], down[order[next]])) {
            attachTo(order[next], here[a], here[b], down, children);
          } else if (runsPast(order[next], here[b], here[a], down[order[next]])) {
            std::swap(here[a], here[b]);
            attachTo(order[next], here[a], here[b], down, children);
          } else {
            ++b;
            continue;
          }
          here.erase(here.begin() + static_cast<std::ptrdiff_t>(b));
          b = a + 1; // it has moved: those left alone so far may be near it now
        }
      order.insert(order.end(), here.begin(), here.end());
    }
    tree_ = renumbered(tree_.positions, children);
  }

  [[nodiscard]] bool areOne(std::uint32_t parent, std::uint32_t a, std::uint32_t b,
                            double down) const {
    const Eigen::Vector3d toA = tree_.positions[a] - tree_.positions[parent];
    const Eigen::Vector3d toB = tree_.positions[b] - tree_.positions[parent];
    const double lengthA = toA.norm();
    const double lengthB = toB.norm();
    if (lengthA == 0 || lengthB == 0) return true;
    const double cosine = toA.dot(toB) / (lengthA * lengthB);
    if (cosine <= std::cos(options_.mergeAngle)) return false;
    if (lengthA > 2 * lengthB || lengthB > 2 * lengthA) return false;
    const Eigen::Vector3d middle = (toA / lengthA + toB / lengthB).normalized();
    return (toA - toB).cross(middle).norm() < radius(down);
  }

  /// Whether the edge to `far` runs past `near` within the wood.
  [[nodiscard]] bool runsPast(std::uint32_t parent, std::uint32_t near, std::uint32_t far,
                              double down) const {
    const Eigen::Vector3d toNear = tree_.positions[near] - tree_.positions[parent];
    const Eigen::Vector3d toFar = tree_.positions[far] - tree_.positions[parent];
    const double along = toNear.dot(toFar);
    return along > 0 && along < toFar.squaredNorm() &&
           distanceFromSegment(tree_.positions[near], tree_.positions[parent],
                               tree_.positions[far]) < radius(down);
  }

  /// `far` goes on from `near`, which moves to between itself and the edge past it.
  void attachTo(std::uint32_t parent, std::uint32_t near, std::uint32_t far,
                std::vector<double>& down, Children& children) {
    const Eigen::Vector3d& from = tree_.positions[parent];
    const Eigen::Vector3d along = tree_.positions[far] - from;
    const Eigen::Vector3d past =
        from + (tree_.positions[near] - from).dot(along) / along.squaredNorm() * along;
    const double weight = down[near] + options_.leastRadius;
    const double rest = (tree_.positions[far] - past).norm();
    const double other = down[far] + rest + options_.leastRadius;
    tree_.positions[near] = (weight * tree_.positions[near] + other * past) / (weight + other);
    down[near] = std::max(down[near], down[far] + rest);
    children[near].push_back(far);
  }

  void mergeInto(std::uint32_t kept, std::uint32_t gone, std::vector<double>& down,
                 Children& children) {
    const double weight = down[kept] + options_.leastRadius; // an apex counts, too
    const double other = down[gone] + options_.leastRadius;
    tree_.positions[kept] =
        (weight * tree_.positions[kept] + other * tree_.positions[gone]) / (weight + other);
    down[kept] = std::max(down[kept], down[gone]);
    children[kept].insert(children[kept].end(), children[gone].begin(), children[gone].end());
    children[gone].clear();
  }

  PointTree tree_;
  const ShortestPathOptions& options_;
  double footRadius_;
  double height_;
};

} // namespace

Skeleton skeletonByShortestPaths(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                 const ShortestPathOptions& options, const Progress& progress) {
  const Eigen::Matrix3Xf drawn = withThickWoodAsLines(
      points, root,
      {.neighbors = options.neighbors, .radius = options.thickWood, .widestGap = options.widestGap},
      progress.part(0, 0.2));
  PointTree tree = shortestPathTree(
      drawn, root,
      {.neighbors = options.neighbors, .power = options.power, .widestGap = options.widestGap},
      progress.part(0.2, 0.7));
  Simplifier simplifier(std::move(tree), options);
  const PointTree simplified = simplifier.simplified(progress.part(0.7, 0.95));
  return withMeanDistances(skeletonOf(simplified, options.spacing), points, progress.part(0.95, 1));
}

} // namespace espalier
