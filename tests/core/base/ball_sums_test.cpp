#include "core/base/ball_sums.h"
#include "core/base/random.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(BallSums, AreThoseOfThePointsOneByOne) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const BallSums sums(points);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3f place = points.col(static_cast<Eigen::Index>(random.below(1000))) +
                                  0.1F * random.direction().cast<float>();
    const auto radius = static_cast<float>(random.uniform(0, 1));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::int64_t count = 0;
    for (Eigen::Index j = 0; j < points.cols(); ++j)
      if ((points.col(j) - place).squaredNorm() <= radius * radius) {
        sum += points.col(j).cast<double>();
        ++count;
      }
    const BallSums::Sum found = sums.within(place, radius);
    ASSERT_EQ(found.count, count);
    EXPECT_LT((found.positions - sum).norm(), 1e-6);
  }
}

TEST(BallSums, CountPointsAtOnePlace) {
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 100);
  const BallSums sums(same);
  EXPECT_EQ(sums.within(Eigen::Vector3f::Ones(), 0).count, 100);
  EXPECT_EQ(sums.within(Eigen::Vector3f::Zero(), 1).count, 0);
  EXPECT_EQ(BallSums(Eigen::Matrix3Xf(3, 0)).within(Eigen::Vector3f::Zero(), 1).count, 0);
}

} // namespace
} // namespace espalier
