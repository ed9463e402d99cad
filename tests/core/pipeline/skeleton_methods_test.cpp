// What every method of the step "skeleton" has to stand, each by its default options.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/regrow.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

class SkeletonMethods : public testing::TestWithParam<std::string> {
protected:
  [[nodiscard]] static PipelineOptions options() {
    PipelineOptions result;
    result.methods["skeleton"] = GetParam();
    return result;
  }
  [[nodiscard]] static Skeleton of(const Eigen::Matrix3Xf& points, PipelineOptions with) {
    RawPoints raw;
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      raw.positions.emplace_back(points.col(i).cast<double>());
    return *Pipeline().run(std::make_shared<const PointCloud>(std::move(raw)), with).skeleton;
  }
  [[nodiscard]] static Skeleton of(const Eigen::Matrix3Xf& points) { return of(points, options()); }
};

/// Tips that a method may have beyond those of the plant in a ring, or where a trunk is many
/// spacings thick: cones find one or two where the wood begins, or is cut off; branch structure
/// graphs go both ways around.
std::ptrdiff_t strayTips(const std::string& method) {
  return method == "point_tracking" || method == "branch_structure" ? 2 : 0;
}

double lengthOf(const Skeleton& skeleton) {
  double length = 0;
  for (const NodeId id : skeleton.ids())
    if (skeleton[id].parent)
      length += (skeleton[id].position - skeleton[*skeleton[id].parent].position).norm();
  return length;
}

/// Share of both that lies within `distance` of the other.
double agreement(const Skeleton& a, const Skeleton& b, double distance) {
  return toleranceCurve(a, b, {.distances = {distance}}).scores.front().f();
}

double highest(const Skeleton& skeleton) {
  double height = 0;
  for (const NodeId id : skeleton.ids())
    height = std::max(height, skeleton[id].position.z());
  return height;
}

void expectFinite(const Skeleton& skeleton) {
  EXPECT_FALSE(skeleton.isEmpty());
  for (const NodeId id : skeleton.ids())
    EXPECT_TRUE(skeleton[id].position.allFinite() && skeleton[id].radius >= 0);
}

TEST_P(SkeletonMethods, FindTheForkOfAFork) {
  const Skeleton skeleton = of(test::forkCloud());
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 2);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.12); // 6 point spacings
  EXPECT_GT(highest(skeleton), 2 + 1.5 * std::cos(35 * std::numbers::pi / 180) - 0.12);
}

TEST_P(SkeletonMethods, MakeOneAxisOfAStick) {
  const Skeleton skeleton = of(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02));
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 1);
  EXPECT_NEAR(highest(skeleton), 2, 0.1);
  for (const NodeId id : skeleton.ids())
    EXPECT_LT(skeleton[id].position.head<2>().norm(), 0.04);
}

TEST_P(SkeletonMethods, LeadAcrossAGapOfFiveSpacings) {
  const Skeleton skeleton = of(test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.04, 0.02),
                                          test::cylinder({0, 0, 1.1}, {0, 0, 2}, 0.04, 0.02)));
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 1);
  EXPECT_NEAR(highest(skeleton), 2, 0.1);
}

TEST_P(SkeletonMethods, LeapOnceOverAGapBelowAFork) {
  const Eigen::Matrix3Xf fork = test::forkCloud();
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < fork.cols(); ++i)
    if (std::abs(fork(2, i) - 1.8F) > 0.15F) seen.push_back(i);
  const Skeleton skeleton = of(fork(Eigen::all, seen));
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 2);
  EXPECT_NEAR(lengthOf(skeleton), 5, 0.3) << "several leaps would be longer";
}

TEST_P(SkeletonMethods, LeaveNoStrandsOnWoodTenSpacingsThick) {
  const Skeleton skeleton =
      of(test::both(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.2, 0.02),
                    test::cylinder({0.2, 0, 1.2}, {1.2, 0, 1.8}, 0.03, 0.02)));
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_GE(test::countTips(skeleton), 2);
  EXPECT_LE(test::countTips(skeleton), 2 + strayTips(GetParam()));
}

TEST_P(SkeletonMethods, OpenARingSomewhere) {
  Eigen::Matrix3Xf points(3, 0);
  constexpr int pieces = 24;
  const auto corner = [](int i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    return Eigen::Vector3d(std::sin(angle), 0, 1 - std::cos(angle));
  };
  for (int i = 0; i < pieces; ++i)
    points = test::both(points, test::cylinder(corner(i), corner(i + 1), 0.03, 0.02,
                                               static_cast<std::uint64_t>(i)));
  const Skeleton skeleton = of(points);
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_LE(test::countTips(skeleton),
            2 + strayTips(GetParam())); // both ways from the root, or all around
  for (const NodeId id : skeleton.ids()) {
    const Eigen::Vector3d place = skeleton[id].position - Eigen::Vector3d(0, 0, 1);
    EXPECT_NEAR(place.norm(), 1, 0.1);
  }
  EXPECT_GT(lengthOf(skeleton), 2 * std::numbers::pi - 0.6);
  EXPECT_LT(lengthOf(skeleton), 2 * std::numbers::pi + 0.6);
}

TEST_P(SkeletonMethods, MakeAForestOrAnErrorOfTwoPlants) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.04, 0.02),
                                             test::cylinder({1, 0, 0}, {1, 0, 2}, 0.04, 0.02, 2));
  try {
    const Skeleton skeleton = of(points);
    expectFinite(skeleton);
    EXPECT_LE(test::countTips(skeleton), 4);
    EXPECT_GT(highest(skeleton), 1.8);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("root"), std::string::npos);
  }
}

TEST_P(SkeletonMethods, CopeWithAFlatSheet) {
  Eigen::Matrix3Xf points(3, 51 * 51);
  for (int i = 0; i < points.cols(); ++i)
    points.col(i) = Eigen::Vector3f(static_cast<float>(i % 51) / 50, 0, // a grid: all ties
                                    static_cast<float>(i / 51) / 50);   // NOLINT: rows
  const Skeleton skeleton = of(points);
  expectFinite(skeleton);
  EXPECT_EQ(skeleton.roots().size(), 1U);
}

TEST_P(SkeletonMethods, CopeWithThreePoints) {
  Eigen::Matrix3Xf points(3, 3);
  points << 0, 0, 0, 0, 0, 0, 0, 1, 2;
  PipelineOptions with = options();
  with.methods["clean"] = "none";
  expectFinite(of(points, with));
}

TEST_P(SkeletonMethods, CopeWithFewerPointsThanNeighbors) {
  Eigen::Matrix3Xf points(3, 7);
  for (int i = 0; i < 7; ++i)
    points.col(i) = Eigen::Vector3f(0, 0.1F * static_cast<float>(i % 2), static_cast<float>(i));
  PipelineOptions with = options();
  with.methods["clean"] = "none";
  expectFinite(of(points, with));
}

TEST_P(SkeletonMethods, MakeMuchTheSameOfEveryPointTwice) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Skeleton twice = of(test::both(points, points));
  EXPECT_GE(test::countTips(twice), 2);
  EXPECT_LE(test::countTips(twice), GetParam() == "branch_structure" ? 4 : 2);
  EXPECT_GT(agreement(twice, of(points), 0.08), 0.99);
}

TEST_P(SkeletonMethods, MakeMuchTheSameOfAnotherOrderOfPoints) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_GT(agreement(of(points.rowwise().reverse()), of(points), 0.04), 0.99);
}

TEST_P(SkeletonMethods, FollowTurningAndOtherUnits) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  Eigen::Affine3f change = Eigen::Affine3f::Identity();
  change.translate(Eigen::Vector3f(500, -300, 100))
      .scale(1000)
      .rotate(Eigen::AngleAxisf(0.3F, Eigen::Vector3f(1, 2, 3).normalized()));
  const Skeleton skeleton = of(points);
  const Skeleton moved = of(change * points);
  Skeleton expected = skeleton;
  for (const NodeId id : expected.ids())
    expected.setPosition(id, change.cast<double>() * expected[id].position);
  EXPECT_EQ(test::countTips(moved), test::countTips(skeleton));
  EXPECT_GT(agreement(moved, expected, 40), 0.97); // 2 spacings; the scale takes boxes along axes
}

TEST_P(SkeletonMethods, AreTheSameOnAnyNumberOfThreads) {
  const auto cloud =
      std::make_shared<const PointCloud>(test::simulatedTree().cloud); // grows widely
  const Skeleton onAll = *Pipeline().run(cloud, options(), {}, "skeleton").skeleton;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(*Pipeline().run(cloud, options(), {}, "skeleton").skeleton, onAll) << threads;
  }
}

TEST_P(SkeletonMethods, FindMostOfASimulatedTree) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto cloud = std::make_shared<const PointCloud>(tree.cloud);
  const Reconstruction result = Pipeline().run(cloud, options());
  EXPECT_GT(agreement(*result.skeleton, tree.truth, 4 * result.scale.spacing), 0.85);
  const AuthorsComparison authors = authorsComparison(*result.skeleton, tree.truth);
  EXPECT_GT(authors.geometric, 0.75);
  EXPECT_GT(authors.structural, 0.5);
}

// The lowest node of the heaviest side branch keeps its place; what it carries grows again.
TEST_P(SkeletonMethods, RegrowABranchAndLeaveTheRest) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  NodeId branch = tree.truth.roots().front();
  std::size_t most = 0;
  for (const NodeId id : tree.truth.ids()) {
    const std::size_t count = downstream(tree.truth, {id}).size();
    if (tree.truth[id].parent && tree.truth[id].edge == EdgeType::branching && count > most) {
      most = count;
      branch = id;
    }
  }
  RegrowOptions with;
  with.pipeline = options();
  const Skeleton grown =
      regrown(tree.truth, branch, std::make_shared<const PointCloud>(tree.cloud), with);
  EXPECT_EQ(grown[grown.roots().front()].position, tree.truth[branch].position);
  Skeleton after = tree.truth;
  SkeletonEditor editor(after);
  replaceCarried(editor, branch, grown);
  (void)editor.commit();
  const std::vector<NodeId> carried = downstream(tree.truth, {branch});
  for (const NodeId id : tree.truth.ids())
    if (id == branch || std::ranges::find(carried, id) == carried.end()) {
      ASSERT_TRUE(after.contains(id));
      EXPECT_EQ(after[id], tree.truth[id]);
    }
  EXPECT_GT(agreement(after, tree.truth, 4 * pointSpacing(tree.cloud.positions())), 0.9);
}

TEST_P(SkeletonMethods, StopWhenAsked) {
  PipelineState state{.cloud = std::make_shared<const PointCloud>(test::simulatedTree().cloud)};
  state.isLeftOut.assign(static_cast<std::size_t>(state.cloud->size()), false);
  state.contracted = std::make_shared<const Eigen::Matrix3Xf>(state.cloud->positions());
  const Step& step = stepNamed("skeleton");
  const Method& method = methodNamed(step, GetParam());
  const PlantScale scale{pointSpacing(state.cloud->positions()), 4};
  const std::vector<double> values = resolvedValues(step, method, {}, scale);
  EXPECT_TRUE(
      test::stopsWhenAsked([&](const Progress& progress) { method.run(state, values, progress); }));
  EXPECT_TRUE(state.skeleton->isEmpty());
}

std::vector<std::string> skeletonMethods() {
  std::vector<std::string> result;
  for (const Method& method : stepNamed("skeleton").methods)
    result.push_back(method.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Registered, SkeletonMethods, testing::ValuesIn(skeletonMethods()),
                         [](const auto& each) { return each.param; });

} // namespace
} // namespace espalier
