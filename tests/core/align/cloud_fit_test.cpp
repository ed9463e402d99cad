#include "core/align/cloud_fit.h"
#include "core/align/pair_fit.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/cloud/joined_clouds.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <string>

namespace espalier {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::HasSubstr;
using Cloud = std::shared_ptr<const PointCloud>;

constexpr double degree = std::numbers::pi / 180;

/// What two stations see of one tree, in its frame.
struct TwoStations {
  Cloud fixed, moved;
  double spacing; // the larger of the two
};

TwoStations twoStations(double angleBetween) {
  const Skeleton tree = growPlant({.segments = 120}, 7);
  ScannerOptions scanner{.points = 40'000};
  for (const double azimuth : {0.3, 0.3 + angleBetween})
    scanner.at.emplace_back(6 * std::cos(azimuth), 6 * std::sin(azimuth), 1.5);
  std::vector<RawPoints> stations = pointsByStation(scan(tree, scanner, 7));
  TwoStations two{.fixed = std::make_shared<const PointCloud>(std::move(stations[0])),
                  .moved = std::make_shared<const PointCloud>(std::move(stations[1])),
                  .spacing = 0};
  two.spacing =
      std::max(pointSpacing(two.fixed->positions()), pointSpacing(two.moved->positions()));
  return two;
}

/// Stations a quarter turn apart. Made once.
const TwoStations& aQuarterApart() {
  static const TwoStations two = twoStations(90 * degree);
  return two;
}

/// A turn about a tilted axis through the middle of the cloud, then a shift.
Isometry3d displacement(const PointCloud& cloud, double angle, double shift) {
  const Vector3d middle = cloud.bounds().center();
  return Eigen::Translation3d(middle + shift * Vector3d(0.6, -0.64, 0.48)) *
         Eigen::AngleAxisd(angle, Vector3d(0.3, -0.2, 0.9).normalized()) *
         Eigen::Translation3d(-middle);
}

Cloud placed(const Cloud& cloud, const Isometry3d& motion) {
  return std::make_shared<const PointCloud>(
      joined({{.cloud = cloud, .motion = motion, .name = {}}}));
}

/// How far the points of a cloud that was displaced lie off in the end, root mean square [L].
double missOf(const PointCloud& displaced, const Isometry3d& found, const Isometry3d& truth) {
  double squares = 0;
  for (Eigen::Index i = 0; i < displaced.size(); ++i) {
    const Vector3d place = displaced.position(i);
    squares += (found * place - truth * place).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(displaced.size()));
}

/// Three targets about the tree that people clicked: 3 cm off, in each coordinate of either scan.
std::vector<TargetPair> roughPairs(const Isometry3d& intoMoved, double off = 0.03) {
  Random random(11);
  const auto rough = [&](const Vector3d& place) {
    return Vector3d(place + off * Vector3d(random.normal(), random.normal(), random.normal()));
  };
  std::vector<TargetPair> pairs;
  for (const Vector3d& place : {Vector3d(1.5, 0, 0.5), Vector3d(-1, 1.2, 1), Vector3d(-0.5, -1, 3)})
    pairs.push_back({.moved = rough(intoMoved * place), .fixed = rough(place)});
  return pairs;
}

std::string refusalOf(const PointCloud& fixed, const PointCloud& moved,
                      const CloudFitOptions& options = {}) {
  try {
    static_cast<void>(fitClouds(fixed, moved, Isometry3d::Identity(), options));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(CloudFit, RegistersTwoStationsFromThreeRoughPairs) {
  const auto& [fixed, moved, spacing] = aQuarterApart();
  const Isometry3d intoMoved = displacement(*moved, 10 * degree, 0.3);
  const Cloud away = placed(moved, intoMoved);
  const PairFit byPairs = fitPairs(roughPairs(intoMoved));
  EXPECT_GT(missOf(*away, byPairs.motion, intoMoved.inverse()), 2 * spacing) << "pairs are rough";
  const CloudFit fit = fitClouds(*fixed, *away, byPairs.motion);
  EXPECT_LT(missOf(*away, fit.motion, intoMoved.inverse()), spacing);
  EXPECT_TRUE(fit.converged);
  EXPECT_GT(fit.overlap, 0.4);
  EXPECT_LT(fit.rms, spacing);
}

TEST(CloudFit, RegistersFromFiveDegreesAlone) {
  const auto& [fixed, moved, spacing] = aQuarterApart();
  const Isometry3d intoMoved = displacement(*moved, 5 * degree, 0);
  const Cloud away = placed(moved, intoMoved);
  const CloudFit fit = fitClouds(*fixed, *away, Isometry3d::Identity());
  EXPECT_LT(missOf(*away, fit.motion, intoMoved.inverse()), spacing);
  EXPECT_TRUE(fit.converged);
}

/// The half of three stems that a station sees that stands far off in this direction.
Cloud halfStems(double azimuth, bool isScannerKnown) {
  const Vector3d side(std::cos(azimuth), std::sin(azimuth), 0);
  RawPoints raw;
  for (const Vector3d& foot : {Vector3d(0, 0, 0), Vector3d(1, 0.2, 0), Vector3d(0.4, 1.1, 0)}) {
    const Eigen::Matrix3Xf stem =
        test::cylinder(foot, foot + Vector3d(0, 0, 2), 0.15, 0.02, azimuth > 0 ? 1 : 2);
    for (Eigen::Index i = 0; i < stem.cols(); ++i) {
      const Vector3d place = stem.col(i).cast<double>();
      if (side.dot(place - foot) > 0) raw.positions.push_back(place);
    }
  }
  if (isScannerKnown) raw.stations = {{.name = "station", .scanner = 50 * side}};
  return std::make_shared<const PointCloud>(std::move(raw));
}

// The two see a sixth of each stem in common, and nearest points of the rest are up to 0.26 apart.
TEST(CloudFit, DoesNotPressAStemFlatThatIsSeenFromTwoSides) {
  for (const bool isScannerKnown : {true, false}) {
    const Cloud one = halfStems(0, isScannerKnown);
    const Cloud other = halfStems(120 * degree, isScannerKnown);
    const CloudFit fit = fitClouds(*one, *other, Isometry3d::Identity());
    EXPECT_LT(missOf(*other, fit.motion, Isometry3d::Identity()), 0.005)
        << "a fourth of a spacing, scanner known: " << isScannerKnown;
  }
}

TEST(CloudFit, StaysWhereItFits) {
  const auto& [fixed, moved, spacing] = aQuarterApart();
  const CloudFit fit = fitClouds(*fixed, *fixed, Isometry3d::Identity());
  EXPECT_LT(missOf(*fixed, fit.motion, Isometry3d::Identity()), 1e-6);
  EXPECT_EQ(fit.overlap, 1);
  EXPECT_LT(fit.rms, 1e-6);
}

TEST(CloudFit, FollowsUnitAndFrames) {
  const auto& [fixed, moved, spacing] = aQuarterApart();
  const Isometry3d intoMoved = displacement(*moved, 4 * degree, 0.05);
  const Cloud away = placed(moved, intoMoved);
  const CloudFit before = fitClouds(*fixed, *away, Isometry3d::Identity());
  const auto inMillimeters = [](const PointCloud& cloud, const Isometry3d& motion) {
    RawPoints raw;
    raw.stations = cloud.stations();
    raw.stations[0].scanner = motion * Vector3d(1000 * *cloud.stations()[0].scanner);
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      raw.positions.emplace_back(motion * Vector3d(1000 * cloud.position(i)));
    return PointCloud(std::move(raw));
  };
  const Isometry3d frame = Eigen::Translation3d(3000, -20'000, 500) *
                           Eigen::AngleAxisd(1, Vector3d(1, 1, 1).normalized()) *
                           Isometry3d::Identity();
  const CloudFit after =
      fitClouds(inMillimeters(*fixed, frame), inMillimeters(*away, Isometry3d::Identity()), frame);
  Isometry3d expected = before.motion;
  expected.translation() *= 1000;
  EXPECT_NEAR(after.overlap, before.overlap, 0.01);
  EXPECT_NEAR(after.rms, 1000 * before.rms, 10 * before.rms);
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(500, 500, 4000)})
    EXPECT_LT((after.motion * place - frame * expected * place).norm(), 1000 * spacing / 3);
}

TEST(CloudFit, IsTheSameOnAnyNumberOfThreads) {
  const auto& [fixed, moved, spacing] = aQuarterApart();
  const auto fitOn = [&](int threads) {
    const ThreadLimit limit(threads);
    return fitClouds(*fixed, *moved, displacement(*moved, 2 * degree, 0.02)).motion.matrix();
  };
  EXPECT_EQ(fitOn(1), fitOn(4));
}

// Half of the fork, so that half of the moved points have no counterpart.
TEST(CloudFit, IsNotPulledByWhatOneCloudLacks) {
  const Cloud whole = test::cloudOf(test::forkCloud(1));
  const Eigen::Matrix3Xf other = test::forkCloud(2);
  std::vector<Eigen::Index> lower;
  for (Eigen::Index i = 0; i < other.cols(); ++i)
    if (other(2, i) < 2.5F && other(0, i) < 0.3F) lower.push_back(i);
  const Cloud part = test::cloudOf(Eigen::Matrix3Xf(other(Eigen::all, lower)));
  const Isometry3d intoMoved = displacement(*whole, 2 * degree, 0.03);
  const Cloud away = placed(whole, intoMoved);
  for (const double overlap : {0.0, 0.6}) {
    const CloudFit fit =
        fitClouds(*part, *away, Isometry3d::Identity(), {.overlap = overlap, .reach = 0});
    EXPECT_LT(missOf(*away, fit.motion, intoMoved.inverse()), 0.02) << overlap;
    EXPECT_LT(fit.overlap, 0.9) << overlap;
  }
}

// One point that is a kilometer off changes neither what counts as near nor the result.
TEST(CloudFit, IsNotMisledByAFarPoint) {
  const auto fitted = [](bool hasFarPoint) {
    RawPoints raw;
    const Eigen::Matrix3Xf fork = test::forkCloud(1);
    for (Eigen::Index i = 0; i < fork.cols(); ++i)
      raw.positions.emplace_back(fork.col(i).cast<double>());
    if (hasFarPoint) raw.positions.emplace_back(1000, 0, 0);
    const Cloud moved = test::cloudAtOrigin(test::forkCloud(2));
    const Cloud away = placed(moved, displacement(*moved, 3 * degree, 0.05));
    return fitClouds(PointCloud(std::move(raw)), *away, Isometry3d::Identity()).motion;
  };
  EXPECT_LT((fitted(true) * Vector3d(0, 0, 2) - fitted(false) * Vector3d(0, 0, 2)).norm(), 1e-3);
}

// 60 points: the coarse scales have a handful of cubes, and say nothing.
TEST(CloudFit, RegistersSmallClouds) {
  const Eigen::Matrix3Xf fork = test::forkCloud();
  std::vector<Eigen::Index> few;
  for (Eigen::Index i = 0; i < 60; ++i)
    few.push_back(i * fork.cols() / 60);
  const Cloud small = test::cloudAtOrigin(Eigen::Matrix3Xf(fork(Eigen::all, few)));
  const Isometry3d intoMoved = displacement(*small, 2 * degree, 0.01);
  const Cloud away = placed(small, intoMoved);
  const CloudFit fit = fitClouds(*small, *away, Isometry3d::Identity());
  EXPECT_LT(missOf(*away, fit.motion, intoMoved.inverse()), 1e-3);
}

TEST(CloudFit, RefusesScansThatDoNotOverlap) {
  const Cloud fork = test::cloudOf(test::forkCloud());
  const Cloud far = test::cloudOf(test::forkCloud(2), {600, 600, 700});
  EXPECT_THAT(refusalOf(*fork, *far), HasSubstr("do not overlap"));
  EXPECT_THAT(refusalOf(*fork, PointCloud()), HasSubstr("under 20 points"));
  const Cloud same = test::cloudOf(Eigen::Matrix3Xf(Eigen::Matrix3Xf::Ones(3, 100)));
  EXPECT_THAT(refusalOf(*same, *same), HasSubstr("at one place"));
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusalOf(*fork, *fork, {.overlap = 2, .reach = 0}), HasSubstr("overlap of 0 to 1"));
  EXPECT_THAT(refusalOf(*fork, *fork, {.overlap = 0, .reach = none}), HasSubstr("reach of 0"));
}

TEST(CloudFit, LeavesOpenWhatThePointsLeaveOpen) {
  const Cloud wall = test::cloudOf(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02));
  const CloudFit fit = fitClouds(*wall, *wall, Isometry3d::Identity());
  EXPECT_LT(missOf(*wall, fit.motion, Isometry3d::Identity()), 1e-3)
      << "a pole may turn, and does not";
}

TEST(CloudFit, StopsWhenAsked) {
  const Cloud fork = test::cloudOf(test::forkCloud());
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(fitClouds(*fork, *fork, Isometry3d::Identity(), {}, progress));
  }));
}

} // namespace
} // namespace espalier
