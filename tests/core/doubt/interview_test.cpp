#include "core/base/random.h"
#include "core/doubt/interview.h"
#include "core/doubt/missing_branches.h"
#include "core/evaluate/study/perturbation.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/select.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

namespace espalier {
namespace {

struct Reconstructed {
  std::shared_ptr<const PointCloud> cloud;
  Skeleton plant;
  PlantScale scale;
};

/// With spurs, so that there is something to ask.
const Reconstructed& tree() {
  static const Reconstructed made = [] {
    const auto cloud = std::make_shared<const PointCloud>(test::simulatedTree().cloud);
    const Reconstruction found = Pipeline().run(cloud);
    return Reconstructed{cloud, perturbed(*found.skeleton, Perturbation::spurs, 0.1, 1),
                         found.scale};
  }();
  return made;
}

/// As the tree, but for five branches that the scan has.
const Skeleton& treeThatLacksBranches() {
  static const Skeleton lacking = [] {
    Skeleton plant = tree().plant;
    SkeletonEditor editor(plant);
    int removed = 0;
    for (const NodeId id : tree().plant.ids()) {
      if (!plant.contains(id) || plant[id].edge != EdgeType::branching) continue;
      const std::size_t nodes = downstream(plant, {id}).size();
      if (nodes < 5 || nodes > 20) continue;
      removeSubtree(editor, id);
      if (++removed == 5) break;
    }
    EXPECT_EQ(removed, 5);
    (void)editor.commit();
    return plant;
  }();
  return lacking;
}

Interview interviewed(const Interview::Options& options, const Progress& progress = {},
                      const Skeleton& plant = tree().plant) {
  return {
      tree().cloud, plant,   test::simulatedTree().truth, tree().scale, Eigen::Vector3d::UnitZ(),
      options,      progress};
}

double toleranceOfTree() {
  return 3 * tree().scale.spacing;
}

std::vector<Doubt> doubtsOfTree(const Progress& progress = {}) {
  const SpatialIndex index(tree().cloud->positions());
  const PointDistances distances(tree().cloud, tree().scale.spacing, tree().plant);
  return findDoubts(tree().plant, {.distances = distances, .index = index, .scale = tree().scale},
                    progress);
}

TEST(FindDoubts, ListsChoicesThatAreThereTheGreatestGainFirst) {
  const std::vector<Doubt> doubts = doubtsOfTree();
  ASSERT_GT(doubts.size(), 5U);
  std::set<NodeId> nodes;
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const Doubt& doubt = doubts[i];
    EXPECT_TRUE(isThere(doubt, tree().plant));
    EXPECT_GE(doubt.alternatives.size(), 2U);
    EXPECT_LE(doubt.alternatives.size(), 4U);
    EXPECT_EQ(doubt.alternatives[doubt.present].kind, Alternative::Kind::asItIs);
    double sum = 0;
    for (std::size_t k = 0; k < doubt.alternatives.size(); ++k) {
      sum += doubt.alternatives[k].probability;
      if (k > 0 && k + 1 < doubt.alternatives.size()) {
        EXPECT_GE(doubt.alternatives[k - 1].probability, doubt.alternatives[k].probability);
      }
    }
    EXPECT_LE(sum, 1 + 1e-9);
    EXPECT_GE(doubt.wrong(), 0.05);
    EXPECT_GT(doubt.gain, 0);
    if (i > 0) {
      EXPECT_GE(doubts[i - 1].gain, doubt.gain);
    }
    if (doubt.kind == Doubt::Kind::missing) continue;
    EXPECT_TRUE(nodes.insert(doubt.node).second) << "one doubt for each wood";
  }
}

TEST(FindDoubts, PassesOverWhatWasReviewed) {
  Skeleton plant = tree().plant;
  for (const NodeId id : plant.ids())
    plant.setReview(id, {.state = ReviewState::reviewed, .reviewer = "Ann"});
  const SpatialIndex index(tree().cloud->positions());
  const PointDistances distances(tree().cloud, tree().scale.spacing, plant);
  for (const Doubt& doubt :
       findDoubts(plant, {.distances = distances, .index = index, .scale = tree().scale}))
    EXPECT_EQ(doubt.kind, Doubt::Kind::missing);
}

TEST(FindDoubts, AsksWhatABranchGrowsFromThatIsAttachedToWoodBesideIt) {
  const Skeleton truth = test::simulatedTree().truth;
  const PlantScale scale = scaleOf(*tree().cloud, {}, UpAxis::z);
  const SpatialIndex index(tree().cloud->positions());
  // The upper half of an axis goes to the nearest node of another that does not carry it.
  int asked = 0;
  int first = 0;
  for (const NodeId id : truth.ids()) {
    const auto parent = truth[id].parent;
    if (!parent || truth.children(*parent).size() != 1 || truth.children(id).size() != 1) continue;
    if (static_cast<int>(indexOf(id)) % 5 != 0) continue;
    NodeId onto = *parent;
    double least = 8 * scale.spacing;
    for (const NodeId other : truth.ids()) {
      const double apart = (truth[other].position - truth[id].position).norm();
      if (apart >= least || truth.isAncestor(id, other) || truth.isAncestor(other, id)) continue;
      least = apart;
      onto = other;
    }
    if (onto == *parent) continue;
    Skeleton plant = truth;
    plant.reparent(id, onto, EdgeType::branching);
    const PointDistances distances(tree().cloud, scale.spacing, plant);
    for (const Doubt& doubt :
         findDoubts(plant, {.distances = distances, .index = index, .scale = scale})) {
      if (doubt.node != id) continue;
      ++asked;
      first += doubt.alternatives.front().onto == parent;
    }
    if (asked == 8) break;
  }
  ASSERT_GE(asked, 3);
  EXPECT_GE(first, asked * 2 / 3) << "where it was is the most probable";
}

// Two equal branches without wood leave one long edge of the stem: the evidence of each is that of
// a branch which begins where it was found to.
TEST(MissingBranches, BeginWhereTheyWereFoundThoughTheyLeaveOneEdge) {
  Skeleton stem;
  std::optional<NodeId> last;
  for (const double z : {0.0, 0.2, 0.4, 1.6, 1.8, 2.0})
    last = stem.add({.position = {0, 0, z}, .radius = 0.04, .parent = last});
  const auto branchAt = [](double z, double side) {
    return test::cylinder({side * 0.04, 0, z}, {side * 0.6, 0, z}, 0.02, 0.02);
  };
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02),
                                             test::both(branchAt(0.8, 1), branchAt(1.2, -1)));
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, scale.spacing, stem);
  const std::vector<MissingBranch> missing =
      missingBranches(stem, {.distances = distances, .index = index, .scale = scale});
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].branch.on, missing[1].branch.on);
  EXPECT_LT(missing[0].branch.fraction, missing[1].branch.fraction);
  for (const MissingBranch& one : missing) {
    const std::vector<NodeId> ids = one.branch.part.ids();
    double length = 0;
    for (const NodeId id : ids)
      length += edgeLength(one.branch.part, id);
    EXPECT_NEAR(one.evidence.length * scale.spacing, length, 0.02 * length);
  }
}

/// Branches along points of a sheet with twigs about it, beside a stem.
std::vector<MissingBranch> branchesAlongSheet(std::uint64_t seed) {
  const Skeleton stem = test::stick(3);
  RawPoints raw;
  Random random(seed);
  const double width = random.uniform(0.05, 0.6);
  for (int i = 0; i < 1500; ++i)
    raw.positions.emplace_back(random.uniform(0.1, 1), random.uniform(-width, width) / 2,
                               random.uniform(1, 1.02));
  for (int twig = 0; twig < 4; ++twig) {
    const Eigen::Vector3d foot(random.uniform(0.3, 1), random.uniform(-width, width) / 2, 1);
    const Eigen::Vector3d tip = foot + random.uniform(0.05, 0.4) * random.direction();
    for (int i = 0; i < 60; ++i)
      raw.positions.emplace_back(foot + random.uniform() * (tip - foot) +
                                 0.004 * random.direction());
  }
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, scale.spacing, stem);
  return missingBranches(stem, {.distances = distances, .index = index, .scale = scale});
}

// Many ends along a sheet are taken away again, also such as the axis went on with.
TEST(MissingBranches, GoOnWhereAnEndIsTakenAway) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const MissingBranch& one : branchesAlongSheet(seed)) {
      const Skeleton& part = one.branch.part;
      for (const NodeId id : part.ids()) {
        const auto parent = part[id].parent;
        if (!parent || parent == part.roots().front() || part.children(*parent).size() > 1)
          continue;
        EXPECT_EQ(part[id].edge, EdgeType::successor)
            << indexOf(id) << " of " << part.size() << ", seed " << seed;
      }
    }
}

TEST(FindDoubts, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) { (void)doubtsOfTree(progress); }));
}

TEST(Interview, MakesThePlantMoreRightAndEndsWhenNothingIsInDoubt) {
  Interview interview = interviewed({.tolerance = toleranceOfTree()}, {}, treeThatLacksBranches());
  const auto share = [&] {
    return agreementWith(interview.reference(), interview.plant(), toleranceOfTree()).share();
  };
  const double before = share();
  const std::size_t doubts = interview.doubts().size();
  while (interview.answers() < 200 && interview.askNext())
    ;
  EXPECT_FALSE(interview.askNext());
  EXPECT_GT(share(), before);
  EXPECT_GT(interview.changes(), 0U);
  EXPECT_LT(interview.changes(), interview.answers());
  EXPECT_GE(2 * doubts, interview.answers()) << "answers lead to few further doubts";
}

TEST(Interview, PutsMoreRightWithFewAnswersThanInTheOrderOfTheReview) {
  const auto after = [](AskingOrder order, std::size_t answers) {
    Interview interview =
        interviewed({.tolerance = toleranceOfTree(), .order = order}, {}, treeThatLacksBranches());
    while (interview.answers() < answers && interview.askNext())
      ;
    return agreementWith(interview.reference(), interview.plant(), toleranceOfTree()).share();
  };
  EXPECT_GE(after(AskingOrder::byGain, 12), after(AskingOrder::alongPlant, 12));
}

TEST(Interview, IsTheSameForTheSameSeed) {
  const auto plantAfter = [](std::uint64_t seed) {
    Interview interview =
        interviewed({.tolerance = toleranceOfTree(), .order = AskingOrder::random, .seed = seed});
    for (int i = 0; i < 10; ++i)
      interview.askNext();
    return interview.plant();
  };
  EXPECT_EQ(plantAfter(3), plantAfter(3));
}

TEST(Interview, DecidesTheRestByWhatItLearned) {
  Interview interview = interviewed({.tolerance = toleranceOfTree()});
  for (int i = 0; i < 20; ++i)
    interview.askNext();
  const double before =
      agreementWith(interview.reference(), interview.plant(), toleranceOfTree()).share();
  interview.decideRest();
  EXPECT_GE(agreementWith(interview.reference(), interview.plant(), toleranceOfTree()).share(),
            before - 0.005);
}

// That the branches are missing is surer than that not.
TEST(Interview, CountsWhatItDecidesAmongTheChanges) {
  Interview interview = interviewed({.tolerance = toleranceOfTree()}, {}, treeThatLacksBranches());
  const auto surely =
      static_cast<std::size_t>(std::ranges::count_if(interview.doubts(), [](const Doubt& doubt) {
        return doubt.present != 0 && doubt.alternatives.front().probability >= surelyOtherwise;
      }));
  ASSERT_GT(surely, 0U);
  interview.decideRest();
  EXPECT_GT(interview.plant().size(), treeThatLacksBranches().size());
  EXPECT_GT(interview.changes(), 0U);
  EXPECT_LE(interview.changes(), surely);
  EXPECT_EQ(interview.answers(), 0U);
}

TEST(ExpectedAgreement, IsNearTheRealOneAndOfWhatIsReviewedFull) {
  Interview interview = interviewed({.tolerance = toleranceOfTree()});
  const double real =
      agreementWith(interview.reference(), interview.plant(), toleranceOfTree()).share();
  EXPECT_NEAR(interview.expected().share(), real, 0.08);
  Skeleton plant = tree().plant;
  for (const NodeId id : plant.ids())
    plant.setReview(id, {.state = ReviewState::reviewed, .reviewer = "Ann"});
  const ErrorRatings ratings{
      .ofEdges = std::vector<double>(plant.idEnd(), 0.3), .pieces = {}, .evidence = {}};
  EXPECT_EQ(expectedAgreement(plant, ratings, {}).share(), 1);
  EXPECT_NEAR(expectedAgreement(tree().plant, ratings, {}).share(), 0.7, 1e-9);
}

TEST(AnswersFor, AreThoseThatProbablyMakeEnoughRight) {
  std::vector<Doubt> doubts = doubtsOfTree();
  std::erase_if(doubts, [](const Doubt& doubt) { return doubt.kind == Doubt::Kind::missing; });
  ASSERT_GT(doubts.size(), 3U);
  ErrorRatings ratings{
      .ofEdges = std::vector<double>(tree().plant.idEnd(), 0), .pieces = {}, .evidence = {}};
  EXPECT_EQ(answersFor(1, tree().plant, ratings, doubts), 0U) << "all is right";
  for (const NodeId id : doubts[2].nodes)
    ratings.ofEdges[indexOf(id)] = 0.5;
  EXPECT_EQ(answersFor(1 - 1e-12, tree().plant, ratings, doubts), 3U) << "the third mends it";
  const double now = expectedAgreement(tree().plant, ratings, doubts).share();
  EXPECT_EQ(answersFor(now, tree().plant, ratings, doubts), 0U);
  std::set<NodeId> inDoubt;
  for (const Doubt& doubt : doubts)
    inDoubt.insert(doubt.nodes.begin(), doubt.nodes.end());
  for (const NodeId id : tree().plant.ids())
    if (!inDoubt.contains(id)) ratings.ofEdges[indexOf(id)] = 0.5;
  EXPECT_GT(answersFor(1 - 1e-12, tree().plant, ratings, doubts), doubts.size());
}

} // namespace
} // namespace espalier
