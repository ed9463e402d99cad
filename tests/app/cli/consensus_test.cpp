#include "core/io/formats.h"
#include "core/project/project.h"
#include "tests/app/cli/subcommands.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

struct ConsensusCommand : test::Subcommands {
  std::string three_; // shoots
  std::string two_;   // of these, as a project

  void SetUp() override {
    three_ = file("three.mtg");
    two_ = file("two.espalier");
    writeStructure(three_, test::fork(3));
    Skeleton plant = test::fork(3);
    plant.erase(plant.ids().back());
    (void)Project::create(two_, {.skeleton = plant});
  }
};

TEST_F(ConsensusCommand, WritesWhatAStructureAndAProjectAgreeOn) {
  const Outcome outcome =
      runProgram({"consensus", three_, two_, "-o", file("out.mtg"), "--json", file("out.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("two.espalier: agreed on 100 % of its length"));
  EXPECT_THAT(outcome.err, HasSubstr("1 place to decide; 1 tree"));
  EXPECT_EQ(readStructure(file("out.mtg")).value.skeleton.size(), 4U);
  const auto json = nlohmann::json::parse(std::ifstream(file("out.json")));
  ASSERT_EQ(json["places"].size(), 1U);
  EXPECT_EQ(json["places"][0]["kind"], "invented");
  EXPECT_EQ(json["places"][0]["with"], two_);
  EXPECT_EQ(json["nodes"], 4);
  EXPECT_GT(json["plants"][1]["agreed"], json["plants"][0]["agreed"]);
}

TEST_F(ConsensusCommand, SaysHundredPercentOnlyOfAll) {
  Skeleton plant = test::fork(3);
  const NodeId tip = plant.ids().back();
  plant.add({.position = plant[tip].position + Eigen::Vector3d(0.5, 0, 0), .parent = tip});
  Skeleton shorter = plant;
  plant.add({.position = plant[tip].position + Eigen::Vector3d(0, 0.015, 0), .parent = tip});
  writeStructure(file("whole.mtg"), plant);
  writeStructure(file("shorter.mtg"), shorter);
  const Outcome outcome = runProgram({"consensus", file("whole.mtg"), file("shorter.mtg"), "-o",
                                      file("out.mtg"), "--distance", "0.001"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("whole.mtg: agreed on 99."));
  EXPECT_THAT(outcome.err, HasSubstr("shorter.mtg: agreed on 100 %"));
}

TEST_F(ConsensusCommand, RefusesOnePlantAndPlantsApart) {
  EXPECT_EQ(runProgram({"consensus", three_, "-o", file("out.mtg")}).status, 2);
  Skeleton away = test::fork(3);
  for (const NodeId id : away.ids())
    away.setPosition(id, away[id].position + Eigen::Vector3d(0, 90, 0));
  writeStructure(file("away.mtg"), away);
  const Outcome outcome =
      runProgram({"consensus", three_, file("away.mtg"), "-o", file("out.mtg")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("check that all are in one frame and unit"));
  EXPECT_EQ(runProgram({"consensus", three_, two_, "-o", three_}).status, 1) << "it is read";
  const Outcome twice = runProgram({"consensus", three_, two_, three_, "-o", file("out.mtg")});
  EXPECT_EQ(twice.status, 1);
  EXPECT_THAT(twice.err, HasSubstr("three.mtg: is named twice: name each plant once"));
}

TEST_F(ConsensusCommand, RefusesPlantsInDifferentUnitsInAnyOrder) {
  Skeleton larger = test::fork(3);
  for (const NodeId id : larger.ids())
    larger.setPosition(id, 1000 * larger[id].position);
  writeStructure(file("mm.mtg"), larger);
  for (const auto& [first, second] :
       {std::pair(three_, file("mm.mtg")), std::pair(file("mm.mtg"), three_)}) {
    const Outcome outcome = runProgram({"consensus", first, second, "-o", file("out.mtg")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("check that all are in one frame and unit"));
    EXPECT_FALSE(std::filesystem::exists(file("out.mtg")));
  }
}

} // namespace
} // namespace espalier
