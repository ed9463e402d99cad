#include "core/skeleton/bounds.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/review_stops.h"
#include "tests/support/plants.h"

#include <algorithm>
#include <cstdint>
#include <gmock/gmock.h>
#include <limits>
#include <random>

namespace espalier {
namespace {

using testing::ElementsAre;
using Numbers = std::vector<std::vector<unsigned>>;

Numbers nodesOfStops(const std::vector<ReviewStop>& stops) {
  Numbers result;
  for (const ReviewStop& stop : stops) {
    result.emplace_back();
    for (const NodeId id : stop.nodes)
      result.back().push_back(static_cast<unsigned>(id));
  }
  return result;
}

/// A trunk of 20 nodes along z, 1 apart; on node 10 the branch 20-23 along x, on 22 the twig 24.
/// Its longest stretch is 1.95.
Skeleton trunkWithBranch() {
  Skeleton plant = test::stick(20);
  const auto add = [&](double x, double z, unsigned parent, EdgeType edge) {
    plant.add({.position = {x, 0, z}, .parent = NodeId{parent}, .edge = edge});
  };
  add(0.5, 10, 10, EdgeType::branching);
  for (unsigned i = 1; i < 4; ++i)
    add(0.5 + 0.5 * i, 10, 19 + i, EdgeType::successor);
  add(1.5, 10.3, 22, EdgeType::branching);
  return plant;
}

ExpectedErrors errorsAt(const Skeleton& plant, const std::vector<unsigned>& risky,
                        double probability = 0.5) {
  ExpectedErrors errors{std::vector<double>(plant.idEnd(), 0.01)};
  for (const unsigned id : risky)
    errors.ofEdges[id] = probability;
  return errors;
}

TEST(ReviewStops, AreStretchesWhereNothingIsKnownOfErrors) {
  const Skeleton plant = trunkWithBranch();
  std::vector<std::vector<NodeId>> expected = stretches(plant, longestStretch(plant));
  std::vector<std::vector<NodeId>> found;
  for (const ReviewStop& stop : reviewStops(plant, nullptr))
    found.push_back(stop.nodes);
  EXPECT_EQ(found, expected);
}

// Of the trunk, 3 edges are seen in one look: two stretches are 3.9. The branch with its twig
// is 2.3 long, and fits beside none of these, as both together would be longer.
TEST(ReviewStops, TakeWhatIsCleanWhole) {
  const Skeleton plant = trunkWithBranch();
  const ExpectedErrors errors = errorsAt(plant, {});
  EXPECT_THAT(nodesOfStops(reviewStops(plant, &errors)),
              ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6), ElementsAre(7, 8, 9),
                          ElementsAre(10, 11, 12), ElementsAre(13, 14, 15), ElementsAre(16, 17, 18),
                          ElementsAre(19), ElementsAre(20, 21, 22, 23, 24)));
}

TEST(ReviewStops, TakeARootWithItsFirstEdgeHoweverLong) {
  Skeleton plant = test::stick(20);
  plant.setPosition(NodeId{0}, {0, 0, -6});
  for (const std::vector<unsigned>& risky : {std::vector<unsigned>{}, std::vector<unsigned>{1}}) {
    const ExpectedErrors errors = errorsAt(plant, risky);
    EXPECT_THAT(nodesOfStops(reviewStops(plant, &errors)).front(), ElementsAre(0, 1));
  }
}

TEST(ReviewStops, TakeACleanBranchWithTheCleanWoodThatBearsIt) {
  Skeleton plant = trunkWithBranch();
  const NodeId twig =
      plant.add({.position = {0.5, 0, 19}, .parent = NodeId{19}, .edge = EdgeType::branching});
  ExpectedErrors errors = errorsAt(plant, {});
  const auto together = [&] {
    const std::vector<ReviewStop> stops = reviewStops(plant, &errors);
    return stopOf(stops, twig) == stopOf(stops, NodeId{19});
  };
  EXPECT_TRUE(together());
  errors.ofEdges[indexOf(twig)] = 0.2;
  EXPECT_FALSE(together()) << "it is risky, and the trunk is not";
}

// The branch of 2 and its twig of 0.3 are 2.3 long: under two stretches, over one.
TEST(ReviewStops, TakeWhatIsRiskyInPartsOfAStretch) {
  const Skeleton plant = trunkWithBranch();
  const ExpectedErrors clean = errorsAt(plant, {});
  const auto holding = [&](const ExpectedErrors& errors, unsigned id) {
    const std::vector<ReviewStop> stops = reviewStops(plant, &errors);
    return stops[*stopOf(stops, NodeId{id})];
  };
  EXPECT_TRUE(holding(clean, 23).isClean);
  EXPECT_THAT(holding(clean, 23).nodes, testing::IsSupersetOf({NodeId{20}, NodeId{24}}));
  const ExpectedErrors risky = errorsAt(plant, {20, 21, 22, 23, 24});
  EXPECT_FALSE(holding(risky, 23).isClean);
  EXPECT_THAT(nodesOfStops({holding(risky, 20)}), ElementsAre(ElementsAre(20, 21, 22, 24)));
  EXPECT_THAT(nodesOfStops({holding(risky, 23)}), ElementsAre(ElementsAre(23)));
  EXPECT_DOUBLE_EQ(holding(risky, 20).length, 1.8);
  EXPECT_DOUBLE_EQ(holding(risky, 20).wrong, 0.9);
}

TEST(ReviewStops, LookCloserAtWhatIsNotKnown) {
  Skeleton plant = trunkWithBranch();
  const ExpectedErrors errors = errorsAt(plant, {});
  const NodeId added = plant.add(
      {.position = {0, 1, 15}, .parent = NodeId{15}, .edge = EdgeType::branching}); // since
  const std::vector<ReviewStop> stops = reviewStops(plant, &errors);
  const ReviewStop& stop = stops[*stopOf(stops, added)];
  EXPECT_EQ(stop.nodes, std::vector{added});
  EXPECT_FALSE(stop.isClean);
  EXPECT_DOUBLE_EQ(stop.wrong, 1);
}

TEST(ReviewStops, AreEachOneLookAndLeaveOutNoNode) {
  std::mt19937 random(1);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Skeleton plant = test::randomPlant(300, seed);
    ExpectedErrors errors{std::vector<double>(plant.idEnd())};
    for (double& each : errors.ofEdges)
      each = std::uniform_real_distribution<double>(0, seed % 3 == 0 ? 0.11 : 0.3)(random);
    for (const WalkOrder order : {WalkOrder::alongPlant, WalkOrder::byExpectedError}) {
      std::vector<NodeId> walked;
      double before = std::numeric_limits<double>::infinity();
      for (const ReviewStop& stop : reviewStops(plant, &errors, order)) {
        ASSERT_TRUE(isOneLook(plant, stop.nodes)) << "seed " << seed;
        if (order == WalkOrder::byExpectedError) {
          ASSERT_LE(stop.wrong, before);
        }
        before = stop.wrong;
        walked.insert(walked.end(), stop.nodes.begin(), stop.nodes.end());
      }
      std::vector<NodeId> all = plant.ids();
      std::ranges::sort(walked);
      std::ranges::sort(all);
      ASSERT_EQ(walked, all) << "seed " << seed;
    }
  }
}

TEST(ReviewStops, AreAlsoAtPointsWithoutWood) {
  const Skeleton plant = trunkWithBranch();
  ExpectedErrors errors = errorsAt(plant, {});
  const auto addCluster = [&](unsigned node, double z, double reach) {
    errors.clusters.push_back({.kind = Finding::Kind::unexplainedPoints,
                               .node = NodeId{node},
                               .place = {3, 0, z},
                               .reach = reach});
  };
  addCluster(24, 10, 30);
  addCluster(0, 0, 0.1);
  addCluster(99, 0, 0.1);  // whose node is gone
  addCluster(5, 0.5, 0.1); // looked at with the one at the foot
  addCluster(6, 5, 0.2);
  addCluster(12, 12, 0.1); // small, and alone
  std::vector<ReviewStop> stops = reviewStops(plant, &errors);
  EXPECT_THAT(stops[1].clusters, ElementsAre(1, 3));
  EXPECT_TRUE(stops[1].nodes.empty());
  EXPECT_THAT(stops[*stopOf(stops, NodeId{6}) + 1].clusters, ElementsAre(4));
  EXPECT_THAT(stops[*stopOf(stops, NodeId{24}) + 1].clusters, ElementsAre(0));
  EXPECT_EQ(std::ranges::count_if(stops, &ReviewStop::isAtPoints), 3);
  EXPECT_THAT(reviewStops(plant, &errors, WalkOrder::byExpectedError).front().clusters,
              ElementsAre(0));
  EXPECT_EQ(walk(plant, stops, 0, WalkTo::toDo), 1U);
  stops[1].isDoubtful = true;
  EXPECT_EQ(walk(plant, stops, 0, WalkTo::toDo), 2U) << "it was looked at";
  EXPECT_EQ(walk(plant, stops, 0, WalkTo::notReviewed), 1U);
}

TEST(ReviewStops, OfNothingAreNone) {
  const ExpectedErrors errors;
  EXPECT_TRUE(reviewStops(Skeleton(), &errors).empty());
  EXPECT_EQ(walk(Skeleton(), {}, std::nullopt, WalkTo::anyStop), std::nullopt);
}

void markReviewed(Skeleton& plant, const ReviewStop& stop) {
  for (const NodeId id : stop.nodes)
    plant.setReview(id, {.state = ReviewState::reviewed});
}

TEST(ReviewStops, GoesOnAndBackAndBeginsAnewAtTheEnd) {
  const Skeleton plant = test::walkedTree();
  const auto parts = reviewStops(plant, nullptr);
  EXPECT_EQ(walk(plant, parts, std::nullopt, WalkTo::anyStop), 0U);
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::anyStop), 1U);
  EXPECT_EQ(walk(plant, parts, 6, WalkTo::anyStop), 0U);
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::anyStop, WalkDirection::backward), 6U);
  EXPECT_EQ(walk(plant, parts, std::nullopt, WalkTo::anyStop, WalkDirection::backward), 6U);
  EXPECT_EQ(stopOf(parts, NodeId{5}), 4U);
  EXPECT_EQ(stopOf(parts, NodeId{99}), std::nullopt);
}

TEST(ReviewStops, FindsWhatIsNotReviewed) {
  Skeleton plant = test::walkedTree();
  const auto parts = reviewStops(plant, nullptr);
  for (const std::size_t done : {0, 1, 3, 4, 5})
    markReviewed(plant, parts[done]);
  plant.setReview(NodeId{3}, {.state = ReviewState::doubtful});
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::notReviewed), 2U) << "a doubtful one is not reviewed";
  EXPECT_EQ(walk(plant, parts, 2, WalkTo::notReviewed), 6U);
  EXPECT_EQ(walk(plant, parts, 6, WalkTo::notReviewed), 2U);
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::toDo), 6U) << "a doubtful one was looked at";
  markReviewed(plant, parts[2]);
  EXPECT_EQ(walk(plant, parts, 6, WalkTo::notReviewed), 6U) << "there is only the one it is at";
  markReviewed(plant, parts[6]);
  EXPECT_EQ(walk(plant, parts, 6, WalkTo::notReviewed), std::nullopt);
}

TEST(ReviewStops, FindsOpenEndsAndBranchings) {
  Skeleton plant = test::walkedTree();
  const auto parts = reviewStops(plant, nullptr);
  const auto endsAt = [&](std::optional<std::size_t> from, WalkTo to) {
    return static_cast<unsigned>(parts[*walk(plant, parts, from, to)].nodes.back());
  };
  EXPECT_EQ(endsAt(std::nullopt, WalkTo::openEnd), 3U);
  EXPECT_EQ(endsAt(2, WalkTo::openEnd), 5U);
  EXPECT_EQ(endsAt(6, WalkTo::openEnd), 3U);
  EXPECT_EQ(endsAt(std::nullopt, WalkTo::branching), 1U);
  EXPECT_EQ(endsAt(0, WalkTo::branching), 2U);
  EXPECT_EQ(endsAt(1, WalkTo::branching), 4U);
  markReviewed(plant, parts[2]);
  EXPECT_EQ(endsAt(std::nullopt, WalkTo::openEnd), 5U) << "the tip of the trunk is known";
  for (const ReviewStop& part : parts)
    markReviewed(plant, part);
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::openEnd), std::nullopt);
  EXPECT_EQ(walk(plant, parts, 0, WalkTo::branching), std::nullopt);
}

} // namespace
} // namespace espalier
