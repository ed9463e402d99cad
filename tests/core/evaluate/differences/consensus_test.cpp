#include "core/evaluate/differences/consensus.h"
#include "core/evaluate/match/comparable.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/evaluate/differences/differing_plants.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace espalier {
namespace {

constexpr double nearBy = 0.1;

Consensus consensusOfAll(const std::vector<Skeleton>& plants) {
  return consensusOf(plants, nearBy);
}

TEST(Consensus, OfEqualPlantsIsThePlant) {
  const Skeleton plant = test::trunkAndBranch().plant;
  const Consensus found = consensusOfAll({plant, plant, plant});
  EXPECT_EQ(test::canonical(found.agreed), test::canonical(plant));
  EXPECT_TRUE(found.places.empty());
  EXPECT_EQ(found.shares, std::vector<double>(3, 1));
}

TEST(Consensus, LeavesOutWhatOneOfThemLacks) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton bare = test::edited(
      plant, [first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  for (const bool isFirst : {true, false}) {
    const Consensus found =
        isFirst ? consensusOfAll({plant, plant, bare}) : consensusOfAll({bare, plant, plant});
    EXPECT_EQ(test::canonical(found.agreed), test::canonical(bare));
    ASSERT_EQ(found.places.size(), isFirst ? 1U : 2U);
    EXPECT_EQ(found.places[0].with, isFirst ? 2U : 1U);
    EXPECT_EQ(found.places[0].kind, isFirst ? Difference::invented : Difference::missed);
    EXPECT_NEAR(found.places[0].length, 4, 1e-9);
    EXPECT_NEAR(found.shares[isFirst ? 2 : 0], 1, 1e-9) << "all of the bare one";
    EXPECT_NEAR(found.shares[1], 10.0 / 14, 0.02) << "the trunk";
  }
}

/// The first skeleton of a consensus, once what is agreed on is kept of it.
Skeleton keptOf(Skeleton plant, const Consensus& consensus) {
  SkeletonEditor editor(plant);
  keepAgreed(editor, consensus);
  static_cast<void>(editor.commit());
  return plant;
}

TEST(Consensus, IsKeptOfAPlantWithWhatThatSaysOfIt) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton bare = test::edited(
      plant, [first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  Skeleton marked = plant;
  marked.setReview(trunk[1], {.state = ReviewState::reviewed, .reviewer = "Anna"});
  Skeleton kept = keptOf(marked, consensusOfAll({marked, bare}));
  EXPECT_EQ(kept[trunk[1]].review.reviewer, "Anna");
  kept.setReview(trunk[1], {});
  EXPECT_EQ(kept, bare);
}

TEST(Consensus, MakesWhatIsAttachedElsewhereATreeOfItsOwn) {
  // The branch runs beside the trunk, so that it can be attached to either end of it.
  Skeleton low;
  const NodeId root = low.add({.radius = 0.1});
  NodeId top = root;
  std::vector<NodeId> trunk = {root};
  for (int z = 1; z <= 10; ++z)
    trunk.push_back(top = low.add({.position = {0, 0, double(z)}, .radius = 0.1, .parent = top}));
  NodeId shoot{};
  NodeId at = trunk[2];
  for (int z = 2; z <= 8; ++z) {
    at = low.add({.position = {2, 0, double(z)},
                  .radius = 0.1,
                  .parent = at,
                  .edge = z == 2 ? EdgeType::branching : EdgeType::successor});
    if (z == 2) shoot = at;
  }
  Skeleton high = low;
  high.makeRoot(shoot);
  high.setPosition(shoot, {2, 0, 2});
  high.reparent(shoot, trunk[9], EdgeType::branching);
  const Consensus found = consensusOfAll({low, high});
  EXPECT_TRUE(std::ranges::any_of(found.places, [](const Disagreement& place) {
    return place.kind == Difference::wronglyAttached;
  }));
  EXPECT_EQ(found.agreed.roots().size(), 2U);
  EXPECT_NEAR(totalLength(found.agreed), 10 + 6, 1e-9)
      << "trunk and shoot, without what leads there";
  EXPECT_EQ(test::canonical(keptOf(low, found)), test::canonical(found.agreed));
}

/// A trunk with three twigs that leave it at one node, along three lines or one behind the other.
Skeleton trunkWithTwigs(bool isStar, int pieces) {
  Skeleton plant;
  const auto line = [&](NodeId from, const Eigen::Vector3d& to, int count, EdgeType edge) {
    const Eigen::Vector3d start = plant[from].position;
    for (int i = 1; i <= count; ++i) {
      from = plant.add({.position = start + (to - start) * i / count,
                        .radius = 0.02,
                        .parent = from,
                        .edge = i == 1 ? edge : EdgeType::successor});
    }
    return from;
  };
  const NodeId root = plant.add({.radius = 0.02});
  const NodeId hub = line(root, {0, 0, 5}, 10, EdgeType::successor);
  line(hub, {0, 0, 9}, 8, EdgeType::successor);
  NodeId bearer = hub;
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(1, 0, 5.5), Eigen::Vector3d(2, 0, 6.5), Eigen::Vector3d(3, 0, 8)}) {
    const NodeId end = line(bearer, place, pieces, EdgeType::branching);
    line(end, place + Eigen::Vector3d(0.2, 2, 1), 6, EdgeType::branching);
    if (!isStar) bearer = end;
  }
  return plant;
}

TEST(Consensus, CountsWhatIsAttachedElsewhereOnceWhicheverIsFirst) {
  const Skeleton chain = trunkWithTwigs(false, 4);
  for (const int pieces : {1, 4}) { // what leads from twig to twig is of wood, or one long edge
    const Skeleton star = trunkWithTwigs(true, pieces);
    for (const bool isChainFirst : {true, false}) {
      const Consensus found =
          isChainFirst ? consensusOfAll({chain, star}) : consensusOfAll({star, chain});
      ASSERT_EQ(found.places.size(), 2U) << "the twigs behind the first, " << pieces;
      for (const Disagreement& place : found.places)
        EXPECT_EQ(place.kind, Difference::wronglyAttached);
      EXPECT_EQ(found.agreed.roots().size(), 3U) << pieces;
    }
  }
}

// The trunk of one stands on its top: each has all of its wood near the other.
TEST(Consensus, LeavesOutWoodThatOneHasFromItsOtherEndUp) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton turned;
  std::vector<NodeId> down; // from the top
  for (int z = 10; z >= 0; --z)
    down.push_back(turned.add({.position = {0, 0, double(z)},
                               .radius = 0.3,
                               .parent = z < 10 ? std::optional(down.back()) : std::nullopt}));
  NodeId at = down[5];
  for (int x = 1; x <= 4; ++x)
    at = turned.add({.position = {double(x), 0, 5},
                     .radius = 0.1,
                     .parent = at,
                     .edge = x > 1 ? EdgeType::successor : EdgeType::branching});
  for (const auto& [first, second] : {std::pair(plant, turned), std::pair(turned, plant)}) {
    const Consensus found = consensusOfAll({first, second});
    ASSERT_FALSE(found.places.empty());
    EXPECT_EQ(found.places[0].kind, Difference::wronglyAttached);
    EXPECT_NEAR(found.places[0].length, 10, 1e-9) << "the trunk";
    EXPECT_NEAR(totalLength(found.agreed), 4, 1e-9) << "the branch grows out in both";
    EXPECT_NEAR(found.shares[0], 4.0 / 14, 0.02);
  }
}

TEST(Consensus, KeepsPositionsAndRadiiOfTheFirst) {
  const Skeleton first = test::trunkAndBranch().plant;
  Skeleton second = first;
  for (const NodeId id : first.ids()) {
    second.setPosition(id, first[id].position + Eigen::Vector3d(0, 0.05, 0));
    second.setRadius(id, 7);
  }
  EXPECT_EQ(test::canonical(consensusOfAll({first, second}).agreed), test::canonical(first));
}

TEST(Consensus, IsEmptyWhereNothingIsNear) {
  const Skeleton first = test::trunkAndBranch().plant;
  Skeleton second = first;
  for (const NodeId id : first.ids())
    second.setPosition(id, first[id].position + Eigen::Vector3d(0, 50, 0));
  const Consensus found = consensusOfAll({first, second});
  EXPECT_TRUE(found.agreed.isEmpty());
  EXPECT_EQ(found.shares, std::vector<double>(2, 0));
}

TEST(Consensus, StopsWhenAskedTo) {
  const Skeleton plant = test::trunkAndBranch().plant;
  std::stop_source stop;
  stop.request_stop();
  const std::vector<Skeleton> plants = {plant, plant};
  EXPECT_THROW((void)consensusOf(plants, nearBy, Progress(stop.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
