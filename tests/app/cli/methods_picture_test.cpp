#include "core/io/formats.h"
#include "core/project/project.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::namesIn;
using test::Outcome;
using test::runProgram;
using test::Subcommands;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Subcommands, MethodsDescribesEveryOption) {
  const json methods = json::parse(run({"methods", "--json"}));
  EXPECT_GE(methods.size(), 8U);
  const std::string text = run({"methods"});
  for (const json& method : methods) {
    const std::string name =
        method["step"].get<std::string>() + '.' + method["method"].get<std::string>();
    SCOPED_TRACE(name);
    EXPECT_THAT(text, HasSubstr(name));
    for (const json& option : method["options"]) {
      for (const char* key : {"name", "kind", "rule", "range", "help"})
        EXPECT_FALSE(option.value(key, "").empty()) << key;
      EXPECT_LE(option["minimum"], option["maximum"]);
      EXPECT_THAT(text, HasSubstr(option["help"].get<std::string>()));
    }
  }
}

TEST_F(Subcommands, MethodsListsThoseOfOneStep) {
  const json methods = json::parse(run({"methods", "contract", "--json"}));
  ASSERT_GE(methods.size(), 1U);
  for (const json& method : methods)
    EXPECT_EQ(method["step"], "contract");
}

TEST_F(Subcommands, PictureIsOfTheSizeThatIsAsked) {
  const auto outcome =
      runProgram({"picture", scan_, truth_, "-o", file("a.png"), "--width", "320", "--height",
                  "200", "--view", "side", "--dark", "--radii", "--unit", "m"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "espalier: wrote " + file("a.png") + ": 320 x 200 pixels\n");
  const std::string png = test::bytesOf(file("a.png"));
  ASSERT_GT(png.size(), 1000U);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x1\x40\0\0\0\xc8", 8)) << "320 x 200, big endian";
  EXPECT_THAT(namesIn(folder_), ElementsAre("a.png"));
}

TEST_F(Subcommands, PictureTurnsAsAMovie) {
  const auto outcome = runProgram({"picture", truth_, "-o", file("turn.png"), "--turntable", "2",
                                   "--width", "64", "--height", "48"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "espalier: wrote " + file("turn.png") + ": 30 pictures, 64 x 48 pixels\n");
  EXPECT_THAT(test::bytesOf(file("turn.png")), HasSubstr(std::string("acTL\0\0\0\x1e", 8)));
  EXPECT_THAT(runProgram({"picture", truth_, "-o", file("a.png"), "--turntable", "61"}).err,
              HasSubstr("choose a whole number from 2 to 60"));
  EXPECT_THAT(namesIn(folder_), ElementsAre("turn.png"));
}

TEST_F(Subcommands, PictureShowsTheLayersThatAreAsked) {
  const auto picture = [&](const std::string& name, const test::Arguments& extra) {
    test::Arguments arguments = {"picture", scan_, truth_,     "-o", file(name),
                                 "--width", "160", "--height", "120"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    run(arguments);
    return test::bytesOf(file(name));
  };
  const std::string all = picture("all.png", {});
  const std::string points = picture("points.png", {"--layers", "points"});
  const std::string skeleton = picture("skeleton.png", {"--layers", "skeleton"});
  EXPECT_NE(points, skeleton);
  EXPECT_NE(all, points);
  EXPECT_NE(all, skeleton);
  EXPECT_EQ(picture("both.png", {"--layers", "points,skeleton"}), all);
  EXPECT_NE(picture("side.png", {"--view", "side"}), all);
  EXPECT_EQ(picture("right.png", {"--view", "right"}), picture("side.png", {"--view", "side"}));
}

TEST_F(Subcommands, PictureOfLayersThatAreNotThereIsRefused) {
  expectRefusal(runProgram({"picture", truth_, "-o", file("a.png"), "--layers", "points"}), 1,
                {"has no points to draw: give a scan, or no --layers"});
  expectRefusal(runProgram({"picture", scan_, "-o", file("a.png"), "--layers", "skeleton"}), 1,
                {"has no skeleton to draw: give a structure, or no --layers"});
  EXPECT_FALSE(std::filesystem::exists(file("a.png")));
}

/// A project of the sample, with points that are set aside.
void makeProject(const std::string& path, const std::string& scan, const std::string& structure) {
  History history;
  history.skeleton = readStructure(structure).value.skeleton;
  history.leftOut = PointSet::firstOf(5000);
  Project project = Project::create(path, history);
  project.setScan(ScanReference::of(std::filesystem::absolute(scan), {}));
}

TEST_F(Subcommands, PictureShowsThePlantOfAProject) {
  makeProject(file("oak.espalier"), scan_, truth_);
  const auto picture = [&](const std::string& name, const test::Arguments& files) {
    test::Arguments arguments = {"picture", "--width", "160", "--height", "120", "-o", file(name)};
    arguments.insert(arguments.end(), files.begin(), files.end());
    run(arguments);
    return test::bytesOf(file(name));
  };
  const std::string drawn = picture("project.png", {file("oak.espalier")});
  EXPECT_EQ(picture("again.png", {file("oak.espalier")}), drawn);
  EXPECT_NE(picture("all.png", {scan_, truth_}), drawn) << "points that are set aside are drawn";
  EXPECT_NE(picture("wood.png", {file("oak.espalier"), "--layers", "skeleton"}), drawn);
  EXPECT_NE(picture("bare.png", {file("oak.espalier"), "--bare"}), drawn);
  EXPECT_THAT(runProgram({"picture", file("oak.espalier"), truth_, "-o", file("b.png")}).err,
              HasSubstr("a project is drawn by itself: give it alone"));
}

// As desktops ask for it: the name may be any, and no scan of gigabytes is read.
TEST_F(Subcommands, PictureIsAThumbnailOfAProject) {
  const std::string scan = file("scan.ply");
  std::filesystem::copy_file(scan_, scan);
  makeProject(file("oak.espalier"), scan, truth_);
  std::ofstream(scan) << "no scan";
  const Outcome outcome =
      runProgram({"picture", file("oak.espalier"), "-o", file("thumbnail.tmp"), "--width", "64",
                  "--height", "64", "--bare", "--layers", "skeleton"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("scan"))) << "which was not looked for";
  EXPECT_THAT(test::bytesOf(file("thumbnail.tmp")), HasSubstr("PNG"));
  (void)Project::create(file("bare.espalier"), {});
  EXPECT_THAT(runProgram({"picture", file("bare.espalier"), "-o", file("b"), "--bare", "--layers",
                          "skeleton"})
                  .err,
              HasSubstr("has no skeleton to draw"));
}

TEST_F(Subcommands, PictureOfAProjectWithoutItsScanShowsTheWood) {
  const std::string scan = file("scan.ply");
  std::filesystem::copy_file(scan_, scan);
  makeProject(file("oak.espalier"), scan, truth_);
  std::filesystem::remove(scan);
  const auto outcome = runProgram({"picture", file("oak.espalier"), "-o", file("a.png")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("its scan is not found: its points are not read"));
  run({"picture", truth_, "-o", file("b.png")});
  EXPECT_EQ(test::bytesOf(file("a.png")), test::bytesOf(file("b.png")));
}

} // namespace
} // namespace espalier
