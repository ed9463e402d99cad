#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace espalier {
namespace {

Skeleton moved(Skeleton plant, const Eigen::Vector3d& shift) {
  SkeletonEditor editor(plant);
  moveAll(editor, shift);
  (void)editor.commit();
  return plant;
}

Skeleton scaled(Skeleton plant, double factor) {
  for (const NodeId id : plant.ids())
    plant.setPosition(id, factor * plant[id].position);
  return plant;
}

/// The points times `factor`, then moved by `shift` [L].
PointCloud placed(const PointCloud& cloud, double factor, const Eigen::Vector3d& shift) {
  RawPoints raw;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    raw.positions.emplace_back(factor * cloud.position(i) + shift);
  return PointCloud(std::move(raw));
}

Eigen::Vector3d meanOf(const PointCloud& cloud) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    sum += cloud.position(i);
  return sum / static_cast<double>(cloud.size());
}

// A tree in m and a herb in mm, each in both units, and far from the origin as in UTM.
TEST(ShiftOntoCloud, IsTheMeanOfTheCloudForAStructureInItsFrame) {
  for (const test::SimulatedPlant* plant : {&test::simulatedTree(), &test::simulatedHerb()})
    for (const double factor : {0.001, 1.0, 1000.0}) {
      const Eigen::Vector3d place = factor * Eigen::Vector3d(50'000, 540'000, 100);
      const PointCloud cloud = placed(plant->cloud, factor, place);
      const Eigen::Vector3d mean = meanOf(cloud);
      const Skeleton centered = moved(scaled(plant->truth, factor), place - mean);
      const auto shift = shiftOntoCloud(centered, cloud);
      ASSERT_TRUE(shift) << factor;
      EXPECT_LT((*shift - mean).norm(), 1e-6 * factor * place.norm() / 1000);
    }
}

TEST(ShiftOntoCloud, IsNoneForAStructureThatFits) {
  for (const test::SimulatedPlant* plant : {&test::simulatedTree(), &test::simulatedHerb()})
    for (const double factor : {0.001, 1.0, 1000.0}) {
      const PointCloud cloud = placed(plant->cloud, factor, {0, 0, 0});
      EXPECT_FALSE(shiftOntoCloud(scaled(plant->truth, factor), cloud)) << factor;
      EXPECT_FALSE(misfitOf(scaled(plant->truth, factor), cloud)) << factor;
    }
}

TEST(ShiftOntoCloud, DoesNotFollowAPointFarAway) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const PointCloud cloud = placed(tree.cloud, 1, {50'000, 540'000, 100});
  RawPoints raw;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    raw.positions.push_back(cloud.position(i));
  raw.positions.emplace_back(0, 0, 0);
  const Skeleton centered =
      moved(tree.truth, Eigen::Vector3d(50'000, 540'000, 100) - meanOf(cloud));
  const auto shift = shiftOntoCloud(centered, PointCloud(raw));
  ASSERT_TRUE(shift);
  EXPECT_LT((*shift - meanOf(cloud)).norm(), 1e-3);
  EXPECT_FALSE(misfitOf(moved(centered, *shift), PointCloud(raw)));
}

TEST(ShiftOntoCloud, IsNoneForAStructureThatFitsInNeitherFrame) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  EXPECT_FALSE(shiftOntoCloud(moved(tree.truth, {30, 0, 0}), tree.cloud));
  EXPECT_FALSE(shiftOntoCloud(scaled(tree.truth, 1000), tree.cloud));
  EXPECT_FALSE(shiftOntoCloud(test::randomPlant(60, 1), tree.cloud));
}

TEST(ShiftOntoCloud, IsNoneWhereThereIsTooLittleToMeasure) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const PointCloud far = placed(tree.cloud, 1, {30, 0, 0});
  Skeleton one;
  one.add({.position = far.position(0) - meanOf(far)}); // it would lie on a point
  EXPECT_FALSE(shiftOntoCloud(one, far));
  EXPECT_FALSE(shiftOntoCloud({}, tree.cloud));
  EXPECT_FALSE(shiftOntoCloud(tree.truth, PointCloud()));
  EXPECT_FALSE(misfitOf({}, tree.cloud));
  EXPECT_FALSE(misfitOf(tree.truth, PointCloud()));
}

TEST(MisfitOf, ReportsHowMuchLargerOrSmallerAStructureIs) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const double size = misfitOf(scaled(tree.truth, 1000), tree.cloud).value().size;
  EXPECT_NEAR(size, 1000, 100); // the truth reaches as far as its scan, about
  const auto small = misfitOf(scaled(tree.truth, 0.001), tree.cloud);
  ASSERT_TRUE(small);
  EXPECT_TRUE(small->isOfOtherSize);
  EXPECT_NEAR(small->size, size / 1'000'000, 1e-9);
}

TEST(MisfitOf, ReportsThatAStructureOfTheSameSizeLiesOutsideOfTheScan) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto misfit = misfitOf(moved(tree.truth, {30, 0, 0}), tree.cloud);
  ASSERT_TRUE(misfit);
  EXPECT_FALSE(misfit->isOfOtherSize);
}

TEST(MisfitOf, IsNoneForAPartOfThePlant) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  Skeleton part = tree.truth;
  const std::vector<NodeId> ids = part.ids();
  for (std::size_t i = ids.size(); i-- > 12;) // the first 12 of over 100 stay
    part.erase(ids[i]);
  EXPECT_FALSE(misfitOf(part, tree.cloud));
}

TEST(MoveAll, MovesEachNodeAndNothingElse) {
  Skeleton expected = test::fork(3);
  for (const NodeId id : expected.ids())
    expected.setPosition(id, expected[id].position + Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(moved(test::fork(3), {1, 2, 3}), expected);
}

// The mean as measured when the file was decoded; the structure is PlantScan3D's, of 2020.
TEST(ShiftOntoCloud, FindsTheMeanInAFileOfPlantScan3D) {
  ESPALIER_SHARED_FILE(scan, "A3B4/scan.asc");
  ESPALIER_SHARED_FILE(structure, "A3B4/plantscan3d.mtg");
  const auto shift =
      shiftOntoCloud(readStructure(structure).value.skeleton, readPoints(scan).value);
  ASSERT_TRUE(shift);
  EXPECT_LT((*shift - Eigen::Vector3d(-6.3895, 4.9307, 8.1829)).norm(), 2e-4);
}

TEST(ShiftOntoCloud, LeavesAnExpertsStructureWhereItIs) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(structure, "puu1/expert.mtg");
  const PointCloud cloud = readPoints(scan).value;
  const Skeleton plant = readStructure(structure).value.skeleton;
  EXPECT_FALSE(shiftOntoCloud(plant, cloud));
  EXPECT_FALSE(misfitOf(plant, cloud));
}

} // namespace
} // namespace espalier
