#include "core/base/error.h"
#include "core/skeleton/axes.h"
#include "core/surface/generalized_cylinders.h"
#include "tests/support/clouds.h"
#include "tests/support/mesh_topology.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;

/// Number of separate pieces; expects that each is closed and like a sphere.
int closedPieces(const SurfaceMesh& mesh) {
  const test::MeshTopology topology = test::topologyOf(int(mesh.corners.size()), mesh.triangles);
  EXPECT_EQ(topology.boundaryLoops, 0);
  EXPECT_EQ(topology.eulerCharacteristic, 2 * topology.pieces);
  return topology.pieces;
}

TEST(GeneralizedCylinders, AStickHasTheVolumeOfItsCylinder) {
  const SurfaceMesh mesh = surfaceByGeneralizedCylinders(test::stick(5, 0.5)); // radius 0.1, 2 high
  EXPECT_NEAR(volume(mesh), pi * 0.01 * 2, 1e-12);
  EXPECT_EQ(closedPieces(mesh), 1);
}

TEST(GeneralizedCylinders, ATaperingStickHasTheVolumeOfItsTruncatedCone) {
  Skeleton plant = test::stick(2, 3);
  plant.setRadius(NodeId{0}, 0.3);
  plant.setRadius(NodeId{1}, 0.1);
  EXPECT_NEAR(volume(surfaceByGeneralizedCylinders(plant)), pi * 3 * (0.09 + 0.03 + 0.01) / 3,
              1e-12);
}

TEST(GeneralizedCylinders, WithManySidesTheAreaIsThatOfTheCylinder) {
  const SurfaceMesh mesh = surfaceByGeneralizedCylinders(test::stick(5, 0.5), {.sides = 200});
  EXPECT_NEAR(area(mesh), 2 * pi * 0.1 * 2 + 2 * pi * 0.01, 1e-3);
}

TEST(GeneralizedCylinders, EachAxisIsAClosedPiece) {
  const Skeleton plant = test::fork(5);
  EXPECT_EQ(closedPieces(surfaceByGeneralizedCylinders(plant)), int(axes(plant).size()));
}

TEST(GeneralizedCylinders, AnyForestYieldsClosedPieces) {
  const Skeleton plant = test::randomPlant(300, 4);
  const SurfaceMesh mesh = surfaceByGeneralizedCylinders(plant);
  EXPECT_GT(closedPieces(mesh), 10);
  EXPECT_GT(volume(mesh), 0);
}

TEST(GeneralizedCylinders, MovingThePlantMovesTheSurface) {
  const Skeleton plant = test::randomPlant(60, 2);
  const double before = volume(surfaceByGeneralizedCylinders(plant));
  Skeleton moved = plant;
  const Eigen::AngleAxisd turned(1, Eigen::Vector3d(1, 2, 3).normalized());
  for (const NodeId id : plant.ids())
    moved.setPosition(id, turned * plant[id].position + Eigen::Vector3d(4e5, 5e6, 100));
  const double after = volume(surfaceByGeneralizedCylinders(moved));
  EXPECT_NEAR(after, before, 1e-5 * before);
}

TEST(GeneralizedCylinders, ScalingThePlantScalesTheVolume) {
  const Skeleton plant = test::fork(3);
  Skeleton large = plant;
  for (const NodeId id : plant.ids()) {
    large.setPosition(id, 1000 * plant[id].position);
    large.setRadius(id, 1000 * plant[id].radius);
  }
  EXPECT_NEAR(volume(surfaceByGeneralizedCylinders(large)) / 1e9,
              volume(surfaceByGeneralizedCylinders(plant)), 1e-9);
}

TEST(GeneralizedCylinders, RadiiThatAreNotKnownLieBetweenThoseThatAre) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{0}, 0.3);
  plant.setRadius(NodeId{1}, 0);
  plant.setRadius(NodeId{2}, 0.1);
  Skeleton known = plant;
  known.setRadius(NodeId{1}, 0.2);
  EXPECT_NEAR(volume(surfaceByGeneralizedCylinders(plant)),
              volume(surfaceByGeneralizedCylinders(known)), 1e-12);
}

TEST(GeneralizedCylinders, AnAxisWithoutRadiiHasThatOfTheOneItIsAttachedTo) {
  Skeleton plant = test::fork(2);
  const Axis branch = axes(plant)[1];
  for (const NodeId id : branch)
    plant.setRadius(id, 0);
  Skeleton known = plant;
  for (const NodeId id : branch)
    known.setRadius(id, plant[test::forkTop].radius);
  EXPECT_NEAR(volume(surfaceByGeneralizedCylinders(plant)),
              volume(surfaceByGeneralizedCylinders(known)), 1e-12);
}

TEST(GeneralizedCylinders, APlantWithoutRadiiIsRefused) {
  Skeleton plant = test::stick(3);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0);
  EXPECT_THROW((void)surfaceByGeneralizedCylinders(plant), Error);
  EXPECT_THROW((void)surfaceByGeneralizedCylinders({}), Error);
}

TEST(GeneralizedCylinders, ALoneNodeHasNoSurface) {
  EXPECT_EQ(surfaceByGeneralizedCylinders(test::stick(1)).triangles.size(), 0U);
}

TEST(GeneralizedCylinders, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)surfaceByGeneralizedCylinders(test::fork(3), {}, progress);
  }));
}

} // namespace
} // namespace espalier
