#include "core/base/error.h"
#include "core/base/random.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/quality_of.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::cloudOf;

PlantScale scaleOf(const Eigen::Matrix3Xf& points, UpAxis up = UpAxis::z) {
  return scaleOf(*cloudOf(points), {}, up);
}

// What rules were tuned on: as long as nothing is odd, the mean and the extent of all points.
TEST(PlantScale, IsThatOfAllPointsOfACleanScan) {
  const Eigen::Matrix3Xf& herb = test::simulatedHerb().cloud.positions();
  const PlantScale found = scaleOf(test::simulatedHerb().cloud, {}, UpAxis::z);
  double sum = 0;
  const SpatialIndex index(herb);
  for (Eigen::Index i = 0; i < herb.cols(); ++i)
    sum += std::sqrt(double(index.nearest(herb.col(i), 2).back().squaredDistance));
  EXPECT_NEAR(found.spacing, sum / double(herb.cols()), 1e-9 * found.spacing);
  EXPECT_EQ(found.height, test::heightOf(herb, UpAxis::z));
}

// 5 % of strays. Those nearer than 16 medians count, so 0.8 spacings is the most that they may add;
// all around the plant, most are farther off.
TEST(PlantScale, IsHardlyMovedByStrays) {
  const Eigen::Matrix3Xf plant = test::forkCloud();
  const PlantScale alone = scaleOf(plant);
  for (const double reach : {0.3, 1.0, 3.0, 10.0, 100.0, 1e5}) {
    Random random(3);
    Eigen::Matrix3Xf strays(3, plant.cols() * 5 / 95);
    for (Eigen::Index i = 0; i < strays.cols(); ++i)
      strays.col(i) = (Eigen::Vector3d(0, 0, 1.6) + reach * Eigen::Vector3d(random.uniform(-1, 1),
                                                                            random.uniform(-1, 1),
                                                                            random.uniform(-1, 1)))
                          .cast<float>();
    const PlantScale found = scaleOf(test::both(plant, strays));
    EXPECT_LT(found.spacing, 1.8 * alone.spacing) << reach;
    EXPECT_NEAR(found.spacing, alone.spacing, (reach < 2 ? 0.4 : 0.02) * alone.spacing) << reach;
    EXPECT_NEAR(found.height, alone.height, 0.1 * alone.height) << reach;
  }
}

// Those that stand alone are passed over, be they a handful or the most that are: 1 of 16.
TEST(PlantScale, HasTheHeightOfThePlantBelowAnyStraysAboveIt) {
  const Eigen::Matrix3Xf plant = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.2, 0.01);
  const double height = test::heightOf(plant, UpAxis::z);
  for (const Eigen::Index part : {4000, 300, 100, 20}) {
    Eigen::Matrix3Xf strays = Eigen::Matrix3Xf::Zero(3, plant.cols() / part);
    ASSERT_GT(strays.cols(), 1) << part;
    strays.row(2).setLinSpaced(2.2F, 2.2F + 0.2F * static_cast<float>(strays.cols() - 1));
    EXPECT_NEAR(scaleOf(test::both(plant, strays)).height, height, 1e-4) << part;
  }
}

TEST(PlantScale, FollowsTheUpAxis) {
  Eigen::Matrix3Xf points = test::forkCloud();
  points.row(0).swap(points.row(2));
  Eigen::Vector3f stray(-0.8F, 0.2F, 0);
  EXPECT_NEAR(scaleOf(test::both(points, stray), UpAxis::x).height,
              test::heightOf(points, UpAxis::x), 1e-4);
}

// A tree of nearly all points is set aside: the sapling beside it is all that there is.
TEST(PlantScale, IsThatOfTheFewPointsThatAreLeft) {
  const Eigen::Matrix3Xf tree = test::cylinder({0, 0, 0}, {0, 0, 4}, 0.45, 0.02);
  const Eigen::Matrix3Xf sapling = test::cylinder({15, 0, 0}, {15, 0, 0.8}, 0.02, 0.02);
  const auto cloud = cloudOf(test::both(tree, sapling));
  std::vector<Eigen::Index> ofTree;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->position(i).x() < 510) ofTree.push_back(i);
  PipelineOptions options;
  options.leftOut = PointSet::of(ofTree);
  const PlantScale alone = scaleOf(sapling);
  const PlantScale found = scaleOf(*cloud, options.leftOut, UpAxis::z);
  EXPECT_NEAR(found.spacing, alone.spacing, 0.01 * alone.spacing);
  EXPECT_NEAR(found.height, alone.height, 1e-4);
  const auto isOfSapling = [&](const Reconstruction& result) {
    const Skeleton& plant = *result.skeleton;
    EXPECT_GT(plant.size(), 2U);
    for (const NodeId id : plant.ids())
      EXPECT_NEAR(plant[id].position.x(), 515, 0.1);
    const Eigen::Vector3d root = plant[plant.roots().front()].position;
    EXPECT_LT((root - Eigen::Vector3d(515, 600, 700)).norm(), 0.2);
    EXPECT_GT(qualityOf(*cloud, result, options).tips, 0U);
  };
  isOfSapling(Pipeline().run(cloud, options));
  options.root = Eigen::Vector3d(515, 600, 700);
  isOfSapling(Pipeline().run(cloud, options));
  options.root = Eigen::Vector3d(500, 600, 700);
  EXPECT_THROW((void)Pipeline().run(cloud, options), Error) << "of the tree";
}

TEST(PlantScale, HasNoSpacingAtOnePlace) {
  EXPECT_EQ(scaleOf(Eigen::Matrix3Xf::Zero(3, 40)).spacing, 0);
  EXPECT_EQ(scaleOf(*cloudOf(test::forkCloud()), PointSet::firstOf(1'000'000), UpAxis::z).height,
            0);
}

} // namespace
} // namespace espalier
