#include "ui/view/detail_budget.h"

#include <algorithm>

namespace espalier {
namespace {

constexpr Eigen::Index fewestToMeasure = 10'000; // of fewer, the time says little
constexpr double weightOfNew = 0.3; // one slow frame, while the machine did other things, is noise

void approach(double& value, double measured) {
  value += weightOfNew * (measured - value);
}

} // namespace

Eigen::Index DetailBudget::points(double milliseconds, Eigen::Index atLeast) const {
  const double count = std::clamp((milliseconds - base_) / perPoint_, 0.0, 1e15);
  return std::max(atLeast, static_cast<Eigen::Index>(count));
}

void DetailBudget::measured(Eigen::Index points, double milliseconds) {
  if (points == 0) {
    approach(base_, milliseconds);
  } else if (points >= fewestToMeasure) {
    const double drawing = std::max(milliseconds - base_, 0.2 * milliseconds);
    approach(perPoint_, std::max(drawing / static_cast<double>(points), 1e-7));
  }
}

} // namespace espalier
