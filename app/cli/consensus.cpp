#include "core/evaluate/differences/consensus.h"

#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/evaluate/match/comparable.h"
#include "core/skeleton/bounds.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <system_error>

namespace espalier {
namespace {

struct ConsensusFlags {
  std::vector<std::string> plants;
  std::string output;
  std::string json;
  double distance = 0; // [L]; 0: by the rule
  MtgStyle mtgStyle = MtgStyle::plantNode;
};

/// "99.9": 100 stands for all of it, but for what rounding leaves.
std::string percentOf(double share) {
  constexpr double rounding = 1e-6;
  return plainDecimal(std::floor(1000 * share + rounding) / 10);
}

nlohmann::ordered_json numbersOf(const ConsensusFlags& flags, const Consensus& consensus,
                                 double tolerance) {
  nlohmann::ordered_json plants = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < flags.plants.size(); ++i)
    plants.push_back({{"file", flags.plants[i]}, {"agreed", consensus.shares[i]}});
  nlohmann::ordered_json places = nlohmann::ordered_json::array();
  for (const Disagreement& place : consensus.places)
    places.push_back({{"with", flags.plants[place.with]},
                      {"kind", nameOf(place.kind)},
                      {"length", place.length},
                      {"place", {place.at.x(), place.at.y(), place.at.z()}}});
  return {{"distance", tolerance},
          {"plants", plants},
          {"nodes", consensus.agreed.size()},
          {"trees", consensus.agreed.roots().size()},
          {"length", totalLength(consensus.agreed)},
          {"places", places}};
}

void requireDifferentFiles(const std::vector<std::string>& files) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    std::error_code unresolved;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(file, unresolved);
    if (!seen.insert(unresolved ? std::filesystem::path(file) : whole).second)
      throw Error(file + ": is named twice: name each plant once");
  }
}

constexpr const char* checkFrames =
    ": check that all are in one frame and unit, or give a larger --distance";

void requireOneUnit(const std::vector<std::string>& files, const std::vector<Skeleton>& plants) {
  const auto other = inOtherUnit(plants);
  if (!other) return;
  const bool isLarger =
      bounds(plants[*other]).diagonal().norm() > bounds(plants[0]).diagonal().norm();
  throw Error(files[*other] + ": is " + (isLarger ? "far larger" : "far smaller") + " than " +
              files[0] + checkFrames);
}

void requireShares(const std::vector<std::string>& files, const Consensus& consensus) {
  if (const auto stranger = withoutAgreement(consensus))
    throw Error(files[*stranger] + ": the others have none of its wood within the distance" +
                checkFrames);
}

void writeConsensus(const ConsensusFlags& flags) {
  if (flags.plants.size() < 2)
    throw WrongUsage("a consensus is of two plants at least: name another file");
  requireApart({flags.output, flags.json});
  requireOutput(flags.output, Content::structure, flags.plants);
  requireOutput(flags.json, flags.plants);
  requireDifferentFiles(flags.plants);
  const TerminalProgress terminal;
  std::vector<Skeleton> plants;
  for (const std::string& file : flags.plants) {
    plants.push_back(plantIn(file).skeleton);
    requireComparable(plants.back(), file);
  }
  requireOneUnit(flags.plants, plants);
  const double tolerance = flags.distance > 0 ? flags.distance : usualDistance(plants);
  const Consensus consensus = consensusOf(plants, tolerance, terminal.progress());
  terminal.check();
  terminal.clear();
  requireShares(flags.plants, consensus);
  for (std::size_t i = 0; i < flags.plants.size(); ++i)
    printLine(flags.plants[i] + ": agreed on " + percentOf(consensus.shares[i]) +
              " % of its length");
  printLine(counted(consensus.places.size(), "place") + " to decide; " +
            counted(consensus.agreed.roots().size(), "tree"));
  const Structure agreed{.skeleton = consensus.agreed};
  writeAndReport(flags.output, agreed, flags.mtgStyle);
  if (!flags.json.empty()) writeJson(flags.json, numbersOf(flags, consensus, tolerance));
}

} // namespace

void addConsensus(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "consensus", "Write the wood on which several structures of one plant agree");
  const auto flags = std::make_shared<ConsensusFlags>();
  command
      ->add_option("PLANT", flags->plants,
                   "Structures or projects of one plant in one frame, two or more. What is written "
                   "lies where the first has it")
      ->required();
  addOutput(*command, flags->output, "Structure to write, in the format of its extension");
  command->add_option("--distance", flags->distance, "How far apart counts as the same wood")
      ->type_name("LENGTH")
      ->check(number(1e-12, 1e12))
      ->default_str("2/9 of the longest median edge");
  command->add_option("--json", flags->json, "Write shares and places that differ as JSON")
      ->type_name("FILE");
  addMtgStyle(*command, flags->mtgStyle);
  command->callback([flags] { writeConsensus(*flags); });
  command->footer("Nothing is registered: experts of one scan have one frame.\n\n"
                  "Examples:\n"
                  "  espalier consensus anna.espalier ben.espalier -o agreed.mtg\n"
                  "  espalier consensus a.mtg b.mtg c.mtg -o agreed.mtg --json places.json");
}

} // namespace espalier
