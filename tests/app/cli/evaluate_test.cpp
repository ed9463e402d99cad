#include "core/io/csv.h"
#include "tests/app/cli/evaluate_files.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::expectRefusal;
using test::Outcome;
using test::runProgram;
using testing::HasSubstr;
using testing::IsEmpty;

class Evaluate : public test::EvaluateFiles {};

TEST_F(Evaluate, ReportsWhatTheAuthorsIndicesHide) {
  const std::string printed =
      runProgram({"evaluate", truth_, truth_, "--json", file("a.json")}).out;
  EXPECT_THAT(printed, HasSubstr("over all segments of the reference, structural index 1.000; "
                                 "one to many, geometric index 1.000\n"));
  EXPECT_THAT(printed, HasSubstr(" precision     recall          F   capped G   capped T\n"));
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_EQ(numbers["authors"]["structural_of_all"], 1);
  EXPECT_EQ(numbers["authors"]["one_to_many"]["geometric"], 1);
  ASSERT_EQ(numbers["capped"].size(), numbers["tolerance"].size());
  for (std::size_t k = 0; k < numbers["capped"].size(); ++k) {
    EXPECT_EQ(numbers["capped"][k]["distance"], numbers["tolerance"][k]["distance"]);
    for (const char* key : {"mapping", "geometric", "structural", "structural_of_all"})
      EXPECT_EQ(numbers["capped"][k][key], 1) << key;
  }
}

TEST_F(Evaluate, ReportsNoAgreementOfPlantsThatAreNowhereNear) {
  std::ofstream(file("far.swc")) << "1 0 1e4 0 0 1 -1\n2 0 1e4 0 1 1 1\n3 0 1e4 0 2 1 2\n";
  const std::string printed = runProgram({"evaluate", file("far.swc"), truth_, "--no-register",
                                          "--where", "--json", file("a.json")})
                                  .out;
  EXPECT_THAT(printed, HasSubstr("nothing lies near the reference"));
  EXPECT_THAT(printed, testing::Not(HasSubstr("100.0%")));
  EXPECT_THAT(printed, HasSubstr("\n                 1          -      0.000            0"))
      << "of the result there is no order 1";
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_TRUE(numbers["architecture"]["same_axis"].is_null());
  EXPECT_TRUE(numbers["architecture"]["edge_kappa"].is_null());
}

TEST_F(Evaluate, WritesNothingIfTheScanOfTheReportIsMissing) {
  const Outcome outcome = runProgram({"evaluate", truth_, truth_, "--json", file("a.json"),
                                      "--report", file("a.html"), "--scan", file("none.ply")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, testing::IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(file("a.json")));
}

TEST_F(Evaluate, ReportsWhatIsAttachedToWhat) {
  const std::string printed =
      runProgram({"evaluate", truth_, truth_, "--json", file("a.json")}).out;
  EXPECT_THAT(printed, HasSubstr("DIADEM-like score 1.000\n  100.0% of paths along the plant"));
  EXPECT_THAT(printed,
              HasSubstr("100.0% of the length is of the same order, 100.0% on the same axis"));
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_EQ(numbers["diadem"]["score"], 1);
  EXPECT_EQ(numbers["diadem"]["connected"], numbers["diadem"]["landmarks"]);
  EXPECT_EQ(numbers["path_lengths"]["within_tenth"], 1);
  EXPECT_EQ(numbers["architecture"]["same_axis"], 1);
  EXPECT_EQ(numbers["architecture"]["same_edge"], 1);
}

TEST_F(Evaluate, RanksSeveralResultsTheBestFirst) {
  ASSERT_EQ(runProgram({"reconstruct", test::sample("young_tree.ply"), "-o", file("a.mtg")}).status,
            0);
  const Outcome outcome = runProgram({"evaluate", file("a.mtg"), truth_, truth_, "--draws", "200",
                                      "--csv", file("r.csv"), "--json", file("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ranked by f within "));
  EXPECT_THAT(outcome.out, HasSubstr("\n   1  " + truth_));
  EXPECT_THAT(outcome.out, HasSubstr("  1.000 (1.000-1.000)"));
  EXPECT_THAT(outcome.out, HasSubstr("\n   2  " + file("a.mtg")));
  const json numbers = json::parse(test::bytesOf(file("r.json")));
  EXPECT_EQ(numbers["reference"], truth_);
  EXPECT_EQ(numbers["results"][0]["result"], truth_);
  EXPECT_EQ(numbers["results"][1]["rank"], 2);
  const json& f = numbers["results"][1]["scores"]["f"];
  EXPECT_LT(f["low"], f["value"]);
  EXPECT_GT(f["high"], f["value"]);
  const CsvTable table = readCsv(test::bytesOf(file("r.csv")), "r.csv");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1].fields[*table.column("f")], f["value"].dump());
}

TEST_F(Evaluate, TakesOneDistanceForAllThatIsNear) {
  const std::vector<std::string> at = {"--distance", "0.0625", "--no-register"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), at.begin(), at.end());
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(run({"evaluate", truth_, truth_, "--where", "--json", file("d.json")}),
              HasSubstr("\nwithin 0.0625"));
  const json numbers = json::parse(test::bytesOf(file("d.json")));
  EXPECT_EQ(numbers["by_place"]["distance"], 0.0625);
  EXPECT_THAT(run({"evaluate", truth_, truth_, truth_, "--draws", "20"}),
              HasSubstr("ranked by f within 0.0625"));
  // The same rule without it, in a ranking as of a pair.
  ASSERT_EQ(runProgram({"evaluate", truth_, truth_, "--json", file("p.json")}).status, 0);
  ASSERT_EQ(runProgram({"evaluate", truth_, truth_, "--ranking", "--draws", "20", "--json",
                        file("q.json")})
                .status,
            0);
  EXPECT_EQ(json::parse(test::bytesOf(file("p.json")))["by_place"]["distance"],
            json::parse(test::bytesOf(file("q.json")))["distance"]);
}

TEST_F(Evaluate, RanksOneResultIfAsked) {
  const Outcome outcome = runProgram({"evaluate", truth_, truth_, "--ranking", "--rank-by",
                                      "geometric", "--draws", "20", "--no-register"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("ranked by geometric within "));
}

TEST_F(Evaluate, ShowsTheScoreThatItRanksBy) {
  const auto headOf = [&](const char* score) {
    const std::string out = runProgram({"evaluate", truth_, truth_, "--ranking", "--rank-by", score,
                                        "--draws", "20", "--no-register"})
                                .out;
    const std::string head = out.substr(out.find("rank "));
    return head.substr(0, head.find('\n'));
  };
  EXPECT_THAT(headOf("structural"), HasSubstr("  structural           F "));
  EXPECT_THAT(headOf("f"), testing::Not(HasSubstr("structural")));
}

TEST_F(Evaluate, RanksTheSameOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(runProgram({"evaluate", truth_, fork("f.txt"), truth_, "--draws", "50", "--seed", "4",
                          "--threads", threads, "--csv", file(std::string(threads) + ".csv")})
                  .status,
              0);
  EXPECT_EQ(test::bytesOf(file("1.csv")), test::bytesOf(file("2.csv")));
}

TEST_F(Evaluate, WritesTheNumbersOfAPairAsATable) {
  ASSERT_EQ(runProgram({"evaluate", truth_, truth_, "--csv", file("a.csv")}).status, 0);
  EXPECT_THAT(test::bytesOf(file("a.csv")), HasSubstr("\nauthors.geometric,1.0\n"));
  EXPECT_THAT(test::bytesOf(file("a.csv")), HasSubstr("\ntolerance.0.f,1.0\n"));
}

TEST_F(Evaluate, WritesAllThatAReportShows) {
  const std::string pair = fork("a.txt");
  ASSERT_EQ(runProgram({"evaluate", pair, fork("b.txt", 1.2), "--no-register", "--unit", "cm",
                        "--distance", "0.05", "--json", file("a.json"), "--csv", file("a.csv")})
                .status,
            0);
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_EQ(numbers["unit"], "cm");
  EXPECT_FALSE(numbers["version"].get<std::string>().empty());
  EXPECT_EQ(numbers["inputs"]["result"]["file"], pair);
  EXPECT_EQ(numbers["inputs"]["reference"]["sha256"].get<std::string>().size(), 64U);
  EXPECT_NE(numbers["inputs"]["reference"]["sha256"], numbers["inputs"]["result"]["sha256"]);
  EXPECT_EQ(numbers["curve"].size(), 41U);
  EXPECT_EQ(numbers["curve"][0]["distance"], 0);
  EXPECT_EQ(numbers["errors"]["distance"], 0.05);
  double missed = 0;
  for (const json& part : numbers["errors"]["parts"])
    if (part["kind"] == "missed") missed += part["length"].get<double>();
  EXPECT_GT(missed, 0);
  EXPECT_NEAR(missed, numbers["errors"]["missed"].get<double>(), 1e-9);
  for (const json& part : numbers["errors"]["parts"]) {
    EXPECT_EQ(part["place"].size(), 3U);
    EXPECT_EQ(part["order"], part["place"][0] == 0.0 ? 0 : 1) << "the branch leaves the trunk";
  }
  const json& f = numbers["intervals"]["scores"]["f"];
  EXPECT_LE(f["low"], f["value"]);
  EXPECT_GE(f["high"], f["value"]);
  EXPECT_THAT(test::bytesOf(file("a.csv")), HasSubstr("\nintervals.scores.f.low,"));
  ASSERT_EQ(
      runProgram({"evaluate", pair, pair, "--ranking", "--draws", "20", "--json", file("r.json")})
          .status,
      0);
  const json ranked = json::parse(test::bytesOf(file("r.json")));
  EXPECT_EQ(ranked["inputs"]["results"][0]["sha256"], numbers["inputs"]["result"]["sha256"]);
  EXPECT_TRUE(ranked["unit"].is_null());
}

TEST_F(Evaluate, WritesAReportOfARanking) {
  const std::string worse = fork("worse.txt", 1.5);
  const Outcome outcome =
      runProgram({"evaluate", worse, fork("same.txt"), fork("true.txt"), "--no-register", "--draws",
                  "50", "--unit", "m", "--distance", "0.1", "--report", file("r.html")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = test::bytesOf(file("r.html"));
  EXPECT_THAT(page, HasSubstr("2 structures compared with true.txt"));
  EXPECT_LT(page.find("same.txt"), page.find("worse.txt")) << "the best first";
  EXPECT_THAT(page, HasSubstr("1.000 to 1.000")) << "the interval of what is the same";
  EXPECT_THAT(page, HasSubstr("1. same.txt: precision, recall and F"));
  EXPECT_THAT(page, HasSubstr("2. worse.txt: precision, recall and F"));
  EXPECT_THAT(page, HasSubstr("<svg"));
  ASSERT_EQ(
      runProgram({"evaluate", worse, worse, worse, "--draws", "20", "--report", file("r.pdf")})
          .status,
      0);
  EXPECT_EQ(test::bytesOf(file("r.pdf")).substr(0, 5), "%PDF-");
  expectRefusal(runProgram({"evaluate", worse, worse, worse, "--report", file("s.html"), "--scan",
                            test::sample("young_tree.ply")}),
                2, {"--scan is of one plant"});
}

TEST_F(Evaluate, RefusesWhatARankingDoesNotShow) {
  expectRefusal(runProgram({"evaluate", truth_, truth_, truth_, "--where"}), 2,
                {"--where, --traits, --light, --merge-paths and --mapping are for one plant"});
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--rank-by", "beauty"}), 2,
                {"choose one of geometric, structural"});
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--rank-by", "f"}), 2, {"--ranking"});
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--report", ""}), 2,
                {"--report", "expected the name of a file"});
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--json", file("x"), "--csv", file("x")}),
                2, {"two results would be written to"});
  EXPECT_FALSE(std::filesystem::exists(file("x")));
  expectRefusal(runProgram({"evaluate", truth_}), 2, {"REFERENCE is required"});
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--csv", truth_}), 1,
                {"would be replaced"});
}

TEST_F(Evaluate, ReportsTheTraitsOfBoth) {
  const std::string printed = runProgram({"evaluate", fork("a.txt"), fork("b.txt", 2),
                                          "--no-register", "--traits", "--json", file("a.json")})
                                  .out;
  EXPECT_THAT(printed, HasSubstr("               traits        plant    reference   difference\n"));
  EXPECT_THAT(printed, HasSubstr("               height            2            4       -50.0%\n"));
  EXPECT_THAT(printed, HasSubstr("      Strahler number            2            2         0.0%\n"));
  const json traits = json::parse(test::bytesOf(file("a.json")))["traits"]["result"];
  EXPECT_EQ(traits["crown"]["height"], 2);
  EXPECT_EQ(traits["crown"]["base_height"], 1);
  EXPECT_EQ(traits["strahler"].size(), 2U);
  EXPECT_NEAR(traits["branching_angles"][0]["mean"].get<double>(), 45, 1e-9);
}

TEST_F(Evaluate, NamesTheUnitOfEveryLength) {
  const std::string printed =
      runProgram({"evaluate", fork("a.txt"), fork("b.txt", 2), "--no-register", "--unit", "cm",
                  "--where", "--traits", "--edit-cost", "length"})
          .out;
  for (const char* part : {"mean (Chamfer) distance to the reference ", " cm, from it ",
                           " cm of each other: tips F ", ", branchings F ", "distance/cm",
                           "height/cm", "radius up to/cm", "reference/cm", "crown area/cm^2"})
    EXPECT_THAT(printed, HasSubstr(part));
  EXPECT_THAT(printed, testing::ContainsRegex("edit distance [0-9.]+ cm, similarity"));
  EXPECT_THAT(printed, testing::ContainsRegex("divergence/deg +0 +0 +-\n")) << "of one branch";
}

TEST_F(Evaluate, SaysWhenAShiftThatIsLeftDecides) {
  const Outcome apart = runProgram(
      {"evaluate", fork("a.txt", 1, 0.5), fork("b.txt"), "--no-register", "--unit", "m"});
  EXPECT_EQ(apart.status, 0);
  EXPECT_THAT(apart.err, HasSubstr("the plant lies about 0.5 m off the reference"));
  const Outcome same = runProgram({"evaluate", truth_, truth_, "--no-register"});
  EXPECT_THAT(same.err, IsEmpty());
}

TEST_F(Evaluate, MovesThePlantByAShiftThatIsGiven) {
  const auto shiftWith = [&](const std::string& shift) {
    const Outcome outcome = runProgram({"evaluate", fork("a.txt", 1, 0.5), fork("b.txt"), "--shift",
                                        shift, "--json", file("a.json")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(test::bytesOf(file("a.json")))["shift"];
  };
  EXPECT_EQ(shiftWith("0,0,0"), json({0, 0, 0})) << "none is found";
  EXPECT_EQ(shiftWith("-0.25,0.5,1"), json({-0.25, 0.5, 1}));
  const auto refusal = [&](const test::Arguments& more) {
    test::Arguments arguments = {"evaluate", truth_, truth_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  };
  expectRefusal(refusal({"--shift", "1,2"}), 2, {"--shift '1,2'", "X,Y,Z"});
  expectRefusal(refusal({"--shift", "1,2,3", "--no-register"}), 2, {"exclude each other"});
  expectRefusal(refusal({truth_, "--shift", "1,2,3"}), 2, {"--shift and --turn are of one plant"});
}

// 1e155 crashed, as its square is no number any more.
TEST_F(Evaluate, RefusesAShiftBeyondAllCoordinates) {
  for (const char* shift : {"1e155,0,0", "0,-1e13,0", "0,0,1e300"}) {
    const Outcome outcome = runProgram({"evaluate", truth_, truth_, "--shift", shift});
    expectRefusal(outcome, 2, {std::string("--shift '") + shift + "'", "up to 1e12"});
  }
  EXPECT_EQ(runProgram({"evaluate", truth_, truth_, "--shift", "1e12,0,0"}).status, 0);
}

TEST_F(Evaluate, CountsASpurAloneOncePathsAreMerged) {
  const std::string stick = plant(
      "stick.txt", {"1\t\t<\t0\t0\t0\t0.1", "2\t1\t<\t0\t0\t1\t0.1", "3\t2\t<\t0\t0\t2\t0.1"});
  const std::string spurred =
      plant("spurred.txt", {"1\t\t<\t0\t0\t0\t0.1", "2\t1\t<\t0\t0\t1\t0.1",
                            "3\t2\t<\t0\t0\t2\t0.1", "4\t2\t+\t0.1\t0\t1\t0.1"});
  EXPECT_THAT(runProgram({"evaluate", spurred, stick}).out, HasSubstr("edit distance 2,"));
  const Outcome merged = runProgram({"evaluate", spurred, stick, "--merge-paths"});
  EXPECT_THAT(merged.out, HasSubstr("edit distance 1,"));
  EXPECT_THAT(merged.err, testing::Not(HasSubstr("merge-paths")));
}

TEST_F(Evaluate, SaysWhereMergedPathsChangeNothing) {
  EXPECT_THAT(runProgram({"evaluate", truth_, truth_, "--merge-paths", "--edit-unit", "axis"}).err,
              HasSubstr("--merge-paths changes nothing with --edit-unit axis"));
  EXPECT_THAT(runProgram({"evaluate", truth_, truth_, "--merge-paths"}).err, IsEmpty());
}

TEST_F(Evaluate, ReportsTheLightOfBoth) {
  const Outcome outcome = runProgram({"evaluate", truth_, fork("f.txt"), "--no-register", "--light",
                                      "--pixels", "256", "--json", file("a.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("silhouette to total area (STAR), overcast sky"));
  const json light = json::parse(test::bytesOf(file("a.json")))["light"];
  EXPECT_EQ(light["result"]["directions"].size(), 46U);
  EXPECT_EQ(light["reference"]["convergence"][3]["pixels"], 256);
  const double star = light["reference"]["star"];
  EXPECT_GT(star, 0.15); // of three rods that hardly hide each other: about a quarter
  EXPECT_LT(star, 0.3);
  const std::string bare = plant("bare.txt", {"1\t\t<\t0\t0\t0\t0", "2\t1\t<\t0\t0\t1\t0"});
  const Outcome without = runProgram({"evaluate", bare, fork("f.txt"), "--light"});
  EXPECT_EQ(without.status, 0);
  EXPECT_THAT(without.err, HasSubstr("the plant has no radii: its light is left out"));
}

TEST_F(Evaluate, SaysThatAFileHoldsTwoPlants) {
  const std::string two = plant("two.txt", {"1\t\t<\t0\t0\t0\t0.1", "2\t1\t<\t0\t0\t2\t0.1",
                                            "3\t\t<\t9\t0\t0\t0.1", "4\t3\t<\t9\t0\t2\t0.1"});
  const Outcome result = runProgram({"evaluate", two, fork("f.txt"), "--no-register"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("the plant is of 2 separate trees, compared as one plant: "
                                    "keep one of them if they are not\n"));
  const Outcome reference = runProgram({"evaluate", fork("f.txt"), two, "--no-register"});
  EXPECT_THAT(reference.err, HasSubstr("the reference is of 2 separate trees"));
  const Outcome itself = runProgram({"evaluate", two, two});
  EXPECT_THAT(itself.out, HasSubstr("mapping 1.000  geometric index 1.000"));
}

TEST_F(Evaluate, RefusesAnEmptyReferenceByName) {
  const std::string empty = plant("empty.txt", {});
  const Outcome outcome = runProgram({"evaluate", fork("f.txt"), empty});
  expectRefusal(outcome, 1, {"empty.txt"});
  const Outcome many = runProgram({"evaluate", fork("f.txt"), fork("g.txt"), empty});
  expectRefusal(many, 1, {"empty.txt"});
}

TEST_F(Evaluate, RecognizesUnitsThatDiffer) {
  const Outcome larger =
      runProgram({"evaluate", fork("mm.txt", 1000), fork("m.txt"), "--json", file("a.json")});
  EXPECT_EQ(larger.status, 0);
  EXPECT_THAT(larger.err, HasSubstr("the plant is 1000 times as large as the reference: it seems "
                                    "to be in mm, the reference in m; scale the plant by 0.001"));
  const json numbers = json::parse(test::bytesOf(file("a.json")));
  EXPECT_LT(numbers["tolerance"][0]["precision"], 0.01) << "as they are, hardly anything fits";
  const Outcome smaller = runProgram({"evaluate", fork("m.txt"), fork("cm.txt", 100)});
  EXPECT_THAT(smaller.err, HasSubstr("100 times as small as the reference: it seems to be in m, "
                                     "the reference in cm; scale the plant by 100\n"));
  const Outcome scaled =
      runProgram({"evaluate", fork("mm.txt", 1000), fork("m.txt"), "--scale", "0.001"});
  EXPECT_THAT(scaled.err, IsEmpty());
  EXPECT_THAT(scaled.out, HasSubstr("mapping 1.000  geometric index 1.000"));
  const Outcome many =
      runProgram({"evaluate", fork("mm.txt", 1000), fork("m.txt"), fork("m.txt"), "--draws", "10"});
  EXPECT_THAT(many.err, HasSubstr("mm.txt: the plant is 1000 times as large"));
}

TEST_F(Evaluate, SaysThatPlantsDoNotMeet) {
  const Outcome apart =
      runProgram({"evaluate", fork("far.txt", 1, 500), fork("f.txt"), "--no-register"});
  EXPECT_EQ(apart.status, 0);
  EXPECT_THAT(apart.err, HasSubstr("hardly anything of the two lies within "));
  EXPECT_THAT(apart.err, HasSubstr("and in the same frame, or let the plant be registered"));
  EXPECT_THAT(apart.out, HasSubstr("mapping 0.000  geometric index 0.000  structural index 0.000"));
  const Outcome together = runProgram({"evaluate", fork("far.txt", 1, 500), fork("f.txt")});
  EXPECT_THAT(together.out, HasSubstr("mapping 1.000  geometric index 1.000"));
  EXPECT_THAT(together.out, HasSubstr("moved by -500, "));
}

TEST_F(Evaluate, RefusesAReferenceWithACycle) {
  const std::string cycle = plant(
      "cycle.txt", {"1\t3\t<\t0\t0\t0\t0.1", "2\t1\t<\t0\t0\t1\t0.1", "3\t2\t<\t0\t0\t2\t0.1"});
  expectRefusal(runProgram({"evaluate", fork("f.txt"), cycle}), 1, {"cycle.txt"});
}

} // namespace
} // namespace espalier
