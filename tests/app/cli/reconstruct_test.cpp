#include "core/io/formats.h"
#include "core/radius/assigned_radii.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/checks.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <numeric>
#include <sstream>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::namesIn;
using test::Outcome;
using test::runProgram;
using test::Subcommands;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Eigen::Vector3d rootOf(const fs::path& structure) {
  const Skeleton plant = readStructure(structure).value.skeleton;
  return plant[plant.roots().front()].position;
}

TEST_F(Subcommands, ReconstructFindsOnePlantWithRadii) {
  EXPECT_THAT(
      run({"reconstruct", scan_, "-o", file("a.mtg"), "--json", file("a.json"), "--unit", "m"}),
      IsEmpty());
  const Skeleton plant = readStructure(file("a.mtg")).value.skeleton;
  EXPECT_EQ(plant.roots().size(), 1U);
  for (const Finding& finding : check(plant)) // where wood turns or touches is the plant's
    EXPECT_TRUE(finding.kind == Finding::Kind::sharpTurn ||
                finding.kind == Finding::Kind::crossing || finding.kind == Finding::Kind::loop)
        << describe(finding, plant);
  for (const NodeId id : plant.ids())
    ASSERT_GT(plant[id].radius, 0);
  const json statistics = test::jsonIn(file("a.json"));
  EXPECT_EQ(statistics["scan"], scan_);
  EXPECT_EQ(statistics["unit"], "m");
  EXPECT_EQ(statistics["cloud"]["points"], readPoints(scan_).value.size());
  EXPECT_EQ(statistics["skeleton"]["nodes"], plant.size());
  EXPECT_EQ(statistics["steps"].size(), 12U);
  const json sources = statistics["radius_sources"];
  EXPECT_EQ(sources["measured"].get<std::size_t>() + sources["corrected"].get<std::size_t>() +
                sources["extrapolated"].get<std::size_t>(),
            statistics["skeleton"]["nodes"].get<std::size_t>());
  EXPECT_EQ(statistics["steps"][2]["method"], "geodesic_centroid");
  EXPECT_TRUE(statistics["seconds"].contains("Contract"));
  EXPECT_THAT(namesIn(folder_), ElementsAre("a.json", "a.mtg"));
}

TEST_F(Subcommands, ReconstructListsDoubtfulEndsWhereTheyAreDecidedByOdds) {
  run({"reconstruct", scan_, "-o", file("a.mtg"), "--json", file("a.json")});
  const json ends = test::jsonIn(file("a.json"))["ends"];
  const Skeleton plant = readStructure(file("a.mtg")).value.skeleton;
  EXPECT_EQ(ends["asked"].get<std::size_t>() - ends["removed"].get<std::size_t>(),
            branchEnds(plant).size());
  EXPECT_GT(ends["expected_wrong"], 0);
  EXPECT_LT(ends["expected_wrong"], ends["asked"]);
  for (const json& end : ends["doubtful"]) {
    EXPECT_GE(end["probability"], 0.2);
    EXPECT_LE(end["probability"], 0.8);
    EXPECT_NE(end["foot"], end["tip"]);
  }
  run({"reconstruct", scan_, "-o", file("b.mtg"), "--json", file("b.json"), "--set",
       "prune.method=spurs"});
  EXPECT_TRUE(test::jsonIn(file("b.json"))["ends"].is_null()) << "nothing is asked";
}

TEST_F(Subcommands, ReconstructListsDoubtfulGapsWithTheirAlternatives) {
  run({"simulate", "-o", file("sparse"), "--points", "4000", "--segments", "150", "--seed", "3"});
  run({"reconstruct", file("sparse.ply"), "-o", file("a.mtg"), "--json", file("a.json")});
  const json gaps = test::jsonIn(file("a.json"))["gaps"];
  ASSERT_GT(gaps["asked"], 0);
  EXPECT_LE(gaps["doubtful"].size(), gaps["asked"].get<std::size_t>());
  for (const json& gap : gaps["doubtful"]) {
    const json& chosen = gap["alternatives"][gap["chosen"].get<std::size_t>()];
    EXPECT_LE(chosen["probability"], 0.8);
    EXPECT_GE(gap["nodes"], 1);
  }
  run({"reconstruct", file("sparse.ply"), "-o", file("b.mtg"), "--json", file("b.json"), "--set",
       "join.method=by_direction"});
  EXPECT_TRUE(test::jsonIn(file("b.json"))["gaps"].is_null()) << "nothing is asked";
}

TEST_F(Subcommands, ReconstructUsesWhatIsSet) {
  test::writeBytes(
      file("preset.json"),
      R"({"contract": {"radius": 0.07, "neighbors": 9}, "prune": {"method": "none"}})");
  run({"reconstruct", scan_, "-o", file("a.mtg"), "--json", file("a.json"), "--preset",
       file("preset.json"), "--set", "contract.radius=0.05", "--set", "axes.sharpest_turn=45"});
  const json steps = test::jsonIn(file("a.json"))["steps"];
  EXPECT_EQ(steps[2]["options"]["radius"], 0.05) << "what is set changes the preset";
  run({"reconstruct", scan_, "-o", file("b.mtg"), "--set", "contract.radius=0.05", "--set",
       "axes.sharpest_turn=45", "--json", file("b.json"), "--preset", file("preset.json")});
  EXPECT_EQ(test::jsonIn(file("b.json"))["steps"], steps) << "wherever it stands";
  EXPECT_EQ(steps[2]["options"]["neighbors"], 9);
  const auto named = [&](const std::string& name) {
    return *std::ranges::find_if(steps, [&](const json& step) { return step["step"] == name; });
  };
  EXPECT_EQ(named("prune")["method"], "none");
  EXPECT_EQ(named("axes")["options"]["sharpest_turn"], 45);
}

TEST_F(Subcommands, ReconstructBeginsAnotherMethodThanThePresetsWithItsDefaults) {
  const auto contractionWith = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> all = {"reconstruct", scan_,    "-o",     file("a.mtg"),
                                    "--preset",    "thesis", "--json", file("a.json")};
    all.insert(all.end(), flags.begin(), flags.end());
    run(all);
    const json steps = test::jsonIn(file("a.json"))["steps"];
    return *std::ranges::find_if(steps,
                                 [](const json& step) { return step["step"] == "contract"; });
  };
  const json own = contractionWith({"--set", "contract.method=geodesic_centroid"});
  EXPECT_EQ(own["method"], "geodesic_centroid");
  const json set = contractionWith(
      {"--set", "contract.radius=0.05", "--set", "contract.method=geodesic_centroid"});
  EXPECT_NE(own["options"]["radius"], 0.05);
  EXPECT_EQ(set["options"]["radius"], 0.05) << "the method first, in whatever order";
  expectRefusal(
      runProgram({"reconstruct", scan_, "-o", file("a.mtg"), "--preset", "thesis", "--set",
                  "contract.method=geodesic_centroid", "--set", "contract.curve=0.5"}),
      2, {"method geodesic_centroid of step contract has no option \"curve\""});
}

TEST_F(Subcommands, ReconstructStartsAtTheRootThatIsGiven) {
  const Skeleton truth = readStructure(truth_).value.skeleton;
  Eigen::Vector3d top = Eigen::Vector3d::Zero();
  for (const NodeId id : truth.ids())
    if (truth[id].position.z() > top.z()) top = truth[id].position;
  std::ostringstream place;
  place << top.x() << ',' << top.y() << ',' << top.z();
  run({"reconstruct", scan_, "-o", file("top.mtg"), "--root", place.str()});
  EXPECT_LT((rootOf(file("top.mtg")) - top).norm(), 0.1);
  run({"reconstruct", scan_, "-o", file("lowest.mtg"), "--root", "lowest"});
  EXPECT_LT(rootOf(file("lowest.mtg")).norm(), 0.1) << "the sample stands at the origin";
}

TEST_F(Subcommands, ReconstructKnowsWhereUpIs) {
  std::ostringstream turned; // z becomes x
  const PointCloud cloud = readPoints(scan_).value;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.position(i);
    turned << p.z() << ' ' << p.x() << ' ' << p.y() << '\n';
  }
  test::writeBytes(file("turned.xyz"), turned.str());
  run({"reconstruct", file("turned.xyz"), "-o", file("a.mtg"), "--up", "x"});
  EXPECT_LT(rootOf(file("a.mtg")).norm(), 0.1);
}

/// The points of a scan in map coordinates, so often each, then more lines.
std::string movedText(const PointCloud& cloud, int copies, const std::string& more) {
  std::ostringstream text;
  text.precision(12);
  for (int copy = 0; copy < copies; ++copy)
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d place = cloud.position(i) + Eigen::Vector3d(430'000, 5'410'000, 0);
      text << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    }
  return text.str() + more;
}

TEST_F(Subcommands, ReconstructMakesTheSameOfAScanWithStraysOrRepeatedPoints) {
  const PointCloud cloud = readPoints(scan_).value;
  const auto skeletonOf = [&](const std::string& text, const std::string& note) {
    test::writeBytes(file("scan.xyz"), text);
    const Outcome outcome = runProgram({"reconstruct", file("scan.xyz"), "-o", file("a.mtg")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, testing::HasSubstr(note));
    return readStructure(file("a.mtg")).value.skeleton;
  };
  const Skeleton alone = skeletonOf(movedText(cloud, 1, {}), "wrote");
  EXPECT_GT(alone.size(), 50U);
  EXPECT_EQ(skeletonOf(movedText(cloud, 1, "0 0 0\n"), "1 point lies far from all others"), alone);
  EXPECT_EQ(skeletonOf(movedText(cloud, 1, "430030 5410000 0\n"), "far from all others"), alone);
  EXPECT_EQ(skeletonOf(movedText(cloud, 9, {}), "each place counts once"), alone);
}

TEST_F(Subcommands, ContractPullsPointsTowardsTheAxes) {
  EXPECT_THAT(run({"contract", scan_, "-o", file("a.ply")}), IsEmpty());
  const PointCloud before = readPoints(scan_).value;
  const PointCloud after = readPoints(file("a.ply")).value;
  ASSERT_EQ(after.size(), before.size());
  const Skeleton truth = readStructure(truth_).value.skeleton;
  const auto meanDistance = [&](const PointCloud& cloud) {
    const std::vector<double> distances =
        meanPointDistances(truth, cloud.positions(), cloud.origin());
    return std::accumulate(distances.begin(), distances.end(), 0.0);
  };
  EXPECT_LT(meanDistance(after), 0.8 * meanDistance(before));
}

TEST_F(Subcommands, ContractReportsHowGoodItIs) {
  run({"contract", scan_, "-o", file("a.ply"), "--json", file("a.json")});
  run({"contract", scan_, "-o", file("b.ply"), "--json", file("b.json"), "--method", "none"});
  const json contracted = test::jsonIn(file("a.json"))["quality"];
  const json asScanned = test::jsonIn(file("b.json"))["quality"];
  EXPECT_LT(contracted["residual_thickness"], asScanned["residual_thickness"]);
  EXPECT_GT(contracted["share_on_line"], asScanned["share_on_line"]);
  EXPECT_EQ(contracted["tips"], asScanned["tips"]) << "of the scan";
  EXPECT_FALSE(contracted.contains("nodes")) << "there is no skeleton";
}

TEST_F(Subcommands, SweepTriesEachValue) {
  const std::string out =
      run({"sweep", scan_, "contract.radius", "--values", "0.03,8 spacings", "--reference", truth_,
           "--csv", file("a.csv"), "--json", file("a.json")});
  EXPECT_EQ(std::ranges::count(out, '\n'), 3) << "a head and two rows";
  const json results = test::jsonIn(file("a.json"))["results"];
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0]["value"], 0.03);
  for (const json& result : results) {
    EXPECT_GT(result["quality"]["nodes"], 10);
    EXPECT_GT(result["scores"]["geometric"], 0.2);
  }
  std::istringstream table(test::bytesOf(file("a.csv")));
  std::string head;
  std::getline(table, head);
  EXPECT_THAT(head, testing::StartsWith("value,quality.residual_thickness,"));
  EXPECT_THAT(head, HasSubstr(",scores.structural,"));
}

TEST_F(Subcommands, SweepTriesTheMethodsOfAStep) {
  const std::string out = run({"sweep", scan_, "contract.method", "--values", "euclidean_ball,none",
                               "--json", file("a.json")});
  EXPECT_THAT(out, HasSubstr("euclidean_ball"));
  const json results = test::jsonIn(file("a.json"))["results"];
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[1]["value"], "none");
  EXPECT_LT(results[0]["quality"]["residual_thickness"],
            results[1]["quality"]["residual_thickness"]);
}

TEST_F(Subcommands, SweepRefusesWhatItCannotTry) {
  test::expectRefusal(runProgram({"sweep", scan_, "contract.method", "--values", "magic"}), 2,
                      {"magic", "euclidean_ball"});
  test::expectRefusal(runProgram({"sweep", scan_, "radius"}), 2, {"STEP.OPTION"});
  test::expectRefusal(runProgram({"sweep", scan_, "contract.strength"}), 2,
                      {"no option", "radius"});
  test::expectRefusal(runProgram({"sweep", scan_, "contract.radius", "--values", "wide"}), 2,
                      {"contract.radius", "wide"});
  test::expectRefusal(runProgram({"sweep", scan_, "skeleton.power", "--method", "shortest_paths",
                                  "--unit", "m", "--values", "500mm"}),
                      2, {"skeleton.power must be a number, not '500mm'"});
  test::expectRefusal(
      runProgram({"reconstruct", scan_, "-o", file("x.mtg"), "--unit", "mm", "--method",
                  "shortest_paths", "--set", "skeleton.merge_angle=30mm"}),
      2, {"skeleton.merge_angle must be a number, not '30mm'"});
}

TEST_F(Subcommands, ReconstructWritesAxesIfAskedAndReportsTheLengthInItsUnit) {
  const Outcome outcome = runProgram({"reconstruct", scan_, "-o", file("a.mtg"), "--unit", "m",
                                      "--mtg-scales", "plant-axis-node"});
  const json info = json::parse(run({"info", file("a.mtg"), "--json"}));
  ASSERT_EQ(info["vertices_per_scale"].size(), 4U);
  EXPECT_EQ(info["vertices_per_scale"][2], info["branching_edges"].get<int>() / 2 + 1)
      << "an axis for the root and each branching node; its edges are named at both scales";
  std::ostringstream wrote;
  wrote.precision(6);
  wrote << "espalier: wrote " << file("a.mtg") << ": " << info["nodes"] << " nodes, length "
        << info["length"].get<double>() << " m\n";
  EXPECT_EQ(outcome.err, wrote.str());
}

TEST_F(Subcommands, ReconstructReportsThatItFoundNoBranch) {
  std::ofstream(file("two.xyz")) << "0 0 0\n0 0 1\n";
  const Outcome outcome = runProgram({"reconstruct", file("two.xyz"), "-o", file("two.mtg")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "espalier: note: " + file("two.xyz") +
                             ": no branch is found: the scan has too few points, or the lengths of "
                             "the steps are too long for it\nespalier: wrote " +
                             file("two.mtg") + ": 1 node, length 0\n");
}

// Nothing is measured about so few places.
TEST_F(Subcommands, ReconstructReportsWhatAStepNotes) {
  std::ofstream scan(file("crowds.xyz"));
  for (int i = 0; i < 9; ++i)
    scan << "0 0 0\n0 0 3\n";
  scan << "100 0 0\n100 0 0.1\n";
  scan.close();
  const std::string note = "no radius is measured: radii are a guess; they have the exponent of "
                           "published structures, 1/2.9, from tips half as thick as the points are "
                           "apart";
  const Outcome outcome =
      runProgram({"reconstruct", file("crowds.xyz"), "-o", file("a.mtg"), "--json", file("a.json"),
                  "--set", "radius.method=node_count_pipe"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("espalier: note: " + file("crowds.xyz") + ": Radius: " + note + "\n"));
  const json steps = test::jsonIn(file("a.json"))["steps"];
  EXPECT_EQ(steps.back()["notes"], json::array({note}));
  EXPECT_FALSE(steps.front().contains("notes"));
}

} // namespace
} // namespace espalier
