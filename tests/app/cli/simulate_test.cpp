#include "core/base/spatial_index.h"
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
  EXPECT_EQ(runProgram({"simulate", "--from", truth_, "-o", file("a"), "--points", "5000"}).status,
            0);
  const PointCloud cloud = readPoints(file("a.ply")).value;
  const Eigen::AlignedBox3d wanted = readPoints(scan_).value.bounds();
  EXPECT_LT((cloud.bounds().sizes() - wanted.sizes()).norm(), 0.2 * wanted.sizes().norm());
}

} // namespace
} // namespace espalier
