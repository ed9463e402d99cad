// What must not change a reconstruction: where the plant stands, how it is turned, its unit, the
// order of its points, points that are there twice, and which axis points up.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/evaluate/comparison.h"
#include "core/pipeline/pipeline.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace espalier {
namespace {

using Points = Eigen::Matrix3Xf;

constexpr double herbSpacing = 0.004; // [L], about that of the herb in m

/// Small enough to be reconstructed by every method in a moment.
const Points& herb() {
  static const Points points = [] {
    Points all = test::simulatedHerb().cloud.positions();
    return Points(all / 1000); // in m
  }();
  return points;
}

struct EveryMethodInvariance : testing::TestWithParam<std::pair<std::string, std::string>> {
  PipelineOptions options;

  void SetUp() override { options.methods[GetParam().first] = GetParam().second; }

  Skeleton of(const Points& points) const {
    return *Pipeline().run(test::cloudOf(points, {0, 0, 0}), options).skeleton;
  }
  const Skeleton& plain() {
    if (plain_.isEmpty()) plain_ = of(herb());
    return plain_;
  }
  /// The two agree but for what rounding decides.
  static void expectSame(const Skeleton& result, const Skeleton& truth) {
    const Comparison comparison =
        compare(result, truth, {.registers = false, .tolerance = {.distances = {2 * herbSpacing}}});
    EXPECT_GT(comparison.tolerance.scores[0].f(), 0.97);
    EXPECT_NEAR(comparison.resultTraits.length / comparison.referenceTraits.length, 1, 0.04);
  }

private:
  Skeleton plain_;
};

TEST_P(EveryMethodInvariance, WhereItStandsAndHowItIsTurnedIsNothing) {
  const float angle = 1.1F;
  const Eigen::Matrix3f turn = // which keeps up what is up
      Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  Points moved = turn * herb();
  moved.colwise() += Eigen::Vector3f(0.5F, -0.25F, 0.125F);
  const Skeleton back = test::placed(of(moved), [&](const Eigen::Vector3d& place) {
    return Eigen::Vector3d(turn.transpose().cast<double>() *
                           (place - Eigen::Vector3d(0.5, -0.25, 0.125)));
  });
  expectSame(back, plain());
}

TEST_P(EveryMethodInvariance, TheUnitIsNothing) {
  expectSame(test::scaled(of(1000 * herb()), 0.001), plain());
}

TEST_P(EveryMethodInvariance, TheOrderOfPointsIsNothing) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(herb().cols()));
  std::iota(order.begin(), order.end(), 0);
  Random random(4);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  EXPECT_EQ(of(herb()(Eigen::all, order)), plain());
}

TEST_P(EveryMethodInvariance, WhichAxisPointsUpIsNothing) {
  Points lying(3, herb().cols()); // y is up: x stays, z becomes y, y becomes -z
  lying << herb().row(0), herb().row(2), -herb().row(1);
  options.up = UpAxis::y;
  const Skeleton found = of(lying);
  const Skeleton stood = test::placed(found, [](const Eigen::Vector3d& place) {
    return Eigen::Vector3d(place.x(), -place.z(), place.y());
  });
  options.up = UpAxis::z;
  expectSame(stood, plain());
}

TEST_P(EveryMethodInvariance, TheNumberOfThreadsIsNothing) {
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(of(herb()), plain()) << threads;
  }
}

std::vector<std::pair<std::string, std::string>> methodsOnce() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      if (&method != &step.methods.front() || step.name == "contract")
        all.emplace_back(step.name, method.name); // the defaults are all in the first
  return all;
}

INSTANTIATE_TEST_SUITE_P(Pipeline, EveryMethodInvariance, testing::ValuesIn(methodsOnce()),
                         [](const auto& each) {
                           return each.param.first + "_" + each.param.second;
                         });

} // namespace
} // namespace espalier
