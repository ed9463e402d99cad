#include "core/decide/decide_gaps.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

namespace espalier {
namespace {

constexpr double spacing = 0.1; // of the points that these plants would be made of
const GapOptions reachedGaps{.widest = 1.5, .reach = 8, .backCost = 2};

/// Nodes 1 apart from `from`, by `step`, on `parent`.
std::vector<NodeId> growOn(Skeleton& plant, std::optional<NodeId> parent,
                           const Eigen::Vector3d& from, const Eigen::Vector3d& step, int nodes) {
  std::vector<NodeId> ids;
  for (int i = 0; i < nodes; ++i) {
    parent = plant.add({.position = from + i * step, .radius = 0.05, .parent = parent});
    ids.push_back(*parent);
  }
  return ids;
}

/// Two upright axes; the upper part of the first, beyond a gap, is attached to the second,
/// which is nearer.
struct BesideTheGap {
  Skeleton plant;
  NodeId below;
  NodeId above;

  explicit BesideTheGap(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
    const auto grow = [&](std::optional<NodeId> parent, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& step, int nodes) {
      return growOn(plant, parent, turn * from, turn * step, nodes);
    };
    const auto first = grow(std::nullopt, {0, 0, 0}, {0, 0, 1}, 6);
    const auto second = grow(first[0], {1, 0, 0}, {0, 0, 1}, 1);
    const auto beside = grow(second[0], {2, 0, 0}, {0.1, 0, 1}, 16);
    above = grow(beside[8], {0, 0, 8}, {0, 0, 1}, 6).front();
    below = first.back();
  }
};

DecidedGaps decided(const Skeleton& plant, const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ()) {
  return withDecidedGaps(plant, spacing, up, reachedGaps);
}

TEST(DecideGaps, AttachesWhatGoesOnStraightToTheWoodBelowIt) {
  const BesideTheGap scene;
  const DecidedGaps found = decided(scene.plant);
  EXPECT_EQ(found.skeleton[scene.above].parent, scene.below);
  EXPECT_EQ(found.skeleton.size(), scene.plant.size());
  EXPECT_EQ(found.skeleton.roots().size(), 1U);
}

TEST(DecideGaps, SaysHowProbableEachLinkIs) {
  const BesideTheGap scene;
  const DecidedGaps found = decided(scene.plant);
  ASSERT_EQ(found.decisions.size(), 1U);
  const GapDecision& decision = found.decisions.front();
  EXPECT_EQ(decision.nodes, 6U);
  ASSERT_GE(decision.alternatives.size(), 1U);
  EXPECT_TRUE(
      std::ranges::is_sorted(decision.alternatives, std::greater(), &GapAlternative::probability));
  EXPECT_EQ(decision.alternatives[decision.chosen].from, scene.plant[scene.below].position);
  EXPECT_EQ(decision.alternatives[decision.chosen].to, scene.plant[scene.above].position);
}

TEST(DecideGaps, GivesProbabilitiesThatAddUpToOneForEachFragment) {
  const BesideTheGap scene;
  Skeleton plant = scene.plant;
  growOn(plant, plant.roots().front(), {-6, 0, 2}, {-1, 0, 0.2}, 5); // another fragment
  const Gaps gaps = gapsIn(plant, reachedGaps);
  const auto probabilities = probabilitiesOf(gaps, spacing, Eigen::Vector3d::UnitZ());
  std::vector<double> sums(gaps.entries.size());
  for (std::size_t i = 0; i < gaps.links.size(); ++i) {
    EXPECT_GT(probabilities[i], 0);
    sums[gaps.links[i].borne] += probabilities[i];
  }
  ASSERT_GE(std::ranges::count_if(sums, [](double sum) { return sum > 0; }), 2);
  for (const double sum : sums)
    if (sum > 0) {
      EXPECT_NEAR(sum, 1, 1e-12);
    }
}

/// The links of a fragment to one that bears it, of an axis along x and a branch beyond a gap whose
/// line leads back to the axis at x = 2, though x = 8 is nearer.
std::vector<GapLink> linksOfASlantingBranch(const std::optional<Eigen::Vector3d>& between = {}) {
  Skeleton plant;
  const auto axis = growOn(plant, std::nullopt, {0, 0, 0}, {1, 0, 0}, 12);
  growOn(plant, axis[8], {8, 0, 3}, {2, 0, 1}, 4);
  if (between) growOn(plant, axis[0], *between, {0, 0.3, 0}, 3);
  std::vector<GapLink> links;
  const Gaps gaps = gapsIn(plant, {.widest = 2.5, .reach = 8, .backCost = 2});
  for (const GapLink& link : gaps.links)
    if (link.to == NodeId{12} && indexOf(link.from) < 12) links.push_back(link);
  return links;
}

TEST(GapLinks, OfferTheShortestAndTheStraightest) {
  const std::vector<GapLink> links = linksOfASlantingBranch();
  ASSERT_GE(links.size(), 2U);
  const auto shortest =
      std::ranges::min_element(links, {}, [](const GapLink& link) { return link.evidence.length; });
  EXPECT_EQ(shortest->from, NodeId{8});
  EXPECT_NEAR(shortest->evidence.length, 3, 1e-9);
  EXPECT_NEAR(shortest->evidence.turn, 0, 1e-9);
  EXPECT_NEAR(shortest->evidence.miss, 3 * 2 / std::sqrt(5), 1e-9);
  EXPECT_TRUE(shortest->evidence.isThere);
  const auto straightest =
      std::ranges::min_element(links, {}, [](const GapLink& link) { return link.evidence.miss; });
  EXPECT_LT(indexOf(straightest->from), 6U);
  EXPECT_LT(straightest->evidence.miss, 1.5);
  EXPECT_FALSE(straightest->evidence.isThere);
  for (const GapLink& one : links) // no two from about the same place
    for (const GapLink& other : links)
      if (&one != &other) {
        EXPECT_GT(std::abs(static_cast<double>(indexOf(one.from)) -
                           static_cast<double>(indexOf(other.from))),
                  1);
      }
}

TEST(GapLinks, SayWhereOtherWoodLiesBetween) {
  const auto passed = [](const std::vector<GapLink>& links) {
    double most = 0;
    for (const GapLink& link : links)
      most = std::max(most, link.evidence.passes);
    return most;
  };
  EXPECT_EQ(passed(linksOfASlantingBranch()), 0);
  EXPECT_GT(passed(linksOfASlantingBranch(Eigen::Vector3d(8, -0.3, 1.5))), 0);
}

TEST(DecideGaps, FollowsTheAxisThatIsUp) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto probabilities = [](const Eigen::Matrix3d& turned, const Eigen::Vector3d& up) {
    BesideTheGap scene(turned);
    growOn(scene.plant, scene.plant.roots().front(), turned * Eigen::Vector3d(-3, 0, 6),
           turned * Eigen::Vector3d(0, 0, 1), 5); // may bear it, too
    std::vector<double> all;
    for (const GapDecision& decision : decided(scene.plant, up).decisions)
      for (const GapAlternative& link : decision.alternatives)
        all.push_back(link.probability);
    return all;
  };
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const std::vector<double> upright = probabilities(Eigen::Matrix3d::Identity(), up);
  const std::vector<double> lying = probabilities(turn, turn * up); // z became y
  ASSERT_GE(upright.size(), 4U);
  ASSERT_EQ(lying.size(), upright.size());
  for (std::size_t i = 0; i < upright.size(); ++i)
    EXPECT_NEAR(lying[i], upright[i], 1e-9);
  EXPECT_NE(probabilities(turn, -turn * up), lying);
}

TEST(DecideGaps, AsksNothingOfAPlantWithoutGaps) {
  Skeleton plant;
  growOn(plant, std::nullopt, {0, 0, 0}, {0, 0, 1}, 20);
  const DecidedGaps found = decided(plant);
  EXPECT_EQ(found.skeleton, plant);
  EXPECT_TRUE(found.decisions.empty());
  EXPECT_TRUE(decided({}).decisions.empty());
}

} // namespace
} // namespace espalier
