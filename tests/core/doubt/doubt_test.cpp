#include "core/base/error.h"
#include "core/doubt/doubt.h"
#include "core/doubt/expected_agreement.h"
#include "core/doubt/learned_odds.h"
#include "core/skeleton/edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// A stem of four nodes, 0 to 3, with a branch of two, 4 and 5, on node 1.
Skeleton stemWithBranch() {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i < 4; ++i)
    last = plant.add({.position = {0, 0, 1.0 * i}, .radius = 0.1, .parent = last});
  const NodeId low = plant.add({.position = {0.5, 0, 1.5},
                                .radius = 0.05,
                                .parent = NodeId(1),
                                .edge = EdgeType::branching});
  plant.add({.position = {1, 0, 2}, .radius = 0.05, .parent = low});
  return plant;
}

/// About the branch: it stays, goes, or grows from node 2.
Doubt aboutBranch() {
  return {
      .kind = Doubt::Kind::attachment,
      .node = NodeId(4),
      .nodes = {NodeId(4), NodeId(5)},
      .alternatives = {{.kind = Alternative::Kind::asItIs, .probability = 0.5},
                       {.kind = Alternative::Kind::attach, .probability = 0.3, .onto = NodeId(2)},
                       {.kind = Alternative::Kind::remove, .probability = 0.2}},
      .length = 1.4,
      .gain = 0.1};
}

Doubt aboutMissing(const Eigen::Vector3d& tip) {
  GrownBranch branch{.on = NodeId(2), .part = {}};
  const NodeId root = branch.part.add({.position = {0, 0, 2}, .radius = 0.1});
  branch.part.add({.position = tip, .radius = 0.05, .parent = root, .edge = EdgeType::branching});
  return {.kind = Doubt::Kind::missing,
          .node = NodeId(2),
          .alternatives = {{.kind = Alternative::Kind::add, .probability = 0.6, .branch = branch},
                           {.kind = Alternative::Kind::asItIs, .probability = 0.4}},
          .present = 1,
          .length = 1,
          .gain = 0.2};
}

Skeleton settled(const Doubt& doubt, std::size_t alternative) {
  Skeleton plant = stemWithBranch();
  SkeletonEditor editor(plant);
  settle(editor, doubt, doubt.alternatives[alternative], "Ann");
  const SkeletonDelta delta = editor.commit();
  Skeleton back = plant;
  delta.inverse().apply(back);
  EXPECT_EQ(back, stemWithBranch());
  return plant;
}

TEST(Doubt, StaysAsItIsAndIsReviewed) {
  const Skeleton plant = settled(aboutBranch(), 0);
  for (const NodeId id : aboutBranch().nodes) {
    EXPECT_EQ(plant[id].review.state, ReviewState::reviewed);
    EXPECT_EQ(plant[id].review.reviewer, "Ann");
  }
  EXPECT_EQ(plant[NodeId(3)].review.state, ReviewState::toDo);
  EXPECT_EQ(plant[NodeId(4)].parent, NodeId(1));
}

TEST(Doubt, AttachesElsewhereAndIsReviewed) {
  const Skeleton plant = settled(aboutBranch(), 1);
  EXPECT_EQ(plant[NodeId(4)].parent, NodeId(2));
  EXPECT_EQ(plant[NodeId(4)].edge, EdgeType::branching) << "the stem goes on there already";
  EXPECT_EQ(plant[NodeId(5)].review.state, ReviewState::reviewed);
}

TEST(Doubt, RemovesAllThatTheWoodCarries) {
  const Skeleton plant = settled(aboutBranch(), 2);
  EXPECT_FALSE(plant.contains(NodeId(4)));
  EXPECT_FALSE(plant.contains(NodeId(5)));
  EXPECT_EQ(plant.size(), 4U);
}

TEST(Doubt, LetsTheAxisGoOnWhereItsContinuationIsRemoved) {
  Skeleton plant = stemWithBranch();
  SkeletonEditor editor(plant);
  Doubt doubt = aboutBranch();
  doubt.node = NodeId(2);
  doubt.nodes = {NodeId(2), NodeId(3)};
  settle(editor, doubt, doubt.alternatives[2], std::nullopt);
  (void)editor.commit();
  EXPECT_EQ(plant[NodeId(4)].edge, EdgeType::successor);
}

TEST(Doubt, AddsABranchThatIsReviewed) {
  const Skeleton plant = settled(aboutMissing({1, 0, 3}), 0);
  ASSERT_EQ(plant.size(), 7U);
  EXPECT_EQ(plant[NodeId(6)].parent, NodeId(2));
  EXPECT_EQ(plant[NodeId(6)].review.state, ReviewState::reviewed);
}

TEST(Doubt, IsTheSameAboutTheSameWoodOrPlace) {
  EXPECT_TRUE(isSame(aboutBranch(), aboutBranch(), 0));
  Doubt other = aboutBranch();
  other.node = NodeId(5);
  EXPECT_FALSE(isSame(aboutBranch(), other, 1));
  EXPECT_FALSE(isSame(aboutBranch(), aboutMissing({1, 0, 3}), 1));
  EXPECT_TRUE(isSame(aboutMissing({1, 0, 3}), aboutMissing({1, 0.05, 3}), 0.1));
  EXPECT_FALSE(isSame(aboutMissing({1, 0, 3}), aboutMissing({1, 0.5, 3}), 0.1));
}

TEST(Doubt, IsThereWhileAllThatItRefersToIs) {
  Skeleton plant = stemWithBranch();
  EXPECT_TRUE(isThere(aboutBranch(), plant));
  Doubt inItself = aboutBranch();
  inItself.alternatives[1].onto = NodeId(5);
  EXPECT_FALSE(isThere(inItself, plant)) << "nothing grows from what it carries";
  plant.erase(NodeId(5));
  EXPECT_FALSE(isThere(aboutBranch(), plant));
}

TEST(DecideByOdds, MakesWhatIsMoreProbableThanThePresentAndPassesOverWhatIsGone) {
  Skeleton plant = stemWithBranch();
  SkeletonEditor editor(plant);
  Doubt goes = aboutBranch();
  std::swap(goes.alternatives[0], goes.alternatives[2]);
  goes.alternatives[0].probability = 0.6;
  goes.present = 2;
  EXPECT_EQ(decideByOdds(editor, {goes, goes, aboutMissing({1, 0, 3})}, 0.5).size(), 2U);
  EXPECT_EQ(decideByOdds(editor, {aboutMissing({1, 0, 3})}, 0.7).size(), 0U) << "not sure enough";
  (void)editor.commit();
  EXPECT_FALSE(plant.contains(NodeId(4)));
  EXPECT_EQ(plant.size(), 5U);
  for (const NodeId id : plant.ids())
    EXPECT_EQ(plant[id].review.state, ReviewState::toDo);
}

TEST(DecideByOdds, AttachesNothingToWhatGoesAndKeepsOneEndOfAFork) {
  const auto surely = [](Doubt doubt, Alternative::Kind kind) {
    for (Alternative& one : doubt.alternatives)
      if (one.kind == kind) std::swap(one, doubt.alternatives.front());
    doubt.alternatives.front().probability = 0.9;
    doubt.present = 1;
    return doubt;
  };
  Skeleton plant = stemWithBranch();
  SkeletonEditor editor(plant);
  Doubt tip{.kind = Doubt::Kind::end,
            .node = NodeId(2),
            .nodes = {NodeId(2), NodeId(3)},
            .alternatives = {{.kind = Alternative::Kind::remove, .probability = 0.9},
                             {.kind = Alternative::Kind::asItIs, .probability = 0.1}},
            .present = 1};
  const Doubt moves = surely(aboutBranch(), Alternative::Kind::attach); // onto node 2
  EXPECT_EQ(decideByOdds(editor, {moves, tip}).size(), 1U);
  EXPECT_FALSE(plant.contains(NodeId(2)));
  EXPECT_TRUE(plant.contains(NodeId(4)));
  Skeleton fork = stemWithBranch();
  SkeletonEditor other(fork);
  EXPECT_EQ(decideByOdds(other, {surely(aboutBranch(), Alternative::Kind::remove), tip}).size(), 1U)
      << "of the ends at a fork one stays";
  EXPECT_EQ(fork.size(), 4U);
}

TEST(DecideByOdds, AddsBranchesToOneEdgeWhereTheyBelong) {
  Skeleton plant = stemWithBranch();
  SkeletonEditor editor(plant);
  std::vector<Doubt> doubts;
  for (const double fraction : {0.25, 0.75}) {
    doubts.push_back(aboutMissing({1, 0, 3}));
    doubts.back().alternatives.front().probability = 0.9;
    doubts.back().alternatives.front().branch->fraction = fraction;
  }
  EXPECT_EQ(decideByOdds(editor, doubts).size(), 2U);
  (void)editor.commit();
  std::vector<double> heights;
  for (const NodeId id : plant.ids())
    if (indexOf(id) > 5 && plant[id].position.x() == 0) heights.push_back(plant[id].position.z());
  std::ranges::sort(heights);
  EXPECT_EQ(heights, (std::vector<double>{1.25, 1.75}));
}

// The branch goes to node 2; what is missing would leave the edge by which it is attached to 1.
TEST(DecideByOdds, AddsNothingToAnEdgeThatGoesElsewhere) {
  Doubt moves = aboutBranch();
  std::swap(moves.alternatives[0], moves.alternatives[1]);
  moves.alternatives[0].probability = 0.9;
  moves.present = 1;
  Doubt missing = aboutMissing({0.2, 0.5, 1.3});
  missing.node = NodeId(4);
  missing.alternatives[0].probability = 0.9;
  missing.alternatives[0].branch->on = NodeId(4);
  for (const double fraction : {0.5, 1.0}) {
    missing.alternatives[0].branch->fraction = fraction;
    Skeleton plant = stemWithBranch();
    SkeletonEditor editor(plant);
    const bool isAtNode = fraction == 1;
    EXPECT_EQ(decideByOdds(editor, {missing, moves}).size(), isAtNode ? 2U : 1U);
    (void)editor.commit();
    EXPECT_EQ(plant[NodeId(4)].parent, NodeId(2));
    EXPECT_EQ(plant.size(), isAtNode ? 7U : 6U);
  }
  Skeleton stays = stemWithBranch();
  SkeletonEditor editor(stays);
  missing.alternatives[0].branch->fraction = 0.5;
  EXPECT_EQ(decideByOdds(editor, {missing}).size(), 1U);
  EXPECT_EQ(stays.size(), 8U);
}

// A stem and what answers would settle: its upper half; the last edge of that; the branch.
TEST(AnswersFor, CountsWoodOnceAndNoneThatWasReviewed) {
  Skeleton plant = stemWithBranch();
  const auto about = [](std::vector<NodeId> nodes) {
    Doubt doubt = aboutBranch();
    doubt.node = nodes.front();
    doubt.nodes = std::move(nodes);
    return doubt;
  };
  const std::vector<Doubt> doubts = {about({NodeId(2), NodeId(3)}), about({NodeId(3)}),
                                     about({NodeId(4), NodeId(5)})};
  ErrorRatings ratings{
      .ofEdges = std::vector<double>(plant.idEnd(), 0), .pieces = {}, .evidence = {}};
  for (const NodeId id : {NodeId(2), NodeId(3), NodeId(4), NodeId(5)})
    ratings.ofEdges[indexOf(id)] = 0.5;
  const double all = 3 + 2 * std::sqrt(0.5);
  const double afterTwo = 1 - std::sqrt(0.5) / all; // the branch may still be wrong
  EXPECT_EQ(answersFor(afterTwo - 1e-9, plant, ratings, doubts), 1U);
  EXPECT_EQ(answersFor(afterTwo + 1e-9, plant, ratings, doubts), 3U);
  EXPECT_EQ(answersFor(1 - 1e-9, plant, ratings, doubts), 3U);
  // What is reviewed is right already: an answer about it adds nothing.
  plant.setReview(NodeId(3), {.state = ReviewState::reviewed, .reviewer = "Ann"});
  EXPECT_EQ(answersFor(afterTwo - 1e-9, plant, ratings, {doubts[1], doubts[0], doubts[2]}), 2U);
}

TEST(LearnedOdds, AreThoseThatWereFittedUntilSomethingIsAnswered) {
  const std::vector<Doubt> doubts =
      LearnedOdds().adjusted({aboutBranch(), aboutMissing({1, 0, 3})}, 0.05);
  ASSERT_EQ(doubts.size(), 2U);
  EXPECT_EQ(doubts[0].kind, Doubt::Kind::missing) << "the greater gain first";
  EXPECT_NEAR(doubts[0].wrong(), 0.6, 1e-9);
  EXPECT_NEAR(doubts[1].wrong(), 0.5, 1e-9);
  EXPECT_NEAR(doubts[1].gain, 0.1, 1e-9);
}

TEST(LearnedOdds, AreNumbersWherePointsHaveNoSpacing) {
  const Doubt missing = aboutMissing({1, 0, 3});
  LearnedOdds learned;
  for (int i = 0; i < 3; ++i)
    learned.learn(learnedFrom(missing, false, 0));
  const Doubt adjusted = learned.adjusted({missing}, 0).front();
  EXPECT_TRUE(std::isfinite(learned.answers().front().spacings));
  EXPECT_LT(adjusted.wrong(), missing.wrong());
  EXPECT_GT(adjusted.wrong(), 0);
}

TEST(LearnedOdds, FollowTheAnswersOfTheirKindAlone) {
  const Doubt missing = aboutMissing({1, 0, 3});
  LearnedOdds learned;
  double before = 0.6;
  for (int i = 0; i < 5; ++i) {
    learned.learn(learnedFrom(missing, false, 0.05));
    const double now = learned.adjusted({missing}, 0.05).front().wrong();
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_LT(before, 0.3) << "five that are none";
  EXPECT_GT(before, 0.02) << "say no more than five can";
  const Doubt adjusted = learned.adjusted({missing}, 0.05).front();
  EXPECT_EQ(adjusted.present, 0U) << "the most probable first";
  EXPECT_NEAR(adjusted.alternatives[0].probability + adjusted.alternatives[1].probability, 1, 1e-9);
  EXPECT_NEAR(adjusted.gain, 0.2 * before / 0.6, 1e-9);
  EXPECT_NEAR(learned.adjusted({aboutBranch()}, 0.05).front().wrong(), 0.5, 1e-9);
  EXPECT_EQ(LearnedOdds(learned.answers()).adjusted({missing}, 0.05).front().wrong(), before);
}

TEST(LearnedOdds, AreOthersOfShortWoodThanOfLong) {
  LearnedOdds learned;
  for (int i = 0; i < 20; ++i) {
    learned.learn({.kind = Doubt::Kind::missing, .said = 0.5, .spacings = 5, .wasWrong = false});
    learned.learn({.kind = Doubt::Kind::missing, .said = 0.5, .spacings = 80, .wasWrong = true});
  }
  Doubt shortOne = aboutMissing({1, 0, 3});
  Doubt longOne = shortOne;
  shortOne.length = 0.25;
  longOne.length = 4;
  EXPECT_LT(learned.adjusted({shortOne}, 0.05).front().wrong(), 0.4);
  EXPECT_GT(learned.adjusted({longOne}, 0.05).front().wrong(), 0.8);
}

} // namespace
} // namespace espalier
