#include "core/pipeline/pipeline.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/foot_on_axis.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// The bark of a trunk of radius 0.1 about the z axis, from 0 to 2.
Eigen::Matrix3Xf trunk() {
  return test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.01);
}

/// Its axis, but for the foot: the root lies on the bark.
Skeleton axisFromTheBark() {
  Skeleton plant;
  NodeId at = plant.add({.position = {0.1, 0, 0.05}});
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0.05, 0, 0.07), Eigen::Vector3d(0.01, 0, 0.1)})
    at = plant.add({.position = place, .parent = at});
  for (int i = 3; i <= 20; ++i)
    at = plant.add({.position = {0, 0, 0.1 * i - 0.1}, .parent = at});
  return plant;
}

TEST(FootOnAxis, LiesInTheMiddleOfTheWoodWhereItsPointsEnd) {
  const Skeleton plant = withFootOnAxis(axisFromTheBark(), trunk(), {0, 0, 0});
  const Eigen::Vector3d& root = plant[plant.roots().front()].position;
  EXPECT_LT(root.head<2>().norm(), 0.02);
  EXPECT_NEAR(root.z(), 0, 0.03);
  EXPECT_EQ(plant.size(), axisFromTheBark().size());
  const Axis axis = axes(plant).front();
  for (std::size_t i = 1; i < axis.size(); ++i)
    EXPECT_GT(plant[axis[i]].position.z(), plant[axis[i - 1]].position.z()) << i;
}

TEST(FootOnAxis, LosesWhatWasDrawnBesideItInTheWood) {
  Skeleton skeleton = axisFromTheBark();
  SkeletonEditor editor(skeleton);
  const NodeId spur = editor.add({.position = {-0.05, 0.05, 0.02},
                                  .parent = skeleton.roots().front(),
                                  .edge = EdgeType::branching});
  const NodeId branch = editor.add({.position = {0.6, 0, 0.9},
                                    .parent = axes(skeleton).front()[8],
                                    .edge = EdgeType::branching});
  (void)editor.commit();
  const Skeleton plant = withFootOnAxis(skeleton, trunk(), {0, 0, 0});
  EXPECT_FALSE(plant.contains(spur));
  EXPECT_TRUE(plant.contains(branch));
}

TEST(FootOnAxis, LeavesARootAloneThatBearsABranch) {
  Skeleton skeleton = axisFromTheBark();
  SkeletonEditor editor(skeleton);
  (void)editor.add(
      {.position = {0.9, 0, 0.1}, .parent = skeleton.roots().front(), .edge = EdgeType::branching});
  (void)editor.commit();
  EXPECT_EQ(withFootOnAxis(skeleton, trunk(), {0, 0, 0}), skeleton);
}

TEST(FootOnAxis, LeavesAFootAloneThatIsOnTheAxis) {
  const Skeleton stick = test::stick(20, 0.1);
  EXPECT_EQ(withFootOnAxis(stick, trunk(), {0, 0, 0}), stick);
  EXPECT_EQ(withFootOnAxis(test::stick(2), trunk(), {0, 0, 0}), test::stick(2));
  EXPECT_TRUE(withFootOnAxis({}, trunk(), {0, 0, 0}).isEmpty());
  EXPECT_EQ(withFootOnAxis(stick, Eigen::Matrix3Xf(3, 0), {0, 0, 0}), stick);
}

// From wherever on the bark, or in the hollow, the root is picked.
TEST(FootOnAxis, IsFoundByAReconstruction) {
  const auto cloud = test::cloudAtOrigin(trunk());
  for (const Eigen::Vector3d& picked :
       {Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d(0, -0.1, 0), Eigen::Vector3d(0.01, 0.01, 0)}) {
    Pipeline pipeline;
    const Reconstruction found = pipeline.run(cloud, {.root = picked});
    const Skeleton& plant = *found.skeleton;
    const Axis axis = axes(plant).front();
    ASSERT_GT(axis.size(), 4);
    const Eigen::Vector3d& root = plant[axis.front()].position;
    EXPECT_LT(root.head<2>().norm(), 0.035) << picked.transpose();
    EXPECT_LT(root.z(), 0.07) << picked.transpose();
    const Eigen::Vector3d first = plant[axis[1]].position - root;
    EXPECT_GT(first.normalized().z(), std::cos(30 * std::numbers::pi / 180)) << picked.transpose();
  }
}

} // namespace
} // namespace espalier
