#include "core/base/spatial_index.h"
#include "core/base/text.h"
#include "core/io/csv.h"
#include "core/io/formats.h"
#include "core/skeleton/assign_points.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::Outcome;
using test::runProgram;
using test::Subcommands;
using testing::IsEmpty;
using testing::StartsWith;

TEST_F(Subcommands, SimulateWritesAScanAndItsTruth) {
  const Outcome outcome =
      runProgram({"simulate", "-o", file("a"), "--points", "3000", "--segments", "40", "--height",
                  "300", "--architecture", "shrub", "--strays", "0"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, IsEmpty());
  const PointCloud cloud = readPoints(file("a.ply")).value;
  const Skeleton truth = readStructure(file("a.mtg")).value.skeleton;
  EXPECT_NEAR(static_cast<double>(cloud.size()), 3000, 600);
  EXPECT_NEAR(cloud.bounds().max().z(), 300, 15);
  EXPECT_THAT(outcome.err,
              StartsWith("espalier: wrote " + file("a.ply") + ": " + std::to_string(cloud.size()) +
                         " points\nespalier: wrote " + file("a.mtg") + ": " +
                         std::to_string(truth.size()) + " nodes, length "));
}

TEST_F(Subcommands, SimulateAddsFoliageToTheScanAlone) {
  struct Result {
    Skeleton truth;
    std::ptrdiff_t away = 0; // points farther from the axes than the stem is thick
  };
  const auto simulated = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"simulate", "-o", file("a"), "--architecture", "conifer",
                                 "--points", "5000", "--segments", "40", "--strays", "0"});
    EXPECT_EQ(runProgram(flags).status, 0);
    const PointCloud cloud = readPoints(file("a.ply")).value;
    Result result{.truth = readStructure(file("a.mtg")).value.skeleton};
    for (const PointOnSkeleton& place :
         assignPoints(cloud.positions(), cloud.origin(), result.truth, {}))
      if (place.distance > 0.06) ++result.away;
    return result;
  };
  const Result bare = simulated({});
  const Result leafy = simulated({"--foliage", "2", "--foliage-length", "0.05"});
  const Result flat =
      simulated({"--foliage", "2", "--foliage-length", "0.05", "--foliage-angle", "0"});
  EXPECT_EQ(leafy.truth, bare.truth);
  EXPECT_GT(leafy.away, bare.away + 300);
  EXPECT_GT(leafy.away, 2 * flat.away) << "along the wood, needles stay near it";
}

/// A stem of height 4 with few leaves, and how its points lie.
struct LeafyStem {
  double lowest = 0;
  double widest = 0; // from the axis of the stem
  Eigen::Index points = 0;
};

/// Arguments of a stem of height 4 with leaves.
std::vector<std::string> leafyStem(const std::string& prefix,
                                   const std::vector<std::string>& leaves) {
  std::vector<std::string> all = {
      "simulate", "-o",       prefix, "--architecture", "herb", "--segments", "1", "--points",
      "6000",     "--strays", "0",    "--height",       "4",    "--foliage",  "1"};
  all.insert(all.end(), leaves.begin(), leaves.end());
  return all;
}

TEST_F(Subcommands, SimulateShapesLeaves) {
  const auto simulated = [&](std::vector<std::string> flags) {
    for (const char* flag : {"--foliage-length", "0.4", "--foliage-width", "0.04", "--foliage-gap",
                             "0.2", "--foliage-angle", "90"})
      flags.emplace_back(flag);
    const Outcome outcome = runProgram(leafyStem(file("a"), flags));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const PointCloud cloud = readPoints(file("a.ply")).value;
    LeafyStem stem{.lowest = cloud.bounds().min().z(), .points = cloud.size()};
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      stem.widest = std::max(stem.widest, cloud.position(i).head<2>().norm());
    return stem;
  };
  const LeafyStem stiff = simulated({"--foliage-reach", "10"});
  EXPECT_GT(stiff.widest, 0.7 * 0.4 * 4) << "0.7 to 1.3 times as long as they are asked for";
  EXPECT_LT(stiff.widest, 1.3 * 0.4 * 4 + 0.6) << "from a stem that leans by up to 0.6";
  const LeafyStem drooping = simulated({"--foliage-reach", "10", "--droop", "170"});
  EXPECT_LT(drooping.widest, 0.85 * stiff.widest);
  const LeafyStem stalked = simulated({"--foliage-reach", "10", "--petiole", "1"});
  EXPECT_GT(stalked.widest, 1.5 * stiff.widest) << "its petiole is as long as the blade";
  const LeafyStem atTop = simulated({"--foliage-reach", "0.01"});
  EXPECT_LT(atTop.widest, 0.7 * stiff.widest) << "hardly any leaf";
}

TEST_F(Subcommands, SimulateAddsLeaflets) {
  const auto sidewards = [&](const char* leaflets) { // points far from any straight petiole
    const Outcome outcome = runProgram(leafyStem(
        file("a"), {"--foliage-length", "0.2", "--foliage-width", "0.1", "--foliage-gap", "0.3",
                    "--foliage-reach", "10", "--petiole", "2", "--leaflets", leaflets}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const PointCloud cloud = readPoints(file("a.ply")).value;
    const Skeleton truth = readStructure(file("a.mtg")).value.skeleton;
    std::ptrdiff_t near = 0; // along the petioles
    for (const PointOnSkeleton& place : assignPoints(cloud.positions(), cloud.origin(), truth, {}))
      near += place.distance > 0.3 && place.distance < 1.2;
    return static_cast<double>(near) / static_cast<double>(cloud.size());
  };
  EXPECT_GT(sidewards("3"), 2 * sidewards("0"));
}

TEST_F(Subcommands, SimulateRefusesLeavesThatAreNone) {
  const auto refusal = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"simulate", "-o", file("a"), "--points", "1000"});
    const Outcome outcome = runProgram(flags);
    EXPECT_NE(outcome.status, 0);
    EXPECT_THAT(test::namesIn(folder_), testing::Not(testing::Contains("a.ply")));
    return outcome.err;
  };
  EXPECT_THAT(refusal({"--droop", "40"}), testing::HasSubstr("add --foliage 1"));
  EXPECT_THAT(refusal({"--foliage", "1", "--leaflets", "2"}), testing::HasSubstr("add --petiole"));
  for (const char* flag : {"--petiole", "--leaflets", "--droop", "--foliage-gap"})
    EXPECT_THAT(refusal({"--foliage", "1", flag, "1000"}), testing::HasSubstr(flag));
}

TEST_F(Subcommands, SimulateHidesWoodInClumpsOfLeaves) {
  const auto unseen = [&](const char* clumps) { // nodes of the truth without points nearby
    EXPECT_EQ(runProgram({"simulate", "-o", file("a"), "--points", "5000", "--segments", "40",
                          "--clumps", clumps})
                  .status,
              0);
    const PointCloud cloud = readPoints(file("a.ply")).value;
    const SpatialIndex index(cloud.positions());
    const Skeleton truth = readStructure(file("a.mtg")).value.skeleton;
    const std::vector<NodeId> ids = truth.ids();
    return std::ranges::count_if(ids, [&](NodeId id) {
      const Eigen::Vector3d place = truth[id].position - cloud.origin();
      return index.within(place.cast<float>(), 0.1F).empty();
    });
  };
  EXPECT_GT(unseen("30"), unseen("0") + 20);
}

TEST_F(Subcommands, SimulateScansAnyStructure) {
  expectRefusal(runProgram({"simulate", "--from", truth_, "-o", file("a"), "--segments", "60"}), 2,
                {"--from excludes --segments"});
  EXPECT_EQ(runProgram({"simulate", "--from", truth_, "-o", file("a"), "--points", "5000"}).status,
            0);
  const PointCloud cloud = readPoints(file("a.ply")).value;
  const Eigen::AlignedBox3d wanted = readPoints(scan_).value.bounds();
  EXPECT_LT((cloud.bounds().sizes() - wanted.sizes()).norm(), 0.2 * wanted.sizes().norm());
}

// A turn by 10 degrees about the upright axis, then 0.3 along x: heights stay, and so does what
// lies between any two points.
TEST_F(Subcommands, SimulateSavesStationsApart) {
  const Outcome outcome = runProgram({"simulate", "-o", file("a"), "--stations", "3", "--points",
                                      "6000", "--segments", "40", "--apart", "0.3,10"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(test::namesIn(folder_),
            (std::vector<std::string>{"a.mtg", "a_1.ply", "a_2.ply", "a_3.ply", "a_pairs.csv"}));
  Eigen::Index points = 0;
  for (const char* name : {"a_1.ply", "a_2.ply", "a_3.ply"}) {
    const PointCloud cloud = readPoints(file(name)).value;
    points += cloud.size();
    ASSERT_EQ(cloud.stations().size(), 1U) << name;
    EXPECT_TRUE(cloud.stations()[0].scanner) << name;
    EXPECT_FALSE(cloud.intensities().empty()) << name;
  }
  EXPECT_NEAR(static_cast<double>(points), 6000, 900);
  const CsvTable pairs = readCsv(test::bytesOf(file("a_pairs.csv")), "a_pairs.csv");
  ASSERT_EQ(pairs.rows.size(), 8U) << "four for either of two";
  EXPECT_EQ(pairs.rows[0].fields[0], "a_2.ply");
  std::vector<Eigen::Vector3d> moved;
  std::vector<Eigen::Vector3d> fixed;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto number = [&](std::size_t k) { return *numberIn(pairs.rows[i].fields[k]); };
    moved.emplace_back(number(1), number(2), number(3));
    fixed.emplace_back(number(4), number(5), number(6));
    EXPECT_NEAR(moved[i].z(), fixed[i].z(), 1e-9);
    EXPECT_NEAR((moved[i] - moved[0]).norm(), (fixed[i] - fixed[0]).norm(), 1e-9);
  }
  const Eigen::Vector3d shift =
      (moved[0] + moved[1] + moved[2] + moved[3] - fixed[0] - fixed[1] - fixed[2] - fixed[3]) / 4;
  EXPECT_LT((shift - Eigen::Vector3d(0.3, 0, 0)).norm(), 1e-9);
}

TEST_F(Subcommands, SimulateRefusesStationsThatCannotBeApart) {
  const auto with = [&](test::Arguments more) {
    more.insert(more.begin(), {"simulate", "-o", file("a"), "--apart"});
    return runProgram(more);
  };
  test::expectRefusal(with({"0.3"}), 2, {"--apart"});
  test::expectRefusal(with({"0.3,x"}), 2, {"--apart"});
  test::expectRefusal(with({"0.3,nan"}), 2, {"--apart"});
  test::expectRefusal(with({"0.3,10", "--stations", "1"}), 2, {"--stations 2"});
  test::expectRefusal(with({"0.3,10", "--plants", "2"}), 2, {"--plants"});
}

} // namespace
} // namespace espalier
