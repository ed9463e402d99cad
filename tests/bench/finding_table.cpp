// How many errors the checks find, and how much they report beside them: 60 errors of six kinds
// (tests/support/planted_errors.h) are put into a structure that was right.
//
//   espalier_findings SCAN STRUCTURE [SEEDS] [--list]    seeds 1 to SEEDS, one by default
//   espalier_findings --simulated FIRST COUNT [--list]   bare ones of scannedPlant(FIRST) and on
//   espalier_findings --noisy FIRST COUNT [--list]       those of noisyPlant()
//   espalier_findings --rough FIRST COUNT [--list]       as simulated, drawn as people draw
//
// With --list, each false finding and each missed error is printed.
//
// An error is caught if there is a finding at it that was not there before. Of the findings of the
// structure with the errors, the others are false: those that were there before ("before"), and
// those that only came with the errors ("new"). For each kind of finding, how many are true is
// printed, too.
#include "core/base/random.h"
#include "core/io/formats.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "core/skeleton/skeleton_delta.h"
#include "tests/bench/simulated_scans.h"
#include "tests/support/planted_errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
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
                                const SpatialIndex& index, const CheckOptions& limits) {
  std::vector<Finding> all = check(skeleton, spacing, limits);
  const PointDistances distances(cloud, spacing, skeleton);
  for (Finding& finding : checkAgainstScan(skeleton, distances, index, spacing, limits))
    all.push_back(std::move(finding));
  return all;
}

Tally judged(const Scanned& plant, std::uint64_t seed, bool isListed) {
  const PlantScale scale = scaleOf(*plant.cloud, {}, UpAxis::z);
  const double spacing = scale.spacing;
  const CheckOptions limits{.scatter = scale.scatter / spacing};
  const SpatialIndex index(plant.cloud->positions());
  const std::vector<Finding> before =
      findingsOf(plant.skeleton, plant.cloud, spacing, index, limits);
  const test::PlantedPlant planted =
      test::withPlantedErrors(plant.skeleton, plant.cloud, spacing, seed);
  Tally tally;
  std::vector<char> isCaught(planted.errors.size(), 0);
  for (const Finding& finding : findingsOf(planted.skeleton, plant.cloud, spacing, index, limits)) {
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

/// As people draw it: with fewer nodes, which lie beside the middle, and radii that are estimated.
Skeleton rough(Skeleton plant, double spacing, std::uint64_t seed) {
  Random random(seed);
  SkeletonEditor editor(plant);
  resample(editor, plant.ids(), 6 * spacing);
  const Eigen::Vector3d shift = spacing * random.direction();
  const double thickness = std::exp(0.2 * random.normal());
  for (const NodeId id : plant.ids()) {
    editor.setPosition(id, plant[id].position + shift +
                               0.8 * spacing * random.normal() * random.direction());
    editor.setRadius(id, plant[id].radius * thickness);
  }
  static_cast<void>(editor.commit());
  return plant;
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

/// A simulated plant, bare; none: another number is.
std::optional<ScannedPlant> simulated(const std::string& how, std::uint64_t number) {
  ScannedPlant plant = how == "--noisy" ? noisyPlant(number) : scannedPlant(number);
  if (plant.isLeafy || plant.foliage > 0) return std::nullopt;
  if (how == "--rough")
    plant.truth = rough(plant.truth, pointSpacing(plant.cloud->positions()), number);
  return plant;
}

Scanned read(const std::string& scan, const std::string& structure) {
  Scanned plant{.skeleton = readStructure(structure).value.skeleton,
                .cloud = std::make_shared<const PointCloud>(readPoints(scan).value)};
  if (const auto shift = shiftOntoCloud(plant.skeleton, *plant.cloud))
    for (const NodeId id : plant.skeleton.ids())
      plant.skeleton.setPosition(id, plant.skeleton[id].position + *shift);
  return plant;
}

int run(std::vector<std::string> arguments) {
  const bool isListed = std::erase(arguments, "--list") > 0;
  if (arguments.size() < 2) {
    std::puts("espalier_findings SCAN STRUCTURE [SEEDS] [--list]\n"
              "espalier_findings --simulated|--noisy|--rough FIRST COUNT [--list]");
    return 2;
  }
  Tally all;
  printHead();
  const auto number = [&](std::size_t at, std::uint64_t usual) {
    return arguments.size() > at ? std::stoull(arguments[at]) : usual;
  };
  const auto add = [&](const std::string& name, const Scanned& plant, std::uint64_t seed) {
    const Tally one = judged(plant, seed, isListed);
    printLine(name, one);
    std::fflush(stdout);
    all += one;
  };
  if (arguments[0].starts_with("--")) {
    std::uint64_t left = number(2, 10);
    for (std::uint64_t i = number(1, 0); left > 0; ++i)
      if (const auto plant = simulated(arguments[0], i)) {
        add(plant->name, {plant->truth, plant->cloud}, i);
        --left;
      }
  } else {
    const Scanned plant = read(arguments[0], arguments[1]);
    for (std::uint64_t seed = 1; seed <= number(2, 1); ++seed)
      add("seed " + std::to_string(seed), plant, seed);
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
