#include "core/doubt/finding_gain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

/// A stem of four nodes, 0 to 3, of length 3, with a branch of two, 4 and 5, of length 2, on 1.
Skeleton forkedStem() {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i < 4; ++i)
    last = plant.add({.position = {0, 0, 1.0 * i}, .radius = 0.1, .parent = last});
  const NodeId low = plant.add(
      {.position = {1, 0, 1}, .radius = 0.05, .parent = NodeId(1), .edge = EdgeType::branching});
  plant.add({.position = {2, 0, 1}, .radius = 0.05, .parent = low});
  return plant;
}

FindingGain gainOf(const Finding& finding) {
  return gainsOf({finding}, forkedStem()).front();
}

TEST(FindingGain, OfABranchIsItsShareOfThePlantTimesTheChance) {
  const FindingGain gain = gainOf({.kind = Finding::Kind::noOwnPoints, .node = NodeId(4)});
  EXPECT_DOUBLE_EQ(gain.length, 2);
  EXPECT_DOUBLE_EQ(gain.gain, gain.wrong * (2.0 / 5 + 1.0 / 2) / 2);
}

TEST(FindingGain, OfWoodAmidTheStemHasNoEnd) {
  const FindingGain gain = gainOf({.kind = Finding::Kind::besidePoints, .node = NodeId(2)});
  EXPECT_DOUBLE_EQ(gain.length, 1);
  EXPECT_DOUBLE_EQ(gain.gain, gain.wrong * (1.0 / 5) / 2);
}

TEST(FindingGain, OfPointsIsHowFarTheyReachAndAnEnd) {
  const FindingGain gain = gainOf(
      {.kind = Finding::Kind::unexplainedPoints, .node = NodeId(3), .amount = 40, .reach = 0.5});
  EXPECT_DOUBLE_EQ(gain.length, 1);
  EXPECT_DOUBLE_EQ(gain.gain, gain.wrong * (1.0 / 5 + 1.0 / 2) / 2);
}

TEST(FindingGain, IsInTheMeasureOfDoubtsForEveryKind) {
  for (int kind = 0; kind < findingKinds; ++kind) {
    const FindingGain gain = gainOf({.kind = static_cast<Finding::Kind>(kind),
                                     .node = NodeId(4),
                                     .others = {NodeId(2), NodeId(3)},
                                     .amount = 1e3,
                                     .reach = 1e3});
    EXPECT_GT(gain.wrong, 0) << kind;
    EXPECT_LT(gain.wrong, 1) << kind;
    EXPECT_GT(gain.gain, 0) << kind;
    EXPECT_LE(gain.gain, 1) << kind;
  }
}

TEST(FindingGain, IsOfTheWoodThatTheFindingIsAbout) {
  const Skeleton plant = forkedStem();
  const auto wood = [&](Finding::Kind kind, NodeId node, std::vector<NodeId> others = {}) {
    return woodOf({.kind = kind, .node = node, .others = std::move(others)}, plant);
  };
  using Ids = std::vector<NodeId>;
  EXPECT_EQ(wood(Finding::Kind::sharpTurn, NodeId(4)), (Ids{NodeId(4), NodeId(5)}))
      << "of a branch that is attached too high";
  EXPECT_EQ(wood(Finding::Kind::sharpTurn, NodeId(2)), Ids{NodeId(2)}) << "of an axis";
  EXPECT_EQ(wood(Finding::Kind::edgesWithoutPoints, NodeId(2), {NodeId(3)}),
            (Ids{NodeId(2), NodeId(3)}));
  EXPECT_EQ(wood(Finding::Kind::separatePiece, NodeId(1)).size(), 5U);
  EXPECT_TRUE(wood(Finding::Kind::shortFoot, NodeId(0)).empty());
}

TEST(FindingGain, OfABareTwigFollowsFromItsPointsWhereLeavesMakeMany) {
  const Skeleton plant = forkedStem();
  const auto twig = [](double points) {
    return Finding{.kind = Finding::Kind::unexplainedPoints,
                   .node = NodeId(1),
                   .amount = points,
                   .reach = 0.1};
  };
  const auto of = [&](const std::vector<Finding>& findings) {
    std::vector<double> wrong;
    for (const FindingGain& gain : gainsOf(findings, plant))
      wrong.push_back(gain.wrong);
    return wrong;
  };
  const std::vector<double> many = of({twig(10), twig(30), twig(100)});
  EXPECT_LT(many[0], many[1]);
  EXPECT_LT(many[1], many[2]);
  const std::vector<Finding> ignored(6, twig(10));
  Skeleton bushy = plant;
  for (int i = 0; i < 20; ++i)
    bushy.add({.position = {0.1 * i, 1, 1}, .parent = NodeId(1), .edge = EdgeType::branching});
  EXPECT_GT(gainsOf({twig(10)}, bushy).front().wrong, many[2]) << "a bare plant has few";
  EXPECT_EQ(gainsOf({twig(10)}, bushy, ignored).front().wrong, many[0]) << "ignored ones count";
}

} // namespace
} // namespace espalier
