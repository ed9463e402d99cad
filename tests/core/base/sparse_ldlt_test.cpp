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

SymmetricMatrix sparse(const Eigen::MatrixXd& matrix) {
  SymmetricMatrix result;
  result.begin.push_back(0);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (matrix(i, j) != 0) {
        result.columns.push_back(static_cast<std::uint32_t>(j));
        result.values.push_back(matrix(i, j));
      }
    result.begin.push_back(result.columns.size());
  }
  return result;
}

TEST(DissectionOrder, HoldsEachUnknownOnce) {
  std::vector<std::uint32_t> order = dissectionOrder(sparse(dense()), places());
  std::ranges::sort(order);
  std::vector<std::uint32_t> all(side * side);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST(SparseLdlt, SolvesWhatItMultipliesTo) {
  const SymmetricMatrix matrix = sparse(dense());
  const Eigen::MatrixX3d truth = places().cast<double>().transpose();
  SparseLdlt solver(matrix, dissectionOrder(matrix, places()));
  solver.factor(matrix);
  EXPECT_LT((solver.solve(dense() * truth) - truth).cwiseAbs().maxCoeff(), 1e-9);
  // Again, with other values.
  const SymmetricMatrix other = sparse(3 * dense());
  solver.factor(other);
  EXPECT_LT((solver.solve(3 * dense() * truth) - truth).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SparseLdlt, StopsWhenAsked) {
  const SymmetricMatrix matrix = sparse(dense());
  SparseLdlt solver(matrix, dissectionOrder(matrix, places()));
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& p) { solver.factor(matrix, p); }));
  EXPECT_TRUE(
      test::stopsWhenAsked([&](const Progress& p) { (void)dissectionOrder(matrix, places(), p); }));
}

} // namespace
} // namespace espalier
