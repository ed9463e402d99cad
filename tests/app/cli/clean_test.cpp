#include "core/io/csv.h"
#include "core/io/formats.h"
#include "core/project/project.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::expectRefusal;
using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

std::string textOf(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A small plot, made once per test.
struct CleanCommands : test::Subcommands {
  std::string plot_;

  void SetUp() override {
    plot_ = file("plot.ply");
    ASSERT_EQ(runProgram({"simulate", "-o", file("plot"), "--plants", "3", "--points", "60000",
                          "--segments", "120", "--seed", "7"})
                  .status,
              0);
  }
  /// What each point of the plot is of, in the order of its file.
  [[nodiscard]] std::vector<std::string> parts() const {
    std::vector<std::string> names;
    for (const CsvTable::Row& row : readCsv(textOf(file("plot.csv")), "plot.csv").rows)
      names.push_back(row.fields[0]);
    return names;
  }
};

TEST_F(CleanCommands, WriteThePointsThatAreKeptAndTheRest) {
  const PointCloud all = readPoints(plot_).value;
  ASSERT_EQ(parts().size(), static_cast<std::size_t>(all.size()));
  const Outcome outcome =
      runProgram({"clean", plot_, "-o", file("kept.ply"), "--left-out", file("rest.ply"), "--set",
                  "ground.method=cloth", "--json", file("kept.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("espalier: ground, cloth: "));
  EXPECT_THAT(outcome.err, HasSubstr("espalier: clean, isolated_points: "));
  const PointCloud kept = readPoints(file("kept.ply")).value;
  const PointCloud rest = readPoints(file("rest.ply")).value;
  EXPECT_EQ(kept.size() + rest.size(), all.size());
  EXPECT_EQ(kept.intensities().size(), static_cast<std::size_t>(kept.size()));
  const auto ground = std::ranges::count(parts(), "ground");
  EXPECT_NEAR(static_cast<double>(rest.size()), static_cast<double>(ground),
              0.02 * static_cast<double>(all.size()));
  const auto json = nlohmann::json::parse(textOf(file("kept.json")));
  EXPECT_EQ(json["kept"], kept.size());
  EXPECT_EQ(json["steps"][0]["step"], "ground");
}

TEST_F(CleanCommands, CutAPlotIntoProjectsThatBatchReads) {
  const Outcome outcome = runProgram({"plants", plot_, "-o", file("trees")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("plants.csv: 3 plants"));
  const CsvTable manifest = readCsv(textOf(file("trees/plants.csv")), "plants.csv");
  ASSERT_EQ(manifest.rows.size(), 3U);
  for (const char* name : {"plot_1", "plot_2", "plot_3"}) {
    const fs::path project = file("trees/" + std::string(name) + ".espalier");
    const auto scan = Project::open(project, Access::readOnly).findScan();
    ASSERT_TRUE(scan) << name;
    EXPECT_EQ(scan->filename(), std::string(name) + ".ply");
    EXPECT_GT(readPoints(*scan).value.size(), 3000) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(file("trees")), {}), 7) << "and nothing else";
  const Outcome batch = runProgram({"batch", file("trees/plants.csv"), "-o", file("results")});
  EXPECT_EQ(batch.status, 0) << batch.err;
  EXPECT_TRUE(fs::exists(file("results/plot_3.mtg")));
}

TEST_F(CleanCommands, RefuseWhatTheyCannotDoAndLeaveNothing) {
  ASSERT_EQ(runProgram({"plants", plot_, "-o", file("trees")}).status, 0);
  const std::string before = textOf(file("trees/plants.csv"));
  const Outcome again = runProgram({"plants", plot_, "-o", file("trees")});
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("is there already"));
  EXPECT_EQ(textOf(file("trees/plants.csv")), before);
  const Outcome none =
      runProgram({"plants", plot_, "-o", file("none"), "--set", "plant.slab_from=50 heights",
                  "--set", "plant.slab_to=51 heights"});
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr(plot_ + ": no stem is found"));
  EXPECT_FALSE(fs::exists(file("none")));
  EXPECT_EQ(runProgram({"plants", plot_, "-o", file("none"), "--base", "here"}).status, 2);
  EXPECT_EQ(runProgram({"plants", plot_, "-o", plot_}).status, 1) << "a file is no folder";
  EXPECT_EQ(runProgram({"clean", plot_, "-o", plot_}).status, 1) << "the scan stays";
  EXPECT_EQ(runProgram({"clean", plot_, "-o", file("a.ply"), "--left-out", file("a.ply")}).status,
            2);
  EXPECT_EQ(runProgram({"clean", file("missing.ply"), "-o", file("a.ply")}).status, 1);
  EXPECT_FALSE(fs::exists(file("a.ply")));
}

TEST_F(CleanCommands, TakeTheBasesThatAreGiven) {
  const CsvTable found = [&] {
    EXPECT_EQ(runProgram({"plants", plot_, "-o", file("trees")}).status, 0);
    return readCsv(textOf(file("trees/plants.csv")), "plants.csv");
  }();
  std::string base = found.rows[0].fields[2];
  std::ranges::replace(base, ' ', ',');
  EXPECT_EQ(runProgram({"plants", plot_, "-o", file("one"), "--base", base}).status, 0);
  EXPECT_EQ(readCsv(textOf(file("one/plants.csv")), "plants.csv").rows.size(), 1U);
  expectRefusal(runProgram({"plants", plot_, "-o", file("off"), "--base", "900,-900,0"}), 1,
                {"plot.ply: no plant stands at the places that are given"});
  EXPECT_FALSE(fs::exists(file("off")));
  const Outcome some =
      runProgram({"plants", plot_, "-o", file("some"), "--base", base, "--base", "900,-900,0"});
  EXPECT_EQ(some.status, 0);
  EXPECT_THAT(some.err, HasSubstr("no plant stands at 1 of the 2 places of --base"));
}

TEST_F(CleanCommands, KeepOnePlantOrAllAsIsAsked) {
  const auto kept = [&](const test::Arguments& more) {
    test::Arguments arguments = {"clean", plot_, "-o", file("kept.ply"), "--preset", "plot"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(runProgram(arguments).status, 0);
    return readPoints(file("kept.ply")).value.size();
  };
  EXPECT_LT(1.5 * static_cast<double>(kept({})),
            static_cast<double>(kept({"--set", "plant.method=none"})));
  expectRefusal(runProgram({"plants", plot_, "-o", file("whole"), "--set", "plant.method=none"}), 2,
                {"plant.method=none leaves a plot whole"});
}

} // namespace
} // namespace espalier
