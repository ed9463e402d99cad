#include "app/cli/pipeline_flags.h"

#include "app/cli/arguments.h"
#include "app/cli/files.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/pipeline/presets.h"
#include "core/pipeline/typed_value.h"

namespace espalier {
struct Threads::Limit {
  std::optional<ThreadLimit> tbb;
};

Threads::Threads(int threads) : limit_(std::make_unique<Limit>()) {
  if (threads > 0) limit_->tbb.emplace(threads);
}
Threads::~Threads() = default;

void PipelineFlags::addTo(CLI::App& command, const std::string& result) {
  command
      .add_option("SCAN", scan, "Points of one plant, in any format that is read, as PLY or LAS")
      ->required();
  addOutput(command, output, result);
  read.addTo(command);
  addOptionsTo(command);
  addRootTo(command);
  command.add_option("--json", json, "File to write statistics and the options used to")
      ->type_name("FILE");
}

void PipelineFlags::addRootTo(CLI::App& command) {
  command
      .add_option("--root", root,
                  "Foot of the plant: lowest, or X,Y,Z for the point of the scan nearest to there")
      ->type_name("PLACE")
      ->capture_default_str();
}

void PipelineFlags::addOptionsTo(CLI::App& command) {
  command.add_option("--method", method, "Method of the main step (see: espalier methods)")
      ->type_name("NAME");
  command
      .add_option(
          "--set", settings,
          "STEP.OPTION=VALUE, as often as needed; lengths in the unit of the scan, as 6sp for "
          "spacings of its points or, with --unit, as 38mm; angles in degrees (see: espalier "
          "methods)")
      ->type_name("SETTING")
      ->allow_extra_args(false);
  command
      .add_option("--preset", preset,
                  presetNames() +
                      ", or a JSON file of steps and options; --method and --set change it, "
                      "wherever they stand")
      ->type_name("PRESET");
  addChoice(command, "--up", up, "Axis that points up",
            {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
  addUnit(command, unit, "Unit of the scan: lengths can then be set as 38mm");
  addThreads(command, threads);
}

double PipelineFlags::meters() const {
  return metersIn(unit);
}

PipelineOptions PipelineFlags::options(const std::string& stepOfMethod) const {
  PipelineOptions result;
  if (!preset.empty()) result = presetIn(preset, meters());
  try {
    if (!method.empty()) result.set(stepOfMethod + ".method=" + method);
    for (const bool areMethods : {true, false}) // first, in whatever order they are written
      for (const std::string& setting : settings)
        if ((setting.find(".method=") != std::string::npos) == areMethods)
          result.set(setting, meters());
    if (root != "lowest") {
      result.root = placeIn(root);
      if (!result.root)
        throw Error("--root " + inQuotes(root) + ": write lowest, or three numbers as X,Y,Z");
    }
    requireKnown(result);
  } catch (const Error& problem) {
    throw WrongUsage(problem.what());
  }
  result.up = up;
  return result;
}

} // namespace espalier
