// What scanMeasures() finds on simulated scans beside what is true of them, a row each.
//
//   espalier_measures [--first NUMBER] [--count N]
//
// First plants of any kind (simulated_scans.h): noise along beams and measured scatter, in point
// spacings; diameters of the wood about its points, true and measured, at a tenth, half and nine
// tenths of them; the share that shows none; the arc in degrees; gaps. Then plants in leaf
// (organ_scans.h): the true share of foliage, that among all points, and that measured. Seconds
// are of the measures, and in the last rows of finding organs among all points.
#include "core/base/quantile.h"
#include "core/clean/organs.h"
#include "core/pipeline/scan_measures.h"
#include "tests/bench/organ_scans.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace espalier {
namespace {

template <class Work> double secondsOf(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void printWood(std::uint64_t number) {
  const ScannedPlant plant = scannedPlant(number);
  ScanMeasures found;
  const double seconds = secondsOf([&] { found = scanMeasures(*plant.cloud, {}, UpAxis::z); });
  const double spacing = found.spacing;
  const Spread thickness = found.whole.thickness.value_or(Spread());
  const auto truth = [&](double share) {
    return quantile(plant.diameters, share).value_or(0) / spacing;
  };
  std::printf("%-20s %8td %7.0f  %6.2f %6.2f  %5.1f %5.1f %5.1f  %5.1f %5.1f %5.1f  %4.2f %4.0f "
              "%5zu  %4.2f  %5.2f\n",
              plant.name.c_str(), plant.cloud->size(), plant.pointsPerSegment,
              plant.noise / spacing, found.whole.scatter.value_or(0) / spacing, truth(0.1),
              truth(0.5), truth(0.9), thickness.low / spacing, thickness.median / spacing,
              thickness.high / spacing, 1 - found.whole.measured,
              found.whole.arc.value_or(0) * 180 / std::numbers::pi, found.whole.gaps.size(),
              found.whole.foliage.value_or(0), seconds);
  std::fflush(stdout);
}

double foliageShare(const std::vector<Organ>& organs) {
  const auto count = std::ranges::count_if(
      organs, [](Organ organ) { return organ == Organ::blade || organ == Organ::needle; });
  return static_cast<double>(count) / static_cast<double>(organs.size());
}

/// @return how far the measured share is from the true one, and from that among all points
std::pair<double, double> printFoliage(std::uint64_t number) {
  const OrganScan scan = organScan(number);
  ScanMeasures found;
  const double seconds = secondsOf([&] { found = scanMeasures(*scan.cloud, {}, UpAxis::z); });
  const double spacing = pointSpacing(scan.cloud->positions());
  std::vector<Organ> all;
  const double whole =
      secondsOf([&] { all = organsAmong(scan.cloud->positions(), std::nullopt, spacing).ofPoint; });
  const double truth = foliageShare(scan.organs);
  const double measured = found.whole.foliage.value_or(0);
  std::printf("%-20s %8td  %4.2f  %4.2f  %4.2f  %5.2f  %5.2f\n", scan.kind.c_str(),
              scan.cloud->size(), truth, foliageShare(all), measured, seconds, whole);
  std::fflush(stdout);
  return {std::abs(measured - truth), std::abs(measured - foliageShare(all))};
}

void printMeasures(std::uint64_t first, std::uint64_t count) {
  std::printf("%-20s %8s %7s  %6s %6s  %17s  %17s  %4s %4s %5s  %4s  %5s\n", "", "points", "/segm.",
              "noise", "found", "true thickness", "found", "n.t.", "arc", "gaps", "leaf", "s");
  for (std::uint64_t i = 0; i < count; ++i)
    printWood(first + i);
  std::printf("%-20s %8s  %4s  %4s  %4s  %5s  %5s\n", "foliage", "points", "true", "all", "found",
              "s", "all s");
  std::vector<double> off;
  std::vector<double> offAll;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto [fromTruth, fromAll] = printFoliage(first + i);
    off.push_back(fromTruth);
    offAll.push_back(fromAll);
  }
  std::printf("median off: %.3f from the truth, %.3f from all points\n",
              quantile(off, 0.5).value_or(0), quantile(offAll, 0.5).value_or(0));
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  std::uint64_t first = 3001;
  std::uint64_t count = 28;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    (name == "--first" ? first : count) = std::stoull(argv[i + 1]);
  }
  espalier::printMeasures(first, count);
}
