#include "core/base/random.h"
#include "core/evaluate/match/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stop_token>

namespace espalier {
namespace {

/// Least cost over all assignments, by trying each.
double leastByTrying(const AssignmentProblem& problem, std::size_t row,
                     std::vector<bool>& isTaken) {
  if (row == problem.candidates.size()) {
    double alone = 0;
    for (std::size_t column = 0; column < isTaken.size(); ++column)
      if (!isTaken[column]) alone += problem.columnAlone[column];
    return alone;
  }
  double least = problem.rowAlone[row] + leastByTrying(problem, row + 1, isTaken);
  for (const auto& [column, cost] : problem.candidates[row]) {
    if (isTaken[column]) continue;
    isTaken[column] = true;
    least = std::min(least, cost + leastByTrying(problem, row + 1, isTaken));
    isTaken[column] = false;
  }
  return least;
}

AssignmentProblem randomProblem(Random& random, std::size_t rows, std::size_t columns) {
  AssignmentProblem problem;
  const double density = random.uniform();
  for (std::size_t row = 0; row < rows; ++row) {
    problem.rowAlone.push_back(random.uniform(-1, 5));
    problem.candidates.emplace_back();
    for (std::size_t column = 0; column < columns; ++column)
      if (random.uniform() < density)
        problem.candidates.back().push_back({column, random.uniform(-2, 10)});
  }
  for (std::size_t column = 0; column < columns; ++column)
    problem.columnAlone.push_back(random.uniform(-1, 5));
  return problem;
}

/// The cost that the pairs themselves add up to; fails where they are no assignment.
double checkedCost(const AssignmentProblem& problem, const Assignment& assignment) {
  double cost = std::accumulate(problem.columnAlone.begin(), problem.columnAlone.end(), 0.0);
  std::vector<int> uses(problem.columnAlone.size(), 0);
  for (std::size_t row = 0; row < problem.candidates.size(); ++row) {
    const auto column = assignment.columnOfRow[row];
    if (!column) {
      cost += problem.rowAlone[row];
      continue;
    }
    EXPECT_EQ(++uses[*column], 1);
    double pair = std::numeric_limits<double>::quiet_NaN(); // not a candidate
    for (const auto& candidate : problem.candidates[row])
      if (candidate.column == *column) pair = candidate.cost;
    cost += pair - problem.columnAlone[*column];
  }
  return cost;
}

TEST(Assignment, CostsWhatTryingAllFindsLeast) {
  Random random(1);
  for (int trial = 0; trial < 400; ++trial) {
    const AssignmentProblem problem = randomProblem(random, random.below(7), random.below(7));
    const Assignment assignment = leastCostAssignment(problem);
    std::vector<bool> isTaken(problem.columnAlone.size(), false);
    EXPECT_NEAR(assignment.cost, leastByTrying(problem, 0, isTaken), 1e-9);
    EXPECT_NEAR(assignment.cost, checkedCost(problem, assignment), 1e-9);
  }
}

TEST(Assignment, LeavesAloneWhatCostsMoreTogether) {
  const AssignmentProblem problem{
      .candidates = {{{0, 5.0}}, {{1, 1.0}}}, .rowAlone = {2, 2}, .columnAlone = {2, 2}};
  const Assignment assignment = leastCostAssignment(problem);
  EXPECT_EQ(assignment.columnOfRow[0], std::nullopt);
  EXPECT_EQ(assignment.columnOfRow[1], 1U);
  EXPECT_EQ(assignment.cost, 5);
}

TEST(Assignment, MovesAnEarlierRowForALaterOne) {
  const AssignmentProblem problem{
      .candidates = {{{0, 1.0}, {1, 2.0}}, {{0, 1.0}}}, .rowAlone = {9, 9}, .columnAlone = {9, 9}};
  const Assignment assignment = leastCostAssignment(problem);
  EXPECT_EQ(assignment.columnOfRow[0], 1U);
  EXPECT_EQ(assignment.columnOfRow[1], 0U);
}

TEST(Assignment, OfNothingCostsNothing) {
  EXPECT_EQ(leastCostAssignment({}).cost, 0);
  EXPECT_EQ(leastCostAssignment({.columnAlone = {3}}).cost, 3);
}

// Costs are given prices of rows and columns plus a surplus that is zero on a hidden assignment:
// no assignment can cost less than the prices, and the hidden one costs just that.
TEST(Assignment, FindsAHiddenAssignmentOfManyRows) {
  constexpr std::size_t rows = 20000;
  Random random(2);
  std::vector<std::size_t> hidden(rows);
  std::iota(hidden.begin(), hidden.end(), std::size_t{0});
  for (std::size_t i = rows; i > 1; --i)
    std::swap(hidden[i - 1], hidden[random.below(i)]);
  std::vector<double> columnPrice(rows);
  for (double& price : columnPrice)
    price = random.uniform(0, 100);

  AssignmentProblem problem{.rowAlone = std::vector<double>(rows, 1000),
                            .columnAlone = std::vector<double>(rows, 1000)};
  double prices = std::accumulate(columnPrice.begin(), columnPrice.end(), 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    const double rowPrice = random.uniform(0, 100);
    prices += rowPrice;
    problem.candidates.push_back({{hidden[row], rowPrice + columnPrice[hidden[row]]}});
    for (int more = 0; more < 10; ++more) {
      const std::size_t column = hidden[(row + 1 + random.below(50)) % rows];
      auto& candidates = problem.candidates.back();
      if (std::none_of(candidates.begin(), candidates.end(),
                       [&](const auto& candidate) { return candidate.column == column; }))
        candidates.push_back({column, rowPrice + columnPrice[column] + random.uniform(0, 10)});
    }
  }
  const Assignment assignment = leastCostAssignment(problem);
  EXPECT_NEAR(assignment.cost, prices, 1e-4);
  for (std::size_t row = 0; row < rows; ++row)
    EXPECT_EQ(assignment.columnOfRow[row], hidden[row]);
}

TEST(Assignment, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const AssignmentProblem problem{.candidates = {{}}, .rowAlone = {1}};
  EXPECT_THROW((void)leastCostAssignment(problem, Progress(source.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
