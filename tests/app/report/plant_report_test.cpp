#include "app/report/html_report.h"
#include "app/report/plant_report.h"
#include "core/base/error.h"
#include "core/evaluate/traits_json.h"
#include "tests/app/report/reported_plants.h"
#include "tests/support/cloud_of.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

using test::cellOf;
using test::sectionOf;
using test::textOf;

PlantReportData data(UpAxis up = UpAxis::z) {
  PlantReportData made{.plant = test::branched(), .up = up, .measures = {}, .pixels = 64};
  made.measures = plantMeasures(
      made.plant, {.up = up, .breastHeight = 1.3, .light = LightOptions{.pixels = 64}});
  return made;
}

PlantReportAbout about() {
  return {.plant = {"oak.mtg", QString(64, 'a'), {}, "trees/oak.mtg"},
          .scan = std::nullopt,
          .date = "2026-01-02",
          .version = "9.8.7",
          .unit = "m",
          .handWork = std::nullopt};
}

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(PlantReport, ShowsAllOfOnePlant) {
  const Report report = plantReport(data(), {}, about());
  EXPECT_EQ(report.title, "oak.mtg");
  const QString summary = textOf(sectionOf(report, "Summary"));
  EXPECT_TRUE(summary.contains("3.000")) << "of axes: " << qPrintable(summary);
  EXPECT_TRUE(summary.contains("in 2 orders, with 2 tips and 1 branching.")) << qPrintable(summary);
  const ReportSection& architecture = sectionOf(report, "Architecture");
  EXPECT_EQ(cellOf(architecture, "length [m]", 1), "3.000");
  EXPECT_EQ(cellOf(architecture, "branching angle, order 1", 1), "90.0°");
  EXPECT_EQ(cellOf(architecture, "1", 2), "1.000") << "mean length of order 1";
  EXPECT_EQ(cellOf(sectionOf(report, "Wood"), "all", 1), "3.000");
  EXPECT_TRUE(textOf(sectionOf(report, "Wood")).contains("1.3 m"));
}

TEST(PlantReport, SaysBetweenWhichBoundsTheVolumeLies) {
  PlantReportData made = data();
  EXPECT_FALSE(htmlOf(plantReport(made, {}, about())).contains("in 90 of 100 cases"));
  made.measures.volumeUnknown = 0.25;
  EXPECT_TRUE(htmlOf(plantReport(made, {}, about()))
                  .contains("no bounds: how radii err is unknown in 25.0"));
  made.measures.volume = VolumeInterval{0.0123, 0.0456};
  EXPECT_TRUE(htmlOf(plantReport(made, {}, about()))
                  .contains("0.0123 to 0.0456 in 90 of 100 cases, as radii err"));
}

TEST(PlantReport, HoldsTheNumbersOfTheJson) {
  const PlantReportData made = data();
  const Report report = plantReport(made, {}, about());
  const auto json = numbersOf(made, about());
  const ReportSection& light = sectionOf(report, "Light");
  EXPECT_EQ(cellOf(light, "64", 1), QString::number(json["light"]["star"].get<double>(), 'f', 5));
  std::size_t directions = 0;
  for (const ReportBlock& block : light.blocks)
    if (const auto* table = std::get_if<ReportTable>(&block))
      directions = std::max(directions, table->rows.size());
  EXPECT_EQ(directions, 46U) << "of the sky";
  EXPECT_EQ(json["inputs"]["plant"]["file"], "trees/oak.mtg");
  EXPECT_EQ(json["unit"], "m");
  EXPECT_EQ(json["traits"], toJson(made.measures.traits));
}

TEST(PlantReport, SaysHowToGetTheSameNumbers) {
  const QString text =
      textOf(sectionOf(plantReport(data(UpAxis::y), {}, about()), "How it was measured"));
  EXPECT_TRUE(text.contains("espalier traits trees/oak.mtg --light --pixels 64 --unit m --up y "
                            "--json numbers.json --csv numbers.csv"))
      << qPrintable(text);
}

TEST(PlantReport, SaysHowToGetTheSameEnvelopeWhereTheCommandLineCan) {
  PlantReportData made = data();
  made.envelope = ReportedEnvelope{.kind = "alpha", .label = "Alpha hull", .isUsual = true};
  made.envelope->envelope.parameters = {{"pieces", "pieces", EnvelopeParameter::Kind::number, 1},
                                        {"height", "height", EnvelopeParameter::Kind::length, 2}};
  PlantReportAbout of = about();
  of.scan = ReportedFile{"oak.ply", QString(64, 'b'), {}, "trees/oak.ply"};
  const auto command = [&] {
    return textOf(sectionOf(plantReport(made, {}, of), "How it was measured"));
  };
  EXPECT_TRUE(command().contains("--envelope alpha --scan trees/oak.ply --json"))
      << qPrintable(command());
  const auto scan = std::exchange(of.scan, std::nullopt);
  EXPECT_FALSE(command().contains("--envelope")) << "it would be about the skeleton";
  of.scan = scan;
  const Report report = plantReport(made, {}, of);
  EXPECT_EQ(cellOf(sectionOf(report, "Crown envelope"), "pieces", 1), "1");
  int heights = 0;
  for (const ReportBlock& block : sectionOf(report, "Crown envelope").blocks)
    if (const auto* table = std::get_if<ReportTable>(&block))
      for (const auto& row : table->rows)
        heights += row.front().text.startsWith("height");
  EXPECT_EQ(heights, 1) << "that of the surface";
  made.envelope->isOfSkeleton = true;
  EXPECT_TRUE(command().contains("--envelope alpha --json"));
  made.envelope->isUsual = false; // dragged, by options, or of some of the points
  EXPECT_FALSE(command().contains("--envelope"));
}

TEST(PlantReport, LeavesOutWhatWasNotMeasured) {
  PlantReportData made = data();
  made.measures = plantMeasures(made.plant);
  const Report report = plantReport(made, {}, about());
  EXPECT_THROW(static_cast<void>(sectionOf(report, "Light")), std::out_of_range);
  EXPECT_THROW(static_cast<void>(sectionOf(report, "The plant")), std::out_of_range)
      << "no pictures, no section";
  EXPECT_TRUE(textOf(sectionOf(report, "Wood")).contains("There is no diameter"));
  EXPECT_FALSE(htmlOf(report).isEmpty());
}

TEST(PlantReport, IsWrittenAsItsNameSays) {
  const std::filesystem::path folder = test::freshFolder();
  const PlantReportData made = data();
  for (const char* name : {"oak.html", "oak.pdf", "oak.csv", "oak.json"})
    writePlantReport(folder / name, made, {}, about());
  EXPECT_THAT(contentOf(folder / "oak.html"), testing::HasSubstr("<h1>oak.mtg</h1>"));
  EXPECT_THAT(contentOf(folder / "oak.pdf"), testing::StartsWith("%PDF"));
  EXPECT_EQ(nlohmann::ordered_json::parse(contentOf(folder / "oak.json")),
            numbersOf(made, about()));
  EXPECT_THAT(contentOf(folder / "oak.csv"), testing::HasSubstr("\ntraits.tips,2\n"));
  EXPECT_THROW(requirePlantReportName("oak.txt"), Error);
  EXPECT_TRUE(hasPictures("oak.PDF"));
  EXPECT_FALSE(hasPictures("oak.csv"));
}

// Its structure may be in another frame.
TEST(PlantReport, ShowsAScanThatLiesElsewhere) {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}, .radius = 0.02});
  plant.add({.position = {0, 0, 2}, .radius = 0.02, .parent = foot});
  Eigen::Matrix3Xf points(3, 4000);
  for (int i = 0; i < 4000; ++i)
    points.col(i) = Eigen::Vector3d(0.1 * std::cos(i), 0.1 * std::sin(i), 0.0005 * i).cast<float>();
  const auto scan = test::cloudOf(points, {500, 0, 70});
  PictureSession session(plant, scan, UpAxis::z);
  while (session.drawNext()) {
  }
  if (!session.pictures().problem.isEmpty()) GTEST_SKIP() << "there is no OpenGL";
  const QImage& image = session.pictures().scan;
  int colored = 0;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2)
      colored += image.pixelColor(x, y).saturation() > 60;
  EXPECT_GT(colored, 2000);
}

// A plant that stands along y is drawn standing: higher than wide.
TEST(PlantReport, DrawsThePlantUpright) {
  Skeleton lying;
  NodeId last = lying.add({.position = {0, 0, 0}, .radius = 0.02});
  for (int i = 1; i <= 20; ++i)
    last = lying.add({.position = {0, 0.1 * i, 0}, .radius = 0.02, .parent = last});
  const auto sizeFor = [&](UpAxis up) {
    PictureSession session(lying, nullptr, up);
    while (session.drawNext()) {
    }
    if (!session.pictures().problem.isEmpty()) return QSize();
    return session.pictures().front.size();
  };
  const QSize standing = sizeFor(UpAxis::y);
  if (standing.isEmpty()) GTEST_SKIP() << "there is no OpenGL";
  EXPECT_GT(standing.height(), standing.width());
  EXPECT_LT(sizeFor(UpAxis::z).height(), sizeFor(UpAxis::z).width());
}

} // namespace
} // namespace espalier
