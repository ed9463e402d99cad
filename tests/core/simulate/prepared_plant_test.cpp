#include "core/base/error.h"
#include "core/simulate/grown_radii.h"
#include "core/simulate/prepared_plant.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

double longestEdge(const Skeleton& plant) {
  double longest = 0;
  for (const NodeId id : plant.ids())
    if (const auto parent = plant[id].parent)
      longest = std::max(longest, (plant[id].position - plant[*parent].position).norm());
  return longest;
}

/// A quarter of a circle of radius 1 about the origin, in `edges` straight edges.
Skeleton arc(int edges) {
  Skeleton plant;
  std::optional<NodeId> parent;
  for (int i = 0; i <= edges; ++i) {
    const double angle = std::numbers::pi / 2 * i / edges;
    parent = plant.add(
        {.position = {std::cos(angle), 0, std::sin(angle)}, .radius = 0.1, .parent = parent});
  }
  return plant;
}

std::size_t count(const Skeleton& plant, EdgeType type) {
  const std::vector<NodeId> ids = plant.ids();
  return static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), [&](NodeId id) {
    return plant[id].parent && plant[id].edge == type;
  }));
}

TEST(PreparedPlant, PutsFurtherNodesOnASmoothCurve) {
  const Skeleton plant =
      preparedPlant(arc(6), {.spacing = 0.02, .smoothing = 0, .apexExtension = 0});
  EXPECT_LT(longestEdge(plant), 0.021);
  for (const NodeId id : plant.ids()) // chords miss the circle by 1 - cos(7.5 degrees) = 0.0086
    EXPECT_NEAR(plant[id].position.norm(), 1, 0.0005);
}

TEST(PreparedPlant, KeepsTheNodesGivenIfItDoesNotSmooth) {
  const Skeleton given = arc(6);
  const Skeleton plant = preparedPlant(given, {.smoothing = 0, .apexExtension = 0});
  for (const NodeId id : given.ids()) {
    const std::vector<NodeId> ids = plant.ids();
    EXPECT_TRUE(std::any_of(ids.begin(), ids.end(), [&](NodeId other) {
      return plant[other].position == given[id].position;
    }));
  }
}

TEST(PreparedPlant, LeavesAStraightAxisStraightHoweverUnevenItsNodes) {
  Skeleton given;
  std::optional<NodeId> parent;
  for (const double z : {0.0, 1000.0, 1045.0, 1046.0, 1100.0})
    parent = given.add({.position = {0, 0, z}, .radius = 5, .parent = parent});
  const Skeleton plant = preparedPlant(given, {.smoothing = 5, .apexExtension = 0});
  double last = -1;
  for (const NodeId id : plant.ids()) {
    EXPECT_NEAR(plant[id].position.head<2>().norm(), 0, 1e-9);
    EXPECT_GT(plant[id].position.z(), last); // and never turns back
    last = plant[id].position.z();
  }
  EXPECT_NEAR(last, 1100, 1e-9);
}

TEST(PreparedPlant, TakesKinksOutOfAnAxis) {
  Skeleton given = test::stick(21);
  for (const NodeId id : given.ids())
    given.setPosition(id, given[id].position + Vector3d(indexOf(id) % 2 == 0 ? 0.2 : -0.2, 0, 0));
  const auto roughness = [](const Skeleton& plant) {
    double most = 0;
    for (const NodeId id : plant.ids())
      if (plant[id].position.z() > 5 && plant[id].position.z() < 15)
        most = std::max(most, std::abs(plant[id].position.x()));
    return most;
  };
  EXPECT_LT(roughness(preparedPlant(given, {.smoothing = 3})),
            0.3 * roughness(preparedPlant(given, {.smoothing = 0})));
}

TEST(PreparedPlant, KeepsBranchingsAndEdgeTypes) {
  const Skeleton given = test::fork(4);
  const Skeleton plant = preparedPlant(given, {.spacing = 0.1});
  EXPECT_EQ(plant.roots().size(), 1U);
  EXPECT_EQ(count(plant, EdgeType::branching), count(given, EdgeType::branching));
  std::size_t forks = 0;
  std::size_t apices = 0;
  for (const NodeId id : plant.ids()) {
    forks += plant.children(id).size() == 4 ? 1 : 0;
    apices += plant.children(id).empty() ? 1 : 0;
  }
  EXPECT_EQ(forks, 1U);
  EXPECT_EQ(apices, 4U);
}

TEST(PreparedPlant, TapersEvenlyBetweenTheGivenNodes) {
  Skeleton given = test::stick(3);
  given.setRadius(NodeId{0}, 0.5);
  given.setRadius(NodeId{1}, 0.3);
  given.setRadius(NodeId{2}, 0.2);
  const Skeleton plant = preparedPlant(given, {.spacing = 0.1, .apexExtension = 0});
  for (const NodeId id : plant.ids()) {
    const double z = plant[id].position.z();
    EXPECT_NEAR(plant[id].radius, z < 1 ? 0.5 - 0.2 * z : 0.4 - 0.1 * z, 1e-9);
  }
}

// As woodOf has it: the solid stays what it was.
TEST(PreparedPlant, KeepsTheRadiusOfABranchDownToTheAxisThatBearsIt) {
  Skeleton given = test::fork(2);
  given.setRadius(test::forkTop, 0.7);
  const Skeleton plant = preparedPlant(given, {.spacing = 0.1});
  for (const NodeId id : plant.ids())
    if (plant[id].edge == EdgeType::branching) {
      EXPECT_EQ(plant[id].radius, 0.1);
      EXPECT_EQ(plant[*plant[id].parent].radius, 0.7);
    }
}

TEST(PreparedPlant, ExtendsApicesByHalfAnEdgeUnlessSetOtherwise) {
  const auto top = [](const PreparationOptions& options) {
    const Skeleton plant = preparedPlant(test::stick(5), options);
    double highest = 0;
    for (const NodeId id : plant.ids())
      highest = std::max(highest, plant[id].position.z());
    return highest;
  };
  EXPECT_NEAR(top({}), 4.5, 1e-12);
  EXPECT_NEAR(top({.apexExtension = 2}), 6, 1e-12);
}

TEST(PreparedPlant, GivesRadiiWhereThereAreNone) {
  Skeleton given = test::stick(11);
  for (const NodeId id : given.ids())
    given.setRadius(id, 0);
  const Skeleton plant = preparedPlant(given, {.baseRadius = 0.3, .apexRadius = 0.03});
  double apex = 1;
  for (const NodeId id : plant.ids()) {
    EXPECT_GT(plant[id].radius, 0);
    apex = std::min(apex, plant[id].radius);
  }
  EXPECT_NEAR(plant[plant.roots().front()].radius, 0.3, 1e-9);
  EXPECT_NEAR(apex, 0.03, 1e-9);
}

TEST(PreparedPlant, FitsMissingRadiiToThoseThatAreKnown) {
  const GrownRadiusOptions truth{.baseRadius = 0.2, .apexRadius = 0.01};
  const Skeleton whole = withGrownRadii(test::stick(30), truth);
  Skeleton given = whole;
  for (const NodeId id : given.ids())
    given.setRadius(id, indexOf(id) % 3 == 0 ? 0 : 5 * given[id].radius);
  const Skeleton plant = preparedPlant(
      given,
      {.spacing = 9, .smoothing = 0, .baseRadius = 0.2, .apexRadius = 0.01, .apexExtension = 0});
  for (const NodeId id : whole.ids())
    EXPECT_NEAR(plant[id].radius, 5 * whole[id].radius, 1e-9);
}

TEST(PreparedPlant, TakesEmptySingleAndCoincidentNodes) {
  EXPECT_TRUE(preparedPlant({}).isEmpty());
  EXPECT_EQ(preparedPlant(test::stick(1)), test::stick(1));
  EXPECT_EQ(preparedPlant(test::stick(4, 0)), test::stick(4, 0));
  Skeleton doubled = test::stick(5);
  doubled.setPosition(NodeId{2}, doubled[NodeId{1}].position);
  for (const NodeId id : preparedPlant(doubled).ids())
    EXPECT_TRUE(preparedPlant(doubled)[id].position.allFinite());
}

TEST(PreparedPlant, RefusesBadNodesAndOptions) {
  Skeleton bad = test::stick(3);
  bad.setPosition(NodeId{1}, {0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_THROW(static_cast<void>(preparedPlant(bad)), Error);
  const auto run = [](const PreparationOptions& options) {
    static_cast<void>(preparedPlant(test::stick(3), options));
  };
  EXPECT_THROW(run({.spacing = -1}), Error);
  EXPECT_THROW(run({.spacing = 1e-9}), Error);
  EXPECT_THROW(run({.smoothing = -1}), Error);
  EXPECT_THROW(run({.apexRadius = std::nan("")}), Error);
  EXPECT_THROW(run({.apexExtension = -1}), Error);
}

} // namespace
} // namespace espalier
