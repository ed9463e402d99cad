#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/target_pairs.h"
#include "app/cli/terminal.h"
#include "core/align/cloud_fit.h"
#include "core/align/pair_fit.h"
#include "core/align/target_sphere.h"
#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/cloud/joined_clouds.h"
#include "core/evaluate/registration/registration.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

struct RegisterFlags {
  std::string fixed;
  std::vector<std::string> moved;
  std::string output;
  std::string pairs;  // file of pairs of targets
  double spheres = 0; // radius of the targets [L]; 0: they are places
  bool noFit = false; // by pairs alone
  CloudFitOptions fit;
  std::vector<std::string> structure; // in and out
  std::string unit;
  std::string json;
  int threads = 0;
};

using Cloud = std::shared_ptr<const PointCloud>;

/// How one scan came to the frame of the fixed one.
struct Registered {
  std::string file;
  std::vector<TargetPair> pairs;
  std::optional<PairFit> byPairs;
  std::optional<CloudFit> byPoints;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();

  /// How far the targets of each pair are apart in the end [L].
  [[nodiscard]] std::vector<double> apart() const { return distancesApart(pairs, motion); }
};

std::string lengthText(double length, const std::string& unit) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", length);
  return unit.empty() ? text.data() : std::string(text.data()) + ' ' + unit;
}

double degreesOf(const Eigen::Isometry3d& motion) {
  return Eigen::AngleAxisd(motion.linear()).angle() * 180 / std::numbers::pi;
}

/// How far a motion takes the middle of a scan.
double shiftOf(const Eigen::Isometry3d& motion, const PointCloud& cloud) {
  const Eigen::Vector3d middle = cloud.bounds().center();
  return (motion * middle - middle).norm();
}

/// Each place moved to the center of the sphere that is about it.
void takeCenters(std::vector<TargetPair>& pairs, const PointCloud& moved, const PointCloud& fixed,
                 double radius, const Progress& progress) {
  const SpatialIndex ofMoved(moved.positions(), progress);
  const SpatialIndex ofFixed(fixed.positions(), progress);
  const TargetSphereOptions options{.radius = radius, .reach = std::nullopt};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string pair = "pair " + std::to_string(i + 1);
    pairs[i].moved = about(pair + ", moved scan", [&] {
      return targetSphere(moved, ofMoved, pairs[i].moved, options, progress).center;
    });
    pairs[i].fixed = about(pair + ", fixed scan", [&] {
      return targetSphere(fixed, ofFixed, pairs[i].fixed, options, progress).center;
    });
  }
}

Registered registered(const RegisterFlags& flags, const std::string& file,
                      std::vector<TargetPair> pairs, const PointCloud& moved,
                      const PointCloud& fixed, const PointCloud& soFar, const Progress& progress) {
  Registered result{.file = file, .pairs = std::move(pairs), .byPairs = {}, .byPoints = {}};
  if (!result.pairs.empty()) {
    if (flags.spheres > 0)
      takeCenters(result.pairs, moved, fixed, flags.spheres, progress.part(0, 0.1));
    result.byPairs = fitPairs(result.pairs);
    result.motion = result.byPairs->motion;
  }
  if (!flags.noFit) {
    result.byPoints = fitClouds(soFar, moved, result.motion, flags.fit, progress.part(0.1, 1));
    result.motion = result.byPoints->motion;
  }
  return result;
}

void print(const Registered& result, const PointCloud& cloud, const std::string& unit) {
  const std::string file = result.file + ": ";
  if (result.byPairs)
    printLine(file + "by pairs, root mean square " + lengthText(result.byPairs->rms, unit));
  if (const auto& fit = result.byPoints) {
    printLine(file + "by points, root mean square " + lengthText(fit->rms, unit) + ", " +
              plainDecimal(std::round(1000 * fit->overlap) / 10) + " % overlap, " +
              counted(static_cast<std::size_t>(fit->iterations), "iteration"));
    if (!fit->converged)
      printNotes({file + "it still moved when it was stopped: give more pairs of targets"});
    if (fit->overlap < 0.2)
      printNotes({file + "little overlaps: look whether it lies well, or give pairs of targets"});
  }
  const std::vector<double> apart = result.apart();
  for (std::size_t i = 0; i < apart.size(); ++i)
    printLine(file + "pair " + std::to_string(i + 1) + " is " + lengthText(apart[i], unit) +
              " apart");
  if (result.byPairs && result.byPoints &&
      tookTargetsApart(rmsOf(apart), result.byPairs->rms, pointSpacing(cloud.positions())))
    printNotes({file + "by points, the targets are " + lengthText(rmsOf(apart), unit) +
                " apart; by pairs alone they were " + lengthText(result.byPairs->rms, unit) +
                ": --no-icp leaves it at the pairs"});
  printLine(file + "shifted by " + lengthText(shiftOf(result.motion, cloud), unit) +
            ", turned by " + lengthText(degreesOf(result.motion), {}) + " degrees");
}

Json jsonOf(const Eigen::Vector3d& place) {
  return Json::array({place.x(), place.y(), place.z()});
}

Json jsonOf(const Registered& result, const PointCloud& cloud) {
  Json json{{"file", result.file}};
  if (result.byPairs) {
    const std::vector<double> apart = result.apart();
    Json pairs = Json::array();
    for (std::size_t i = 0; i < result.pairs.size(); ++i)
      pairs.push_back({{"moved", jsonOf(result.pairs[i].moved)},
                       {"fixed", jsonOf(result.pairs[i].fixed)},
                       {"residual", result.byPairs->residuals[i]},
                       {"apart", apart[i]}});
    json["by_pairs"] = {{"pairs", std::move(pairs)}, {"rms", result.byPairs->rms}};
  }
  if (const auto& fit = result.byPoints)
    json["by_points"] = {{"rms", fit->rms},
                         {"overlap", fit->overlap},
                         {"iterations", fit->iterations},
                         {"converged", fit->converged}};
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < 4; ++row) {
    const Eigen::RowVector4d values = result.motion.matrix().row(row);
    rows.push_back(std::vector<double>(values.begin(), values.end()));
  }
  json["motion"] = std::move(rows);
  json["shift"] = shiftOf(result.motion, cloud);
  json["turn_degrees"] = degreesOf(result.motion);
  return json;
}

void requireFiles(const RegisterFlags& flags) {
  std::vector<std::string> inputs = flags.moved;
  inputs.push_back(flags.fixed);
  if (!flags.pairs.empty()) inputs.push_back(flags.pairs);
  std::vector<std::string> outputs = {flags.output, flags.json};
  if (!flags.structure.empty()) {
    inputs.push_back(flags.structure[0]);
    outputs.push_back(flags.structure[1]);
  }
  requireApart(outputs);
  requireOutput(flags.output, Content::points, inputs);
  requireOutput(flags.json, inputs);
  if (!flags.structure.empty()) requireOutput(flags.structure[1], Content::structure, inputs);
}

void requirePairs(const RegisterFlags& flags) {
  if (flags.pairs.empty() && flags.noFit)
    throw WrongUsage("--no-icp without --pairs leaves nothing to register by: give pairs");
  if (flags.pairs.empty() && flags.spheres > 0)
    throw WrongUsage("--spheres says what the targets of --pairs are: give pairs");
}

void registerScans(const RegisterFlags& flags) {
  const Threads threads(flags.threads);
  requirePairs(flags);
  requireFiles(flags);
  const std::vector<std::vector<TargetPair>> pairs =
      flags.pairs.empty() ? std::vector<std::vector<TargetPair>>(flags.moved.size())
                          : readTargetPairs(flags.pairs, flags.moved);
  std::optional<Structure> structure;
  if (!flags.structure.empty()) structure = plantIn(flags.structure[0]);
  const TerminalProgress terminal;
  const double share = 0.9 / static_cast<double>(flags.moved.size());
  const auto open = [](const std::string& file, const Progress& progress) {
    auto scan = readPoints(file, progress);
    printNotes(scan.notes);
    return std::make_shared<const PointCloud>(std::move(scan.value));
  };
  const auto nameOf = [](const std::string& file) {
    return std::filesystem::path(file).filename().string();
  };
  const Cloud fixed = open(flags.fixed, terminal.progress().part(0, 0.05, "Read"));
  std::vector<PlacedCloud> placed = {{.cloud = fixed, .name = nameOf(flags.fixed)}};
  Cloud soFar = fixed; // those that are registered already
  Json scans = Json::array();
  for (std::size_t i = 0; i < flags.moved.size(); ++i) {
    const std::string& file = flags.moved[i];
    const double from = 0.05 + share * static_cast<double>(i);
    const Progress here = terminal.progress().part(from, from + share, "Register");
    const Cloud cloud = open(file, here.part(0, 0.2));
    const Registered result = about(file, [&] {
      return registered(flags, file, pairs[i], *cloud, *fixed, *soFar, here.part(0.2, 0.9));
    });
    placed.push_back({.cloud = cloud, .motion = result.motion, .name = nameOf(file)});
    soFar = std::make_shared<const PointCloud>(joined(placed, here.part(0.9, 1)));
    terminal.clear();
    print(result, *cloud, flags.unit);
    scans.push_back(jsonOf(result, *cloud));
  }
  terminal.check();
  terminal.clear();
  writeAndReport(flags.output, *soFar, soFar->positions(), terminal.progress());
  if (structure) {
    structure->skeleton = moved(std::move(structure->skeleton), placed[1].motion);
    writeAndReport(flags.structure[1], *structure, MtgStyle::plantNode, flags.unit);
  }
  if (!flags.json.empty())
    writeJson(flags.json,
              {{"fixed", flags.fixed}, {"points", soFar->size()}, {"scans", std::move(scans)}});
}

} // namespace

void addRegister(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "register", "Bring several scans of a plant to one frame, and join their points");
  const auto flags = std::make_shared<RegisterFlags>();
  command->add_option("FIXED", flags->fixed, "Scan whose frame all get")->required();
  command->add_option("MOVED", flags->moved, "Scans that are moved, each to those before it")
      ->required();
  addOutput(*command, flags->output,
            "Points of all to write: PLY (.ply) or text (.xyz, .asc, .txt, .csv, .pts)");
  command
      ->add_option("--pairs", flags->pairs,
                   "Table of targets that two scans show: x, y and z in MOVED, then in FIXED; "
                   "three and more of each scan, in a column scan by file or number")
      ->type_name("FILE");
  command
      ->add_option("--spheres", flags->spheres,
                   "The targets are spheres of this radius: their centers are found")
      ->type_name("RADIUS")
      ->check(number(1e-9, 1e9));
  command->add_flag("--no-icp", flags->noFit, "By pairs alone: the points refine nothing");
  command
      ->add_option("--overlap", flags->fit.overlap,
                   "Share of the points of MOVED that those before it have, too, 0.05 to 1")
      ->type_name("SHARE")
      ->check(number(0.05, 1))
      ->default_str("found");
  command
      ->add_option("--reach", flags->fit.reach,
                   "How far a point may be off before its counterpart is found")
      ->type_name("LENGTH")
      ->check(number(1e-9, 1e9))
      ->default_str("a tenth of the diagonal of FIXED");
  command
      ->add_option("--structure", flags->structure,
                   "Structure in the frame of the first MOVED, which moves with it, and the file "
                   "to write it to")
      ->type_name("IN OUT")
      ->expected(2);
  addUnit(*command, flags->unit, "Unit of the scans, to be named with the numbers");
  command->add_option("--json", flags->json, "File to write all numbers to")->type_name("FILE");
  addThreads(*command, flags->threads);
  command->callback([flags] { registerScans(*flags); });
  command->footer("Examples:\n"
                  "  espalier register a.ply b.ply -o both.ply --pairs targets.csv\n"
                  "  espalier register a.ply b.ply c.ply -o all.ply --pairs targets.csv \\\n"
                  "    --spheres 0.07 --json all.json\n"
                  "  espalier register a.ply b.ply -o both.ply --structure b.mtg moved.mtg");
}

} // namespace espalier
