// What holds for every contraction, on wood whose axis is known.
#include "core/base/parallel.h"
#include "core/contract/adaptive_geodesic.h"
#include "core/contract/adaptive_sections.h"
#include "core/contract/euclidean_ball.h"
#include "core/contract/geodesic_centroid.h"
#include "core/contract/implicit_laplacian.h"
#include "core/contract/l1_medial.h"
#include "core/contract/one_step_laplacian.h"
#include "core/contract/path_based.h"
#include "core/contract/rotational_symmetry.h"
#include "tests/core/contract/known_plants.h"
#include "tests/support/clouds.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>

namespace espalier {
namespace {

using Contract =
    std::function<Eigen::Matrix3Xf(const Eigen::Matrix3Xf&, double spacing, const Progress&)>;

/// What share of points a contraction brings within one spacing of the axis.
struct Contraction {
  std::string name;
  Contract contract;
  double bent = 0; // of wood 4 spacings thick
  double fork = 0;
  // From 10 to 2 spacings thick: balls of 8 along the surface reach around 22 % of it, those of 6
  // across 33 %; the circles and sections see more.
  double cone = 0;
  double half = 0; // seen from one side
  double turned =
      1e-3; // spacings that the mean point may move when the plant is turned or shuffled
};

void PrintTo(const Contraction& contraction, std::ostream* out) {
  *out << contraction.name;
}

/// The point farthest from the mean: the same one, however the plant is turned and sorted.
Eigen::Index outermost(const Eigen::Matrix3Xf& points) {
  Eigen::Index farthest = 0;
  if (points.cols() > 0)
    (points.colwise() - points.rowwise().mean().eval()).colwise().norm().maxCoeff(&farthest);
  return farthest;
}

std::vector<Contraction> contractions() {
  return {
      {.name = "GeodesicCentroid",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToGeodesicCentroids(
                 points, {.neighbors = 7, .radius = 8 * s, .fitsCircles = false}, progress);
           },
       .bent = 0.98,
       .fork = 0.9,
       .cone = 0.2,
       .half = 0,
       .turned = 0.02},
      {.name = "GeodesicCentroidWithCircles",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToGeodesicCentroids(
                 points, {.neighbors = 7, .radius = 8 * s, .fitsCircles = true}, progress);
           },
       .bent = 0.95,
       .fork = 0.85,
       .cone = 0.5,
       .half = 0.85,
       .turned = 0.05},
      {.name = "AdaptiveGeodesic",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedAdaptively(points,
                                         {.neighbors = 7,
                                          .densityRadius = 3 * s,
                                          .leastRadius = 6 * s,
                                          .mostRadius = 10 * s,
                                          .orientationRadius = 8 * s},
                                         progress);
           },
       .bent = 0.95,
       .fork = 0.85,
       .cone = 0.5,
       .half = 0.85,
       .turned = 0.05},
      {.name = "AdaptiveGeodesicSlices",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedAdaptively(points,
                                         {.neighbors = 7,
                                          .densityRadius = 3 * s,
                                          .leastRadius = 8 * s,
                                          .mostRadius = 8 * s,
                                          .along = 4,
                                          .across = 1,
                                          .orientationRadius = 8 * s,
                                          .fitsCircles = false},
                                         progress);
           },
       .bent = 0.9,
       .fork = 0.8,
       .cone = 0.2,
       .half = 0,
       .turned = 0.05},
      {.name = "AdaptiveSections",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToSections(points,
                                         {.neighbors = 7,
                                          .densityRadius = 3 * s,
                                          .leastRadius = 10 * s,
                                          .mostRadius = 14 * s,
                                          .width = 2 * s,
                                          .orientationRadius = 10 * s},
                                         progress);
           },
       .bent = 0.9,
       .fork = 0.8,
       .cone = 0.8,
       .half = 0.85,
       .turned = 0.05},
      {.name = "EuclideanBall",
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToBallMeans(points, 6 * s, progress);
           },
       .bent = 0.98,
       .fork = 0.85,
       .cone = 0.3,
       .half = 0,
       .turned = 0.02},
      {.name = "OneStepLaplacian",
       .contract =
           [](const auto& points, double /*s*/, const Progress& progress) {
             return contractedByOneLaplacianStep(points, 7, progress);
           },
       .turned = 0.02},
      {.name = "ImplicitLaplacian",
       .contract =
           [](const auto& points, double /*s*/, const Progress& progress) {
             return contractedByImplicitLaplacian(
                 points, {.neighbors = 16, .contraction = 0.2, .growth = 2, .rounds = 2}, progress);
           },
       .bent = 0.95,
       .fork = 0.9,
       .cone = 0.5,
       .half = 0,
       .turned = 0.1},
      {.name = "PathBased",
       .contract =
           [](const auto& points, double /*s*/, const Progress& progress) {
             return contractedAlongPaths(points, outermost(points), {}, progress);
           },
       .turned = 0.1},
      {.name = "L1Medial", // draws other samples from points in another order
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToL1Medial(
                 points, {.sampleShare = 0.2, .firstRadius = 4 * s, .lastRadius = 12 * s},
                 progress);
           },
       .bent = 0.9,
       .fork = 0.9,
       .cone = 0.3,
       .half = 0,
       .turned = 1},
      {.name = "RotationalSymmetry", // thin wood has hardly normals, and none at its rims
       .contract =
           [](const auto& points, double s, const Progress& progress) {
             return contractedToSymmetryAxes(points, {.width = 2 * s, .reach = 8 * s}, progress);
           },
       .bent = 0.95,
       .fork = 0.9,
       .cone = 0.9,
       .half = 0,
       .turned = 0.1},
  };
}

class EveryContraction : public testing::TestWithParam<Contraction> {
protected:
  [[nodiscard]] static Eigen::Matrix3Xf contracted(const Eigen::Matrix3Xf& points,
                                                   double spacing = test::knownSpacing,
                                                   const Progress& progress = {}) {
    return GetParam().contract(points, spacing, progress);
  }
  static void expectOnAxis(const test::KnownPlant& plant, double share) {
    const Eigen::Matrix3Xf places = contracted(plant.points);
    ASSERT_EQ(places.cols(), plant.points.cols());
    const test::OffAxis before = test::offAxis(plant, plant.points);
    const test::OffAxis after = test::offAxis(plant, places);
    EXPECT_LT(after.mean, before.mean); // whatever it is, it contracts
    EXPECT_GE(after.within, share) << "mean " << after.mean << " spacings";
  }
  static double meanShift(const Eigen::Matrix3Xf& a, const Eigen::Matrix3Xf& b) {
    return static_cast<double>((a - b).colwise().norm().mean()) / test::knownSpacing;
  }
};

TEST_P(EveryContraction, BringsABentCylinderToItsAxis) {
  expectOnAxis(test::bentCylinder(), GetParam().bent);
}
TEST_P(EveryContraction, BringsAForkToItsAxes) {
  expectOnAxis(test::knownFork(), GetParam().fork);
}
TEST_P(EveryContraction, BringsANoisyConeToItsAxis) {
  expectOnAxis(test::noisyCone(), GetParam().cone);
}
TEST_P(EveryContraction, BringsACylinderSeenFromOneSideToItsAxis) {
  expectOnAxis(test::halfCylinder(), GetParam().half);
}

TEST_P(EveryContraction, FollowsMovingAndTurning) {
  const Eigen::Matrix3Xf points = test::knownFork().points;
  Eigen::Affine3f change = Eigen::Affine3f::Identity();
  change.rotate(Eigen::AngleAxisf(1, Eigen::Vector3f(1, 2, 3).normalized()));
  change.pretranslate(Eigen::Vector3f(3, -2, 1));
  const Eigen::Matrix3Xf moved = contracted(change * points);
  EXPECT_LT(meanShift(change.inverse() * moved, contracted(points)), GetParam().turned);
}

TEST_P(EveryContraction, KnowsNoUnit) {
  const Eigen::Matrix3Xf points = test::knownFork().points;
  const Eigen::Matrix3Xf inMillimeters = contracted(1000 * points, 1000 * test::knownSpacing);
  EXPECT_LT(meanShift(inMillimeters / 1000, contracted(points)), GetParam().turned);
}

TEST_P(EveryContraction, KnowsNoOrderOfPoints) {
  const test::Shuffled shuffled = test::shuffled(test::knownFork().points, 5);
  const Eigen::Matrix3Xf places = contracted(test::knownFork().points);
  EXPECT_LT(meanShift(contracted(shuffled.points), places(Eigen::all, shuffled.from)),
            GetParam().turned);
}

TEST_P(EveryContraction, BearsEveryPointTwice) {
  const test::KnownPlant plant = test::bentCylinder();
  const test::OffAxis off =
      test::offAxis(plant, contracted(test::both(plant.points, plant.points)));
  EXPECT_LT(off.mean, test::offAxis(plant, plant.points).mean);
}

TEST_P(EveryContraction, IsTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::knownFork().points;
  const Eigen::Matrix3Xf onAll = contracted(points);
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(contracted(points), onAll) << threads;
  }
}

TEST_P(EveryContraction, BearsFewPointsAndManyAtOnePlace) {
  EXPECT_EQ(contracted(Eigen::Matrix3Xf(3, 0)).cols(), 0);
  const Eigen::Matrix3Xf one = Eigen::Matrix3Xf::Ones(3, 1);
  EXPECT_EQ(contracted(one), one);
  Eigen::Matrix3Xf three(3, 3); // fewer than there are to be neighbors
  three << 0, 0.01F, 0, 0, 0, 0.01F, 0, 0, 0;
  const Eigen::Matrix3Xf places = contracted(three);
  ASSERT_EQ(places.cols(), 3);
  EXPECT_TRUE(places.allFinite());
  EXPECT_LT(places.cwiseAbs().maxCoeff(), 0.02F);
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 50);
  EXPECT_LT((contracted(same) - same).cwiseAbs().maxCoeff(), 1e-5F);
}

TEST_P(EveryContraction, KeepsALineOnItself) {
  Eigen::Matrix3Xf line(3, 200);
  for (int i = 0; i < 200; ++i)
    line.col(i) = static_cast<float>(i * test::knownSpacing) * Eigen::Vector3f(2, 1, 2) / 3;
  const Eigen::Matrix3Xf places = contracted(line);
  ASSERT_TRUE(places.allFinite());
  for (Eigen::Index i = 0; i < 200; ++i) {
    const Eigen::Vector3f off = places.col(i).cross(Eigen::Vector3f(2, 1, 2) / 3);
    EXPECT_LT(off.norm(), 1e-4F);
  }
}

TEST_P(EveryContraction, StopsWhenAskedBeforeItStarts) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)contracted(test::knownFork().points, test::knownSpacing, progress);
  }));
}

TEST_P(EveryContraction, ReportsHowFarItIs) {
  double last = 0;
  const Progress progress({}, [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  (void)contracted(test::knownFork().points, test::knownSpacing, progress);
  EXPECT_GT(last, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Contractions, EveryContraction, testing::ValuesIn(contractions()),
                         [](const auto& each) { return each.param.name; });

} // namespace
} // namespace espalier
