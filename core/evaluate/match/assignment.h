#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// Who may be paired with whom, and at what cost. All costs are finite; any sign.
struct AssignmentProblem {
  struct Candidate {
    std::size_t column;
    double cost;
  };
  std::vector<std::vector<Candidate>> candidates; // by row; each column at most once in a row
  std::vector<double> rowAlone;                   // by row: cost of leaving it without a column
  std::vector<double> columnAlone;                // by column: cost of leaving it without a row
};

struct Assignment {
  std::vector<std::optional<std::size_t>> columnOfRow; // none: the row stays alone
  double cost = 0;                                     // of all pairs and all left alone
};

/// The one-to-one assignment of least total cost, exactly.
///
/// Each row gets a private dummy column that stands for staying alone; rows are then added one by
/// one along shortest augmenting paths (Dijkstra with a heap on costs reduced by potentials).
/// The order of rows and candidates decides between assignments of equal cost.
///
/// pre: candidates.size() == rowAlone.size(), each candidate's column < columnAlone.size()
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Memory O(rows + columns + candidates), never rows x columns. Time at worst
/// O(rows * candidates * log), in practice a few searches' worth of candidates per row.
/// Source: R. Jonker, A. Volgenant, "A shortest augmenting path algorithm for dense and sparse
/// linear assignment problems", Computing 38, 1987. Differs: no initial reductions, binary heap.
[[nodiscard]] Assignment leastCostAssignment(const AssignmentProblem& problem,
                                             const Progress& progress = {});

} // namespace espalier
