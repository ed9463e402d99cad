#include "app/about/version.h"
#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/crown_envelope.h"
#include "app/cli/evaluate_command.h"
#include "app/cli/files.h"
#include "app/cli/headless.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "app/report/plant_report.h"
#include "app/report/write_report.h"
#include "core/evaluate/compartments.h"
#include "core/evaluate/trait_rows.h"
#include "core/evaluate/traits/breast_height.h"
#include "core/evaluate/traits_json.h"
#include "core/pipeline/typed_value.h"

#include <QDate>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <memory>
#include <numbers>

namespace espalier {
namespace {

struct TraitsFlags {
  std::string file;
  UpAxis up = UpAxis::z;
  bool light = false;
  int pixels = LightOptions().pixels;
  std::string unit;
  double density = 0;   // of the wood [kg / m^3]; 0: not known
  std::string envelope; // the kind about its crown; empty: none
  std::string csv;
  std::string json;
  ReportFlags report;
  int threads = 0;
};

void requireOutputs(const TraitsFlags& flags) {
  requireApart({flags.csv, flags.json, flags.report.file});
  for (const std::string& file : {flags.csv, flags.json})
    requireOutput(file, {flags.file});
  requireReport(flags.report, {flags.file});
}

std::string unitOf(TraitKind kind, const std::string& unit) {
  if (kind == TraitKind::angle) return " deg";
  if (unit.empty() || kind == TraitKind::count || kind == TraitKind::share) return {};
  return ' ' + unit + (kind == TraitKind::area ? "^2" : kind == TraitKind::volume ? "^3" : "");
}

/// The least and the greatest of a class of diameters.
std::string rangeOf(const Compartment& row) {
  std::array<char, 64> text{};
  if (!row.upTo)
    std::snprintf(text.data(), text.size(), "over %.4g", *row.from);
  else
    std::snprintf(text.data(), text.size(), "%.4g to %.4g", row.from.value_or(0), *row.upTo);
  return text.data();
}

std::string titleOf(const CompartmentTable& table) {
  switch (table.kind) {
  case CompartmentTable::Kind::order:
    return "order";
  case CompartmentTable::Kind::diameter:
    return "diameter";
  case CompartmentTable::Kind::mtgClass:
    return "class, scale " + std::to_string(table.scale);
  }
  return {};
}

void printCompartments(const PlantMeasures& measures, const std::string& unit) {
  const bool hasBiomass = measures.density.isKnown();
  const std::string length = "length" + (unit.empty() ? "" : " " + unit);
  const std::string volume = "volume" + (unit.empty() ? "" : " " + unit + "^3");
  for (const CompartmentTable& table : compartments(measures)) {
    std::printf("\n%22s %8s %12s %12s", titleOf(table).c_str(), "edges", length.c_str(),
                volume.c_str());
    std::printf("%s\n", hasBiomass ? "   biomass kg" : "");
    for (const Compartment& row : table.rows) {
      const std::string name = row.name.empty() ? rangeOf(row) : row.name;
      std::printf("%22s %8zu %12.7g %12.7g", name.c_str(), row.wood.edges, row.wood.length,
                  row.wood.volume);
      if (row.biomass) std::printf(" %12.7g", *row.biomass);
      std::printf("\n");
    }
  }
}

void print(const PlantMeasures& measures, const std::string& unit) {
  std::string group;
  for (const TraitRow& row : traitRows(measures)) {
    if (row.group != group) std::printf("%s%s\n", group.empty() ? "" : "\n", row.group.c_str());
    group = row.group;
    const double value =
        row.kind == TraitKind::angle ? row.value * 180 / std::numbers::pi : row.value;
    std::printf("  %-28s %12.7g%s\n", row.label.c_str(), value, unitOf(row.kind, unit).c_str());
  }
  const std::vector<AxisTraits>& axes = measures.traits.axes;
  std::printf("\n%7s %8s %12s %12s %12s\n", "order", "axes", "mean length", "mean chord",
              "leaves at");
  for (std::size_t order = 0; order < axes.size(); ++order)
    std::printf("%7zu %8zu %12.7g %12.7g %12.4f\n", order, axes[order].count,
                axes[order].meanLength, axes[order].meanChord, axes[order].meanInsertion);
  printCompartments(measures, unit);
}

/// About the points of the scan, where one is given.
ReportedEnvelope envelopeOf(const PlantReportData& data, const TraitsFlags& flags,
                            const Progress& progress) {
  const EnvelopeKind& kind = envelopeKindNamed(flags.envelope);
  const EnvelopedPlant plant =
      data.scan ? ofPoints(*data.scan, {}, flags.up, progress) : ofSkeleton(data.plant, flags.up);
  return {.kind = kind.form.name,
          .label = kind.form.label,
          .isOfSkeleton = plant.isOfSkeleton,
          .isUsual = true,
          .envelope = envelopeAbout(plant.places, flags.up, kind,
                                    valuesSet(kind, {}, plant, flags.unit), progress)};
}

/// @throws WrongUsage if nobody can say how much a volume is
WoodDensity densityOf(const TraitsFlags& flags) {
  if (flags.density == 0) return {};
  if (flags.unit.empty())
    throw WrongUsage("--density is in kg per cubic meter: say what unit the structure is in by "
                     "--unit");
  return {.perCubicMeter = flags.density, .meters = metersIn(flags.unit)};
}

PlantReportAbout aboutOf(const TraitsFlags& flags) {
  PlantReportAbout about;
  about.plant = reportedFile(flags.file);
  if (!flags.report.scan.empty()) about.scan = reportedFile(flags.report.scan);
  about.date = QDate::currentDate().toString(Qt::ISODate);
  about.version = QString::fromStdString(programVersion());
  about.unit = QString::fromStdString(flags.unit);
  return about;
}

void writeReport(const TraitsFlags& flags, const PlantReportData& data,
                 const PlantReportAbout& about, const Progress& progress) {
  const Headless headless;
  PictureSession session(data.plant, data.scan, data.up, about.unit);
  do
    progress.update(session.done());
  while (session.drawNext());
  writePlantReport(flags.report.file, data, session.pictures(), about);
  printWritten(flags.report.file);
}

void measure(const TraitsFlags& flags) {
  const WoodDensity density = densityOf(flags);
  requireOutputs(flags);
  const Threads threads(flags.threads);
  const TerminalProgress terminal;
  const Progress& whole = terminal.progress();
  PlantReportData data{.plant = skeletonIn(flags.file),
                       .up = flags.up,
                       .measures = {},
                       .pixels = flags.pixels,
                       .scan = scanFor(flags.report, whole.part(0, 0.1, "Reading"))};
  PlantMeasureOptions options{.up = flags.up,
                              .breastHeight = breastHeightIn(flags.unit),
                              .light = std::nullopt,
                              .density = density};
  if (flags.light) options.light = LightOptions{.pixels = flags.pixels};
  data.measures =
      about(flags.file, [&] { return plantMeasures(data.plant, options, whole.part(0.1, 0.6)); });
  if (!flags.envelope.empty())
    data.envelope = about(flags.report.scan.empty() ? flags.file : flags.report.scan, [&] {
      return envelopeOf(data, flags, whole.part(0.6, 0.7, "Envelope"));
    });
  printNotes(eachInEnglish(data.measures.warnings));
  terminal.clear();
  print(data.measures, flags.unit);
  if (data.envelope) {
    std::printf("\ncrown envelope: %s, about the %s\n", data.envelope->label.c_str(),
                data.envelope->isOfSkeleton ? "skeleton" : "points");
    printEnvelope(data.envelope->envelope, flags.unit);
  }
  const PlantReportAbout reportAbout = aboutOf(flags);
  const nlohmann::ordered_json json = numbersOf(data, reportAbout);
  if (!flags.csv.empty()) writeTable(flags.csv, tableOf(json));
  writeJson(flags.json, json);
  if (!flags.report.file.empty())
    writeReport(flags, data, reportAbout, whole.part(0.7, 1, "Drawing"));
}

} // namespace

void addTraits(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "traits", "Measure one plant by itself: sizes, axes, angles, wood and light");
  const auto flags = std::make_shared<TraitsFlags>();
  command->add_option("PLANT", flags->file, "A structure, in any format that is read")->required();
  addLight(*command, flags->light, flags->pixels,
           "Measure how much of its surface it shows to an overcast sky (STAR)");
  addChoice(*command, "--up", flags->up, "Axis that points up",
            {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}});
  addUnit(*command, flags->unit,
          "Unit of the structure: named with the numbers, and sets where breast height is");
  command
      ->add_option("--density", flags->density,
                   "Dry mass of the wood in kg per cubic meter, for biomass; needs --unit")
      ->type_name("KG")
      ->check(number(1, 2000));
  addEnvelopeKind(*command, "--envelope", flags->envelope,
                  "Measure a closed surface about the plant, about the points of --scan if there "
                  "are some; espalier envelope takes options of its kind");
  addNumberFiles(*command, flags->csv, flags->json);
  addReport(*command, flags->report);
  addThreads(*command, flags->threads);
  command->callback([flags] {
    flags->unit = unitOfPlant(flags->file, flags->unit);
    measure(*flags);
  });
  command->footer("Lengths are in the unit of the structure. Beside a reference: espalier "
                  "evaluate.\n\n"
                  "Examples:\n"
                  "  espalier traits pine.mtg --unit m --density 420\n"
                  "  espalier traits pine.mtg --light --json numbers.json --csv numbers.csv\n"
                  "  espalier traits pine.mtg --light --scan pine.ply --report pine.html\n"
                  "  espalier traits pine.mtg --scan pine.ply --envelope alpha");
}

} // namespace espalier
