#include "core/cloud/displacements.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

TEST(Displacements, AreTheMovesOfThePoints) {
  const Eigen::Matrix3Xf scanned{{0, 1}, {0, 1}, {0, 1}};
  const Eigen::Matrix3Xf contracted{{3, 1}, {0, 1}, {4, 1}};
  EXPECT_THAT(displacements(scanned, contracted), testing::ElementsAre(5, 0));
  EXPECT_TRUE(displacements({}, {}).empty());
}

} // namespace
} // namespace espalier
