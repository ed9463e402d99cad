#include "app/cli/commands.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>

namespace espalier {
namespace {

void writeStatistics(const PipelineFlags& flags, const PointCloud& cloud,
                     const Reconstruction& result, const TerminalProgress& terminal) {
  if (flags.json.empty()) return;
  nlohmann::ordered_json json = {
      {"scan", flags.scan},
      {"unit", flags.unit.empty() ? nlohmann::json(nullptr) : nlohmann::json(flags.unit)},
      {"cloud", statistics(cloud)}};
  if (!result.skeleton.isEmpty()) json["skeleton"] = statistics(result.skeleton);
  json.update(statistics(result, terminal.stageSeconds()));
  writeAtomically(flags.json, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

void reconstruct(const PipelineFlags& flags) {
  const Threads threads(flags.threads);
  const PipelineOptions options = flags.options("skeleton");
  (void)formatToWrite(flags.output, Content::structure); // before the work, not after it
  const TerminalProgress terminal;
  auto scan = readPoints(flags.scan, terminal.progress().part(0, 0.2, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const Reconstruction result = Pipeline().run(cloud, options, terminal.progress().part(0.2, 1));
  writeStructure(flags.output, result.skeleton);
  writeStatistics(flags, *cloud, result, terminal);
}

void contract(const PipelineFlags& flags) {
  const Threads threads(flags.threads);
  const PipelineOptions options = flags.options("contract");
  (void)formatToWrite(flags.output, Content::points);
  const TerminalProgress terminal;
  auto scan = readPoints(flags.scan, terminal.progress().part(0, 0.2, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const Reconstruction result =
      Pipeline().run(cloud, options, terminal.progress().part(0.2, 1), "contract");
  writePoints(flags.output, *cloud, *result.contracted);
  writeStatistics(flags, *cloud, result, terminal);
}

void add(CLI::App& app, const std::string& name, const std::string& help,
         void (*run)(const PipelineFlags&)) {
  CLI::App* command = app.add_subcommand(name, help);
  const auto flags = std::make_shared<PipelineFlags>();
  flags->addTo(*command);
  command->callback([flags, run] { run(*flags); });
}

} // namespace

void addReconstruct(CLI::App& app) {
  add(app, "reconstruct", "Find the skeleton of a scanned plant, with radii", reconstruct);
}

void addContract(CLI::App& app) {
  add(app, "contract", "Pull the points of a scan towards the axes of the plant", contract);
}

} // namespace espalier
