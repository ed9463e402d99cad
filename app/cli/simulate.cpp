#include "app/cli/commands.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/io/formats.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/prepared_plant.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <iostream>
#include <map>
#include <memory>
#include <string>

namespace espalier {
namespace {

struct Flags {
  std::string prefix;
  std::uint64_t seed = 1;
  std::string from;
  GrowthOptions growth;
  ScannerOptions scanner;
  double noise = -1; // [L], < 0: the scanner's own
  int threads = 0;
};

/// Scan and truth next to each other: PREFIX.ply and PREFIX.mtg.
void simulate(const Flags& flags) {
  const Threads threads(flags.threads);
  const TerminalProgress terminal;
  Skeleton truth;
  if (flags.from.empty()) {
    truth = growPlant(flags.growth, flags.seed, terminal.progress().part(0, 0.3, "Grow"));
  } else {
    const auto structure = readStructure(flags.from);
    printNotes(structure.notes);
    truth = preparedPlant(structure.value);
  }
  ScannerOptions scanner = flags.scanner;
  if (flags.noise >= 0) scanner.rangeNoise = flags.noise;
  Scan result = scan(truth, scanner, flags.seed, terminal.progress().part(0.3, 0.95, "Scan"));
  const PointCloud cloud(std::move(result.points));
  writePoints(flags.prefix + ".ply", cloud);
  writeStructure(flags.prefix + ".mtg", truth);
  std::cerr << cloud.size() << " points in " << flags.prefix << ".ply, the truth of "
            << truth.size() << " nodes in " << flags.prefix << ".mtg\n";
}

} // namespace

void addSimulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Grow a plant, or take a structure, and scan it: the truth is known");
  const auto flags = std::make_shared<Flags>();
  GrowthOptions& growth = flags->growth;
  ScannerOptions& scanner = flags->scanner;
  command->add_option("-o,--output", flags->prefix, "Writes PREFIX.ply and PREFIX.mtg")->required();
  command->add_option("--seed", flags->seed, "The same seed gives the same plant and scan")
      ->capture_default_str();
  command->add_option("--from", flags->from, "Structure to scan instead of growing one");
  const std::map<std::string, Architecture> architectures = {{"broadleaf", Architecture::broadleaf},
                                                             {"conifer", Architecture::conifer},
                                                             {"shrub", Architecture::shrub},
                                                             {"herb", Architecture::herb}};
  command->add_option("--architecture", growth.architecture, "Kind of plant to grow")
      ->transform(CLI::CheckedTransformer(architectures, CLI::ignore_case))
      ->default_str("broadleaf");
  command->add_option("--height", growth.height, "Height of the grown plant")
      ->capture_default_str();
  command->add_option("--segments", growth.segments, "Unbranched chains of the grown plant")
      ->capture_default_str();
  command->add_option("--points", scanner.points, "Points of all stations together")
      ->capture_default_str();
  command->add_option("--stations", scanner.stations, "Places the scanner looks from")
      ->capture_default_str();
  command->add_option("--noise", flags->noise, "Standard deviation of the range")
      ->check(CLI::NonNegativeNumber)
      ->default_str("a 2500th of the plant");
  command->add_option("--strays", scanner.strayShare, "Share of points that lie on nothing")
      ->capture_default_str();
  addThreadsFlag(*command, flags->threads);
  command->callback([flags] { simulate(*flags); });
}

} // namespace espalier
