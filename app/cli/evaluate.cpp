#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/evaluate_command.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/evaluate/match/edit_comparison.h"
#include "core/evaluate/study/ranking.h"

#include <memory>

namespace espalier {
namespace {

void requireSense(const EvaluateFlags& flags) {
  if (flags.files.size() < 2) throw CLI::RequiredError("REFERENCE");
  const bool isRanking = flags.ranks || flags.files.size() > 2;
  if (!isRanking && !flags.rankBy.empty())
    throw WrongUsage("--rank-by sets how several structures are ranked: give more of them, or "
                     "--ranking");
  requireApart({flags.csv, flags.json, flags.mapping, flags.report.file});
}

void evaluate(const EvaluateFlags& flags) {
  requireSense(flags);
  if (flags.merges && flags.editCost == "topology" && flags.editUnit == "axis")
    printNotes(
        {"--merge-paths changes nothing with --edit-unit axis and --edit-cost topology, where "
         "each joint costs as much as the axis it saves: choose segments, or another cost"});
  const Threads threads(flags.threads);
  std::vector<std::string> read = flags.files;
  if (!flags.report.scan.empty()) read.push_back(flags.report.scan);
  for (const std::string& file : {flags.csv, flags.json, flags.mapping})
    requireOutput(file, read);
  requireReport(flags.report, flags.files);
  const TerminalProgress terminal;
  if (flags.ranks || flags.files.size() > 2)
    evaluateMany(flags, terminal);
  else
    evaluateOne(flags, terminal);
}

void addRegistration(CLI::App& command, EvaluateFlags& flags) {
  command.add_flag("--no-register", flags.noRegister,
                   "Compare the two where they lie; without it the plant is first laid on the "
                   "reference");
  addNoRotate(command, flags.noRotate);
  addChoice(command, "--up", flags.up,
            "Axis of the files that points up: heights are along it, and a turn by any angle "
            "about it is found",
            {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
  command
      .add_option("--shift", flags.shift,
                  "Move the plant by this to lie on the reference, rather than by what is found")
      ->type_name("X,Y,Z");
  command
      .add_option("--turn", flags.turn,
                  "Turn the plant by this about an axis through the middle of its box, before "
                  "--shift, rather than by what is found")
      ->type_name("X,Y,Z,DEGREES");
}

void addEdits(CLI::App& command, EvaluateFlags& flags) {
  command
      .add_option("--edit-unit", flags.editUnit,
                  "What the edit distance edits: node, segment or axis")
      ->check(oneOf(editUnitNames()))
      ->type_name("UNIT");
  command
      .add_option("--edit-cost", flags.editCost,
                  "What an edit costs: topology, attributes, length, place or shape")
      ->check(oneOf(editCostNames()))
      ->type_name("COST");
  command.add_flag(
      "--merge-paths", flags.merges,
      "Let one part stand for up to three that follow each other, as where a spur cuts "
      "a segment in two");
  command
      .add_option("--mapping", flags.mapping,
                  "File to write to which part stands for which, and what is removed and inserted")
      ->type_name("FILE");
}

void addRanking(CLI::App& command, EvaluateFlags& flags) {
  command.add_flag("--ranking", flags.ranks,
                   "Rank the structures, as is done where there are several");
  command
      .add_option("--rank-by", flags.rankBy,
                  "Score to rank by: " + CLI::detail::join(keysOf(rankedScores()), ", "))
      ->type_name("NAME")
      ->check(oneOf(keysOf(rankedScores())))
      ->default_str(std::string(leadingScore));
  command
      .add_option("--draws", flags.draws,
                  "How often segments are drawn for the intervals of a ranking, 1 to 1000000")
      ->type_name("N")
      ->check(wholeNumber(1, 1e6))
      ->capture_default_str();
  command.add_option("--seed", flags.seed, "The same seed gives the same draws")
      ->type_name("N")
      ->check(wholeNumber(0, 1e15))
      ->capture_default_str();
}

} // namespace

void addEvaluate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "evaluate", "Measure a skeleton against a reference structure, or rank several");
  const auto flags = std::make_shared<EvaluateFlags>();
  command
      ->add_option(
          "RESULT... REFERENCE", flags->files,
          "Structures to judge, in any format that is read, and last the one that is taken as true")
      ->expected(1, 10000)
      ->required();
  addRegistration(*command, *flags);
  command
      ->add_option("--scale", flags->scale,
                   "Multiply all but the reference by this first, as by 0.001 from mm to m")
      ->type_name("FACTOR")
      ->check(number(1e-12, 1e12));
  addUnit(*command, flags->unit,
          "Unit of the structures: named with the numbers, and sets where breast height is");
  command
      ->add_option("--distance", flags->distance,
                   "How far apart counts as near, for the report, the ranking and --where")
      ->type_name("LENGTH")
      ->check(number(1e-12, 1e12))
      ->default_str("2/9 of the median edge");
  addEdits(*command, *flags);
  command->add_flag("--where", flags->where,
                    "Report by order, height and radius where the two agree");
  command->add_flag("--traits", flags->traits,
                    "Report sizes, Strahler numbers, branching angles and crown of both");
  addLight(*command, flags->light, flags->pixels,
           "Measure how much of its surface each shows to an overcast sky (STAR)");
  addRanking(*command, *flags);
  addNumberFiles(*command, flags->csv, flags->json);
  addReport(*command, flags->report);
  const CLI::Validator isNamed(
      [](const std::string& name) {
        return name.empty() ? std::string("expected the name of a file") : std::string();
      },
      "");
  for (const char* option : {"--csv", "--json", "--report"})
    command->get_option(option)->check(isNamed);
  addThreads(*command, flags->threads);
  command->callback([flags] {
    flags->unit = unitOfPlant(flags->files.back(), flags->unit);
    evaluate(*flags);
  });
  command->footer("Lengths are in the unit of the structures.\nOne plant without a reference: "
                  "espalier traits.\n\n"
                  "Examples:\n"
                  "  espalier evaluate pine.mtg expert.mtg --json numbers.json\n"
                  "  espalier evaluate pine.mtg expert.mtg --scan pine.ply --report pine.html\n"
                  "  espalier evaluate a.mtg b.mtg c.mtg expert.mtg --csv ranking.csv");
}

} // namespace espalier
