#include "core/base/random.h"
#include "core/base/sparse_ldlt.h"
#include "tests/support/clouds.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace espalier {
namespace {

constexpr int side = 20; // of a lattice of unknowns

Eigen::Matrix3Xf places() {
  Eigen::Matrix3Xf result(3, side * side);
  for (int i = 0; i < side * side; ++i)
    result.col(i) = Eigen::Vector3f(static_cast<float>(i % side), static_cast<float>(i / side), 0);
  return result;
}

/// Positive definite, with entries between those within 2 of each other on the lattice.
Eigen::MatrixXd dense() {
  const Eigen::Matrix3Xf at = places();
  Random random(1);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(at.cols(), at.cols());
  for (Eigen::Index i = 0; i < at.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if ((at.col(i) - at.col(j)).norm() <= 2) {
        matrix(i, j) = matrix(j, i) = -random.uniform();
        matrix(i, i) -= matrix(i, j);
        matrix(j, j) -= matrix(i, j);
      }
  matrix.diagonal().array() += 0.1;
  return matrix;
}

/// Both halves of a matrix, row by row.
struct Sparse {
  SymmetricPattern pattern;
  Eigen::VectorXd values;
};

Sparse sparse(const Eigen::MatrixXd& matrix) {
  Sparse result;
  std::vector<double> values;
  result.pattern.begin.push_back(0);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (matrix(i, j) != 0) {
        result.pattern.columns.push_back(static_cast<std::uint32_t>(j));
        values.push_back(matrix(i, j));
      }
    result.pattern.begin.push_back(values.size());
  }
  result.values = Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values));
  return result;
}

TEST(DissectionOrder, HoldsEachUnknownOnce) {
  std::vector<std::uint32_t> order = dissectionOrder(sparse(dense()).pattern, places());
  std::ranges::sort(order);
  std::vector<std::uint32_t> all(side * side);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST(SparseLdlt, SolvesWhatItMultipliesTo) {
  const Sparse matrix = sparse(dense());
  const Eigen::MatrixX3d truth = places().cast<double>().transpose();
  SparseLdlt solver(matrix.pattern, dissectionOrder(matrix.pattern, places()));
  solver.factor(matrix.values);
  EXPECT_LT((solver.solve(dense() * truth) - truth).cwiseAbs().maxCoeff(), 1e-9);
  // Again, with other values.
  solver.factor(3 * matrix.values);
  EXPECT_LT((solver.solve(3 * dense() * truth) - truth).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SparseLdlt, StopsWhenAsked) {
  const Sparse matrix = sparse(dense());
  const std::vector<std::uint32_t> order = dissectionOrder(matrix.pattern, places());
  SparseLdlt solver(matrix.pattern, order);
  solver.factor(matrix.values);
  const Eigen::MatrixX3d right = places().cast<double>().transpose();
  using test::stopsWhenAsked;
  EXPECT_TRUE(stopsWhenAsked(
      [&](const Progress& p) { (void)dissectionOrder(matrix.pattern, places(), p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { SparseLdlt(matrix.pattern, order, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { solver.factor(matrix.values, p); }));
  EXPECT_TRUE(stopsWhenAsked([&](const Progress& p) { (void)solver.solve(right, p); }));
}

} // namespace
} // namespace espalier
