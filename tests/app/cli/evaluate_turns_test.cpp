#include "tests/app/cli/evaluate_files.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::expectRefusal;
using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

class EvaluateTurns : public test::EvaluateFiles {};

TEST_F(EvaluateTurns, FindsAndReportsATurn) {
  const std::string turned = turnedSample("turned.mtg", 30, Eigen::Vector3d::UnitZ());
  const Outcome outcome = runProgram({"evaluate", turned, truth_, "--json", file("a.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("geometric index 1.000  structural index 1.000"));
  EXPECT_THAT(outcome.out, HasSubstr("turned by 30 degrees about"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("fit poorly")));
  const json found = json::parse(test::bytesOf(file("a.json")))["registration"];
  EXPECT_NEAR(found["rotation"], 30, 1e-3);
  EXPECT_NEAR(found["axis"][2], -1, 1e-3);
  EXPECT_NEAR(found["near_share"], 1, 1e-3);
  const Outcome refused =
      runProgram({"evaluate", turned, truth_, "--no-rotate", "--json", file("b.json")});
  EXPECT_THAT(refused.out, testing::Not(HasSubstr("turned by")));
  EXPECT_THAT(refused.err, HasSubstr("the two fit poorly"));
  const json kept = json::parse(test::bytesOf(file("b.json")));
  EXPECT_EQ(kept["registration"]["rotation"], 0);
  EXPECT_TRUE(kept["registration"]["axis"].is_null());
  EXPECT_LT(kept["authors"]["structural"], 0.6);
  EXPECT_THAT(runProgram({"evaluate", turned, truth_, "--no-register"}).err,
              HasSubstr("turned by 30 degrees, which lowers the scores"));
}

TEST_F(EvaluateTurns, LooksForTurnsAboutTheAxisThatPointsUp) {
  const std::string lying = turnedSample("lying.mtg", 90, Eigen::Vector3d::UnitX()); // y is up
  Skeleton skeleton = readStructure(lying).value.skeleton;
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitY()));
  writeStructure(file("turned.mtg"), moved(skeleton, turn));
  EXPECT_THAT(runProgram({"evaluate", file("turned.mtg"), lying, "--up", "y"}).out,
              HasSubstr("geometric index 1.000  structural index 1.000"));
}

TEST_F(EvaluateTurns, TurnsThePlantAsGiven) {
  const std::string turned = turnedSample("turned.mtg", 90, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(runProgram({"evaluate", turned, truth_, "--json", file("a.json")}).status, 0);
  const json found = json::parse(test::bytesOf(file("a.json")));
  const auto listed = [](const json& numbers) {
    return numbers[0].dump() + "," + numbers[1].dump() + "," + numbers[2].dump();
  };
  const json& how = found["registration"];
  const Outcome again = runProgram({"evaluate", turned, truth_, "--json", file("b.json"),
                                    "--turn=" + listed(how["axis"]) + "," + how["rotation"].dump(),
                                    "--shift=" + listed(found["shift"])});
  ASSERT_EQ(again.status, 0) << again.err;
  const json given = json::parse(test::bytesOf(file("b.json")));
  EXPECT_NEAR(given["registration"]["rotation"], how["rotation"], 1e-6);
  EXPECT_NEAR(given["authors"]["cost"], found["authors"]["cost"], 1e-3);
  const auto refusal = [&](const test::Arguments& more) {
    test::Arguments arguments = {"evaluate", truth_, truth_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  };
  for (const char* turn : {"90", "0,0,1", "0,0,0,90", "0,0,1,x", "0,0,1,1e5"})
    expectRefusal(refusal({"--turn", turn}), 2, {"--turn '", "X,Y,Z,DEGREES"});
  expectRefusal(refusal({"--turn", "0,0,1,9", "--no-register"}), 2, {"exclude each other"});
  expectRefusal(refusal({"--turn", "0,0,1,9", "--no-rotate"}), 2, {"exclude each other"});
}

TEST_F(EvaluateTurns, RanksTurnedPlantsAndSaysWhichFitPoorly) {
  const std::string turned = turnedSample("turned.mtg", 120, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(runProgram({"simulate", "-o", file("other"), "--seed", "9"}).status, 0);
  const std::string other = file("other.mtg");
  const Outcome outcome =
      runProgram({"evaluate", other, turned, truth_, "--draws", "20", "--json", file("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(other + ": the two fit poorly"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr(turned + ": ")));
  const json best = json::parse(test::bytesOf(file("r.json")))["results"][0];
  EXPECT_EQ(best["result"], turned);
  EXPECT_NEAR(best["rotation"], 120, 1e-3);
  EXPECT_NEAR(best["scores"]["f"]["value"], 1, 1e-6);
}

TEST_F(EvaluateTurns, AreFoundAndReportedByASweepToo) {
  const std::string turned = turnedSample("turned.mtg", 90, Eigen::Vector3d::UnitZ());
  test::Arguments sweep = {"sweep",
                           test::sample("young_tree.ply"),
                           "contract.radius",
                           "--values",
                           "8 spacings",
                           "--reference",
                           turned,
                           "--json",
                           file("a.json")};
  const auto score = [&] {
    return json::parse(test::bytesOf(file("a.json")))["results"][0]["scores"]["f"].get<double>();
  };
  const Outcome found = runProgram(sweep);
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(found.err, HasSubstr("note: contract.radius="));
  EXPECT_THAT(found.err, HasSubstr(": the plant was turned by "));
  EXPECT_THAT(found.err, testing::Not(HasSubstr("fit poorly")));
  const double best = score();
  sweep.emplace_back("--no-rotate");
  EXPECT_THAT(runProgram(sweep).err, HasSubstr(": the two fit poorly"));
  EXPECT_LT(score(), best - 0.1);
}

// The expert's pine, turned: as unturned to .005.
TEST_F(EvaluateTurns, ScoresTheTurnedExpertOfThePineAsUnturned) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton pine = readStructure(expert).value.skeleton;
  const auto scoresWith = [&](double degrees, const Eigen::Vector3d& axis) {
    const Eigen::Isometry3d turn(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
    writeStructure(file("turned.mtg"), moved(pine, turn));
    const Outcome outcome = runProgram({"evaluate", expert.string(), file("turned.mtg"), "--unit",
                                        "mm", "--json", file("a.json")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("turned by " + std::to_string(static_cast<int>(degrees)) +
                                       " degrees about"));
    return json::parse(test::bytesOf(file("a.json")))["authors"];
  };
  for (const json& authors :
       {scoresWith(30, Eigen::Vector3d::UnitZ()), scoresWith(90, Eigen::Vector3d::UnitZ()),
        scoresWith(180, Eigen::Vector3d::UnitZ()), scoresWith(5, Eigen::Vector3d::UnitX())}) {
    EXPECT_NEAR(authors["geometric"], 1, 0.005);
    EXPECT_NEAR(authors["structural"], 1, 0.005);
  }
}

} // namespace
} // namespace espalier
