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
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/graph/find_root.h"
#include "core/io/formats.h"
#include "core/pipeline/grow_branches.h"
#include "core/pipeline/regrow.h"
#include "core/reconstruct/leave_wood.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "tests/bench/judged_twigs.h"
#include "tests/bench/simulated_scans.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

struct Made {
  Skeleton plant;
  std::vector<NodeId> added;
};

struct Arguments {
  std::vector<std::string> names;
  std::size_t twigs = 10;
  std::string folder;
  std::string tool; // empty: all
  bool isListed = false;
};

enum class Tool : std::uint8_t { trace, stroke, regrow, points, missing };
constexpr std::array names = {"trace", "stroke", "regrow", "points", "missing"};

/// A plant to make twigs of.
struct Subject {
  std::string name;
  std::shared_ptr<const PointCloud> cloud;
  double spacing = 0;
  const PrunedPlant& plant;
  std::optional<TraceGraph> graph;
  double step = 0; // between nodes, as the tools have it [L]
};

/// The place of some nodes' edges that is nearest.
NearestPlace nearestOn(const Skeleton& skeleton, const Vector3d& place) {
  return *EdgeIndex(skeleton).nearest(place);
}

/// Adds a branch as the tools do that trace it.
void addLine(Made& made, const Trace& trace) {
  SkeletonEditor editor(made.plant);
  NodeId at = addTrace(editor, trace);
  (void)editor.commit();
  for (std::size_t i = 1; i < trace.places.size(); ++i, at = *made.plant[at].parent)
    made.added.push_back(at);
}

/// What a trace is asked for with.
TraceOptions optionsOf(const Subject& subject, const Skeleton& plant) {
  return {.step = subject.step,
          .alternatives = 0,
          .wood = std::make_shared<const EdgeIndex>(bodiesOf(plant))};
}

/// What a hand makes of a twig at once: from the node that bears it to a tip.
struct Chain {
  std::vector<NodeId> nodes;
  std::vector<Eigen::Index> points; // that show it, nearest the tip first
};

/// All of a twig, one after another, but for those that hardly any points show.
std::vector<Chain> chainsOf(const Subject& subject, const Twig& twig) {
  constexpr std::size_t fewest = 4; // points
  const Skeleton& truth = subject.plant.truth;
  std::vector<EdgeBody> wood = bodiesOf(truth);
  std::erase_if(
      wood, [&](const EdgeBody& edge) { return std::ranges::count(twig.nodes, edge.node) == 0; });
  const EdgeIndex index(wood);
  std::vector<Chain> chains;
  for (const NodeId id : twig.nodes) {
    if (id != twig.first && nextOnAxis(truth, *truth[id].parent) == id) continue;
    Chain chain{.nodes = {*truth[id].parent, id}, .points = {}};
    while (const auto next = nextOnAxis(truth, chain.nodes.back()))
      chain.nodes.push_back(*next);
    for (const Eigen::Index point : twig.points) {
      const NodeId nearest = index.nearest(subject.cloud->position(point))->node;
      if (std::find(chain.nodes.begin() + 1, chain.nodes.end(), nearest) != chain.nodes.end())
        chain.points.push_back(point);
    }
    std::ranges::sort(chain.points, {}, [&](Eigen::Index point) {
      return (subject.cloud->position(point) - truth[chain.nodes.back()].position).squaredNorm();
    });
    if (id == twig.first || chain.points.size() >= fewest) chains.push_back(std::move(chain));
  }
  return chains;
}

/// Where a click on the bearer lands that is meant for a place of it.
NearestPlace clickedOn(const Subject& subject, const Skeleton& plant, const Vector3d& place,
                       Random& random) {
  const NearestPlace at = nearestOn(plant, place);
  const Node& node = plant[at.node];
  Vector3d along = at.along;
  if (along.isZero(0) && node.parent) along = node.position - plant[*node.parent].position;
  const double aside = (random.uniform() < 0.5 ? -4 : 4) * subject.spacing;
  return nearestOn(plant, at.position + aside * along.normalized());
}

Made traced(const Subject& subject, const Twig& twig, Random& random) {
  Made made{subject.plant.pruned, {}};
  const Skeleton& truth = subject.plant.truth;
  for (const Chain& chain : chainsOf(subject, twig)) {
    const NearestPlace on =
        clickedOn(subject, made.plant, truth[chain.nodes.front()].position, random);
    if (chain.points.empty()) continue;
    const Vector3d end = subject.cloud->position(chain.points.front());
    addLine(made, subject.graph
                      ->between({on.position, true}, {end, false}, optionsOf(subject, made.plant))
                      .front());
  }
  return made;
}

/// Points as they are seen from one side, and picked there.
class Sight {
public:
  Sight(const PointCloud& cloud, const std::vector<Eigen::Index>& points, const Vector3d& toViewer)
      : cloud_(cloud), points_(points), toViewer_(toViewer),
        flat_(cloud.positions()(Eigen::all, points)), index_(flattened(flat_, toViewer)) {}
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  /// The frontmost point within a reach about a place as it is seen.
  [[nodiscard]] std::optional<Eigen::Index> pick(const Vector3d& place, double reach) const {
    Eigen::Matrix3Xf seen = (place - cloud_.origin()).cast<float>();
    flattened(seen, toViewer_);
    std::optional<Eigen::Index> best;
    double nearest = 0;
    for (const Neighbor& near : index_.within(seen.col(0), static_cast<float>(reach))) {
      const Eigen::Index point = points_[static_cast<std::size_t>(near.index)];
      const double depth = toViewer_.dot(cloud_.position(point));
      if (best && depth <= nearest) continue;
      best = point;
      nearest = depth;
    }
    return best;
  }

private:
  static Eigen::Matrix3Xf& flattened(Eigen::Matrix3Xf& places, const Vector3d& toViewer) {
    const Eigen::Vector3f normal = toViewer.cast<float>();
    for (Eigen::Index i = 0; i < places.cols(); ++i)
      places.col(i) -= normal.dot(places.col(i)) * normal;
    return places;
  }

  const PointCloud& cloud_;
  const std::vector<Eigen::Index>& points_;
  Vector3d toViewer_;
  Eigen::Matrix3Xf flat_;
  SpatialIndex index_;
};

/// Points as near to a twig as one sees it in the focus of the view.
std::vector<Eigen::Index> pointsAbout(const Subject& subject, const Twig& twig) {
  constexpr double margin = 20; // spacings
  Eigen::AlignedBox3d box;
  for (const NodeId id : twig.nodes)
    box.extend(subject.plant.truth[id].position);
  std::vector<Eigen::Index> points;
  for (Eigen::Index i = 0; i < subject.cloud->size(); ++i)
    if (box.exteriorDistance(subject.cloud->position(i)) <= margin * subject.spacing)
      points.push_back(i);
  return points;
}

/// Places that a hand leads along, a spacing or more apart.
std::vector<Vector3d> handOver(const Skeleton& truth, const std::vector<NodeId>& chain,
                               double spacing, const Vector3d& toViewer, Random& random) {
  std::vector<Vector3d> places;
  const double step = 2 * spacing;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vector3d from = truth[chain[i - 1]].position;
    const Vector3d along = truth[chain[i]].position - from;
    const auto parts = static_cast<int>(std::clamp(std::ceil(along.norm() / step), 1.0, 1000.0));
    for (int part = 0; part < parts; ++part) {
      Vector3d aside = spacing * random.normal() * random.direction();
      aside -= aside.dot(toViewer) * toViewer;
      places.push_back(from + (part + 0.5) / parts * along + aside);
    }
  }
  return places;
}

Made stroked(const Subject& subject, const Twig& twig, Random& random) {
  Made made{subject.plant.pruned, {}};
  const Skeleton& truth = subject.plant.truth;
  const PointCloud& cloud = *subject.cloud;
  constexpr double reach = 2; // spacings about the pointer
  const std::vector<Eigen::Index> about = pointsAbout(subject, twig);
  for (const Chain& chain : chainsOf(subject, twig)) {
    const Vector3d along =
        (truth[chain.nodes.back()].position - truth[chain.nodes.front()].position).normalized();
    std::size_t mostSeen = 0;
    std::unique_ptr<const Sight> best;
    std::vector<Vector3d> hand;
    constexpr int sides = 8;
    for (int side = 0; side < sides; ++side) {
      const Vector3d toViewer =
          Eigen::AngleAxisd(2 * std::numbers::pi * side / sides, along) * along.unitOrthogonal();
      auto sight = std::make_unique<const Sight>(cloud, about, toViewer);
      std::vector<Vector3d> places =
          handOver(truth, chain.nodes, subject.spacing, toViewer, random);
      std::size_t seen = 0;
      for (const Vector3d& place : places)
        if (const auto point = sight->pick(place, reach * subject.spacing))
          seen += std::ranges::binary_search(twig.points, *point) ? 1 : 0;
      if (best && seen <= mostSeen) continue;
      mostSeen = seen;
      best = std::move(sight);
      hand = std::move(places);
    }
    const NearestPlace on = nearestOn(made.plant, truth[chain.nodes.front()].position);
    std::vector<Vector3d> places = {on.position};
    for (const Vector3d& place : hand) { // as the tool takes them
      const auto point = best->pick(place, reach * subject.spacing);
      if (!point) continue;
      const double slack =
          4 * subject.spacing + (places.size() == 1 ? 2 * made.plant[on.node].radius : 0);
      const Vector3d picked = cloud.position(*point);
      if ((picked - places.back()).norm() <= 4 * (place - places.back()).norm() + slack)
        places.push_back(picked);
    }
    if (places.size() < 2) continue;
    addLine(made, subject.graph->through(places, true, optionsOf(subject, made.plant)));
  }
  return made;
}

std::vector<NodeId> newNodes(const Skeleton& after, const Skeleton& before,
                             const std::vector<NodeId>& first) {
  std::vector<NodeId> added = downstream(after, first);
  std::erase_if(added, [&](NodeId id) { return before.contains(id); });
  return added;
}

Made withGrown(const Skeleton& plant, const std::vector<GrownBranch>& branches) {
  Made made{plant, {}};
  SkeletonEditor editor(made.plant);
  const std::vector<NodeId> first = addGrown(editor, branches);
  (void)editor.commit();
  made.added = newNodes(made.plant, plant, first);
  return made;
}

std::optional<Made> regrownTwig(const Subject& subject, const Twig& twig) {
  if (twig.nodes.size() < 2) return std::nullopt;
  Made made{subject.plant.pruned, {}};
  Skeleton plant = subject.plant.truth;
  for (auto id = twig.nodes.rbegin(); *id != twig.first; ++id)
    plant.erase(*id);
  const Skeleton part = regrown(plant, twig.first, subject.cloud);
  made.plant = plant;
  SkeletonEditor editor(made.plant);
  const std::vector<NodeId> first = addCarried(editor, twig.first, part);
  (void)editor.commit();
  made.added = newNodes(made.plant, plant, first);
  return made;
}

/// What a tool makes of a twig; none: it does not apply.
std::optional<Made> madeBy(Tool tool, const Subject& subject, const Twig& twig, Random& random) {
  try {
    switch (tool) {
    case Tool::trace:
      return traced(subject, twig, random);
    case Tool::stroke:
      return stroked(subject, twig, random);
    case Tool::regrow:
      return regrownTwig(subject, twig);
    case Tool::points:
      return withGrown(subject.plant.pruned,
                       grownBranches(subject.plant.pruned, subject.cloud, twig.points));
    case Tool::missing:
      return withGrown(subject.plant.pruned,
                       grownFromUnexplained(subject.plant.pruned, subject.cloud));
    }
  } catch (const Error&) { // it makes nothing
  }
  return Made{subject.plant.pruned, {}};
}

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

using Tallies = std::array<Tally, names.size()>;

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
        copy.parent = nearestOn(all, made.plant[parent].position).node;
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
  const char* name = names[static_cast<std::size_t>(tool)];
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
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!arguments.tool.empty() && arguments.tool != names[i]) continue;
    const Tally tally = judged(subject, static_cast<Tool>(i), seed, arguments);
    printLine(name, names[i], tally);
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
    for (std::size_t i = 0; i < names.size(); ++i)
      if ((*tallies)[i].twigs > 0) printLine(name, names[i], (*tallies)[i]);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::run(std::vector<std::string>(argv + 1, argv + argc));
}
