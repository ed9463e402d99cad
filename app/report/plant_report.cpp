#include "app/report/plant_report.h"

#include "app/report/report_sections.h"
#include "app/report/write_report.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/evaluate/compartments.h"
#include "core/evaluate/traits_json.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"
#include "ui/document/shown_message.h"
#include "ui/document/shown_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

namespace espalier {
namespace {

struct Parts {
  const PlantReportData& data;
  const ReportPictures& pictures;
  const PlantReportAbout& about;
  ReportNumbers numbers;
};

char axisName(UpAxis up) {
  return "xyz"[static_cast<std::size_t>(up)];
}

QString valueOf(const TraitRow& row, const ReportNumbers& numbers) {
  switch (row.kind) {
  case TraitKind::count:
    return numbers.count(static_cast<std::size_t>(row.value));
  case TraitKind::share:
    return numbers.share(row.value, 5);
  case TraitKind::angle:
    return numbers.degrees(row.value);
  default:
    return numbers.number(row.value);
  }
}

QString sentence(const Parts& parts) {
  const Traits& traits = parts.data.measures.traits;
  const ReportNumbers& numbers = parts.numbers;
  std::size_t axes = 0;
  for (const std::size_t ofOrder : traits.axesByOrder)
    axes += ofOrder;
  const auto counted = [&](std::size_t count, const QString& one, const QString& many) {
    return count == 1 ? ReportText::tr("1 %1").arg(one)
                      : ReportText::tr("%1 %2").arg(numbers.count(count), many);
  };
  return ReportText::tr(
             "The plant is %1 high. It has %2 of a length of %3 in sum, in %4, with %5 and %6.")
      .arg(numbers.length(traits.crown.height),
           counted(axes, ReportText::tr("axis"), ReportText::tr("axes")),
           numbers.length(traits.length),
           counted(traits.axesByOrder.size(), ReportText::tr("order"), ReportText::tr("orders")),
           counted(traits.tips, ReportText::tr("tip"), ReportText::tr("tips")),
           counted(traits.branchings, ReportText::tr("branching"), ReportText::tr("branchings")));
}

ReportKeyNumbers keyNumbers(const Parts& parts) {
  const PlantMeasures& measures = parts.data.measures;
  const Traits& traits = measures.traits;
  const ReportNumbers& numbers = parts.numbers;
  ReportKeyNumbers key{
      {{numbers.length(traits.crown.height), ReportText::tr("height"),
        ReportText::tr("from the lowest node to the highest")},
       {numbers.length(traits.length), ReportText::tr("length of all axes"), {}},
       {numbers.count(traits.axesByOrder.size()), ReportText::tr("orders"), {}},
       {numbers.count(traits.strahler.size()), ReportText::tr("Strahler number"), {}}}};
  if (measures.wood.whole.volume > 0) {
    const QString unit = parts.about.unit;
    const QString volume = numbers.number(measures.wood.whole.volume);
    QString bounds;
    if (measures.volume)
      bounds = ReportText::tr("%1 to %2 in 90 of 100 cases, as radii err")
                   .arg(numbers.number(measures.volume->least, 3),
                        numbers.number(measures.volume->most, 3));
    else if (measures.volumeUnknown > mostUnknownError)
      bounds = ReportText::tr("no bounds: how radii err is unknown in %1 of it")
                   .arg(numbers.percent(measures.volumeUnknown));
    key.numbers.push_back(
        {unit.isEmpty() ? volume : volume + QChar(0x202f) + unit + QStringLiteral("³"),
         ReportText::tr("volume of wood"), bounds});
  }
  if (measures.light)
    key.numbers.push_back({numbers.share(measures.light->star), ReportText::tr("STAR"),
                           ReportText::tr("under an overcast sky")});
  return key;
}

ReportSection summary(const Parts& parts) {
  ReportSection section{ReportText::tr("Summary"), {ReportParagraph{sentence(parts)}}};
  section.blocks.emplace_back(keyNumbers(parts));
  ReportWarnings warnings;
  for (const ShownMessage& warning : parts.data.measures.warnings)
    warnings.lines.append(shownText(warning));
  if (!parts.pictures.problem.isEmpty())
    warnings.lines.append(ReportText::tr("there are no pictures: %1").arg(parts.pictures.problem));
  if (!warnings.lines.isEmpty()) section.blocks.emplace_back(std::move(warnings));
  return section;
}

ReportSection pictures(const Parts& parts) {
  ReportSection section{ReportText::tr("The plant"), {}};
  ReportFigures shown{.across = parts.data.scan ? 3 : 2, .figures = {}};
  const auto add = [&](const QImage& image, const QString& title, const QString& text) {
    if (!image.isNull()) shown.figures.push_back({image, title, text});
  };
  add(parts.pictures.front, ReportText::tr("From the front"), parts.about.plant.name);
  add(parts.pictures.side, ReportText::tr("From the right"),
      ReportText::tr("The same from the side"));
  if (parts.data.scan)
    add(parts.pictures.scan, ReportText::tr("The scan"),
        scanText(parts.about.scan ? parts.about.scan->name : ReportText::tr("points of the plant"),
                 *parts.data.scan, parts.data.up, parts.numbers));
  if (!shown.figures.empty()) section.blocks.emplace_back(std::move(shown));
  return section;
}

/// The axes of each order: how many, and their means.
ReportTable axesTable(const Parts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.caption = ReportText::tr(
      "Axes by order: how many, and their means: along them, straight, where on what "
      "bears them, and radii");
  table.columns = {{ReportText::tr("order"), false},
                   {ReportText::tr("axes")},
                   {numbers.inUnit(ReportText::tr("length"))},
                   {numbers.inUnit(ReportText::tr("chord"))},
                   {ReportText::tr("leaves at")},
                   {numbers.inUnit(ReportText::tr("at the base"))},
                   {numbers.inUnit(ReportText::tr("at the apex"))}};
  const std::vector<AxisTraits>& axes = parts.data.measures.traits.axes;
  for (std::size_t order = 0; order < axes.size(); ++order)
    table.rows.push_back({{QString::number(order)},
                          {numbers.count(axes[order].count)},
                          {numbers.number(axes[order].meanLength)},
                          {numbers.number(axes[order].meanChord)},
                          {numbers.number(axes[order].meanInsertion)},
                          {numbers.number(axes[order].meanBaseRadius)},
                          {numbers.number(axes[order].meanTopRadius)}});
  return table;
}

ReportTable strahlerTable(const Parts& parts) {
  ReportTable table;
  table.caption = ReportText::tr("Streams by Strahler number");
  table.columns = {{ReportText::tr("number"), false},
                   {ReportText::tr("streams")},
                   {parts.numbers.inUnit(ReportText::tr("length in all"))}};
  const std::vector<StrahlerOrder>& orders = parts.data.measures.traits.strahler;
  for (std::size_t k = 0; k < orders.size(); ++k)
    table.rows.push_back({{QString::number(k + 1)},
                          {parts.numbers.count(orders[k].streams)},
                          {parts.numbers.number(orders[k].length)}});
  return table;
}

ReportSection architecture(const Parts& parts) {
  ReportSection section{ReportText::tr("Architecture"), {}};
  ReportTable table;
  for (const TraitRow& row : traitRows(parts.data.measures.traits)) {
    const QString group = shownText(row.group);
    if (table.caption != group) {
      if (!table.rows.empty()) section.blocks.emplace_back(table);
      table = {.caption = group,
               .columns = {{ReportText::tr("trait"), false}, {ReportText::tr("plant")}},
               .rows = {}};
    }
    table.rows.push_back({{nameOf(row, parts.numbers)}, {valueOf(row, parts.numbers)}});
  }
  section.blocks.emplace_back(std::move(table));
  section.blocks.emplace_back(axesTable(parts));
  section.blocks.emplace_back(strahlerTable(parts));
  return section;
}

ReportTable woodTable(const Parts& parts, const CompartmentTable& of) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  switch (of.kind) {
  case CompartmentTable::Kind::order:
    table = {.caption = ReportText::tr("By order"), .columns = {{ReportText::tr("order"), false}}};
    break;
  case CompartmentTable::Kind::diameter:
    table = {.caption = ReportText::tr("By diameter"),
             .columns = {{numbers.inUnit(ReportText::tr("up to")), false}}};
    break;
  case CompartmentTable::Kind::mtgClass:
    table = {.caption = ReportText::tr("By class, scale %1").arg(of.scale),
             .columns = {{ReportText::tr("class"), false}}};
  }
  table.columns.push_back({numbers.inUnit(ReportText::tr("length"))});
  table.columns.push_back({numbers.inUnit(ReportText::tr("area"), 2)});
  table.columns.push_back({numbers.inUnit(ReportText::tr("volume"), 3)});
  if (parts.data.measures.density.isKnown())
    table.columns.push_back({ReportText::tr("biomass [kg]")});
  return table;
}

void addCompartment(ReportTable& table, const QString& name, const Compartment& row,
                    const ReportNumbers& numbers) {
  table.rows.push_back({{name},
                        {numbers.number(row.wood.length)},
                        {numbers.number(row.wood.area)},
                        {numbers.number(row.wood.volume)}});
  if (row.biomass) table.rows.back().push_back({numbers.number(*row.biomass)});
}

ReportSection wood(const Parts& parts) {
  const PlantMeasures& measures = parts.data.measures;
  const ReportNumbers& numbers = parts.numbers;
  ReportSection section{ReportText::tr("Wood"), {}};
  section.blocks.emplace_back(ReportParagraph{ReportText::tr(
      "Edges count as truncated cones; those without a radius have a length alone.")});
  if (measures.density.isKnown())
    section.blocks.emplace_back(ReportParagraph{
        ReportText::tr("Biomass is the volume times a density of %1 kg/m³, which was given.")
            .arg(numbers.given(measures.density.perCubicMeter))});
  for (const CompartmentTable& of : compartments(measures)) {
    ReportTable table = woodTable(parts, of);
    for (const Compartment& row : of.rows)
      addCompartment(table,
                     of.kind != CompartmentTable::Kind::diameter ? QString::fromStdString(row.name)
                     : row.upTo                                  ? numbers.given(*row.upTo)
                                                                 : ReportText::tr("more"),
                     row, numbers);
    if (of.kind == CompartmentTable::Kind::order) {
      Compartment all{.name = {}, .wood = measures.wood.whole};
      if (measures.density.isKnown()) all.biomass = measures.density.biomass(all.wood);
      addCompartment(table, ReportText::tr("all"), all, numbers);
    }
    section.blocks.emplace_back(std::move(table));
    if (of.kind == CompartmentTable::Kind::order)
      section.blocks.emplace_back(ReportParagraph{
          measures.stemDiameter
              ? ReportText::tr("Diameter of the stem at breast height, 1.3 m: %1.")
                    .arg(numbers.length(*measures.stemDiameter))
              : ReportText::tr("There is no diameter of the stem at breast height, 1.3 m: %1.")
                    .arg(shownText(measures.stemMissing)),
          ReportParagraph::Look::note});
  }
  return section;
}

/// A parameter with its unit, as in the first column of a table.
QString nameOf(const EnvelopeParameter& parameter, const ReportNumbers& numbers) {
  using Kind = EnvelopeParameter::Kind;
  // Of a coordinate, the place has a name, and the axis behind it a letter.
  const std::size_t end =
      parameter.kind == Kind::coordinate ? parameter.label.rfind(' ') : parameter.label.size();
  const QString label = shownText(parameter.label.substr(0, end)) +
                        QString::fromStdString(parameter.label.substr(end));
  return parameter.kind == Kind::length || parameter.kind == Kind::coordinate
             ? numbers.inUnit(label)
             : label;
}

ReportSection envelope(const Parts& parts) {
  const ReportedEnvelope& drawn = *parts.data.envelope;
  const Envelope& body = drawn.envelope;
  const ReportNumbers& numbers = parts.numbers;
  const QString about =
      drawn.isOfSkeleton ? ReportText::tr("the skeleton") : ReportText::tr("the points");
  const QString how = drawn.isByHand
                          ? ReportText::tr("%1 about %2; handles of it were dragged by hand.")
                          : ReportText::tr("%1 about %2.");
  ReportSection section{ReportText::tr("Crown envelope"),
                        {ReportParagraph{how.arg(shownText(drawn.label), about)}}};
  if (drawn.isUsual)
    section.blocks.emplace_back(
        ReportParagraph{ReportText::tr("It is about the whole plant, the stem included.")});
  ReportTable table;
  table.columns = {{ReportText::tr("number"), false}, {ReportText::tr("envelope")}};
  const auto add = [&](const QString& name, const QString& value) {
    table.rows.push_back({{name}, {value}});
  };
  add(numbers.inUnit(ReportText::tr("volume"), 3), numbers.number(body.volume));
  add(numbers.inUnit(ReportText::tr("area"), 2), numbers.number(body.area));
  add(numbers.inUnit(ReportText::tr("height")), numbers.number(body.height));
  add(numbers.inUnit(ReportText::tr("crown diameter")), numbers.number(body.diameter));
  for (const EnvelopeParameter& parameter : ownParameters(body)) {
    using Kind = EnvelopeParameter::Kind;
    add(nameOf(parameter, numbers), parameter.kind == Kind::angle ? numbers.degrees(parameter.value)
                                    : parameter.kind == Kind::number
                                        ? numbers.given(parameter.value)
                                        : numbers.number(parameter.value));
  }
  section.blocks.emplace_back(std::move(table));
  return section;
}

ReportSection light(const Parts& parts) {
  const LightInterception& light = *parts.data.measures.light;
  const ReportNumbers& numbers = parts.numbers;
  ReportSection section{ReportText::tr("Light"), {}};
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr(
          "The plant shows %1 of its surface to an overcast sky (STAR); a sphere shows 0.25.")
          .arg(numbers.share(light.star, 5))});
  ReportTable steps;
  steps.caption =
      ReportText::tr("The same from pictures of fewer pixels: how far the number may be trusted");
  steps.columns = {{ReportText::tr("pixels")}, {ReportText::tr("STAR")}};
  for (const StarAtPixels& step : light.convergence)
    steps.rows.push_back(
        {{numbers.count(static_cast<std::size_t>(step.pixels))}, {numbers.share(step.star, 5)}});
  section.blocks.emplace_back(std::move(steps));
  ReportTable directions;
  directions.caption = ReportText::tr("From each direction");
  directions.columns = {{ReportText::tr("elevation")},
                        {ReportText::tr("azimuth")},
                        {ReportText::tr("weight")},
                        {numbers.inUnit(ReportText::tr("silhouette"), 2)},
                        {ReportText::tr("STAR")}};
  for (const DirectionalStar& each : light.directions)
    directions.rows.push_back({{numbers.degrees(each.elevation)},
                               {numbers.degrees(each.azimuth)},
                               {numbers.share(each.weight, 4)},
                               {numbers.number(each.silhouette)},
                               {numbers.share(each.star, 5)}});
  section.blocks.emplace_back(std::move(directions));
  return section;
}

/// What to type for the same numbers.
QString commandOf(const Parts& parts) {
  QStringList words = {QStringLiteral("espalier traits"), typedName(parts.about.plant)};
  if (parts.data.measures.light)
    words.append(QStringLiteral("--light --pixels %1").arg(parts.data.pixels));
  if (!parts.about.unit.isEmpty()) words.append(QStringLiteral("--unit ") + parts.about.unit);
  if (parts.data.measures.density.isKnown())
    words.append(QStringLiteral("--density %1").arg(parts.data.measures.density.perCubicMeter));
  if (parts.data.up != UpAxis::z)
    words.append(QStringLiteral("--up ") + QChar(axisName(parts.data.up)));
  const auto& envelope = parts.data.envelope;
  if (envelope && envelope->isUsual && (envelope->isOfSkeleton || parts.about.scan)) {
    words.append(QStringLiteral("--envelope ") + QString::fromStdString(envelope->kind));
    if (!envelope->isOfSkeleton)
      words.append(QStringLiteral("--scan ") + typedName(*parts.about.scan));
  }
  words.append(QStringLiteral("--json numbers.json --csv numbers.csv"));
  return words.join(' ');
}

ReportSection settings(const Parts& parts) {
  std::vector<std::pair<QString, ReportedFile>> files = {
      {ReportText::tr("plant"), parts.about.plant}};
  if (parts.about.scan) files.emplace_back(ReportText::tr("scan"), *parts.about.scan);
  ReportTable table;
  table.caption = ReportText::tr("Settings");
  table.columns = {{ReportText::tr("setting"), false}, {ReportText::tr("value"), false}};
  table.rows = {
      {{ReportText::tr("unit of lengths")},
       {parts.about.unit.isEmpty() ? ReportText::tr("that of the files") : parts.about.unit}},
      {{ReportText::tr("up")}, {QString(QChar(axisName(parts.data.up)))}},
      {{ReportText::tr("version")},
       {ReportText::tr("Espalier %1, Qt %2").arg(parts.about.version, qVersion())}}};
  ReportSection section{ReportText::tr("How it was measured"),
                        {inputsTable(files), std::move(table)}};
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr("All numbers as JSON and CSV; they are the values that this report rounds:")});
  for (const ReportBlock& advice : exportAdvice(parts.about.plant))
    section.blocks.push_back(advice);
  section.blocks.emplace_back(ReportParagraph{commandOf(parts), ReportParagraph::Look::code});
  return section;
}

enum class Written { html, json, csv };

std::optional<Written> writtenAs(const std::filesystem::path& path) {
  const std::string extension = lowerCase(path.extension().string());
  if (extension == ".html" || extension == ".htm" || extension == ".pdf") return Written::html;
  if (extension == ".json") return Written::json;
  if (extension == ".csv") return Written::csv;
  return std::nullopt;
}

} // namespace

Report plantReport(const PlantReportData& data, const ReportPictures& drawn,
                   const PlantReportAbout& about) {
  const Parts parts{data, drawn, about, ReportNumbers(about.unit)};
  Report report;
  report.title = about.plant.name;
  report.facts = {about.date, ReportText::tr("Espalier %1").arg(about.version),
                  about.unit.isEmpty() ? ReportText::tr("lengths in the unit of the files")
                                       : ReportText::tr("lengths in %1").arg(about.unit)};
  report.sections = {summary(parts), pictures(parts), architecture(parts), wood(parts)};
  if (data.envelope) report.sections.push_back(envelope(parts));
  if (data.measures.light) report.sections.push_back(light(parts));
  if (about.handWork) report.sections.push_back(handWorkSection(*about.handWork, parts.numbers));
  report.sections.push_back(settings(parts));
  report.sections.push_back(
      {ReportText::tr("Methods"), {ReportTerms{traitTerms(data.measures.light.has_value())}}});
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.blocks.empty(); // no picture could be drawn
  });
  return report;
}

nlohmann::ordered_json numbersOf(const PlantReportData& data, const PlantReportAbout& about) {
  const auto orNull = [](const QString& text) {
    return text.isEmpty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text.toStdString());
  };
  const auto fileJson = [&](const ReportedFile& file) {
    return nlohmann::ordered_json{
        {"file", (file.path.isEmpty() ? file.name : file.path).toStdString()},
        {"sha256", orNull(file.fingerprint)}};
  };
  nlohmann::ordered_json json = {{"version", about.version.toStdString()},
                                 {"unit", orNull(about.unit)},
                                 {"up", std::string(1, axisName(data.up))},
                                 {"inputs", {{"plant", fileJson(about.plant)}}}};
  if (about.scan) json["inputs"]["scan"] = fileJson(*about.scan);
  json.update(toJson(data.measures));
  if (data.envelope) json["envelope"] = numbersOf(*data.envelope);
  return json;
}

void requirePlantReportName(const std::filesystem::path& path) {
  if (!writtenAs(path))
    throw Error(path.string() +
                ": numbers of a plant are written as HTML, PDF, CSV or JSON: choose "
                "a name that ends in .html, .pdf, .csv or .json");
}

bool hasPictures(const std::filesystem::path& path) {
  return writtenAs(path) == Written::html;
}

void writePlantReport(const std::filesystem::path& path, const PlantReportData& data,
                      const ReportPictures& drawn, const PlantReportAbout& about) {
  requirePlantReportName(path);
  if (hasPictures(path)) return writeReport(path, plantReport(data, drawn, about));
  const nlohmann::ordered_json json = numbersOf(data, about);
  const bool isTable = writtenAs(path) == Written::csv;
  writeAtomically(path, [&](std::ostream& out) {
    if (!isTable) out << json.dump(2) << '\n';
    if (isTable)
      for (const std::vector<std::string>& row : tableOf(json))
        out << csvLine(row);
  });
}

} // namespace espalier
