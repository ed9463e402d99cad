#include "core/io/csv.h"
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;
using testing::IsEmpty;

class Noise : public testing::Test {
protected:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  std::filesystem::path folder_ = test::freshFolder();
  std::string truth_ = test::sample("young_tree.mtg");
};

TEST_F(Noise, SaysThatAReferenceIsOfTwoTreesAndNamesTheUnit) {
  test::writeBytes(file("two.swc"),
                   "1 0 0 0 0 1 -1\n2 0 0 0 2 1 1\n3 0 9 0 0 1 -1\n4 0 9 0 2 1 3\n");
  const auto outcome = runProgram(
      {"noise", file("two.swc"), "--kind", "shift=0.1", "--repeats", "1", "--unit", "cm"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("the reference is of 2 separate trees"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("F within [0-9.]+ cm, DIADEM"));
}

TEST_F(Noise, WritesTheCurvesAsTextCsvAndJson) {
  const auto outcome =
      runProgram({"noise", truth_, "--kind", "prune=0.2,0.6", "--kind", "resample=2", "--repeats",
                  "2", "--csv", file("a.csv"), "--json", file("a.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "espalier: wrote " + file("a.csv") + "\nespalier: wrote " + file("a.json") + "\n");
  EXPECT_THAT(outcome.out, HasSubstr("          prune, share         G         T"));
  const CsvTable table = readCsv(test::bytesOf(file("a.csv")), "a.csv");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[1].fields[0], "prune");
  EXPECT_EQ(table.rows[1].fields[1], "0.6");
  EXPECT_EQ(table.rows[2].fields[0], "resample");
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_EQ(numbers["reference"], truth_);
  EXPECT_EQ(numbers["repeats"], 2);
  ASSERT_EQ(numbers["curves"].size(), 2U);
  const json& points = numbers["curves"][0]["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0]["level"], 0.2);
  EXPECT_GT(points[0]["scores"]["geometric"]["mean"], points[1]["scores"]["geometric"]["mean"]);
  EXPECT_EQ(table.rows[0].fields[*table.column("f")], points[0]["scores"]["f"]["mean"].dump());
}

TEST_F(Noise, PrintsTheScoresThatAreAskedFor) {
  const auto outcome = runProgram({"noise", truth_, "--kind", "spurs=0.5", "--repeats", "1",
                                   "--score", "barcode", "--score", "invented_length"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("spurs, per node   barcode invented_length\n"));
  expectRefusal(runProgram({"noise", truth_, "--score", "beauty"}), 2, {"beauty"});
}

TEST_F(Noise, IsTheSameOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(
        runProgram({"noise", truth_, "--kind", "position=1", "--kind", "reparent=0.3", "--repeats",
                    "2", "--threads", threads, "--csv", file(std::string(threads) + ".csv"),
                    "--json", file(std::string(threads) + ".json")})
            .status,
        0);
  EXPECT_EQ(test::bytesOf(file("1.csv")), test::bytesOf(file("2.csv")));
  EXPECT_EQ(test::bytesOf(file("1.json")), test::bytesOf(file("2.json")));
}

TEST_F(Noise, RefusesKindsAndLevelsThatAreNone) {
  expectRefusal(runProgram({"noise", truth_, "--kind", "prun"}), 2,
                {"'prun' is no kind of noise: choose one of position, reparent"});
  expectRefusal(runProgram({"noise", truth_, "--kind", "prune=much"}), 2,
                {"level 'much' of prune: expected numbers, as prune=0.1,0.5"});
  expectRefusal(runProgram({"noise", truth_, "--kind", "prune=1.5"}), 1,
                {"young_tree.mtg: level 1.5", "of prune: expected a number from 0 to 1"});
  expectRefusal(runProgram({"noise", test::sample("young_tree.ply")}), 1, {"holds points"});
  expectRefusal(runProgram({"noise"}), 2, {"REFERENCE is required"});
}

TEST_F(Noise, StopsWhenAsked) {
  const auto outcome = test::runAndSignal(
      {"noise", truth_, "--repeats", "1000", "--csv", file("a.csv")}, "Comparing", SIGINT);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_THAT(outcome.err, HasSubstr("stopped; nothing was written"));
  EXPECT_THAT(test::namesIn(folder_), IsEmpty());
}

} // namespace
} // namespace espalier
