// What the checks find of 60 errors of six kinds, on a simulated plant that no limit was chosen on.
#include "core/pipeline/plant_scale.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "tests/support/planted_errors.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

TEST(PlantedErrors, AreFoundByTheChecksWithAtMostOneFalseFindingEach) {
  const Skeleton plant = growPlant({.segments = 400}, 77);
  const auto cloud = std::make_shared<const PointCloud>(scan(plant, {.points = 60'000}, 77).points);
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const CheckOptions limits{.scatter = scale.scatter / scale.spacing};
  const test::PlantedPlant planted = test::withPlantedErrors(plant, cloud, scale.spacing, 77);
  std::vector<Finding> found = check(planted.skeleton, scale.spacing, limits);
  const PointDistances distances(cloud, scale.spacing, planted.skeleton);
  std::ranges::move(checkAgainstScan(planted.skeleton, distances, index, scale.spacing, limits),
                    std::back_inserter(found));
  std::size_t caught = 0;
  for (const test::PlantedError& error : planted.errors)
    caught += std::ranges::any_of(found, [&](const Finding& each) { return isOf(error, each); });
  const auto isFalse = [&](const Finding& each) {
    return std::ranges::none_of(planted.errors,
                                [&](const test::PlantedError& error) { return isOf(error, each); });
  };
  EXPECT_EQ(planted.errors.size(), 60U);
  EXPECT_GE(double(caught), 0.9 * double(planted.errors.size()));
  EXPECT_LE(std::size_t(std::ranges::count_if(found, isFalse)), caught);
}

} // namespace
} // namespace espalier
