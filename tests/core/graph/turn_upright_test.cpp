#include "core/graph/turn_upright.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(TurnUpright, TurnsTheAxisThatIsUpToZAndMirrorsNothing) {
  for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z}) {
    const Eigen::Matrix3d turn = turnUpright(up);
    EXPECT_EQ(turn * Eigen::Vector3d::Unit(static_cast<int>(up)), Eigen::Vector3d::UnitZ());
    EXPECT_EQ(turn.determinant(), 1);
    EXPECT_EQ(turn * turn.transpose(), Eigen::Matrix3d::Identity());
  }
}

} // namespace
} // namespace espalier
