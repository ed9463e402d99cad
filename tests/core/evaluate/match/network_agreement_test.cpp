#include "core/base/error.h"
#include "core/evaluate/match/network_agreement.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

constexpr NetworkOptions options{.deviation = 0.1, .distance = 0.2, .step = 0.01};

TEST(NetworkAgreement, OfAPlantWithItselfLacksNothing) {
  const NetworkAgreement same = networkAgreement(test::bush(), test::bush(), options);
  EXPECT_NEAR(same.missedLength, 0, 1e-12);
  EXPECT_NEAR(same.inventedLength, 0, 1e-12);
  EXPECT_GT(same.connections, 64U);
  EXPECT_EQ(same.missedConnections, 0);
  EXPECT_EQ(same.inventedConnections, 0);
}

// All of it lies one deviation to the side: each place is right by exp(-1/2).
TEST(NetworkAgreement, WeighsADistanceByAGaussian) {
  Skeleton beside = test::stick(11);
  for (const NodeId id : beside.ids())
    beside.setPosition(id, beside[id].position + Eigen::Vector3d(options.deviation, 0, 0));
  const NetworkAgreement found = networkAgreement(beside, test::stick(11), options);
  EXPECT_NEAR(found.missedLength, 1 - std::exp(-0.5), 1e-9);
  EXPECT_NEAR(found.inventedLength, 1 - std::exp(-0.5), 1e-9);
}

// A twig of 9 on a stick of 10 is missed: near its foot, by the half of a Gaussian, it is found.
TEST(NetworkAgreement, SeparatesMissedFromInvented) {
  Skeleton twig = test::stick(11);
  twig.add({.position = {9, 0, 5}, .parent = NodeId{5}, .edge = EdgeType::branching});
  const double near = options.deviation * std::sqrt(M_PI / 2);
  const NetworkAgreement missed = networkAgreement(test::stick(11), twig, options);
  EXPECT_NEAR(missed.missedLength, (9 - near) / 19, 1e-4);
  EXPECT_NEAR(missed.inventedLength, 0, 1e-12);
  const NetworkAgreement invented = networkAgreement(twig, test::stick(11), options);
  EXPECT_NEAR(invented.inventedLength, missed.missedLength, 1e-12);
  EXPECT_NEAR(invented.missedLength, 0, 1e-12);
}

/// Two forks, each with two arms, on one stem; the last arm is `last`.
struct TwoForks {
  Skeleton plant = test::fork(2);
  NodeId last{};
  TwoForks() {
    for (const double z : {1.0, 3.0}) {
      plant.add({.position = {2, 0, z}, .parent = NodeId{2}, .edge = EdgeType::branching});
      last = plant.add({.position = {-2, 0, z}, .parent = NodeId{3}, .edge = EdgeType::branching});
    }
  }
};

// Seven landmarks make six connections; one arm is attached to the other fork.
TEST(NetworkAgreement, SeesWhatIsConnectedOtherwise) {
  const TwoForks forks;
  Skeleton wrong = forks.plant;
  const NodeId arm =
      wrong.add({.position = {0, 3, 3}, .parent = NodeId{2}, .edge = EdgeType::branching});
  Skeleton right = wrong;
  right.reparent(arm, NodeId{3}, EdgeType::branching);
  const NetworkAgreement found = networkAgreement(wrong, right, options);
  EXPECT_EQ(found.connections, 7U);
  EXPECT_DOUBLE_EQ(found.missedConnections, 1.0 / 7);
  EXPECT_DOUBLE_EQ(found.inventedConnections, 1.0 / 7);
}

TEST(NetworkAgreement, CountsNoConnectionToWhatTheOtherLacks) {
  const TwoForks forks;
  Skeleton missing = forks.plant;
  missing.erase(forks.last); // its fork is no branching any more: both ends are lacking
  const NetworkAgreement found = networkAgreement(missing, forks.plant, options);
  EXPECT_EQ(found.connections, 4U) << "two forks and three arms";
  EXPECT_EQ(found.missedConnections, 0);
  EXPECT_EQ(found.inventedConnections, 0);
}

TEST(NetworkAgreement, DependsNeitherOnTheFrameNorOnNodesWithinEdges) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.1);
  const NetworkAgreement found = networkAgreement(result, reference, options);
  EXPECT_GT(found.missedLength, 0.1);
  const Eigen::Isometry3d motion = test::motion(0.7, {3, 4, 5});
  const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return motion * p; };
  const NetworkAgreement moved = networkAgreement(
      test::placed(test::withMiddleNodes(result), place), test::placed(reference, place), options);
  EXPECT_NEAR(moved.missedLength, found.missedLength, 1e-6);
  EXPECT_NEAR(moved.inventedLength, found.inventedLength, 1e-6);
  EXPECT_EQ(moved.missedConnections, found.missedConnections);
}

TEST(NetworkAgreement, RefusesWhatHasNoLength) {
  EXPECT_THROW(static_cast<void>(networkAgreement({}, test::stick(3), options)), Error);
  EXPECT_THROW(static_cast<void>(networkAgreement(test::stick(3), test::stick(1), options)), Error);
}

} // namespace
} // namespace espalier
