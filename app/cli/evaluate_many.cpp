#include "app/cli/arguments.h"
#include "app/cli/evaluate_command.h"
#include "app/cli/evaluate_numbers.h"
#include "app/cli/evaluate_text.h"
#include "app/cli/files.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/study/ranking.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

/// A line for each result that little of lies near the reference once it was laid on it.
std::vector<std::string> poorFits(const Ranking& ranking, const std::vector<std::string>& names) {
  std::vector<std::string> lines;
  for (const RankedResult& result : ranking.results)
    if (result.registration)
      if (const auto warning = warningOfFit(*result.registration))
        lines.push_back(names.at(result.result) + ": " + inEnglish(*warning));
  return lines;
}

} // namespace

void evaluateMany(const EvaluateFlags& flags, const TerminalProgress& terminal) {
  if (flags.where || flags.merges || flags.traits || flags.light || !flags.mapping.empty())
    throw WrongUsage(
        "--where, --traits, --light, --merge-paths and --mapping are for one plant: leave them "
        "out, or give one");
  if (!flags.shift.empty() || !flags.turn.empty())
    throw WrongUsage("--shift and --turn are of one plant: leave them out, or give one");
  if (!flags.report.scan.empty())
    throw WrongUsage("--scan is of one plant: leave it out, or give one");
  const std::vector<std::string> names(flags.files.begin(), flags.files.end() - 1);
  const Skeleton reference = skeletonIn(flags.files.back());
  const Traits expected = traits(reference);
  std::vector<Skeleton> results;
  std::vector<std::string> notes;
  for (const std::string& name : names) {
    results.push_back(skeletonIn(name, flags.scale));
    const Traits found = traits(results.back());
    for (const auto& warning :
         {warningOfTrees(found, ComparedAs::plant), warningOfSize(found, expected)})
      if (warning) notes.push_back(name + ": " + inEnglish(*warning));
  }
  printNotes(notes);
  const Ranking found =
      ranking(results, reference,
              {.registers = !flags.noRegister,
               .registration = registrationIn(flags),
               .by = flags.rankBy.empty() ? std::string(leadingScore) : flags.rankBy,
               .distance = flags.distance,
               .draws = flags.draws,
               .seed = flags.seed},
              terminal.progress());
  terminal.clear();
  const std::vector<std::string> ofFits = poorFits(found, names);
  printNotes(ofFits);
  notes.insert(notes.end(), ofFits.begin(), ofFits.end());
  print(found, names, flags.unit);
  writeTable(flags.csv, toTable(found, names));
  auto json = toJson(found, names);
  json["reference"] = flags.files.back();
  if (!flags.json.empty()) addOrigin(json, {names, flags.files.back(), {}, flags.unit, true});
  writeJson(flags.json, json);
  if (flags.report.file.empty()) return;
  writeReport(flags.report, rankingReportData(found, results, reference, !flags.noRegister),
              {names, flags.files.back(), flags.unit, flags.scale, notes});
}

} // namespace espalier
