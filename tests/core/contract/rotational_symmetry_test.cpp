#include "core/contract/rotational_symmetry.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr float radius = 0.1F; // of a trunk along z, its points about 0.01 apart

TEST(RotationalSymmetry, FindsTheMiddleOfATrunkSeenFromOneSide) {
  const Eigen::Matrix3Xf whole = test::cylinder({0, 0, 0}, {0, 0, 1}, radius, 0.01);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < whole.cols(); ++i)
    if (whole(1, i) > 0) seen.push_back(i);
  const Eigen::Matrix3Xf half = whole(Eigen::all, seen);
  const Eigen::Matrix3Xf places = contractedToSymmetryAxes(half, {.width = 0.01, .reach = 0.08});
  // A mean of the half would lie 0.064 off the axis.
  const Eigen::ArrayXf off = places.topRows<2>().colwise().norm();
  EXPECT_GT((off < 0.01F).count(), 0.9 * static_cast<double>(off.size()));
}

} // namespace
} // namespace espalier
