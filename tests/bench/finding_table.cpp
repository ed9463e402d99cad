// How many errors the checks find, and how much they report beside them: 60 errors of six kinds
// (tests/support/planted_errors.h) are put into a structure that was right.
//
//   espalier_findings SCAN STRUCTURE [SEEDS]      seeds 1 to SEEDS, one by default
//   espalier_findings --simulated FIRST COUNT     bare ones of scannedPlant(FIRST) and on
//
// An error is caught if there is a finding at it that was not there before. Of the findings of the
// structure with the errors, the others are false: those that were there before ("before"), and
// those that only came with the errors ("new"). For each kind of finding, how many are true is
// printed, too.
#include "core/io/formats.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "tests/bench/simulated_scans.h"
#include "tests/support/planted_errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

using test::PlantedError;
using test::plantedKinds;

struct Scanned {
  Skeleton skeleton;
  std::shared_ptr<const PointCloud> cloud;
};

struct Tally {
  std::array<int, plantedKinds> planted = {};
  std::array<int, plantedKinds> caught = {};
  std::array<int, findingKinds> trueOnes = {};
  std::array<int, findingKinds> before = {};
  std::array<int, findingKinds> news = {};

  Tally& operator+=(const Tally& other) {
    const auto add = [](auto& to, const auto& from) {
      for (std::size_t i = 0; i < to.size(); ++i)
        to[i] += from[i];
    };
    add(planted, other.planted);
    add(caught, other.caught);
    add(trueOnes, other.trueOnes);
    add(before, other.before);
    add(news, other.news);
    return *this;
  }
};

int sum(const auto& counts) {
  int total = 0;
  for (const int count : counts)
    total += count;
  return total;
}

std::vector<Finding> findingsOf(const Skeleton& skeleton,
                                const std::shared_ptr<const PointCloud>& cloud, double spacing,
                                const SpatialIndex& index) {
  std::vector<Finding> all = check(skeleton, spacing);
  const PointDistances distances(cloud, spacing, skeleton);
  for (Finding& finding : checkAgainstScan(skeleton, distances, index, spacing))
    all.push_back(std::move(finding));
  return all;
}

Tally judged(const Scanned& plant, std::uint64_t seed, bool isListed) {
  const double spacing = pointSpacing(plant.cloud->positions());
  const SpatialIndex index(plant.cloud->positions());
  const std::vector<Finding> before = findingsOf(plant.skeleton, plant.cloud, spacing, index);
  const test::PlantedPlant planted =
      test::withPlantedErrors(plant.skeleton, plant.cloud, spacing, seed);
  Tally tally;
  std::vector<char> isCaught(planted.errors.size(), 0);
  for (const Finding& finding : findingsOf(planted.skeleton, plant.cloud, spacing, index)) {
    const auto kind = static_cast<std::size_t>(finding.kind);
    const bool wasThere =
        std::ranges::any_of(before, [&](const Finding& other) { return isSame(other, finding); });
    bool isTrue = false;
    for (std::size_t i = 0; i < planted.errors.size(); ++i)
      if (!wasThere && isOf(planted.errors[i], finding)) {
        isTrue = true;
        isCaught[i] = 1;
      }
    ++(isTrue ? tally.trueOnes : wasThere ? tally.before : tally.news)[kind];
    if (isListed && !isTrue)
      std::printf("    %s %s\n", wasThere ? "before" : "new   ",
                  describe(finding, planted.skeleton).c_str());
  }
  for (std::size_t i = 0; i < planted.errors.size(); ++i) {
    const auto kind = static_cast<std::size_t>(planted.errors[i].kind);
    ++tally.planted[kind];
    tally.caught[kind] += isCaught[i];
    if (isListed && isCaught[i] == 0)
      std::printf("    missed %s at %s, %zu points\n", nameOf(planted.errors[i].kind),
                  planted.errors[i].nodes.empty() ? "-"
                                                  : nameOf(planted.errors[i].nodes[0]).c_str(),
                  planted.errors[i].points.size());
  }
  return tally;
}

void printLine(const std::string& name, const Tally& tally) {
  std::printf("%-16s", name.c_str());
  for (std::size_t i = 0; i < tally.planted.size(); ++i)
    std::printf(" %4d/%-4d", tally.caught[i], tally.planted[i]);
  const int caught = sum(tally.caught);
  const int all = sum(tally.planted);
  const int falseOnes = sum(tally.before) + sum(tally.news);
  std::printf(" | %5.1f %% | before %4d new %4d, %.2f false per caught\n",
              all > 0 ? 100.0 * caught / all : 0, sum(tally.before), sum(tally.news),
              caught > 0 ? double(falseOnes) / caught : 0);
}

void printKinds(const Tally& tally) {
  std::printf("\n%-22s %6s %8s %6s\n", "kind of finding", "true", "before", "new");
  for (int kind = 0; kind < findingKinds; ++kind) {
    const auto i = static_cast<std::size_t>(kind);
    std::printf("%-22s %6d %8d %6d\n", nameOf(static_cast<Finding::Kind>(kind)).c_str(),
                tally.trueOnes[i], tally.before[i], tally.news[i]);
  }
}

void printHead() {
  std::printf("%-16s", "");
  for (int kind = 0; kind < plantedKinds; ++kind)
    std::printf(" %-9.9s", nameOf(static_cast<PlantedError::Kind>(kind)));
  std::printf("\n");
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) {
    std::puts("espalier_findings SCAN STRUCTURE [SEEDS]\n"
              "espalier_findings --simulated FIRST COUNT");
    return 2;
  }
  Tally all;
  printHead();
  if (arguments[0] == "--simulated") {
    const std::uint64_t first = std::stoull(arguments[1]);
    const std::uint64_t count = arguments.size() > 2 ? std::stoull(arguments[2]) : 10;
    std::uint64_t done = 0;
    for (std::uint64_t number = first; done < count; ++number) {
      ScannedPlant plant = scannedPlant(number);
      if (plant.isLeafy || plant.foliage > 0) continue;
      const Tally one = judged({plant.truth, plant.cloud}, number, arguments.size() > 3);
      printLine(plant.name, one);
      std::fflush(stdout);
      all += one;
      ++done;
    }
  } else {
    Scanned plant{.skeleton = readStructure(arguments[1]).value.skeleton,
                  .cloud = std::make_shared<const PointCloud>(readPoints(arguments[0]).value)};
    if (const auto shift = shiftOntoCloud(plant.skeleton, *plant.cloud))
      for (const NodeId id : plant.skeleton.ids())
        plant.skeleton.setPosition(id, plant.skeleton[id].position + *shift);
    const std::uint64_t seeds = arguments.size() > 2 ? std::stoull(arguments[2]) : 1;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Tally one = judged(plant, seed, arguments.size() > 3);
      printLine("seed " + std::to_string(seed), one);
      all += one;
    }
  }
  printLine("all", all);
  printKinds(all);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::run(std::vector<std::string>(argv + 1, argv + argc));
}
