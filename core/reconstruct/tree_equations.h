#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

/// The normal equations of a least-squares problem over the edges of a tree, for one vector per
/// node. Nodes are numbered as in PointTree: parents before children.
class TreeEquations {
public:
  explicit TreeEquations(const std::vector<std::uint32_t>& parents);

  /// Asks that value(node) = `wanted`, with this weight >= 0.
  void ask(std::size_t node, const Eigen::Vector3d& wanted, double weight);
  /// Asks that value(node) + sign * value(parent) = `wanted`. pre: not the root; sign 1 or -1
  void askOfEdge(std::size_t node, double sign, const Eigen::Vector3d& wanted, double weight);

  /// The values that fit best; zero where nothing was asked. Time O(N): elimination from the
  /// tips leaves the equations of a tree those of a tree.
  [[nodiscard]] std::vector<Eigen::Vector3d> solved() const;

private:
  const std::vector<std::uint32_t>& parents_;
  std::vector<double> diagonal_;
  std::vector<double> coupling_; // with the parent
  std::vector<Eigen::Vector3d> right_;
};

} // namespace espalier
