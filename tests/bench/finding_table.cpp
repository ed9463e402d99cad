// How many errors the checks find, and how much they report beside them: 60 errors of six kinds
// (tests/support/planted_errors.h) are put into a structure that was right.
//
//   espalier_findings SCAN STRUCTURE [SEEDS] [--list]    seeds 1 to SEEDS, one by default
//   espalier_findings --simulated FIRST COUNT [--list]   bare ones of scannedPlant(FIRST) and on
//   espalier_findings --noisy FIRST COUNT [--list]       those of noisyPlant()
//   espalier_findings --rough FIRST COUNT [--list]       as simulated, drawn as people draw
//   espalier_findings --found FIRST COUNT                how much of what findings are about is
//                                                        wrong
//
// With --list, each false finding and each missed error is printed.
//
// An error is caught if there is a finding at it that was not there before. Of the findings of the
// structure with the errors, the others are false: those that were there before ("before"), and
// those that only came with the errors ("new"). For each kind of finding, how many are true is
// printed, too.
//
// --found reconstructs plants of scannedPlant(FIRST) and on by default, and prints for each kind of
// finding how much of the wood that it is about is invented or wrongly attached, or of how far its
// points reach is missed (core/evaluate/differences, within 4 spacings): the chances of an error in
// core/doubt/finding_gain.cpp. Bare twigs are counted apart by the chance that they are given.
#include "core/base/random.h"
#include "core/doubt/finding_gain.h"
#include "core/evaluate/differences/differences.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "core/skeleton/skeleton_delta.h"
#include "tests/bench/simulated_scans.h"
#include "tests/support/planted_errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
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

/// Of the findings of a kind.
struct Chance {
  int count = 0;
  double length = 0; // in lengths of the plant: of the wood that they are about
  double wrong = 0;  // likewise
  int mostly = 0;    // of which over half is wrong
};
using Chances = std::map<std::string, Chance>; // by kind; bare twigs apart by what their chance is

/// The kind of a finding; of a bare twig, by what its chance follows from.
std::string rowOf(const Finding& finding, const FindingGain& gain) {
  if (finding.kind != Finding::Kind::unexplainedPoints) return nameOf(finding.kind);
  char row[64];
  std::snprintf(row, sizeof row, "%s, %.2f", nameOf(finding.kind).c_str(), gain.wrong);
  return row;
}

/// The length of what a skeleton lacks about some points, at most as far as they reach [L].
double missedAt(const Finding& finding, const PointCloud& cloud, const Skeleton& truth,
                const Differences& found) {
  const Eigen::Matrix3Xf points = cloud.positions()(Eigen::all, finding.points);
  const SpatialIndex index(points);
  double missed = 0;
  for (const NodeId id : truth.ids()) {
    if (!truth[id].parent || found.ofReference[indexOf(id)] == Difference::matched) continue;
    const Eigen::Vector3d& from = truth[*truth[id].parent].position;
    const double length = edgeLength(truth, id);
    const int parts = std::max(1, static_cast<int>(length / found.tolerance));
    for (int i = 0; i < parts; ++i) {
      const Eigen::Vector3d at =
          from + (i + 0.5) / parts * (truth[id].position - from) - cloud.origin();
      if (index.nearestOne(at.cast<float>(),
                           static_cast<float>(found.tolerance + truth[id].radius)))
        missed += length / parts;
    }
  }
  return missed;
}

void addChances(Chances& chances, const ScannedPlant& plant) {
  const Reconstruction result = Pipeline().run(plant.cloud, {});
  const Skeleton& skeleton = *result.skeleton;
  const PlantScale scale = scaleOf(*plant.cloud, {}, UpAxis::z);
  const CheckOptions limits{.scatter = scale.scatter / scale.spacing};
  const SpatialIndex index(plant.cloud->positions());
  const std::vector<Finding> findings =
      findingsOf(skeleton, plant.cloud, scale.spacing, index, limits);
  const std::vector<FindingGain> gains = gainsOf(findings, skeleton);
  const Differences found = differences(skeleton, plant.truth, 4 * scale.spacing);
  double all = 0;
  for (const NodeId id : skeleton.ids())
    all += edgeLength(skeleton, id);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const std::vector<NodeId> wood = woodOf(findings[i], skeleton);
    double wrong = 0;
    for (const NodeId id : wood)
      if (found.ofResult[indexOf(id)] != Difference::matched) wrong += edgeLength(skeleton, id);
    if (wood.empty()) wrong = missedAt(findings[i], *plant.cloud, plant.truth, found);
    wrong = std::min(wrong, gains[i].length);
    Chance& chance = chances[rowOf(findings[i], gains[i])];
    ++chance.count;
    chance.length += gains[i].length / all;
    chance.wrong += wrong / all;
    if (2 * wrong > gains[i].length) ++chance.mostly;
  }
}

int runFound(std::uint64_t first, std::uint64_t count) {
  Chances chances;
  for (std::uint64_t number = first; number < first + count; ++number)
    addChances(chances, scannedPlant(number));
  std::printf("%-26s %6s %8s %8s %8s\n", "kind of finding", "count", "of plant", "wrong", "mostly");
  for (const auto& [row, one] : chances)
    std::printf("%-26s %6d %8.4f %8.3f %8.3f\n", row.c_str(), one.count,
                one.length / static_cast<double>(count),
                one.length > 0 ? one.wrong / one.length : 0, double(one.mostly) / one.count);
  return 0;
}

int run(std::vector<std::string> arguments) {
  const bool isListed = std::erase(arguments, "--list") > 0;
  if (arguments.size() < 2) {
    std::puts("espalier_findings SCAN STRUCTURE [SEEDS] [--list]\n"
              "espalier_findings --simulated|--noisy|--rough FIRST COUNT [--list]\n"
              "espalier_findings --found FIRST COUNT");
    return 2;
  }
  const auto number = [&](std::size_t at, std::uint64_t usual) {
    return arguments.size() > at ? std::stoull(arguments[at]) : usual;
  };
  if (arguments[0] == "--found") return runFound(number(1, 0), number(2, 10));
  Tally all;
  printHead();
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
