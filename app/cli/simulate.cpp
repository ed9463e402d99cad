#include "app/cli/apart_stations.h"
#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/io/csv.h"
#include "core/simulate/foliage.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/simulate/plot.h"
#include "core/simulate/prepared_plant.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

struct SimulateFlags {
  std::string prefix;
  std::uint64_t seed = 1;
  std::string from;
  GrowthOptions growth;
  ScannerOptions scanner;
  double noise = -1;        // [L], < 0: the scanner's own
  double foliage = 0;       // as dense as the kind of plant bears it
  double foliageLength = 0; // in extents; 0: of the kind
  double foliageAngle = -1; // [degrees]; < 0: of the kind
  double foliageWidth = -1; // in extents; < 0: of the kind
  double foliageGap = 0;    // between needles or leaves along the wood, in extents; 0: of the kind
  double foliageReach = -1; // from the apex, in extents; < 0: of the kind
  double petiole = 0;       // in lengths of the blade
  int leaflets = 0;         // pairs
  double droop = 0;         // [degrees]
  int threads = 0;
  PlotOptions plot;
  bool isPlot = false;
  std::string apart; // how far the stations are displaced; empty: they are joined
};

Foliage foliageOf(const SimulateFlags& flags) {
  Foliage foliage = foliageOf(flags.growth.architecture, flags.foliage);
  if (flags.foliageAngle >= 0)
    foliage.shortShoots.angle = foliage.blades.angle = flags.foliageAngle * std::numbers::pi / 180;
  if (flags.foliageLength > 0) foliage.blades.length = flags.foliageLength;
  if (flags.foliageWidth >= 0) foliage.blades.width = flags.foliageWidth;
  if (flags.foliageGap > 0) foliage.blades.spacing = flags.foliageGap;
  if (flags.foliageReach >= 0) foliage.blades.reach = flags.foliageReach;
  foliage.petiole = flags.petiole;
  foliage.leaflets = flags.leaflets;
  foliage.droop = flags.droop * std::numbers::pi / 180;
  return foliage;
}

/// @throws WrongUsage if flags are given that would change nothing
void requireFoliage(const SimulateFlags& flags) {
  const bool isShaped = flags.foliageLength > 0 || flags.foliageAngle >= 0 ||
                        flags.foliageWidth >= 0 || flags.foliageGap > 0 ||
                        flags.foliageReach >= 0 || flags.petiole > 0 || flags.leaflets > 0 ||
                        flags.droop > 0;
  if (isShaped && !(flags.foliage > 0))
    throw WrongUsage("there are no needles or leaves to shape: add --foliage 1");
  if (flags.leaflets > 0 && !(flags.petiole > 0))
    throw WrongUsage("--leaflets stand along petioles: add --petiole 2");
}

std::string nameOf(PlotPart part) {
  switch (part) {
  case PlotPart::plant:
    return "plant";
  case PlotPart::ground:
    return "ground";
  case PlotPart::pole:
    return "pole";
  case PlotPart::wire:
    return "wire";
  case PlotPart::stray:
    break;
  }
  return "stray";
}

/// The plants of a plot as one structure.
Skeleton allOf(const std::vector<Skeleton>& plants) {
  Skeleton all;
  for (const Skeleton& plant : plants) {
    std::vector<NodeId> copies(plant.idEnd());
    for (const NodeId id : plant.ids()) {
      Node node = plant[id];
      if (node.parent) node.parent = copies[indexOf(*node.parent)];
      copies[indexOf(id)] = all.add(node);
    }
  }
  return all;
}

/// A plot: PREFIX.ply, PREFIX.mtg of its plants, and PREFIX.csv, what each point of the scan is of.
void simulatePlotOf(const SimulateFlags& flags) {
  const std::string scanFile = flags.prefix + ".ply";
  const std::string truthFile = flags.prefix + ".mtg";
  const std::string partsFile = flags.prefix + ".csv";
  if (!flags.from.empty()) throw WrongUsage("--from and --plants: a plot is grown, not read");
  if (!flags.apart.empty()) throw WrongUsage("--apart and --plants: a plot is saved as one scan");
  requireApart({scanFile, truthFile, partsFile});
  for (const std::string& file : {scanFile, truthFile, partsFile})
    requireOutput(file, {});
  const TerminalProgress terminal;
  PlotOptions options = flags.plot;
  options.growth = flags.growth;
  options.scanner = flags.scanner;
  if (flags.noise >= 0) options.scanner.rangeNoise = flags.noise;
  options.scanner.foliage = foliageOf(flags);
  SimulatedPlot plot = simulatePlot(options, flags.seed, terminal.progress());
  const PointCloud cloud(std::move(plot.points));
  terminal.check();
  writeAndReport(scanFile, cloud, cloud.positions(), terminal.progress());
  writeAndReport(truthFile, Structure{.skeleton = allOf(plot.plants)}, MtgStyle::plantNode);
  writeAndReport(partsFile, [&](std::ostream& out) {
    out << csvLine({"part", "plant"});
    for (const PlotPoint& point : plot.truth)
      out << csvLine({nameOf(point.part), std::to_string(point.plant)});
  });
}

/// Scan and truth next to each other: PREFIX.ply and PREFIX.mtg.
void simulate(const SimulateFlags& flags) {
  const Threads threads(flags.threads);
  requireFoliage(flags);
  if (flags.isPlot) return simulatePlotOf(flags);
  const bool isApart = !flags.apart.empty();
  const Displacement displacement = isApart ? displacementIn(flags.apart) : Displacement();
  if (isApart && flags.scanner.stations < 2)
    throw WrongUsage("--apart needs --stations 2 or more: one station is one scan anyway");
  const std::string truthFile = flags.prefix + ".mtg";
  const auto stations = static_cast<std::size_t>(flags.scanner.stations);
  std::vector<std::string> files = isApart ? filesApart(flags.prefix, stations)
                                           : std::vector<std::string>{flags.prefix + ".ply"};
  files.push_back(truthFile);
  requireApart(files);
  for (const std::string& file : files)
    requireOutput(file, {flags.from});
  const TerminalProgress terminal;
  Skeleton truth;
  if (flags.from.empty()) {
    truth = growPlant(flags.growth, flags.seed, terminal.progress().part(0, 0.3, "Grow"));
  } else {
    const Structure structure = plantIn(flags.from);
    truth = about(flags.from, [&] { return preparedPlant(structure.skeleton); });
  }
  ScannerOptions scanner = flags.scanner;
  if (flags.noise >= 0) scanner.rangeNoise = flags.noise;
  scanner.foliage = foliageOf(flags);
  const auto scanned = [&] {
    return scan(truth, scanner, flags.seed, terminal.progress().part(0.3, 0.95, "Scan"));
  };
  SimulatedScan result = flags.from.empty() ? scanned() : about(flags.from, scanned);
  terminal.check();
  if (isApart) {
    writeApart(flags.prefix, result, displacement, terminal.progress());
  } else {
    const PointCloud cloud(std::move(result.points));
    writeAndReport(files.front(), cloud, cloud.positions(), terminal.progress());
  }
  writeAndReport(truthFile, Structure{.skeleton = truth}, MtgStyle::plantNode);
}

void addPlot(CLI::App& command, SimulateFlags& flags) {
  PlotOptions& plot = flags.plot;
  command
      .add_option_function<int>(
          "--plants",
          [&flags](int count) {
            flags.plot.plants = count;
            flags.isPlot = true;
          },
          "Grow a plot of so many plants, 1 to 1000, on ground with poles and wires; PREFIX.csv "
          "then has what each point is of")
      ->type_name("N")
      ->check(wholeNumber(1, 1000));
  command.add_option("--plant-spacing", plot.spacing, "Between plants of a plot, in heights")
      ->type_name("SHARE")
      ->check(number(0.05, 100))
      ->capture_default_str();
  command
      .add_option_function<double>(
          "--slope", [&plot](double degrees) { plot.slope = degrees * std::numbers::pi / 180; },
          "Of the ground of a plot, 0 to 57")
      ->type_name("DEGREES")
      ->check(number(0, 57))
      ->default_str("11.5");
  command.add_option("--ground", plot.groundShare, "Share of the points of a plot on its ground")
      ->type_name("SHARE")
      ->check(number(0, 0.95))
      ->capture_default_str();
  command.add_option("--poles", plot.poles, "Poles in a plot, 0 to 100")
      ->type_name("N")
      ->check(wholeNumber(0, 100))
      ->capture_default_str();
  command.add_option("--wires", plot.wires, "Wires over a plot, 0 to 100")
      ->type_name("N")
      ->check(wholeNumber(0, 100))
      ->capture_default_str();
}

constexpr double infinity = std::numeric_limits<double>::infinity();

void addGrowth(CLI::App& command, GrowthOptions& growth) {
  addChoice(command, "--architecture", growth.architecture,
            "Kind of plant to grow, or whose foliage to give the structure",
            {{"broadleaf", Architecture::broadleaf},
             {"conifer", Architecture::conifer},
             {"shrub", Architecture::shrub},
             {"herb", Architecture::herb}});
  command.add_option("--height", growth.height, "Height of the grown plant, in any unit")
      ->type_name("LENGTH")
      ->check(number(1e-6, 1e9))
      ->capture_default_str();
  command
      .add_option("--segments", growth.segments,
                  "Unbranched chains of the grown plant at least, 1 to 20000")
      ->type_name("N")
      ->check(wholeNumber(1, 20000))
      ->capture_default_str();
}

void addScanner(CLI::App& command, ScannerOptions& scanner) {
  command
      .add_option("--points", scanner.points,
                  "Points wanted of all stations together, 10 to 100000000")
      ->type_name("N")
      ->check(wholeNumber(10, 1e8))
      ->capture_default_str();
  command.add_option("--stations", scanner.stations, "Places the scanner looks from, 1 to 100")
      ->type_name("N")
      ->check(wholeNumber(1, 100))
      ->capture_default_str();
  command
      .add_option("--strays", scanner.strayShare, "Share of points that lie on nothing, 0 to 0.5")
      ->type_name("SHARE")
      ->check(number(0, 0.5))
      ->capture_default_str();
  command
      .add_option("--clumps", scanner.clumps,
                  "Clumps of leaves, 0 to 1000, that hid wood and are not in the scan")
      ->type_name("N")
      ->check(wholeNumber(0, 1000))
      ->capture_default_str();
}

void addLeaves(CLI::App& command, SimulateFlags& flags) {
  command
      .add_option("--petiole", flags.petiole,
                  "Length of the petioles of leaves, in lengths of their blades, 0 to 10")
      ->type_name("LENGTHS")
      ->check(number(0, 10))
      ->capture_default_str();
  command
      .add_option("--leaflets", flags.leaflets,
                  "Pairs of leaflets along the petiole of a compound leaf, 0 to 100")
      ->type_name("N")
      ->check(wholeNumber(0, 100))
      ->capture_default_str();
  command
      .add_option("--droop", flags.droop,
                  "How far a blade bends to the ground along its length, 0 to 229; with it, blades "
                  "are straps that are as wide all along")
      ->type_name("DEGREES")
      ->check(number(0, 229))
      ->capture_default_str();
}

void addFoliage(CLI::App& command, SimulateFlags& flags) {
  command
      .add_option("--foliage", flags.foliage,
                  "Needles, leaves and short shoots that are in the scan, not in the truth: 1 as "
                  "the kind of plant bears them, 2 twice as many")
      ->type_name("DENSITY")
      ->check(number(0, 20))
      ->capture_default_str();
  command
      .add_option("--foliage-length", flags.foliageLength,
                  "Length of needles and leaves, in heights or widths of the plant, the larger")
      ->type_name("SHARE")
      ->check(number(1e-4, 1))
      ->default_str("of the kind, 0.011 to 0.03");
  command
      .add_option("--foliage-angle", flags.foliageAngle,
                  "Angle of needles, leaves and short shoots with the wood")
      ->type_name("DEGREES")
      ->check(number(0, 180))
      ->default_str("of the kind, 45 to 60");
  command
      .add_option("--foliage-width", flags.foliageWidth,
                  "Width of needles and leaves where they are widest, likewise")
      ->type_name("SHARE")
      ->check(number(0, 1))
      ->default_str("of the kind, 0.0005 to 0.01");
  command
      .add_option("--foliage-gap", flags.foliageGap,
                  "Between needles or leaves along the wood, likewise; --foliage 2 halves that of "
                  "the kind")
      ->type_name("SHARE")
      ->check(number(1e-5, 1))
      ->default_str("of the kind, 0.0015 to 0.04");
  command
      .add_option("--foliage-reach", flags.foliageReach,
                  "How far from the tips of the wood needles and leaves stand, likewise; 10: "
                  "everywhere")
      ->type_name("SHARE")
      ->check(number(0, 100))
      ->default_str("of the kind, 0.12 to 0.5");
  addLeaves(command, flags);
}

} // namespace

void addSimulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Grow a plant, or take a structure, and scan it, so that the truth is known");
  const auto flags = std::make_shared<SimulateFlags>();
  addOutput(*command, flags->prefix,
            "Prefix of the files written: PREFIX.ply, the scan, and "
            "PREFIX.mtg, the truth")
      ->type_name("PREFIX");
  command->add_option("--seed", flags->seed, "The same seed gives the same plant and scan")
      ->type_name("N")
      ->check(wholeNumber(0, 1e15))
      ->capture_default_str();
  command->add_option("--from", flags->from, "Structure to scan instead of growing one")
      ->type_name("FILE");
  addGrowth(*command, flags->growth);
  for (const char* ofGrowth : {"--height", "--segments"})
    command->get_option("--from")->excludes(command->get_option(ofGrowth));
  addScanner(*command, flags->scanner);
  addFoliage(*command, *flags);
  addPlot(*command, *flags);
  command
      ->add_option("--noise", flags->noise,
                   "Standard deviation of the range, in the unit of the plant")
      ->type_name("LENGTH")
      ->check(number(0, infinity))
      ->default_str("extent / 2500");
  command
      ->add_option("--apart", flags->apart,
                   "Save each station by itself, PREFIX_1.ply and on: the second and all behind it "
                   "are turned about the upright axis and shifted; PREFIX_pairs.csv has targets "
                   "for register")
      ->type_name("SHIFT,DEGREES");
  addThreads(*command, flags->threads);
  command->callback([flags] { simulate(*flags); });
  command->footer("Examples:\n"
                  "  espalier simulate -o maple --seed 7 --points 200000\n"
                  "  espalier simulate -o pine_again --from pine.mtg\n"
                  "  espalier simulate -o bean --architecture herb --foliage 1 --petiole 1\n"
                  "  espalier simulate -o orchard --plants 6 --points 1000000\n"
                  "  espalier simulate -o maple --stations 3 --apart 0.3,10");
}

} // namespace espalier
