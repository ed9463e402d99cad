#include "core/base/error.h"
#include "core/base/random.h"
#include "core/evaluate/differences/accept_reference.h"
#include "core/evaluate/match/edit_comparison.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/evaluate/differences/differing_plants.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/canonical.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

constexpr double closeBy = 0.1;

/// The result once its first part is as in the reference.
Skeleton accepted(const Skeleton& result, const Skeleton& reference) {
  const Differences found = differences(result, reference, closeBy);
  EXPECT_FALSE(found.parts.empty());
  return test::edited(result, [&](SkeletonEditor& editor) {
    acceptReference(editor, found, reference, found.parts.front());
  });
}

TEST(AcceptReference, CopiesAMissedBranchOntoItsNode) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  EXPECT_EQ(test::canonical(accepted(result, plant)), test::canonical(plant));
}

TEST(AcceptReference, CopiesAllThatAStateOfThePlantItselfSaysOfItsNodes) {
  auto [plant, trunk, branch] = test::trunkAndBranch();
  const RadiusOrigin origin{.source = RadiusSource::byHand};
  plant.setReview(branch[1],
                  {.state = ReviewState::reviewed, .comment = "a dead twig", .reviewer = "Anna"});
  plant.setRadius(branch[2], 0.05, origin);
  plant.setMarked(branch[2], true);
  plant.setEntities(branch[1],
                    {{.scale = 3, .symbol = "N", .index = {}, .values = {{"bark", "red"}}}});
  const Skeleton result = test::edited(
      plant, [first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  const Differences found = differences(result, plant, closeBy);
  const auto copies = [&](Copied copied) {
    std::vector<NodeId> added;
    const Skeleton made = test::edited(result, [&](SkeletonEditor& editor) {
      added = acceptReference(editor, found, plant, found.parts.front(), copied);
    });
    return std::pair(made[added.at(1)], made[added.at(2)]);
  };
  const auto [second, third] = copies(Copied::all);
  EXPECT_EQ(second.entities, plant[branch[1]].entities);
  EXPECT_EQ(second.review, (ReviewMark{.comment = "a dead twig"})) << "it is to be looked at again";
  EXPECT_EQ(third.origin, origin);
  EXPECT_TRUE(third.isMarked);
  const auto [wood, more] = copies(Copied::wood);
  EXPECT_TRUE(wood.entities.empty());
  EXPECT_EQ(wood.review, ReviewMark());
  EXPECT_FALSE(more.isMarked);
}

TEST(AcceptReference, PutsANodeWhereABranchLeavesAnEdge) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result;
  const NodeId root = result.add({.radius = 0.3});
  result.add({.position = {0, 0, 10}, .radius = 0.3, .parent = root});
  const Skeleton made = accepted(result, plant);
  EXPECT_EQ(made.size(), 7U) << "root, top, a node between them, and the branch";
  EXPECT_TRUE(differences(made, plant, closeBy).parts.empty());
  EXPECT_TRUE(check(made).empty());
}

TEST(AcceptReference, AttachesWhatGoesOnAboveAGapToTheCopy) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  // From 2 to 4 high nothing; what is above is a tree of its own.
  Skeleton result = plant;
  result.makeRoot(trunk[5]);
  result.erase(trunk[4]);
  result.erase(trunk[3]);
  const Differences found = differences(result, plant, closeBy);
  const auto gap = std::ranges::find(found.parts, Difference::missed, &DifferingPart::kind);
  ASSERT_NE(gap, found.parts.end());
  const Skeleton made = test::edited(
      result, [&, gap](SkeletonEditor& editor) { acceptReference(editor, found, plant, *gap); });
  EXPECT_EQ(test::canonical(made), test::canonical(plant));
}

TEST(AcceptReference, TakesThePathOfTheReferenceInsteadOfAnother) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant;
  result.setPosition(trunk[2], {1, 0, 2});
  result.setPosition(trunk[3], {1, 0, 3});
  const Differences found = differences(result, plant, closeBy);
  const auto gap = std::ranges::find(found.parts, Difference::missed, &DifferingPart::kind);
  ASSERT_NE(gap, found.parts.end());
  const Skeleton made = test::edited(
      result, [&, gap](SkeletonEditor& editor) { acceptReference(editor, found, plant, *gap); });
  EXPECT_EQ(test::canonical(made), test::canonical(plant)) << "the detour is gone";
}

TEST(AcceptReference, KeepsTheEndOfAnInventedEdgeThatIsOfTheReference) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton result = test::edited(plant, [&, &nodes = trunk](SkeletonEditor& editor) {
    for (const std::size_t i : {7, 6, 4}) // the reference goes on by another path
      removeNode(editor, nodes[i]);
    editor.setPosition(nodes[5], {3, 3, 6});
  });
  const Differences found = differences(result, plant, closeBy);
  const auto detour = std::ranges::find(found.parts, Difference::invented, &DifferingPart::kind);
  ASSERT_NE(detour, found.parts.end());
  const Skeleton made = test::edited(result, [&, detour](SkeletonEditor& editor) {
    acceptReference(editor, found, plant, *detour);
  });
  EXPECT_FALSE(made.contains(trunk[5]));
  EXPECT_TRUE(made.contains(trunk[8])) << "it is where the reference is";
}

TEST(AcceptReference, RemovesWhatIsInvented) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  const Skeleton reference = test::edited(
      plant, [&, first = branch[0]](SkeletonEditor& editor) { removeSubtree(editor, first); });
  EXPECT_EQ(test::canonical(accepted(plant, reference)), test::canonical(reference));
}

TEST(AcceptReference, AttachesABranchWhereTheReferenceDoes) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant;
  const NodeId between =
      result.add({.position = {2, 2, 7}, .parent = trunk[8], .edge = EdgeType::branching});
  result.reparent(branch[0], between, EdgeType::successor);
  EXPECT_EQ(test::canonical(accepted(result, plant)), test::canonical(plant))
      << "what led there is gone";
}

TEST(AcceptReference, ExchangesArmsBackOneByOne) {
  const auto [plant, x, y] = test::crossingArms();
  const Skeleton result = test::edited(
      plant, [&, a = x[3], b = y[3]](SkeletonEditor& editor) { exchangeArms(editor, a, b); });
  const Skeleton once = accepted(result, plant);
  EXPECT_NE(test::canonical(once), test::canonical(plant));
  EXPECT_EQ(test::canonical(accepted(once, plant)), test::canonical(plant));
}

TEST(AcceptReference, IsTakenBackExactlyAndRefusedOnceThePartIsGone) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = test::edited(plant, [&, first = branch[0], top = trunk[8]](SkeletonEditor& e) {
    reparentNode(e, first, top);
  });
  const Differences found = differences(result, plant, closeBy);
  const Skeleton before = result;
  SkeletonEditor editor(result);
  const auto chosen = acceptReference(editor, found, plant, found.parts[0]);
  EXPECT_THAT(chosen, testing::ElementsAre(branch[0]));
  const SkeletonDelta delta = editor.commit();
  delta.inverse().apply(result);
  EXPECT_EQ(result, before);

  SkeletonEditor other(result);
  removeSubtree(other, branch[0]);
  const Skeleton removed = result;
  EXPECT_THROW(acceptReference(other, found, plant, found.parts[0]), Error);
  EXPECT_EQ(result, removed);
}

/// A bush with twigs removed, attached elsewhere, and shoots that are not there.
Skeleton damaged(const Skeleton& bush, std::uint64_t seed) {
  Random random(seed);
  return test::edited(bush, [&](SkeletonEditor& editor) {
    for (int i = 0; i < 12; ++i) {
      const std::vector<NodeId> ids = editor.skeleton().ids();
      const NodeId id = ids[1 + random.below(ids.size() - 1)];
      const NodeId other = ids[random.below(ids.size())];
      const bool isLoop = editor.skeleton().isAncestor(id, other);
      if (i % 3 == 0 && editor.skeleton().children(id).size() < 2)
        removeSubtree(editor, id);
      else if (i % 3 == 1 && !isLoop && id != other)
        reparentNode(editor, id, other);
      else
        addChild(editor, id, editor.skeleton()[id].position + Eigen::Vector3d(0.7, 0.6, 0.5));
    }
  });
}

/// The first part of a kind, once a result is as the reference there.
Skeleton acceptedFirst(Difference kind, const Skeleton& result, const Skeleton& reference) {
  const Differences found = differences(result, reference, closeBy);
  const auto part = std::ranges::find(found.parts, kind, &DifferingPart::kind);
  if (part == found.parts.end()) throw Error("no such part");
  return test::edited(
      result, [&](SkeletonEditor& editor) { acceptReference(editor, found, reference, *part); });
}

TEST(AcceptReference, MakesAMissedFootTheRootOfThePlant) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant;
  result.makeRoot(trunk[4]);
  for (const std::size_t i : {3, 2, 1, 0})
    result.erase(trunk[i]);
  EXPECT_EQ(test::canonical(acceptedFirst(Difference::missed, result, plant)),
            test::canonical(plant));
  // What stood there instead of the foot, and carries a shoot of its own, stays with the tree.
  const NodeId aside = result.add({.position = {0, 3, 3}});
  result.reparent(trunk[4], aside, EdgeType::successor);
  result.add({.position = {0, 5, 4}, .parent = aside, .edge = EdgeType::branching});
  const Skeleton made = acceptedFirst(Difference::missed, result, plant);
  ASSERT_EQ(made.roots().size(), 1U);
  EXPECT_EQ(made[made.roots()[0]].position, plant[trunk[0]].position);
}

TEST(AcceptReference, AttachesWhatAnInventedTrunkCarriesAsTheReference) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant; // the trunk is off below, and the branch is attached to it by itself
  for (const std::size_t i : {0, 1, 2, 3})
    result.setPosition(trunk[i], {2, 0, double(i)});
  result.reparent(branch[0], trunk[3], EdgeType::branching);
  const Skeleton made = acceptedFirst(Difference::invented, result, plant);
  EXPECT_EQ(made.roots().size(), 1U);
  EXPECT_EQ(made[branch[0]].parent, trunk[5]);
  for (const std::size_t i : {0, 1, 2, 3})
    EXPECT_FALSE(made.contains(trunk[i]));
}

TEST(AcceptReference, AttachesWhatAnInventedPathCarriesAlongTheMissedOne) {
  const auto [plant, trunk, branch] = test::trunkAndBranch();
  Skeleton result = plant;
  for (const std::size_t i : {2, 3})
    result.setPosition(trunk[i], {1, 0, double(i)});
  const Skeleton made = acceptedFirst(Difference::invented, result, plant);
  EXPECT_EQ(test::canonical(made), test::canonical(plant)) << "no leap over the gap";
}

// Of any part, whatever else differs: one tree, exact undo, and hardly ever more that differs. A
// branch that is attached elsewhere can lose what was matched by chance: one more part, at most.
TEST(AcceptReference, NeverMakesAPlantFallApartOrMuchWorse) {
  const Skeleton bush = test::bush();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Skeleton plant = damaged(bush, seed);
    const Differences found = differences(plant, bush, closeBy);
    for (const DifferingPart& part : found.parts) {
      Skeleton made = plant;
      SkeletonEditor editor(made);
      try {
        acceptReference(editor, found, bush, part);
      } catch (const Error&) {
        continue;
      }
      const SkeletonDelta delta = editor.commit();
      EXPECT_LE(made.roots().size(), plant.roots().size());
      EXPECT_LE(differences(made, bush, closeBy).parts.size(), found.parts.size() + 1);
      delta.inverse().apply(made);
      EXPECT_EQ(made, plant);
    }
  }
}

TEST(AcceptReference, KeepsThePineOneTreeWhereItsFootWasMissed) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton result = readStructure(automatic).value.skeleton;
  Skeleton reference = readStructure(expert).value.skeleton;
  reference = moved(reference, registration(result, reference).motion.inverse());
  Skeleton footless = result; // up to its first branch
  for (NodeId root = footless.roots()[0]; footless.children(root).size() == 1;) {
    const NodeId next = footless.children(root)[0];
    footless.makeRoot(next);
    footless.erase(root);
    root = next;
  }
  const Differences found = differences(footless, reference, 10); // [mm]
  const auto foot = std::ranges::find_if(found.parts, [&](const DifferingPart& part) {
    return part.kind == Difference::missed && !reference[part.nodes.front()].parent;
  });
  ASSERT_NE(foot, found.parts.end());
  const Skeleton made = test::edited(
      footless, [&](SkeletonEditor& editor) { acceptReference(editor, found, reference, *foot); });
  EXPECT_EQ(made.roots().size(), 1U);
  EXPECT_LE(editComparison(made, reference).distance.distance,
            editComparison(footless, reference).distance.distance);
}

TEST(AcceptReference, MakesAnyDamagedPlantTheReferenceStepByStep) {
  const Skeleton bush = test::bush();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Skeleton plant = damaged(bush, seed);
    int steps = 0;
    for (; steps < 60; ++steps) {
      const Differences found = differences(plant, bush, closeBy);
      if (found.parts.empty()) break;
      SkeletonDelta delta;
      for (const DifferingPart& part : found.parts) // the first that can be accepted
        try {
          SkeletonEditor editor(plant);
          acceptReference(editor, found, bush, part);
          delta = editor.commit();
          break;
        } catch (const Error&) {
          continue;
        }
      ASSERT_FALSE(delta.isEmpty()) << "an accepted part changes something, seed " << seed;
    }
    EXPECT_LT(steps, 60) << "seed " << seed;
    EXPECT_EQ(plant.roots().size(), 1U) << "seed " << seed;
  }
}

} // namespace
} // namespace espalier
