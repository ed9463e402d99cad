#include "core/radius/length_pipe_model.h"
#include "core/skeleton/length_along.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

const double shoot = (test::fork(2)[NodeId{2}].position - Eigen::Vector3d(0, 0, 1)).norm();

std::vector<MeasuredRadius> measuredBy(const Skeleton& plant, const LengthPipeModel& model) {
  std::vector<MeasuredRadius> measured;
  for (const double radius : radiiOf(plant, model))
    measured.push_back({.radius = radius, .deviation = 0.1});
  return measured;
}

TEST(CarriedLengths, AddUpAllThatANodeCarries) {
  EXPECT_THAT(carriedLengths(test::fork(2)),
              ElementsAre(DoubleNear(1 + 2 * shoot, 1e-12), DoubleNear(2 * shoot, 1e-12), 0, 0));
  EXPECT_TRUE(carriedLengths({}).empty());
}

TEST(LengthPipeThrough, GoesThroughTheRadiiAtRootAndTips) {
  const Skeleton plant = test::fork(5);
  const std::vector<double> radii = radiiOf(plant, lengthPipeThrough(plant, 0.8, 0.1));
  EXPECT_NEAR(radii[0], 0.8, 1e-12);
  EXPECT_NEAR(radii[4], 0.1, 1e-12);
  EXPECT_LT(radii[1], radii[0]);
}

TEST(LengthPipeThrough, DoesNotDependOnHowNodesAreSpaced) {
  Skeleton coarse; // a trunk of 4 with a branch of 2 in the middle, nodes 2 or 1 apart
  const NodeId root = coarse.add({});
  const NodeId fork = coarse.add({.position = {0, 0, 2}, .parent = root});
  coarse.add({.position = {0, 0, 4}, .parent = fork});
  coarse.add({.position = {2, 0, 2}, .parent = fork, .edge = EdgeType::branching});
  const LengthPipeModel model{.scale = 0.1, .tipLength = 1, .exponent = 0.5, .spread = 0};
  EXPECT_NEAR(radiiOf(coarse, model)[1], 0.1 * std::sqrt(5.0), 1e-12);
  Skeleton fine = coarse;
  const NodeId between = fine.add({.position = {1, 0, 2}, .parent = fork});
  fine.reparent(NodeId{3}, between, EdgeType::successor);
  EXPECT_NEAR(radiiOf(fine, model)[1], 0.1 * std::sqrt(5.0), 1e-12);
}

TEST(LengthPipeThrough, GivesAPlantWithoutLengthTheApexRadius) {
  const Skeleton one = test::stick(1);
  EXPECT_EQ(radiiOf(one, lengthPipeThrough(one, 2, 1))[0], 1);
}

/// A stick with a twig of three edges on each fifth node, all edges 0.1 long.
Skeleton twigged() {
  Skeleton plant = test::stick(100, 0.1);
  for (std::uint32_t i = 0; i < 100; i += 5) {
    NodeId below{i};
    for (int k = 1; k <= 3; ++k)
      below = plant.add({.position = {0.1 * k, 0, 0.1 * i},
                         .parent = below,
                         .edge = k == 1 ? EdgeType::branching : EdgeType::successor});
  }
  return plant;
}

TEST(FittedLengthPipe, FindsTheLawThatRadiiFollow) {
  const Skeleton plant = twigged();
  const LengthPipeModel law{.scale = 0.03, .tipLength = 0.2, .exponent = 0.4, .spread = 0};
  const auto model = fittedLengthPipe(plant, measuredBy(plant, law));
  ASSERT_TRUE(model);
  EXPECT_NEAR(model->exponent, 0.4, 0.01);
  EXPECT_LT(model->spread, 0.01);
  const std::vector<double> wanted = radiiOf(plant, law);
  const std::vector<double> found = radiiOf(plant, *model);
  for (const NodeId id : plant.ids())
    EXPECT_NEAR(found[indexOf(id)] / wanted[indexOf(id)], 1, 0.02);
}

TEST(FittedLengthPipe, IsNotPulledByWrongRadii) {
  const Skeleton plant = test::stick(200, 0.1);
  const LengthPipeModel law{.scale = 0.03, .tipLength = 0.4, .exponent = 0.5, .spread = 0};
  std::vector<MeasuredRadius> measured = measuredBy(plant, law);
  for (std::size_t i = 0; i < measured.size(); i += 4)
    measured[i].radius *= 5; // a quarter of all
  const auto model = fittedLengthPipe(plant, measured);
  ASSERT_TRUE(model);
  EXPECT_NEAR(radiiOf(plant, *model)[50] / radiiOf(plant, law)[50], 1, 0.05);
}

TEST(FittedLengthPipe, IsNoneForFewMeasurements) {
  const Skeleton plant = test::stick(20);
  EXPECT_FALSE(fittedLengthPipe(plant, std::vector<MeasuredRadius>(20)));
  EXPECT_FALSE(fittedLengthPipe({}, {}));
  const std::vector<MeasuredRadius> known(8, {.radius = 1, .deviation = 0.1});
  EXPECT_FALSE(fittedLengthPipe(test::fork(0), {known[0], known[1]}));
}

// The mean of the radii, weighted by w, is what was asked for; and they go as w^exponent.
TEST(AveragePipeRadii, HaveTheMeanThatIsAskedFor) {
  const Skeleton plant = test::fork(3);
  const std::vector<double> radii = averagePipeRadii(plant, 0.3, 2);
  const std::vector<double> carried = carriedLengths(plant);
  double sum = 0;
  double all = 0;
  std::vector<double> weights;
  for (const NodeId id : plant.ids()) {
    weights.push_back(std::log(1.5 + carried[indexOf(id)] / shoot)); // three of four edges
    sum += weights.back() * radii[indexOf(id)];
    all += weights.back();
  }
  EXPECT_NEAR(sum / all, 0.3, 1e-12);
  EXPECT_NEAR(radii[0] / radii[2], std::pow(weights[0] / weights[2], 2), 1e-9);
}

} // namespace
} // namespace espalier
