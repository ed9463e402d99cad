#include "core/reconstruct/tree_equations.h"

namespace espalier {

TreeEquations::TreeEquations(const std::vector<std::uint32_t>& parents)
    : parents_(parents), diagonal_(parents.size(), 0), coupling_(parents.size(), 0),
      right_(parents.size(), Eigen::Vector3d::Zero()) {}

void TreeEquations::ask(std::size_t node, const Eigen::Vector3d& wanted, double weight) {
  diagonal_[node] += weight;
  right_[node] += weight * wanted;
}

void TreeEquations::askOfEdge(std::size_t node, double sign, const Eigen::Vector3d& wanted,
                              double weight) {
  const std::uint32_t parent = parents_[node];
  diagonal_[node] += weight;
  diagonal_[parent] += weight;
  coupling_[node] += sign * weight;
  right_[node] += weight * wanted;
  right_[parent] += sign * weight * wanted;
}

std::vector<Eigen::Vector3d> TreeEquations::solved() const {
  std::vector<double> diagonal = diagonal_;
  std::vector<Eigen::Vector3d> values = right_;
  for (std::size_t i = diagonal.size(); i-- > 1;) {
    if (!(diagonal[i] > 0)) continue;
    const double factor = coupling_[i] / diagonal[i];
    diagonal[parents_[i]] -= factor * coupling_[i];
    values[parents_[i]] -= factor * values[i];
  }
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    if (!(diagonal[i] > 0)) {
      values[i].setZero();
      continue;
    }
    if (i > 0) values[i] -= coupling_[i] * values[parents_[i]];
    values[i] /= diagonal[i];
  }
  return values;
}

} // namespace espalier
