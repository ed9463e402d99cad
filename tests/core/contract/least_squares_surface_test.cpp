#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/contract/least_squares_surface.h"
#include "tests/support/clouds.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Points = Eigen::Matrix3Xf;

constexpr std::array<LocalShape, 2> shapes = {LocalShape::plane, LocalShape::sphere};

/// A square sheet of points 1 apart about the origin, scattered across it.
Points sheet(int side, double scatter) {
  Random random(3);
  Points points(3, side * side);
  for (int i = 0; i < side * side; ++i)
    points.col(i) = Eigen::Vector3d(i % side - 0.5 * (side - 1), i / side - 0.5 * (side - 1),
                                    scatter * random.normal())
                        .cast<float>();
  return points;
}

/// Root of the mean square of z, of the points that are `from` and more inside the sheet.
double scatterOf(const Points& points, const Points& scanned, float from) {
  const float most = scanned.maxCoeff() - from;
  double sum = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (scanned.col(i).head<2>().cwiseAbs().maxCoeff() <= most) {
      sum += static_cast<double>(points(2, i)) * static_cast<double>(points(2, i));
      ++count;
    }
  return std::sqrt(sum / count);
}

/// By how much the scatter of a grid falls that is fitted by weighted least squares: z is constant
/// for a plane, and for a sphere it grows with the square of the distance, too.
double expectedFall(LocalShape shape, double radius) {
  double m0 = 0;
  double m1 = 0;
  double m2 = 0;
  const int reach = static_cast<int>(radius);
  const auto overGrid = [&](const auto& each) {
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        if (const double u = (x * x + y * y) / (radius * radius); u < 1)
          each(std::pow(1 - u, 4), u);
  };
  overGrid([&](double weight, double u) {
    m0 += weight;
    m1 += weight * u;
    m2 += weight * u * u;
  });
  double squares = 0;
  overGrid([&](double weight, double u) {
    const double share =
        shape == LocalShape::plane ? weight / m0 : weight * (m2 - m1 * u) / (m0 * m2 - m1 * m1);
    squares += share * share;
  });
  return std::sqrt(squares);
}

// The places of a noise-free fit are known on paper; 4 % is what 1600 points show of a deviation.
TEST(LeastSquaresSurface, TakesAsMuchOfTheScatterOfASheetAsLeastSquaresDo) {
  constexpr double scatter = 0.3;
  const Points scanned = sheet(60, scatter);
  for (const LocalShape shape : shapes) {
    const double fall = expectedFall(shape, 6);
    const Points smooth = smoothedPoints(scanned, shape, {.radius = 6.0});
    EXPECT_NEAR(scatterOf(smooth, scanned, 10) / scatterOf(scanned, scanned, 10), fall, 0.2 * fall)
        << static_cast<int>(shape);
  }
  EXPECT_NEAR(expectedFall(LocalShape::plane, 6), 0.16, 0.01) << "as the header has it";
  EXPECT_NEAR(expectedFall(LocalShape::sphere, 6), 0.27, 0.01);
}

TEST(LeastSquaresSurface, SmoothsMoreWithEachIteration) {
  const Points scanned = sheet(40, 0.3);
  const auto left = [&](int iterations) {
    return scatterOf(
        smoothedPoints(scanned, LocalShape::sphere, {.radius = 6.0, .iterations = iterations}),
        scanned, 10);
  };
  EXPECT_LT(left(2), 0.9 * left(1));
}

// Points move across the sheet: its outermost ones by their scatter times the slope of the fit.
TEST(LeastSquaresSurface, DoesNotEatTheEdgeOfASheet) {
  const Points scanned = sheet(40, 0.3);
  for (const LocalShape shape : shapes) {
    const Points smooth = smoothedPoints(scanned, shape, {.radius = 6.0});
    double moved = 0;
    for (Eigen::Index i = 0; i < scanned.cols(); ++i)
      if (scanned(0, i) == scanned.row(0).maxCoeff()) moved += smooth(0, i) - scanned(0, i);
    EXPECT_NEAR(moved / 40, 0, 0.02) << static_cast<int>(shape) << ", in the mean";
    EXPECT_GT(smooth.row(0).maxCoeff(), scanned.row(0).maxCoeff() - 0.1F);
  }
}

/// Mean distance from the z axis, of the points with |z| up to 10.
double meanRadius(const Points& points) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (std::abs(points(2, i)) <= 10) {
      sum += static_cast<double>(points.col(i).head<2>().norm());
      ++count;
    }
  return sum / count;
}

TEST(LeastSquaresSurface, LosesOfThickWoodWhatItSays) {
  constexpr double wood = 20;
  const Points scanned = test::cylinder({0, 0, -25}, {0, 0, 25}, wood, 1);
  const double planes =
      wood - meanRadius(smoothedPoints(scanned, LocalShape::plane, {.radius = 8.0}));
  EXPECT_NEAR(planes, 8.0 * 8 / (24 * wood), 0.02);
  const double spheres =
      wood - meanRadius(smoothedPoints(scanned, LocalShape::sphere, {.radius = 8.0}));
  EXPECT_NEAR(spheres, 0, 0.02);
}

TEST(LeastSquaresSurface, LeavesASphereAsItIs) {
  Random random(5);
  Points scanned(3, 4000);
  for (Eigen::Index i = 0; i < scanned.cols(); ++i)
    scanned.col(i) = (20 * random.direction()).cast<float>();
  const Points smooth = smoothedPoints(scanned, LocalShape::sphere, {.radius = 8.0});
  EXPECT_LT((smooth - scanned).colwise().norm().maxCoeff(), 1e-3F);
}

TEST(LeastSquaresSurface, LeavesWoodThatIsThinnerThanTheRadius) {
  const Points twig = test::cylinder({0, 0, 0}, {0, 0, 30}, 1, 0.5);
  for (const LocalShape shape : shapes)
    EXPECT_EQ(smoothedPoints(twig, shape, {.radius = 6.0}), twig) << static_cast<int>(shape);
}

// A plant of thick and thin wood: moved, turned, in another unit and on other threads.
TEST(LeastSquaresSurface, FollowsWhereTheScanStands) {
  const Points scanned = test::both(test::cylinder({0, 0, 0}, {0, 0, 30}, 9, 1),
                                    test::cylinder({9, 0, 15}, {30, 0, 20}, 1, 1));
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  for (const LocalShape shape : shapes) {
    const Points smooth = smoothedPoints(scanned, shape, {.radius = 4.0});
    EXPECT_GT((smooth - scanned).norm(), 0.1F) << "it does something";
    const Points turned = smoothedPoints(turn * scanned, shape, {.radius = 4.0});
    EXPECT_LT((turned - turn * smooth).colwise().norm().maxCoeff(), 0.02F);
    const Points inMeters = smoothedPoints(0.001F * scanned, shape, {.radius = 0.004});
    EXPECT_LT((1000 * inMeters - smooth).colwise().norm().maxCoeff(), 0.02F);
    for (const int threads : {1, 3}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(smoothedPoints(scanned, shape, {.radius = 4.0}), smooth) << threads;
    }
  }
}

TEST(LeastSquaresSurface, LeavesWhatIsNoSurface) {
  Points line(3, 30);
  for (Eigen::Index i = 0; i < line.cols(); ++i)
    line.col(i) = Eigen::Vector3f(0, 0, static_cast<float>(i));
  const std::array<Points, 5> scans = {Points(3, 0), Points(Points::Zero(3, 1)),
                                       Points(Points::Ones(3, 40)), line, Points(1e9F * line)};
  for (const Points& scan : scans)
    for (const LocalShape shape : shapes)
      EXPECT_EQ(smoothedPoints(scan, shape, {.radius = 6.0}), scan);
}

TEST(LeastSquaresSurface, StopsWhenAsked) {
  const Points scanned = sheet(20, 0.3);
  for (const LocalShape shape : shapes)
    EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
      (void)smoothedPoints(scanned, shape, {.radius = 6.0}, progress);
    }));
}

} // namespace
} // namespace espalier
