#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/crown_envelope.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "app/report/envelope_numbers.h"
#include "core/base/text.h"
#include "core/io/structures/surface_files.h"
#include "core/pipeline/envelopes.h"
#include "core/pipeline/plant_scale.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

namespace espalier {
namespace {

enum class EnvelopeOf { plant, points, skeleton };

struct EnvelopeFlags {
  std::string plant;
  std::string output;
  std::string kind = "convex";
  EnvelopeOf of = EnvelopeOf::plant;
  std::vector<std::string> settings;
  UpAxis up = UpAxis::z;
  std::string unit;
  std::string json;
  int threads = 0;
};

EnvelopedPlant envelopedInProject(const EnvelopeFlags& flags, const Progress& progress) {
  const Project project = Project::open(flags.plant, Access::readOnly);
  const Imported<History> history = project.history();
  printNotes(history.notes);
  if (flags.of != EnvelopeOf::skeleton)
    if (const auto points = pointsOf(project, history.value.leftOut, progress))
      return ofPoints(*points, {}, flags.up, progress);
  if (flags.of == EnvelopeOf::points)
    throw Error(flags.plant + ": the points of its scan cannot be read: put the file beside it, or "
                              "take --of skeleton");
  return ofSkeleton(history.value.skeleton, flags.up);
}

EnvelopedPlant envelopedIn(const EnvelopeFlags& flags, const Progress& progress) {
  if (isProject(flags.plant)) return envelopedInProject(flags, progress);
  if (formatOf(flags.plant).content == Content::points) {
    if (flags.of == EnvelopeOf::skeleton)
      throw WrongUsage(flags.plant + " holds points: leave out --of skeleton");
    auto points = readPoints(flags.plant, progress);
    printNotes(points.notes);
    return ofPoints(points.value, {}, flags.up, progress);
  }
  if (flags.of == EnvelopeOf::points)
    throw WrongUsage(flags.plant + " holds a structure: leave out --of points");
  return ofSkeleton(plantIn(flags.plant).skeleton, flags.up);
}

std::string meshExtension(const std::string& path) {
  const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
  if (extension != ".ply" && extension != ".obj")
    throw Error(path + ": envelopes are written as PLY or OBJ: choose a name that ends in .ply or "
                       ".obj");
  return extension;
}

nlohmann::ordered_json numbersOf(const Envelope& envelope, const EnvelopedPlant& plant,
                                 const EnvelopeFlags& flags) {
  using Json = nlohmann::ordered_json;
  Json json = {{"kind", flags.kind},
               {"of", plant.isOfSkeleton ? "skeleton" : "points"},
               {"unit", flags.unit.empty() ? Json() : Json(flags.unit)},
               {"points", plant.places.cols()}};
  json.update(numbersOf(envelope));
  return json;
}

void drawEnvelope(const EnvelopeFlags& flags) {
  const EnvelopeKind& kind = envelopeKindNamed(flags.kind);
  requireApart({flags.output, flags.json});
  std::string extension;
  if (!flags.output.empty()) extension = meshExtension(flags.output);
  for (const std::string& file : {flags.output, flags.json})
    requireOutput(file, {flags.plant});
  const Threads threads(flags.threads);
  const TerminalProgress terminal;
  const Progress& whole = terminal.progress();
  const EnvelopedPlant plant = envelopedIn(flags, whole.part(0, 0.3, "Reading"));
  const std::vector<double> values = valuesSet(kind, flags.settings, plant, flags.unit);
  const Envelope envelope = about(flags.plant, [&] {
    return envelopeAbout(plant.places, flags.up, kind, values, whole.part(0.3, 1, "Envelope"));
  });
  terminal.check();
  terminal.clear();
  printEnvelope(envelope, flags.unit);
  writeAndReport(
      flags.output,
      [&](std::ostream& out) {
        extension == ".ply" ? writePlySurface(out, envelope.mesh)
                            : writeObjSurface(out, envelope.mesh);
      },
      std::to_string(envelope.mesh.triangles.size()) + " triangles");
  writeJson(flags.json, numbersOf(envelope, plant, flags));
}

/// Words in lines of at most 80 columns, each begun by six blanks.
std::string inLines(const std::string& text) {
  constexpr std::size_t widest = 80;
  const std::string begin(6, ' ');
  std::istringstream words(text);
  std::string lines;
  std::string line = begin;
  for (std::string word; words >> word; line += word) {
    if (line.size() + 1 + word.size() > widest) {
      lines += line + "\n";
      line = begin;
    } else if (line != begin) {
      line += " ";
    }
  }
  return lines + line + "\n";
}

/// Kinds and their options, for the help.
std::string listOfKinds() {
  std::string text = "Kinds, with their options for --set:\n";
  for (const EnvelopeKind& kind : envelopeKinds()) {
    std::string names;
    for (const Option& option : kind.form.options)
      names += (names.empty() ? "" : ", ") + option.name + "=" + option.ruleText();
    text += "  " + kind.form.name + ":\n" + inLines(kind.form.help) + inLines(names);
  }
  return text;
}

} // namespace

void addEnvelope(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "envelope", "Draw a closed surface about a plant, and measure its volume and area");
  const auto flags = std::make_shared<EnvelopeFlags>();
  command->add_option("PLANT", flags->plant, "A scan, a structure or a project")->required();
  command->add_option("-o,--output", flags->output, "Surface to write, as .ply or .obj");
  addEnvelopeKind(*command, "--kind", flags->kind, "What to draw")->capture_default_str();
  addChoice(*command, "--of", flags->of,
            "What it is about; a plant has its points, where it has some",
            {{"plant", EnvelopeOf::plant},
             {"points", EnvelopeOf::points},
             {"skeleton", EnvelopeOf::skeleton}});
  command->add_option("--set", flags->settings, "Set an option of the kind: OPTION=VALUE")
      ->type_name("OPTION=VALUE")
      ->allow_extra_args(false);
  addChoice(*command, "--up", flags->up, "Axis that points up",
            {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
  addUnit(*command, flags->unit, "Unit of the plant, to be named with the numbers");
  command->add_option("--json", flags->json, "File for all numbers");
  addThreads(*command, flags->threads);
  command->callback([flags] {
    flags->unit = unitOfPlant(flags->plant, flags->unit);
    drawEnvelope(*flags);
  });
  command->footer(listOfKinds() +
                  "\nExamples:\n"
                  "  espalier envelope pine.ply --kind alpha --set radius=0.3 -o crown.ply\n"
                  "  espalier envelope pine.mtg --kind asymmetric --json crown.json\n"
                  "  espalier envelope pine.espalier --of skeleton --kind cone --unit m");
}

} // namespace espalier
