#include "app/report/html_report.h"
#include "core/base/error.h"
#include "core/evaluate/comparison_json.h"
#include "tests/app/report/reported_plants.h"
#include "tests/support/clouds.h"
#include "tests/support/shared_data.h"

#include <QCryptographicHash>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace espalier {
namespace {

using test::aboutPlants;
using test::branched;
using test::cellOf;
using test::reported;
using test::sectionOf;
using test::textOf;

constexpr double near = 0.02; // [L]

/// Of the trunk alone with the whole plant: a third of the length is missed.
Report reportOfTrunk(const ReportAbout& about = aboutPlants(),
                     const ReportPictures& pictures = {}) {
  return comparisonReport(reported(test::stick(21, 0.1), branched(), near), pictures, about);
}

QString thin(QString text) {
  return text.replace('_', QChar(0x202f));
}

TEST(ComparisonReport, SaysInWordsWhatIsFoundAndWhatIsMissed) {
  const QString text = textOf(sectionOf(reportOfTrunk(), "Summary"));
  EXPECT_TRUE(text.contains(thin("within 0.02_m"))) << qPrintable(text);
  EXPECT_TRUE(text.contains(thin("100.0_% of its own length lies that near"))) << qPrintable(text);
  EXPECT_TRUE(text.contains(thin("0_m invented in 0 places"))) << qPrintable(text);
  EXPECT_TRUE(text.contains(" are missed in 1 place ")) << qPrintable(text);
  EXPECT_TRUE(text.contains("nothing is attached to the wrong wood")) << qPrintable(text);
}

TEST(ComparisonReport, SaysInWhichOrderItAgreesBestOfThoseThatBothHave) {
  Skeleton shorter = branched();
  for (const NodeId id : std::vector<NodeId>{NodeId{30}, NodeId{29}, NodeId{28}, NodeId{27}})
    shorter.erase(id);
  const QString both = textOf(sectionOf(
      comparisonReport(reported(shorter, branched(), near), {}, aboutPlants()), "Summary"));
  EXPECT_TRUE(both.contains("it agrees best in order 0 (F 1.000) and least in order 1"))
      << qPrintable(both);
  const QString trunk = textOf(sectionOf(reportOfTrunk(), "Summary"));
  EXPECT_FALSE(trunk.contains("agrees best")) << qPrintable(trunk);
}

TEST(ComparisonReport, SaysWithWhatThePlantWasReconstructed) {
  ReportAbout about = aboutPlants();
  about.made = PipelineOptions();
  about.made->set("contract.method=euclidean_ball");
  about.made->set("contract.radius=0.0785");
  about.made->set("prune.length=6sp");
  about.made->up = UpAxis::y;
  const Report report = reportOfTrunk(about);
  const ReportSection& making = sectionOf(report, "How the plant was reconstructed");
  const QString text = textOf(making);
  EXPECT_EQ(cellOf(making, "Contract: Radius", 1), thin("0.0785_m"));
  EXPECT_EQ(cellOf(making, "Contract: Radius", 2), "6 point spacings");
  EXPECT_EQ(cellOf(making, "Prune: Length", 1), "6 point spacings");
  EXPECT_TRUE(text.contains("espalier reconstruct SCAN -o plant.mtg --unit m --up y "
                            "--set contract.method=euclidean_ball --set contract.radius=0.0785 "
                            "--set 'prune.length=6 point spacings'"))
      << qPrintable(text);
  about.made = PipelineOptions();
  EXPECT_TRUE(textOf(sectionOf(reportOfTrunk(about), "How the plant was reconstructed"))
                  .contains("By the default methods, all options by their rules."));
}

TEST(ComparisonReport, HoldsTheNumbersOfTheJson) {
  const ReportData data = reported(test::stick(21, 0.1), branched(), near);
  const Report report = comparisonReport(data, {}, aboutPlants());
  const auto json = toJson(data.comparison);
  const auto five = [](const nlohmann::ordered_json& value) {
    return QString::number(value.get<double>(), 'f', 5);
  };
  const ReportSection& indices = sectionOf(report, "Indices");
  EXPECT_EQ(cellOf(indices, "mapping", 1), five(json["authors"]["mapping"]));
  EXPECT_EQ(cellOf(indices, "geometric index G", 1), five(json["authors"]["geometric"]));
  EXPECT_EQ(cellOf(indices, "structural index T", 1), five(json["authors"]["structural"]));
  EXPECT_EQ(cellOf(indices, "tips, F", 1), five(json["traits"]["matched_tips"]["f"]));
  EXPECT_EQ(cellOf(indices, "edit similarity", 1), five(json["edit_distance"]["similarity"]));
  EXPECT_EQ(cellOf(indices, "NetMets, length missed", 1), five(json["network"]["missed_length"]));
  EXPECT_EQ(cellOf(indices, "distance of the barcodes (TMD)", 1),
            five(json["barcode"]["distance"]));
  EXPECT_EQ(cellOf(sectionOf(report, "Wood"), "concordance (CCC)", 1),
            five(json["radius"]["concordance"]));
  // Two thirds of the length are found, but for what lies about the foot of the branch.
  const QString recall = cellOf(sectionOf(report, "Agreement over the tolerance"), "0.02", 2);
  EXPECT_NEAR(recall.toDouble(), 2.0 / 3 + near / 3, 0.005);
  EXPECT_EQ(cellOf(sectionOf(report, "Agreement over the tolerance"), "0.02", 1), "1.000");
}

TEST(ComparisonReport, ShowsWhereTheLengthIsByHeightAndByOrder) {
  const ReportSection section = sectionOf(reportOfTrunk(), "Where they agree");
  EXPECT_EQ(cellOf(section, "0", 4), "2.000"); // of the reference in order 0
  EXPECT_EQ(cellOf(section, "0", 2), "1.000");
  EXPECT_EQ(cellOf(section, "1", 3), "0");
  EXPECT_NEAR(cellOf(section, "1", 4).toDouble(), 1, 0.02);
}

TEST(ComparisonReport, PutsTheTraitsOfBothBesideEachOther) {
  const ReportSection section = sectionOf(reportOfTrunk(), "Architecture");
  EXPECT_EQ(cellOf(section, "tips", 1), "1");
  EXPECT_EQ(cellOf(section, "tips", 2), "2");
  EXPECT_EQ(cellOf(section, "tips", 3), QChar(0x2212) + thin("50.0_%"));
  EXPECT_EQ(cellOf(section, "length [m]", 1), "2.000");
  EXPECT_EQ(cellOf(section, "length [m]", 2), "3.000");
  EXPECT_EQ(cellOf(section, "Strahler number", 2), "2");
}

TEST(ComparisonReport, SaysWhatTheColorsOfTheScanMean) {
  ReportData data = reported(test::stick(21, 0.1), branched(), near);
  RawPoints raw;
  raw.positions = {{0, 0, -0.5}, {0, 0, 1}, {0, 0, 2}};
  data.scan = std::make_shared<const PointCloud>(std::move(raw));
  ReportAbout about = aboutPlants();
  about.scan = {"oak.ply", QString(64, 'c')};
  ReportPictures pictures;
  pictures.scan = QImage(4, 4, QImage::Format_RGB32);
  const Report report = comparisonReport(data, pictures, about);
  QStringList captions;
  for (const ReportBlock& block : sectionOf(report, "Both plants").blocks)
    if (const auto* figures = std::get_if<ReportFigures>(&block))
      for (const auto& figure : figures->figures)
        captions.append(figure.text);
  EXPECT_EQ(captions.join('\n').replace(QChar(0x202f), ' '),
            QString::fromUtf8("oak.ply, 3 points, colored by height, from −0.500 m (violet) to "
                              "2.00 m (green)"));
}

TEST(ComparisonReport, ListsTheErrorsWithKindLengthAndPlace) {
  const ReportSection section = sectionOf(reportOfTrunk(), "Largest errors");
  EXPECT_EQ(cellOf(section, "1", 1), "Missed");
  EXPECT_NEAR(cellOf(section, "1", 2).toDouble(), 1, 0.11); // an edge half near counts as near
  EXPECT_EQ(cellOf(section, "1", 5), "1.000") << "the height at which it leaves";
  const Report same = comparisonReport(reported(branched(), branched(), near), {}, aboutPlants());
  EXPECT_EQ(textOf(sectionOf(same, "Largest errors")),
            "Largest errors\nThere are none at this tolerance.");
}

TEST(ComparisonReport, ShowsErrorsOfEachKindBeforeMoreOfOne) {
  ReportData data;
  std::vector<DifferingPart>& parts = data.differences.parts;
  for (int i = 0; i < 8; ++i)
    parts.push_back({.kind = Difference::wronglyAttached, .length = 100.0 - i});
  parts.push_back({.kind = Difference::missed, .length = 10});
  parts.push_back({.kind = Difference::invented, .length = 5});
  EXPECT_EQ(shownErrors(data), (std::vector<std::size_t>{0, 1, 2, 3, 8, 9}));
  data.ignored = {1, 9};
  EXPECT_EQ(shownErrors(data), (std::vector<std::size_t>{0, 2, 3, 4, 5, 8}));
  EXPECT_TRUE(shownErrors({}).empty());
}

TEST(ComparisonReport, ListsWhatIsIgnoredApart) {
  Skeleton moved = test::stick(21, 0.1); // beside the reference, without its branch
  for (const NodeId id : moved.ids())
    moved.setPosition(id, moved[id].position + Eigen::Vector3d(0, 0.5, 0));
  ReportData data = reportData(compare(moved, branched(), withTolerance({}, branched(), near)),
                               moved, branched(), nullptr, near);
  ASSERT_EQ(data.differences.parts.size(), 1U);
  ignore(data, {{.kind = Difference::invented, .at = {0.1, 0.5, 1}}});
  EXPECT_TRUE(data.ignored.empty()) << "another kind";
  ignore(data, {{.kind = Difference::missed, .at = {0.1, 0.5, 1}}});
  ASSERT_EQ(data.ignored.size(), 1U) << "where it lay before it was registered";
  const ReportSection section =
      sectionOf(comparisonReport(data, {}, aboutPlants()), "Largest errors");
  EXPECT_EQ(textOf(section), "Largest errors\n1 more was looked at and is ignored. All scores and "
                             "lengths count it.");
  EXPECT_EQ(cellOf(section, "1", 1), "Missed");
}

TEST(ComparisonReport, ShowsStemsAndRadiiByTheArcThatWasSeen) {
  const ReportSection without = sectionOf(reportOfTrunk(), "Wood");
  EXPECT_TRUE(textOf(without).contains("breast height, 1.3 m, are not compared: the unit"))
      << qPrintable(textOf(without));
  Comparison comparison =
      compare(branched(), branched(), withTolerance({.registers = false}, branched(), near));
  comparison.stems = {.height = 1.3, .result = 0.3, .reference = 0.2, .missing = {}};
  comparison.radii.byArc = {{.from = 0, .to = 0.25},
                            {.from = 0.25,
                             .to = 0.5,
                             .compared = 2,
                             .meanError = -0.01,
                             .rootMeanSquare = 0.02,
                             .relativeRootMeanSquare = 0.125}};
  const ReportSection section =
      sectionOf(comparisonReport(reportData(comparison, branched(), branched(), nullptr, near), {},
                                 aboutPlants()),
                "Wood");
  EXPECT_EQ(cellOf(section, "0.3000", 2), thin("+50.0_%"));
  EXPECT_EQ(cellOf(section, "0 to 25 %", 2), QStringLiteral("–"));
  EXPECT_EQ(cellOf(section, "25 to 50 %", 1), "2.000");
  EXPECT_EQ(cellOf(section, "25 to 50 %", 3), "0.02000");
  EXPECT_EQ(cellOf(section, "25 to 50 %", 4), thin("12.5_%"));
}

TEST(HtmlReport, LetsPagesPartLongTablesAlone) {
  const auto pageOf = [](std::size_t rows) {
    ReportTable table;
    table.columns = {{"a"}};
    table.rows.assign(rows, {{"1"}});
    Report report;
    report.sections.push_back({"S", {table}});
    return htmlOf(report);
  };
  EXPECT_FALSE(pageOf(10).contains("<table class=\"long\">"));
  EXPECT_TRUE(pageOf(11).contains("<table class=\"long\">"));
}

TEST(ComparisonReport, NamesTheSettingsAndTheFilesByTheirHashes) {
  const ReportSection section = sectionOf(reportOfTrunk(), "How it was measured");
  EXPECT_EQ(cellOf(section, "plant", 1), "oak.mtg");
  EXPECT_EQ(cellOf(section, "plant", 2), QString(64, 'a'));
  EXPECT_EQ(cellOf(section, "reference", 2), QString(64, 'b'));
  EXPECT_EQ(cellOf(section, "tolerance", 1), thin("0.02_m"));
  EXPECT_EQ(cellOf(section, "registration", 1), "none: compared where they lie");
  EXPECT_TRUE(cellOf(section, "version", 1).startsWith("Espalier 9.8.7, Qt "));
}

TEST(ComparisonReport, SaysWhatToTypeForTheSameNumbers) {
  ReportAbout about = aboutPlants();
  about.scale = 0.001;
  about.edit.unit = EditUnit::axis;
  EXPECT_TRUE(textOf(sectionOf(reportOfTrunk(about), "How it was measured"))
                  .endsWith("espalier evaluate oak.mtg expert.mtg --no-register --scale 0.001 "
                            "--unit m --edit-unit axis --json numbers.json --csv numbers.csv"));
}

TEST(ComparisonReport, SaysToExportAPlantThatNoCommandCanRead) {
  ReportAbout about = aboutPlants();
  about.result.isToExport = true;
  const QString text = textOf(sectionOf(reportOfTrunk(about), "How it was measured"));
  EXPECT_TRUE(text.contains("Export the plant as plant.mtg first."));
  EXPECT_TRUE(text.contains("espalier evaluate plant.mtg expert.mtg "));
}

TEST(ComparisonReport, SaysWhatMakesTheNumbersDoubtful) {
  Skeleton moved = branched();
  for (const NodeId id : moved.ids())
    moved.setPosition(id, moved[id].position + Eigen::Vector3d(0, 0.5, 0));
  const Comparison comparison = compare(moved, branched());
  ReportAbout about = aboutPlants();
  about.scale = 0.001;
  ReportPictures pictures;
  pictures.problem = "OpenGL: no context to draw in";
  const Report report =
      comparisonReport(reportData(comparison, moved, branched()), pictures, about);
  const QString text = textOf(sectionOf(report, "Summary"));
  EXPECT_TRUE(text.contains(thin("the plant lay 0.5000_m off the reference"))) << qPrintable(text);
  EXPECT_TRUE(text.contains("the plant was multiplied by 0.001 first")) << qPrintable(text);
  EXPECT_TRUE(text.contains("there are no pictures: OpenGL: no context")) << qPrintable(text);
}

// As the panel and the command line state it, with the unit.
TEST(ComparisonReport, StatesTheShiftOfThePlantThatIsGiven) {
  const Skeleton plant = branched();
  ComparisonOptions options;
  options.registration.motion = Eigen::Isometry3d(Eigen::Translation3d(0.5, 0, -0.25));
  const ReportData data = reportData(compare(plant, plant, withTolerance(options, plant, near)),
                                     plant, plant, nullptr, near);
  const Report report = comparisonReport(data, {}, aboutPlants());
  const QString summary = textOf(sectionOf(report, "Summary"));
  EXPECT_TRUE(summary.contains(thin("the plant lay 0.5590_m off the reference: it was moved by "
                                    "(0.5000_m, 0_m, −0.2500_m) to lie on it")))
      << qPrintable(summary);
  const ReportSection& how = sectionOf(report, "How it was measured");
  EXPECT_EQ(cellOf(how, "registration", 1), "the plant was moved to lie on the reference");
  EXPECT_TRUE(textOf(how).contains(" --shift=0.5,0,-0.25 ")) << qPrintable(textOf(how));
}

TEST(ComparisonReport, StatesTheWorkByHandOfWhatHasAHistory) {
  ReportAbout about = aboutPlants();
  about.handWork = HandWork{.corrections = {.edits = 3, .added = 2, .moved = 7},
                            .time = std::int64_t{12} * 60'000};
  const ReportSection section = sectionOf(reportOfTrunk(about), "Work by hand");
  EXPECT_TRUE(textOf(section).contains("3 edits, 12 min of work"));
  EXPECT_EQ(cellOf(section, "added", 1), "2");
  EXPECT_EQ(cellOf(section, "moved", 1), "7");
  EXPECT_THROW(static_cast<void>(sectionOf(reportOfTrunk(), "Work by hand")), std::out_of_range);
}

TEST(ComparisonReport, RefusesAComparisonAtOtherDistances) {
  ComparisonOptions options;
  options.registers = false;
  const Comparison comparison = compare(branched(), branched(), options);
  EXPECT_THROW(static_cast<void>(reportData(comparison, branched(), branched(), nullptr, 0.123)),
               Error);
  const auto distances = withTolerance(options, branched(), 0.123).tolerance.distances;
  EXPECT_EQ(distances.size(), defaultTolerances(branched()).size() + 1);
  EXPECT_TRUE(std::ranges::is_sorted(distances));
}

TEST(ComparisonReport, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  ComparisonOptions options;
  options.registers = false;
  const Comparison comparison = compare(branched(), branched(), options);
  EXPECT_THROW(static_cast<void>(reportData(comparison, branched(), branched(), nullptr, 0,
                                            Progress(stop.get_token(), {}))),
               Cancelled);
}

TEST(ReportedFile, IsKnownByTheHashOfItsBytes) {
  const auto file = test::freshFolder() / "abc.txt";
  std::ofstream(file) << "abc"; // the example of FIPS 180-2
  const ReportedFile reportedAs = reportedFile(file);
  EXPECT_EQ(reportedAs.name, "abc.txt");
  EXPECT_EQ(reportedAs.fingerprint,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_THROW(static_cast<void>(reportedFile(file.parent_path() / "missing.txt")), Error);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& p) { (void)reportedFile(file, p); }));
  std::ofstream(file) << std::string(1'000'000, 'a') << std::string(1'000'000, 'a');
  const QByteArray all(2'000'000, 'a');
  EXPECT_EQ(reportedFile(file).fingerprint,
            QCryptographicHash::hash(all, QCryptographicHash::Sha256).toHex())
      << "of a file that is read in parts";
}

} // namespace
} // namespace espalier
