// How well branches that are made by hand or by command follow twigs whose truth is known: twigs
// are taken off a structure that was right, and each is made anew by every tool.
//
//   espalier_twigs --simulated FIRST COUNT [OPTIONS]   plants scannedPlant(FIRST) and on
//   espalier_twigs --noisy FIRST COUNT [OPTIONS]       those of noisyPlant()
//   espalier_twigs SCAN STRUCTURE [OPTIONS]
//
//   --twigs N     of a plant at most, 10 by default
//   --save DIR    what was made, as DIR/PLANT.ply and DIR/PLANT_TOOL.mtg, to be looked at
//   --tool NAME   only that: trace, stroke, regrow, points or missing
//   --list        each twig that falls short
//
// Trace begins on the bearer 4 spacings off the place where the twig leaves it, as a click does,
// and ends at a point of each tip. Strokes are drawn from the bearer to each tip, along what is
// seen from where the twig is hidden least, by a hand that errs by a spacing. Regrow has the lowest
// node of the twig, where there are others. Branch from Points has the points of the twig. Missing
// grows all twigs of a plant at once.
#include "core/base/random.h"
#include "core/io/formats.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "tests/bench/made_twigs.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

struct Arguments {
  std::vector<std::string> names;
  std::size_t twigs = 10;
  std::string folder;
  std::string tool; // empty: all
  bool isListed = false;
};

struct Tally {
  int twigs = 0;
  TwigScore sum; // of lengths in spacings
  int folds = 0, airs = 0, skins = 0, nothing = 0;
  std::vector<double> shares; // of each twig that is found
  std::vector<double> begins; // in spacings
  double seconds = 0;

  void add(const Tally& other) {
    twigs += other.twigs;
    sum.length += other.sum.length;
    sum.found += other.sum.found;
    sum.grown += other.sum.grown;
    sum.near += other.sum.near;
    folds += other.folds;
    airs += other.airs;
    skins += other.skins;
    nothing += other.nothing;
    shares.insert(shares.end(), other.shares.begin(), other.shares.end());
    begins.insert(begins.end(), other.begins.begin(), other.begins.end());
    seconds += other.seconds;
  }
};

using Tallies = std::array<Tally, toolNames.size()>;

constexpr double sharpest = 120; // degrees
constexpr double widestAir = 6;  // spacings: no gap of the scan is bridged that is wider
constexpr double mostOnSkin = 4; // spacings beyond the radius of the bearer

Tally tallyOf(const TwigScore& score, double bearer, double spacing, bool isMade) {
  Tally tally{.twigs = 1, .sum = score, .folds = 0, .shares = {}, .begins = {}};
  for (double* length : {&tally.sum.length, &tally.sum.found, &tally.sum.grown, &tally.sum.near})
    *length /= spacing;
  tally.folds = score.sharpest > sharpest ? 1 : 0;
  tally.airs = score.air > widestAir * spacing ? 1 : 0;
  tally.skins = score.skin > bearer + mostOnSkin * spacing ? 1 : 0;
  tally.nothing = isMade ? 0 : 1;
  if (score.length > 0) tally.shares.push_back(score.found / score.length);
  if (isMade) tally.begins.push_back(score.begins / spacing);
  return tally;
}

double quantileOf(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void printLine(const std::string& name, const std::string& tool, const Tally& tally) {
  const auto percent = [](double part, double whole) { return whole > 0 ? 100 * part / whole : 0; };
  std::printf("%-15s %-8s %4d | %5.1f %5.1f | worst tenth %5.1f | none %3d fold %3d air %3d skin "
              "%3d | begins %4.1f %5.1f | %6.1f s\n",
              name.c_str(), tool.c_str(), tally.twigs, percent(tally.sum.found, tally.sum.length),
              percent(tally.sum.near, tally.sum.grown), 100 * quantileOf(tally.shares, 0.1),
              tally.nothing, tally.folds, tally.airs, tally.skins, quantileOf(tally.begins, 0.5),
              quantileOf(tally.begins, 0.9), tally.seconds);
  std::fflush(stdout);
}

void listShort(const char* tool, const Twig& twig, const TwigScore& score, double spacing) {
  const bool isShort = score.found < 0.9 * score.length || score.near < 0.9 * score.grown;
  if (!isShort && score.sharpest <= sharpest && score.air <= widestAir * spacing) return;
  std::printf("    %-8s twig %4u (%zu nodes, %zu points): found %.1f of %.1f, near %.1f of %.1f, "
              "turn %.0f, air %.1f, skin %.1f, begins %.1f\n",
              tool, static_cast<unsigned>(indexOf(twig.first)), twig.nodes.size(),
              twig.points.size(), score.found / spacing, score.length / spacing,
              score.near / spacing, score.grown / spacing, score.sharpest, score.air / spacing,
              score.skin / spacing, score.begins / spacing);
}

/// All that a tool made of a plant, in one structure.
void join(Skeleton& all, const Made& made) {
  std::vector<NodeId> copies(made.plant.idEnd());
  for (const NodeId id : made.added) {
    Node copy = made.plant[id];
    if (copy.parent) {
      const NodeId parent = *copy.parent;
      if (std::ranges::count(made.added, parent) > 0)
        copy.parent = copies[indexOf(parent)];
      else
        copy.parent = EdgeIndex(all).nearest(made.plant[parent].position)->node;
    }
    copy.edge = EdgeType::branching;
    copies[indexOf(id)] = all.add(copy);
  }
}

/// All twigs of a plant, as if they were one.
Twig allOf(const std::vector<Twig>& twigs) {
  Twig all{.first = twigs.front().first, .nodes = {}, .points = {}};
  for (const Twig& twig : twigs)
    all.nodes.insert(all.nodes.end(), twig.nodes.begin(), twig.nodes.end());
  return all;
}

Tally judged(const Subject& subject, Tool tool, std::uint64_t seed, const Arguments& arguments) {
  const PrunedPlant& plant = subject.plant;
  const TwigJudge judge(plant, *subject.cloud, subject.spacing);
  const char* name = toolNames[static_cast<std::size_t>(tool)];
  Random random(seed);
  Tally tally;
  Skeleton joined = plant.pruned;
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Twig> twigs =
      tool == Tool::missing ? std::vector{allOf(plant.twigs)} : plant.twigs;
  for (const Twig& twig : twigs) {
    const auto made = madeBy(tool, subject, twig, random);
    if (!made) continue;
    TwigScore score = judge.score(twig, made->plant, made->added);
    if (tool == Tool::missing) score.begins = score.skin = 0; // those of all twigs
    const double bearer = plant.truth[*plant.truth[twig.first].parent].radius;
    tally.add(tallyOf(score, bearer, subject.spacing, !made->added.empty()));
    if (arguments.isListed) listShort(name, twig, score, subject.spacing);
    if (!arguments.folder.empty()) join(joined, *made);
  }
  tally.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!arguments.folder.empty())
    writeStructure(arguments.folder + "/" + subject.name + "_" + name + ".mtg", joined);
  return tally;
}

void judgePlant(const std::string& name, const Skeleton& truth,
                const std::shared_ptr<const PointCloud>& cloud, std::uint64_t seed,
                const Arguments& arguments, Tallies& all) {
  const double spacing = pointSpacing(cloud->positions());
  const PrunedPlant plant = withoutTwigs(truth, cloud, spacing, arguments.twigs, seed);
  if (plant.twigs.empty()) return;
  Subject subject{.name = name, .cloud = cloud, .spacing = spacing, .plant = plant, .graph = {}};
  subject.graph.emplace(cloud);
  subject.step = meanEdgeLength(plant.pruned);
  if (!arguments.folder.empty()) {
    std::filesystem::create_directories(arguments.folder);
    writePoints(arguments.folder + "/" + name + ".ply", *cloud);
    writeStructure(arguments.folder + "/" + name + "_truth.mtg", truth);
  }
  for (std::size_t i = 0; i < toolNames.size(); ++i) {
    if (!arguments.tool.empty() && arguments.tool != toolNames[i]) continue;
    const Tally tally = judged(subject, static_cast<Tool>(i), seed, arguments);
    printLine(name, toolNames[i], tally);
    all[i].add(tally);
  }
}

int run(std::vector<std::string> words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool hasValue = i + 1 < words.size();
    if (words[i] == "--twigs" && hasValue)
      arguments.twigs = std::stoull(words[++i]);
    else if (words[i] == "--tool" && hasValue)
      arguments.tool = words[++i];
    else if (words[i] == "--save" && hasValue)
      arguments.folder = words[++i];
    else if (words[i] == "--list")
      arguments.isListed = true;
    else
      arguments.names.push_back(words[i]);
  }
  if (arguments.names.size() < 2) {
    std::puts("espalier_twigs --simulated|--noisy FIRST COUNT [OPTIONS]\n"
              "espalier_twigs SCAN STRUCTURE [OPTIONS]\n"
              "options: --twigs N, --save DIR, --tool NAME, --list");
    return 2;
  }
  std::puts("twigs | % of the length found, % of new wood near it | ... | begins off by spacings: "
            "median, nine tenths");
  Tallies bare;
  Tallies leafy; // with foliage
  if (arguments.names[0].starts_with("--")) {
    const std::uint64_t first = std::stoull(arguments.names[1]);
    const std::uint64_t count = arguments.names.size() > 2 ? std::stoull(arguments.names[2]) : 1;
    for (std::uint64_t i = first; i < first + count; ++i) {
      const ScannedPlant plant = arguments.names[0] == "--noisy" ? noisyPlant(i) : scannedPlant(i);
      if (plant.isLeafy) continue;                                    // its leaves are no twigs
      std::string name = plant.name + (plant.foliage > 0 ? "*" : ""); // with foliage
      std::ranges::replace(name, ' ', '_');
      judgePlant(name, plant.truth, plant.cloud, i, arguments, plant.foliage > 0 ? leafy : bare);
    }
  } else {
    Skeleton truth = readStructure(arguments.names[1]).value.skeleton;
    const auto cloud = std::make_shared<const PointCloud>(readPoints(arguments.names[0]).value);
    if (const auto shift = shiftOntoCloud(truth, *cloud))
      for (const NodeId id : truth.ids())
        truth.setPosition(id, truth[id].position + *shift);
    judgePlant("scan", truth, cloud, 1, arguments, bare);
  }
  for (const auto& [name, tallies] : {std::pair("all bare", &bare), {"all leafy", &leafy}})
    for (std::size_t i = 0; i < toolNames.size(); ++i)
      if ((*tallies)[i].twigs > 0) printLine(name, toolNames[i], (*tallies)[i]);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::run(std::vector<std::string>(argv + 1, argv + argc));
}
