// How many stops a review has, and what is seen at them.
//
//   espalier_review SCAN [STRUCTURE]
//   espalier_review --simulated N
//
// Of a scan with its structure, as it lies and laid on what is found by default, or with that; or
// the mean of N simulated plants that espalier_fit_errors has not seen (simulated_scans.h, from
// number 121 on). A row each for a review in stretches, and for one by risk: stops in all, those of
// clean wood, of risky wood and of points without wood, each one Enter. Of simulated plants also
// how much of what is wrong is in risky stops, and in the first tenth, fifth and half of the stops
// by expected error.
#include "core/decide/error_ratings.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/review_stops.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr std::array parts = {0.1, 0.2, 0.5}; // of the stops

struct Counted {
  double axes = 0;
  double stretches = 0;
  double stops = 0;
  double clean = 0; // of the stops
  double points = 0;
  double cleanLength = 0;                           // share
  double wrong = 0;                                 // share of the length
  double wrongInRisky = 0;                          // share of that
  std::array<double, parts.size()> wrongFirst = {}; // likewise, in these parts of the stops
  double seconds = 0;                               // that it takes to find what is risky
  double walked = 0;                                // likewise, the stops

  void operator+=(const Counted& other) {
    for (double Counted::*member :
         {&Counted::axes, &Counted::stretches, &Counted::stops, &Counted::clean, &Counted::points,
          &Counted::cleanLength, &Counted::wrong, &Counted::wrongInRisky, &Counted::seconds,
          &Counted::walked})
      this->*member += other.*member;
    for (std::size_t i = 0; i < parts.size(); ++i)
      wrongFirst[i] += other.wrongFirst[i];
  }
};

ExpectedErrors errorsOf(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud) {
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, scale.spacing, skeleton);
  return {errorRatings(skeleton, distances, index, scale, Eigen::Vector3d::UnitZ()).ofEdges,
          pointsWithoutWood(skeleton, distances, scale.spacing,
                            {.scatter = scale.scatter / scale.spacing})};
}

/// @param truth  null: not known
Counted counted(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud,
                const Skeleton* truth) {
  Counted result;
  const auto start = std::chrono::steady_clock::now();
  const ExpectedErrors errors = errorsOf(skeleton, cloud);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto known = std::chrono::steady_clock::now();
  const std::vector<ReviewStop> stops = reviewStops(skeleton, &errors);
  result.walked = std::chrono::duration<double>(std::chrono::steady_clock::now() - known).count();
  result.axes = double(axes(skeleton).size());
  result.stretches = double(reviewStops(skeleton, nullptr).size());
  result.stops = double(stops.size());
  double all = 0;
  for (const ReviewStop& stop : stops) {
    result.points += stop.isAtPoints() ? 1 : 0;
    result.clean += stop.isClean ? 1 : 0;
    result.cleanLength += stop.isClean ? stop.length : 0;
    all += stop.length;
  }
  result.cleanLength /= all;
  if (truth == nullptr) return result;
  const double spacing = scaleOf(*cloud, {}, UpAxis::z).spacing;
  const Differences found = differences(skeleton, *truth, 4 * spacing);
  const auto wrongOf = [&](const ReviewStop& stop) {
    double wrong = 0;
    for (const NodeId id : stop.nodes)
      if (found.ofResult[indexOf(id)] != Difference::matched) wrong += edgeLength(skeleton, id);
    return wrong;
  };
  double wrong = 0;
  for (const ReviewStop& stop : stops) {
    wrong += wrongOf(stop);
    if (!stop.isClean) result.wrongInRisky += wrongOf(stop);
  }
  result.wrong = wrong / all;
  if (wrong == 0) return result;
  result.wrongInRisky /= wrong;
  const std::vector<ReviewStop> first = reviewStops(skeleton, &errors, WalkOrder::byExpectedError);
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (double(i) < parts[part] * double(first.size()))
        result.wrongFirst[part] += wrongOf(first[i]) / wrong;
  return result;
}

void print(const Counted& sum, double plants, bool hasTruth) {
  std::printf("axes %.0f, review in stretches: %.0f stops\n", sum.axes / plants,
              sum.stretches / plants);
  std::printf("by risk: %.0f stops (%.3f of that): %.0f clean with %.3f of the length, %.0f risky, "
              "%.0f of points without wood; found in %.2f s, stops in %.1f ms\n",
              sum.stops / plants, sum.stops / sum.stretches, sum.clean / plants,
              sum.cleanLength / plants, (sum.stops - sum.clean - sum.points) / plants,
              sum.points / plants, sum.seconds / plants, 1000 * sum.walked / plants);
  if (!hasTruth) return;
  std::printf("wrong of the length %.3f; of that %.3f in risky stops, %.3f, %.3f and %.3f in the "
              "first 10, 20 and 50 %% of the stops by expected error\n",
              sum.wrong / plants, sum.wrongInRisky / plants, sum.wrongFirst[0] / plants,
              sum.wrongFirst[1] / plants, sum.wrongFirst[2] / plants);
}

void countSimulated(int plants) {
  Counted sum;
  int count = 0;
  for (int i = 0; i < plants; ++i) {
    try {
      const ScannedPlant plant = scannedPlant(121 + static_cast<std::uint64_t>(i));
      sum += counted(*Pipeline().run(plant.cloud, {}).skeleton, plant.cloud, &plant.truth);
      ++count;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%d: %s\n", 121 + i, error.what());
    }
  }
  if (count > 0) print(sum, count, true);
}

void countScan(const std::string& scan, const std::string& structure) {
  const auto cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  Skeleton skeleton;
  if (structure.empty()) {
    skeleton = *Pipeline().run(cloud, {}).skeleton;
  } else {
    skeleton = readStructure(structure).value.skeleton;
    if (const auto shift = shiftOntoCloud(skeleton, *cloud))
      for (const NodeId id : skeleton.ids())
        skeleton.setPosition(id, skeleton[id].position + *shift);
  }
  print(counted(skeleton, cloud, nullptr), 1, false);
  if (structure.empty()) return;
  const Skeleton found = *Pipeline().run(cloud, {}).skeleton;
  std::puts("laid on what is found by default:");
  print(counted(moved(skeleton, registration(skeleton, found).motion), cloud, nullptr), 1, false);
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) try {
  if (argc == 3 && std::string(argv[1]) == "--simulated") {
    espalier::countSimulated(std::atoi(argv[2]));
    return 0;
  }
  if (argc < 2) {
    std::puts("espalier_review SCAN [STRUCTURE] | --simulated N");
    return 2;
  }
  espalier::countScan(argv[1], argc > 2 ? argv[2] : "");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
