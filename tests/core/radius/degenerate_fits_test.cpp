// Points that show no wood: at one place, on a line, in two far clusters of equal points.
#include "core/base/circle_fit.h"
#include "core/radius/cylinder_fit.h"
#include "core/radius/fused_radii.h"
#include "core/radius/length_pipe_model.h"
#include "core/radius/node_count_pipe_model.h"
#include "core/radius/section_circle.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <string>

namespace espalier {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points times(int count, const Eigen::Vector3d& place) {
  return Points(static_cast<std::size_t>(count), place);
}

Points joined(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::map<std::string, Points>& degenerate() {
  static const std::map<std::string, Points> all = [] {
    std::map<std::string, Points> sets;
    sets["none"] = {};
    sets["one"] = times(1, {1, 2, 3});
    sets["equal"] = times(20, {1, 2, 3});
    sets["two clusters"] = joined(times(20, {0, 0, 0}), times(20, {1e6, 0, 1}));
    sets["cluster and one"] = joined(times(20, {0, 0, 0}), times(1, {1e-9, 5, 0}));
    for (int i = 0; i < 20; ++i) {
      sets["line across"].emplace_back(0.1 * i, 0, 0);
      sets["line along"].emplace_back(0, 0, 0.1 * i);
    }
    return sets;
  }();
  return all;
}

std::vector<Eigen::Vector2d> across(const Points& points) {
  std::vector<Eigen::Vector2d> result;
  for (const Eigen::Vector3d& point : points)
    result.emplace_back(point.head<2>());
  return result;
}

bool isFinite(const FittedCircle& circle) {
  return circle.center.allFinite() && std::isfinite(circle.radius) && std::isfinite(circle.error);
}

TEST(DegenerateFits, OfCirclesAreNoneOrFinite) {
  for (const auto& [name, points] : degenerate()) {
    SCOPED_TRACE(name);
    if (const auto circle = fitCircle(across(points))) {
      EXPECT_TRUE(isFinite(*circle));
    }
    if (const auto circle = hullCircle(across(points))) {
      EXPECT_TRUE(isFinite(*circle));
    }
    CrossSection section{};
    section.points = across(points);
    for (const RadiusMeasure measure : {RadiusMeasure::mean, RadiusMeasure::maximum,
                                        RadiusMeasure::hull, RadiusMeasure::circle}) {
      const MeasuredCircle circle = measuredCircle(section, measure);
      if (const auto* found = std::get_if<FittedCircle>(&circle)) {
        EXPECT_TRUE(isFinite(*found));
      }
    }
  }
}

TEST(DegenerateFits, OfCylindersAreNoneOrFinite) {
  for (const auto& [name, points] : degenerate())
    for (const double radius : {1e-9, 0.1, 1e6}) {
      SCOPED_TRACE(name);
      FittedCylinder start;
      start.radius = radius;
      const auto cylinder = fitCylinder(points, start);
      if (!cylinder) continue;
      EXPECT_TRUE(cylinder->point.allFinite() && cylinder->direction.allFinite());
      EXPECT_TRUE(std::isfinite(cylinder->radius) && std::isfinite(cylinder->error));
    }
}

/// A stick of nodes at two places, most of them at the first, and one of them alone.
std::vector<Skeleton> degeneratePlants() {
  Skeleton still = test::stick(20, 0);
  Skeleton oneStep = still;
  oneStep.setPosition(NodeId{19}, {0, 0, 1e-300});
  Skeleton longStep = still;
  longStep.setPosition(NodeId{19}, {0, 0, 1e12});
  Skeleton tiny = test::stick(20, 1e-160); // the squares of its edges are 0
  Skeleton wide = test::stick(20, 1e-300);
  wide.setPosition(NodeId{19}, {0, 0, 1e12});
  return {{}, test::stick(1), still, oneStep, longStep, tiny, wide};
}

void expectFinite(const std::vector<double>& radii) {
  for (const double radius : radii)
    EXPECT_TRUE(std::isfinite(radius) && radius >= 0) << radius;
}

TEST(DegenerateFits, OfModelsAreFiniteOnNodesAtOnePlace) {
  for (const Skeleton& plant : degeneratePlants())
    for (const double apex : {0.0, 1e-300, 0.1}) {
      const double root = 16 * apex;
      expectFinite(radiiOf(plant, lengthPipeThrough(plant, root, apex)));
      expectFinite(averagePipeRadii(plant, apex, 2));
      const Skeleton byCount =
          withNodeCountPipeRadii(plant, {.rootRadius = root, .apexRadius = apex});
      for (const NodeId id : byCount.ids())
        expectFinite({byCount[id].radius});
      for (const double deviation : {1e-300, 0.1}) {
        const std::vector<MeasuredRadius> measured(plant.idEnd(),
                                                   {.radius = apex, .deviation = deviation});
        if (const auto model = fittedLengthPipe(plant, measured))
          expectFinite(radiiOf(plant, *model));
      }
    }
}

TEST(DegenerateFits, OfTheFusionAreFiniteWithoutAModel) {
  const Skeleton plant = test::stick(4);
  const std::vector<MeasuredRadius> none(4);
  EXPECT_THAT(fusedRadii(plant, none, {0, 0, 0, 0}).radii, testing::Each(0));
  std::vector<MeasuredRadius> one = none;
  one[1] = {.radius = 0.2, .deviation = 0.1};
  for (const double radius : fusedRadii(plant, one, {0, 0, 0, 0}).radii)
    EXPECT_NEAR(radius, 0.2, 1e-9);
  const std::vector<double> half = fusedRadii(plant, none, {0.3, 0, 0.1, 0}).radii;
  expectFinite(half);
  EXPECT_GT(half[1], 0);
}

} // namespace
} // namespace espalier
