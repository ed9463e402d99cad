#include "ui/view/detail_budget.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A machine that takes 10 ms a frame and 0.001 ms a point.
double timeOf(Eigen::Index points) {
  return 10 + 1e-3 * static_cast<double>(points);
}

TEST(DetailBudget, LearnsHowManyPointsFitIntoAFrame) {
  DetailBudget budget;
  for (int frame = 0; frame < 50; ++frame) {
    budget.measured(0, timeOf(0));
    const Eigen::Index points = budget.points(60);
    budget.measured(points, timeOf(points));
  }
  EXPECT_NEAR(timeOf(budget.points(60)), 60, 3);
}

TEST(DetailBudget, DrawsSomePointsHoweverSlowTheMachineIs) {
  DetailBudget budget;
  for (int frame = 0; frame < 50; ++frame)
    budget.measured(20'000, 5000);
  EXPECT_GE(budget.points(30), 20'000);
  EXPECT_EQ(budget.points(30, 10'000), 10'000);
}

TEST(DetailBudget, IsNotThrownOffByOneSlowFrame) {
  DetailBudget budget;
  for (int frame = 0; frame < 50; ++frame)
    budget.measured(100'000, timeOf(100'000));
  const Eigen::Index before = budget.points(60);
  budget.measured(100'000, 3 * timeOf(100'000));
  EXPECT_GT(budget.points(60), before / 2);
}

} // namespace
} // namespace espalier
