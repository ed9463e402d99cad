#include "core/base/random.h"
#include "core/base/text.h"
#include "core/cloud/file_order.h"
#include "core/io/csv.h"
#include "core/io/formats.h"
#include "tests/app/cli/subcommands.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using test::expectRefusal;
using test::jsonIn;
using test::Outcome;
using test::runProgram;
using test::writeBytes;
using testing::HasSubstr;

/// Two stations of one tree, the second 0.3 m and 10 degrees off, and true pairs of targets.
struct RegisterCommand : test::Subcommands {
  std::string one_ = file("tree_1.ply");
  std::string two_ = file("tree_2.ply");
  std::string pairs_ = file("tree_pairs.csv");
  std::string joined_ = file("joined.ply");

  void simulate(const std::string& stations = "3", const std::string& points = "24000") {
    const Outcome outcome =
        runProgram({"simulate", "-o", file("tree"), "--stations", stations, "--points", points,
                    "--segments", "60", "--seed", "7", "--apart", "0.3,10"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  /// The motion of the first moved scan that a run wrote.
  [[nodiscard]] Isometry3d motionIn(const std::string& json) const {
    Isometry3d motion;
    const auto rows = jsonIn(file(json))["scans"][0]["motion"];
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        motion.matrix()(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            rows[row][column].get<double>();
    return motion;
  }

  /// The table of pairs, each place of it off by about this much in each coordinate.
  void makeRough(double off) const {
    const CsvTable table = readCsv(test::bytesOf(pairs_), pairs_);
    Random random(5);
    std::string text = csvLine(table.names);
    for (CsvTable::Row row : table.rows) {
      for (std::size_t i = 1; i < row.fields.size(); ++i)
        row.fields[i] = plainDecimal(*numberIn(row.fields[i]) + off * random.normal());
      text += csvLine(row.fields);
    }
    writeBytes(file("rough.csv"), text);
  }
};

/// How far two motions take points of a scan apart, root mean square [L].
double apart(const std::string& scan, const Isometry3d& a, const Isometry3d& b) {
  const PointCloud cloud = readPoints(scan).value;
  double squares = 0;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    squares += (a * cloud.position(i) - b * cloud.position(i)).squaredNorm();
  return std::sqrt(squares / static_cast<double>(cloud.size()));
}

double spacingOf(const std::string& scan) {
  return pointSpacing(readPoints(scan).value.positions());
}

TEST_F(RegisterCommand, JoinsStationsByRoughPairsAndTheirPoints) {
  simulate();
  ASSERT_EQ(runProgram({"register", one_, two_, file("tree_3.ply"), "-o", joined_, "--pairs",
                        pairs_, "--no-icp", "--json", file("true.json")})
                .status,
            0);
  makeRough(0.03);
  const Outcome outcome =
      runProgram({"register", one_, two_, file("tree_3.ply"), "-o", joined_, "--pairs",
                  file("rough.csv"), "--json", file("all.json"), "--unit", "m"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("tree_2.ply: pair 1 is "));
  EXPECT_THAT(outcome.err, HasSubstr(" m apart"));
  EXPECT_THAT(outcome.err, HasSubstr("% overlap"));
  const double spacing = spacingOf(two_);
  EXPECT_LT(apart(two_, motionIn("all.json"), motionIn("true.json")), spacing);
  const auto json = jsonIn(file("all.json"));
  EXPECT_EQ(json["scans"].size(), 2U);
  EXPECT_EQ(json["scans"][1]["by_pairs"]["pairs"].size(), 4U);
  EXPECT_GT(json["scans"][0]["by_pairs"]["rms"].get<double>(), 0.01) << "they are rough";
  for (const auto& pair : json["scans"][0]["by_pairs"]["pairs"]) {
    const auto place = [&](const char* name) {
      return Vector3d(pair[name][0], pair[name][1], pair[name][2]);
    };
    EXPECT_NEAR(pair["apart"].get<double>(),
                (motionIn("all.json") * place("moved") - place("fixed")).norm(), 1e-9)
        << "in the end";
  }
  EXPECT_TRUE(json["scans"][0]["by_points"]["converged"].get<bool>());
  EXPECT_GT(json["scans"][0]["by_points"]["overlap"].get<double>(), 0.3);
  EXPECT_NEAR(json["scans"][0]["turn_degrees"].get<double>(), 10, 0.5);
  const PointCloud all = readPoints(joined_).value;
  EXPECT_EQ(all.size(), json["points"].get<Eigen::Index>());
  ASSERT_EQ(all.stations().size(), 3U);
  EXPECT_EQ(all.stations()[1].name, "station 2");
  const Vector3d scanner = *readPoints(two_).value.stations()[0].scanner;
  EXPECT_LT((*all.stations()[1].scanner - motionIn("all.json") * scanner).norm(), 1e-6);
  EXPECT_EQ(all.intensities().size(), static_cast<std::size_t>(all.size()));
}

// What is exactly 0.3 m and 10 degrees about z off comes back exactly.
TEST_F(RegisterCommand, FollowsTruePairsExactly) {
  simulate();
  const Outcome outcome = runProgram({"register", one_, two_, file("tree_3.ply"), "-o", joined_,
                                      "--pairs", pairs_, "--no-icp", "--json", file("true.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = jsonIn(file("true.json"));
  EXPECT_LT(json["scans"][0]["by_pairs"]["rms"].get<double>(), 1e-9);
  EXPECT_NEAR(json["scans"][0]["turn_degrees"].get<double>(), 10, 1e-6);
  EXPECT_FALSE(json["scans"][0].contains("by_points"));
}

TEST_F(RegisterCommand, RefinesByPointsAlone) {
  const Outcome made =
      runProgram({"simulate", "-o", file("tree"), "--stations", "4", "--points", "32000",
                  "--segments", "60", "--seed", "7", "--apart", "0.05,5"});
  ASSERT_EQ(made.status, 0) << made.err;
  ASSERT_EQ(runProgram({"register", one_, two_, file("tree_3.ply"), file("tree_4.ply"), "-o",
                        joined_, "--pairs", pairs_, "--no-icp", "--json", file("true.json")})
                .status,
            0);
  const Outcome outcome =
      runProgram({"register", one_, two_, "-o", joined_, "--json", file("alone.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_LT(apart(two_, motionIn("alone.json"), motionIn("true.json")), spacingOf(two_));
}

TEST_F(RegisterCommand, MovesAStructureWithItsScan) {
  simulate();
  const std::string structure = file("tree.mtg");
  const Outcome outcome = runProgram({"register", one_, two_, file("tree_3.ply"), "-o", joined_,
                                      "--pairs", pairs_, "--no-icp", "--structure", structure,
                                      file("moved.mtg"), "--json", file("true.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Skeleton before = readStructure(structure).value.skeleton;
  const Skeleton after = readStructure(file("moved.mtg")).value.skeleton;
  ASSERT_EQ(after.size(), before.size());
  const Isometry3d motion = motionIn("true.json");
  for (const NodeId id : before.ids()) {
    EXPECT_LT((after[id].position - motion * before[id].position).norm(), 1e-5);
    EXPECT_EQ(after[id].radius, before[id].radius);
  }
}

/// Appends the half of a sphere that a scanner in -x sees.
void addSphere(RawPoints& raw, const Vector3d& center, double radius, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    Vector3d to = random.direction();
    if (to.x() > 0) to.x() *= -1;
    raw.positions.emplace_back(center + radius * to);
  }
}

TEST_F(RegisterCommand, FindsTheCentersOfSpheres) {
  const Isometry3d intoMoved = Eigen::Translation3d(0.3, 0, 0) *
                               Eigen::AngleAxisd(10 * std::numbers::pi / 180, Vector3d::UnitZ()) *
                               Isometry3d::Identity();
  RawPoints fixed;
  RawPoints moved;
  std::string pairs;
  for (const Vector3d& center : {Vector3d(1, 0, 1), Vector3d(-1, 0.5, 1), Vector3d(0, -1, 2)}) {
    addSphere(fixed, center, 0.07, 1);
    addSphere(moved, intoMoved * center, 0.07, 2);
    // As people click: on the side that is seen. Without a header.
    const Vector3d clicked = intoMoved * center + Vector3d(-0.05, 0.02, 0.04);
    pairs += csvLine({plainDecimal(clicked.x()), plainDecimal(clicked.y()),
                      plainDecimal(clicked.z()), plainDecimal(center.x() - 0.07),
                      plainDecimal(center.y()), plainDecimal(center.z())});
  }
  writePoints(one_, PointCloud(std::move(fixed)));
  writePoints(two_, PointCloud(std::move(moved)));
  writeBytes(pairs_, pairs);
  const test::Arguments command = {"register", one_,   two_,       "-o",     joined_,
                                   "--pairs",  pairs_, "--no-icp", "--json", file("spheres.json")};
  const auto with = [&](const std::string& radius) {
    test::Arguments arguments = command;
    arguments.insert(arguments.end(), {"--spheres", radius});
    return runProgram(arguments);
  };
  EXPECT_EQ(runProgram(command).status, 0);
  EXPECT_GT(apart(two_, motionIn("spheres.json"), intoMoved.inverse()), 0.01) << "as clicked";
  EXPECT_EQ(with("0.07").status, 0);
  EXPECT_LT(apart(two_, motionIn("spheres.json"), intoMoved.inverse()), 1e-4);
  expectRefusal(with("0.2"), 1, {two_, "pair 1, moved scan", "no sphere of radius 0.2"});
}

TEST_F(RegisterCommand, RefusesWhatItCannotDoInOneLine) {
  simulate("2", "4000");
  const auto with = [&](test::Arguments more) {
    more.insert(more.begin(), {"register", one_, two_, "-o", joined_});
    return runProgram(more);
  };
  expectRefusal(with({"--no-icp"}), 2, {"--pairs"});
  expectRefusal(with({"--spheres", "0.1"}), 2, {"--pairs"});
  expectRefusal(with({"--overlap", "2"}), 2, {"--overlap"});
  expectRefusal(with({"--structure", file("tree.mtg")}), 2, {"--structure"});
  expectRefusal(runProgram({"register", one_, "-o", joined_}), 2, {"MOVED"});
  expectRefusal(runProgram({"register", one_, two_, "-o", two_}), 1, {two_});
  expectRefusal(runProgram({"register", one_, file("none.ply"), "-o", joined_}), 1, {"none.ply"});
  const auto pairs = [&](const std::string& text) {
    writeBytes(file("bad.csv"), text);
    return with({"--pairs", file("bad.csv"), "--no-icp"});
  };
  expectRefusal(pairs("x,y,z\n1,2,3\n"), 1, {"bad.csv, line 1", "fixed_x"});
  expectRefusal(pairs("0,0,0,0,0,0\n1,0,0,1,0\n"), 1, {"bad.csv, line 2", "fixed_z"});
  expectRefusal(pairs("0,0,0,0,0,0\n1,0,0,1,0,here\n"), 1, {"bad.csv, line 2", "here"});
  expectRefusal(pairs("0;0;0;0;0;0\n1;0;0;1;0;0;5\n"), 1, {"bad.csv, line 2", "6 fields"});
  expectRefusal(pairs("1,0,0,0,0,0,0\n3,0,0,1,0,0,1\n"), 1, {"bad.csv, line 2", "no scan '3'"});
  expectRefusal(pairs("0,0,0,0,0,0\n1,0,0,1,0,0\n"), 1, {two_, "2 pairs"});
  expectRefusal(pairs("0,0,0,0,0,0\n1,0,0,1,0,0\n2,0,0,2,0,0\n"), 1, {two_, "on a line"});
  expectRefusal(with({"--pairs", file("missing.csv")}), 1, {"missing.csv"});
  EXPECT_FALSE(fs::exists(joined_));
}

TEST_F(RegisterCommand, RefusesScansThatDoNotOverlap) {
  simulate("2", "4000");
  RawPoints far;
  const PointCloud cloud = readPoints(two_).value;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    far.positions.emplace_back(cloud.position(i) + Vector3d(100, 0, 0));
  writePoints(file("far.ply"), PointCloud(std::move(far)));
  expectRefusal(runProgram({"register", one_, file("far.ply"), "-o", joined_}), 1,
                {"far.ply", "do not overlap"});
  EXPECT_FALSE(fs::exists(joined_));
}

TEST_F(RegisterCommand, NeedsAScanColumnOnlyForSeveralScans) {
  simulate();
  writeBytes(file("one.csv"), "0,0,0,0,0,0\n1,0,0,1,0,0\n0,1,0,0,1,0\n");
  expectRefusal(runProgram({"register", one_, two_, file("tree_3.ply"), "-o", joined_, "--pairs",
                            file("one.csv")}),
                1, {"one.csv, line 1", "no column scan"});
  EXPECT_EQ(
      runProgram({"register", one_, two_, "-o", joined_, "--pairs", file("one.csv"), "--no-icp"})
          .status,
      0);
  const std::string pairs = "0\t0\t0\t0\t0\t0\n\n"
                            "1\t0\t0\t1\t0\t0\n"
                            "0\t1\t0\t0\t1\t0\n";
  writeBytes(file("tabs.csv"), "\n" + pairs);
  EXPECT_EQ(
      runProgram({"register", one_, two_, "-o", joined_, "--pairs", file("tabs.csv"), "--no-icp"})
          .status,
      0);
}

} // namespace
} // namespace espalier
