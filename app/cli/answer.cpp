#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/evaluate_command.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/doubt/doubts_of.h"
#include "core/doubt/interview.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/scores.h"
#include "core/graph/turn_upright.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <memory>

namespace espalier {
namespace {

const std::vector<std::string>& orderNames() {
  static const std::vector<std::string> names = {"gain", "random", "review"};
  return names;
}

struct AnswerFlags {
  PipelineFlags pipeline;
  std::string oracle;
  std::string plant; // empty: it is reconstructed
  std::string order = "gain";
  int answers = 30;
  std::uint64_t seed = 1;
  double distance = 0; // [L]; 0 = the rule
  bool noRegister = false;
  bool decidesRest = false;
};

/// After how many answers scores are printed.
bool isPrinted(std::size_t answers, std::size_t all) {
  for (std::size_t step = 1; step <= answers; step *= 10)
    if (answers == step || answers == 3 * step) return true;
  return answers == 0 || answers == all || answers % 50 == 0;
}

nlohmann::ordered_json rowOf(const Interview& interview, double distance,
                             const Progress& progress) {
  ComparisonOptions options;
  options.registers = false;
  options.tolerance.distances = {distance};
  ComparedPlants plants(interview.plant(), interview.reference(), options, progress);
  plants.goTo(distance);
  const ScoreValues scores =
      valuesOf({&scoreOf("geometric"), &scoreOf("structural"), &scoreOf("f")}, plants);
  return {{"answers", interview.answers()},
          {"changes", interview.changes()},
          {"doubts_left", interview.doubts().size()},
          {"geometric", scores.at("geometric").value_or(0)},
          {"structural", scores.at("structural").value_or(0)},
          {"f", scores.at("f").value_or(0)},
          {"right",
           agreementWith(interview.reference(), interview.plant(), distance, progress).share()},
          {"expected_right", interview.expected(progress).share()}};
}

void print(const nlohmann::ordered_json& row) {
  std::printf("%8d %8d %8d %10.3f %10.3f %10.3f %10.3f %10.3f\n", row["answers"].get<int>(),
              row["changes"].get<int>(), row["doubts_left"].get<int>(),
              row["geometric"].get<double>(), row["structural"].get<double>(),
              row["f"].get<double>(), row["right"].get<double>(),
              row["expected_right"].get<double>());
  std::fflush(stdout);
}

/// The plant with the marks that it had: what answers settle is marked as reviewed, by nobody.
Skeleton withMarksOf(const Skeleton& before, Skeleton plant) {
  for (const NodeId id : plant.ids())
    plant.setReview(id, before.contains(id) ? before[id].review : ReviewMark());
  return plant;
}

void run(const AnswerFlags& flags) {
  const PipelineFlags& pipeline = flags.pipeline;
  const Threads threads(pipeline.threads);
  const PipelineOptions options = pipeline.options("skeleton");
  const ReadOptions reading = pipeline.read.options();
  const std::vector<std::string> inputs = {pipeline.scan, pipeline.preset, flags.oracle,
                                           flags.plant};
  requireApart({pipeline.output, pipeline.json});
  if (!pipeline.output.empty()) requireOutput(pipeline.output, Content::structure, inputs);
  requireOutput(pipeline.json, inputs);
  const TerminalProgress terminal;
  const Skeleton reference = skeletonIn(flags.oracle);
  auto scan = readPoints(pipeline.scan, reading, terminal.progress().part(0, 0.05, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const Reconstruction found = about(pipeline.scan, [&] {
    return Pipeline().run(cloud, options, terminal.progress().part(0.05, 0.2));
  });
  const Skeleton plant = flags.plant.empty() ? *found.skeleton : skeletonIn(flags.plant);
  const double distance = flags.distance > 0 ? flags.distance : usualTolerance(reference);
  Skeleton laid = reference; // on the plant, which stays with its points
  if (!flags.noRegister)
    laid = moved(reference, registration(plant, reference, {.up = options.up}).motion.inverse());
  const Eigen::Vector3d up = turnUpright(options.up).row(2).transpose();
  const auto order =
      static_cast<AskingOrder>(std::ranges::find(orderNames(), flags.order) - orderNames().begin());
  Interview interview(pointsOf(cloud, found), plant, laid, found.scale, up,
                      {.tolerance = distance, .order = order, .seed = flags.seed},
                      terminal.progress().part(0.2, 0.25, "Finding doubts"));
  auto rows = nlohmann::ordered_json::array();
  const auto all = static_cast<std::size_t>(flags.answers);
  terminal.clear();
  std::printf(
      " answers  changes   doubts  geometric structural          F      right   expected\n");
  for (;;) {
    const std::size_t answers = interview.answers();
    const bool isLast = answers >= all || interview.doubts().empty();
    if (isLast || isPrinted(answers, all)) {
      rows.push_back(rowOf(interview, distance, terminal.progress().part(0.25, 0.25)));
      terminal.clear();
      print(rows.back());
    }
    if (isLast) break;
    const double share = static_cast<double>(answers) / static_cast<double>(all);
    static_cast<void>(interview.askNext(terminal.progress().part(
        0.25 + 0.75 * share, 0.25 + 0.75 * (share + 1 / static_cast<double>(all)), "Answering")));
  }
  nlohmann::ordered_json rest;
  if (flags.decidesRest) {
    interview.decideRest(terminal.progress());
    rest = rowOf(interview, distance, terminal.progress());
    terminal.clear();
    std::printf("the rest decided by the odds as they are learned:\n");
    print(rest);
  }
  terminal.clear();
  writeJson(pipeline.json, {{"scan", pipeline.scan},
                            {"oracle", flags.oracle},
                            {"order", flags.order},
                            {"distance", distance},
                            {"rows", std::move(rows)},
                            {"rest", std::move(rest)}});
  if (!pipeline.output.empty())
    writeAndReport(pipeline.output, {.skeleton = withMarksOf(plant, interview.plant())},
                   pipeline.mtgStyle, pipeline.unit);
}

} // namespace

void addAnswer(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "answer", "Measure what answers are worth: a reference answers what the program asks");
  const auto flags = std::make_shared<AnswerFlags>();
  flags->pipeline.addTo(*command, "Structure to write, as it is after the answers");
  command->get_option("--output")->required(false);
  command->add_option("--oracle", flags->oracle, "Structure that is taken as true, and answers")
      ->required()
      ->type_name("REFERENCE");
  command->add_option("--plant", flags->plant, "Structure to ask about, in the frame of the scan")
      ->type_name("FILE")
      ->default_str("as reconstructed");
  command->add_option("--answers", flags->answers, "How many answers at most")
      ->type_name("N")
      ->check(wholeNumber(0, 100000))
      ->capture_default_str();
  command
      ->add_option("--order", flags->order,
                   "What is asked first: gain, what puts most right; review, as "
                   "a review walks along the plant; random")
      ->type_name("NAME")
      ->check(oneOf(orderNames()))
      ->capture_default_str();
  command->add_option("--seed", flags->seed, "The same seed gives the same random order")
      ->type_name("N")
      ->check(wholeNumber(0, 1e15))
      ->capture_default_str();
  command->add_option("--distance", flags->distance, "How far apart counts as near")
      ->type_name("LENGTH")
      ->check(number(1e-12, 1e12))
      ->default_str("2/9 of the median edge");
  command->add_flag("--no-register", flags->noRegister,
                    "Compare the two where they lie; without it the reference is first laid on "
                    "the plant");
  command->add_flag("--decide-rest", flags->decidesRest,
                    "After the answers, decide what is still in doubt by the odds as they were "
                    "learned from them, and print scores once more");
  command->footer("Example:\n"
                  "  espalier answer pine.las --oracle expert.mtg --answers 100 -o pine.mtg");
  command->callback([flags] { run(*flags); });
}

} // namespace espalier
