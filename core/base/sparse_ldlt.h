#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

/// Where the entries of a symmetric matrix are that are not 0: both halves of them, row by row.
struct SymmetricPattern {
  std::vector<std::size_t> begin;     // N + 1 places in columns
  std::vector<std::uint32_t> columns; // of each row ascending, the diagonal among them

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(begin.size()) - 1; }
};

/// An order of unknowns that stand at places in space, in which few entries are added to the
/// factor: halves of the plant first, what lies between them last, and so again in each half.
/// Deterministic. Time O(entries log N). @throws Cancelled if `progress` asks to stop
/// Source: A. George, "Nested dissection of a regular finite element mesh", SIAM J. Numer. Anal.
/// 10, 1973.
[[nodiscard]] std::vector<std::uint32_t> dissectionOrder(const SymmetricPattern& pattern,
                                                         const Eigen::Matrix3Xf& places,
                                                         const Progress& progress = {});

/// Solves A x = b for a sparse positive definite A by its factors L D L^T, again and again with
/// other values at the same places. Unlike Eigen's, it can be stopped: each call looks at
/// `progress` every few ms, and throws Cancelled if that asks to stop.
///
/// Source: T. A. Davis, "Algorithm 849: a concise sparse Cholesky factorization package", ACM
/// Trans. Math. Softw. 31, 2005.
class SparseLdlt {
public:
  /// @param pattern must outlive this
  /// @param order   all of [0, N), each once: dissectionOrder
  SparseLdlt(const SymmetricPattern& pattern, std::vector<std::uint32_t> order,
             const Progress& progress = {});
  SparseLdlt(SymmetricPattern&&, std::vector<std::uint32_t>, const Progress& = {}) = delete;

  /// @param values one per column of the pattern. pre: they make a positive definite matrix
  void factor(const Eigen::VectorXd& values, const Progress& progress = {});

  /// pre: factored. N x 3, the solutions for the three columns of `right`.
  [[nodiscard]] Eigen::MatrixX3d solve(const Eigen::MatrixX3d& right,
                                       const Progress& progress = {}) const;

private:
  [[nodiscard]] std::size_t pathOf(std::uint32_t k);

  static constexpr std::uint32_t none = 0xffffffff;

  const SymmetricPattern& pattern_;
  std::vector<std::uint32_t> order_; // place -> unknown
  std::vector<std::uint32_t> place_; // unknown -> place
  std::vector<std::uint32_t> parent_;
  std::vector<std::size_t> begin_;  // of the columns of L, without its diagonal
  std::vector<std::size_t> filled_; // end of what is there of each column
  // Those of L, gigabytes of them, are Eigen's, for it does not fill what it allocates.
  Eigen::Array<std::uint32_t, Eigen::Dynamic, 1> rows_;
  Eigen::VectorXd values_;
  std::vector<double> diagonal_;
  std::vector<std::uint32_t> met_;  // the row that came by last
  std::vector<std::uint32_t> path_; // columns of a row, in the order of elimination, at the end
};

} // namespace espalier
