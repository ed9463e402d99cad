#include "core/evaluate/match/assignment.h"

#include <queue>

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
constexpr double unreached = std::numeric_limits<double>::infinity();

/// Pairs rows with columns along shortest augmenting paths.
///
/// Columns [0, columns_) are real; column columns_ + row is that row's own dummy.
/// Invariant: cost - rowPotential_ - columnPotential_ is zero on each pair, and nowhere negative
/// for rows that were added.
class AugmentingPaths {
public:
  explicit AugmentingPaths(const AssignmentProblem& problem)
      : problem_(problem), columns_(problem.columnAlone.size()),
        rowPotential_(problem.candidates.size(), 0),
        columnPotential_(columns_ + rowPotential_.size(), 0),
        rowOf_(columnPotential_.size(), nobody), columnOf_(rowPotential_.size(), nobody),
        distance_(columnPotential_.size(), unreached), before_(columnPotential_.size(), nobody) {}

  /// Gives `row` a column, moving other rows to other columns where that is cheapest.
  void add(std::size_t row) {
    rowPotential_[row] = leastReducedCost(row);
    reachFrom(row, 0);
    std::size_t column = settleNearest();
    while (rowOf_[column] != nobody) { // ends: the dummy of a row that has another column is free
      reachFrom(rowOf_[column], distance_[column]);
      column = settleNearest();
    }
    raisePotentials(row, distance_[column]);
    augment(row, column);
    for (const std::size_t each : reached_)
      distance_[each] = unreached;
    reached_.clear();
    settled_.clear();
    open_ = {};
  }

  [[nodiscard]] std::optional<std::size_t> columnOf(std::size_t row) const {
    if (columnOf_[row] >= columns_) return std::nullopt;
    return columnOf_[row];
  }

private:
  /// Calls visit(column, cost) for all a row may be paired with, its dummy last.
  template <class Visit> void eachColumn(std::size_t row, const Visit& visit) const {
    // A pair saves what its column would cost alone: then columns need no dummies.
    for (const auto& candidate : problem_.candidates[row])
      visit(candidate.column, candidate.cost - problem_.columnAlone[candidate.column]);
    visit(columns_ + row, problem_.rowAlone[row]);
  }

  [[nodiscard]] double leastReducedCost(std::size_t row) const {
    double least = unreached;
    eachColumn(row, [&](std::size_t column, double cost) {
      least = std::min(least, cost - columnPotential_[column]);
    });
    return least;
  }

  void reachFrom(std::size_t row, double soFar) {
    eachColumn(row, [&](std::size_t column, double cost) {
      const double step = cost - rowPotential_[row] - columnPotential_[column];
      const double distance = soFar + std::max(step, 0.0); // rounding may dip below zero
      if (distance >= distance_[column]) return;
      if (distance_[column] == unreached) reached_.push_back(column);
      distance_[column] = distance;
      before_[column] = row;
      open_.emplace(distance, column);
    });
  }

  std::size_t settleNearest() {
    for (;;) {
      const auto [distance, column] = open_.top();
      open_.pop();
      if (distance != distance_[column]) continue; // a shorter path was found since
      settled_.push_back(column);
      return column;
    }
  }

  void raisePotentials(std::size_t row, double length) {
    rowPotential_[row] += length;
    for (const std::size_t column : settled_) {
      const double slack = length - distance_[column];
      columnPotential_[column] -= slack;
      if (rowOf_[column] != nobody) rowPotential_[rowOf_[column]] += slack;
    }
  }

  void augment(std::size_t row, std::size_t column) {
    for (std::size_t taker = nobody; taker != row;) {
      taker = before_[column];
      rowOf_[column] = taker;
      std::swap(columnOf_[taker], column); // go on with the column that `taker` leaves
    }
  }

  using Reached = std::pair<double, std::size_t>; // distance, column

  const AssignmentProblem& problem_;
  std::size_t columns_;
  std::vector<double> rowPotential_, columnPotential_;
  std::vector<std::size_t> rowOf_, columnOf_;

  // Of the search that runs:
  std::vector<double> distance_;     // by column
  std::vector<std::size_t> before_;  // by column: the row from which it was reached
  std::vector<std::size_t> reached_; // columns whose distance is not `unreached`
  std::vector<std::size_t> settled_; // columns whose distance is final
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open_;
};

double totalCost(const AssignmentProblem& problem, const Assignment& assignment) {
  double cost = 0;
  std::vector<bool> isTaken(problem.columnAlone.size(), false);
  for (std::size_t row = 0; row < problem.candidates.size(); ++row) {
    const std::optional<std::size_t> column = assignment.columnOfRow[row];
    if (!column) {
      cost += problem.rowAlone[row];
      continue;
    }
    isTaken[*column] = true;
    const auto& candidates = problem.candidates[row];
    cost += std::find_if(candidates.begin(), candidates.end(), [&](const auto& candidate) {
              return candidate.column == *column;
            })->cost;
  }
  for (std::size_t column = 0; column < isTaken.size(); ++column)
    if (!isTaken[column]) cost += problem.columnAlone[column];
  return cost;
}

} // namespace

Assignment leastCostAssignment(const AssignmentProblem& problem, const Progress& progress) {
  const std::size_t rows = problem.candidates.size();
  assert(problem.rowAlone.size() == rows);
  AugmentingPaths paths(problem);
  for (std::size_t row = 0; row < rows; ++row) {
    paths.add(row);
    if (row % 64 == 0) progress.update(static_cast<double>(row) / static_cast<double>(rows));
  }
  Assignment result;
  result.columnOfRow.reserve(rows);
  for (std::size_t row = 0; row < rows; ++row)
    result.columnOfRow.push_back(paths.columnOf(row));
  result.cost = totalCost(problem, result);
  progress.update(1);
  return result;
}

} // namespace espalier
