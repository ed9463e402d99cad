// Parts of scans that are too large: --most, --box and --columns.
#include "core/io/formats.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using nlohmann::json;
using test::expectRefusal;
using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

struct ReadPartCommands : test::Subcommands {
  const PointCloud cloud_ = readPoints(scan_).value;

  /// The lower half of the plant, as --box has it.
  [[nodiscard]] Eigen::AlignedBox3d lowerHalf() const {
    Eigen::AlignedBox3d box = cloud_.bounds();
    box.max().z() = box.center().z();
    return box;
  }
  [[nodiscard]] static std::string text(const Eigen::AlignedBox3d& box) {
    const Eigen::IOFormat byCommas(9, Eigen::DontAlignCols, ",", ",");
    std::ostringstream out;
    out << box.min().transpose().format(byCommas) << ',' << box.max().transpose().format(byCommas);
    return std::move(out).str();
  }
};

TEST_F(ReadPartCommands, InfoCountsThePointsThatWereReadAndThoseOfTheFile) {
  const Outcome outcome = runProgram({"info", scan_, "--most", "500", "--json"});
  const json info = json::parse(outcome.out);
  EXPECT_EQ(info["points"], 500);
  EXPECT_EQ(info["part"]["points_in_file"], cloud_.size());
  EXPECT_EQ(info["part"]["most"], 500);
  EXPECT_THAT(outcome.err, HasSubstr("500 of " + std::to_string(cloud_.size()) +
                                     " points are read, a sample of all"));
  EXPECT_FALSE(json::parse(run({"info", scan_, "--json"})).contains("part"));
}

TEST_F(ReadPartCommands, ConvertWritesWhatLiesInTheBox) {
  const Eigen::AlignedBox3d box = lowerHalf();
  const Outcome outcome = runProgram({"convert", scan_, file("low.ply"), "--box", text(box)});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  Eigen::Index expected = 0;
  for (Eigen::Index point = 0; point < cloud_.size(); ++point)
    if (cloud_.position(point).z() <= box.max().z()) ++expected;
  const PointCloud low = readPoints(file("low.ply")).value;
  EXPECT_NEAR(static_cast<double>(low.size()), static_cast<double>(expected), 2); // 9 digits
  EXPECT_LT(low.size(), cloud_.size());
  EXPECT_LE(low.bounds().max().z(), box.max().z() + 1e-6);
}

TEST_F(ReadPartCommands, ReconstructTakesASampleAndSaysSo) {
  const Outcome outcome = runProgram(
      {"reconstruct", scan_, "-o", file("a.mtg"), "--most", "9000", "--json", file("a.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("9000 of "));
  const json record = test::jsonIn(file("a.json"));
  EXPECT_EQ(record["part"]["points_in_file"], cloud_.size());
  EXPECT_EQ(record["cloud"]["points"], 9000);
}

TEST_F(ReadPartCommands, CleanRecordsThePartInItsStatistics) {
  const std::string box = text(lowerHalf());
  const Outcome outcome =
      runProgram({"clean", scan_, "-o", file("a.ply"), "--box", box, "--json", file("a.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json record = test::jsonIn(file("a.json"));
  EXPECT_EQ(record["part"]["points_in_file"], cloud_.size());
  EXPECT_NEAR(record["part"]["box"]["maximum"][2], lowerHalf().max().z(), 1e-6);
  EXPECT_LT(record["points"], cloud_.size());
}

TEST_F(ReadPartCommands, NamesTheColumnsOfAText) {
  test::writeBytes(file("odd.txt"), "1 2 3 7 40\n4 5 6 8 50\n7 8 9 9 60\n");
  EXPECT_EQ(run({"convert", file("odd.txt"), file("named.ply"), "--columns", "z,y,x,-,i"}), "");
  const PointCloud cloud = readPoints(file("named.ply")).value;
  EXPECT_EQ(cloud.bounds().max(), Eigen::Vector3d(9, 8, 7));
  EXPECT_THAT(cloud.intensities(), testing::UnorderedElementsAre(40, 50, 60));
  const json info =
      json::parse(run({"info", file("odd.txt"), "--header", "--columns", "x,y,z,-,-", "--json"}));
  EXPECT_EQ(info["columns"].size(), 3U);
}

TEST_F(ReadPartCommands, AnEmptyBoxIsRefusedWithWhereThePointsAre) {
  expectRefusal(runProgram({"info", scan_, "--box", "900,900,900,901,901,901"}), 1,
                {"young_tree.ply: none of its ", " lies in the box from 900, 900, 900 to 901, 901, "
                                                 "901: a sample of them lies from "});
}

TEST_F(ReadPartCommands, AreThoseThatReadAScanToWorkOn) {
  for (const char* name :
       {"info", "convert", "clean", "plants", "contract", "reconstruct", "sweep"})
    for (const char* flag : {"--most N", "--box CORNERS", "--columns NAMES"})
      EXPECT_THAT(run({name, "--help"}), HasSubstr(flag)) << name;
}

TEST_F(ReadPartCommands, WrongValuesAreNamed) {
  expectRefusal(runProgram({"info", scan_, "--most", "0"}), 2, {"--most"});
  expectRefusal(runProgram({"info", scan_, "--box", "1,2,3,4,5"}), 2,
                {"--box '1,2,3,4,5': write two opposite corners, as X,Y,Z,X,Y,Z"});
  expectRefusal(runProgram({"info", scan_, "--columns", "x,y"}), 2, {"x, y and z are needed"});
  expectRefusal(runProgram({"info", scan_, "--columns", "x,y,z,x"}), 2, {"'x' is named twice"});
  expectRefusal(runProgram({"info", scan_, "--columns", "x,y,z,w"}), 2, {"'w' is no column"});
  expectRefusal(runProgram({"info", scan_, "--columns", "x,y,z"}), 1,
                {"is PLY, which says itself what its columns hold"});
  expectRefusal(runProgram({"info", scan_, "--header", "--most", "5"}), 2, {"--header"});
  for (const test::Arguments& arguments :
       {test::Arguments{"convert", truth_, file("a.swc"), "--most", "5"},
        {"info", truth_, "--columns", "x,y,z"}})
    expectRefusal(runProgram(arguments), 1,
                  {"is a structure: --most, --box and --columns are for points"});
}

} // namespace
} // namespace espalier
