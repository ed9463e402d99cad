#include "core/cloud/point_set.h"
#include "core/io/formats.h"
#include "core/project/project.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;

/// A project of the sample in meters, of whose points the first 5 000 are set aside.
struct ProjectInput : test::Subcommands {
  std::string project_ = file("oak.espalier");
  PointCloud cloud_ = readPoints(scan_).value;
  Skeleton skeleton_ = readStructure(truth_).value.skeleton;

  void SetUp() override {
    Project project =
        Project::create(project_, {.skeleton = skeleton_, .leftOut = PointSet::firstOf(5000)});
    project.setScan(ScanReference::of(std::filesystem::absolute(scan_), cloud_.bounds()));
    project.setDocument("unit", "m");
  }
};

TEST_F(ProjectInput, IsConvertedToItsStructureOrItsPoints) {
  run({"convert", project_, file("oak.mtg")});
  EXPECT_EQ(readStructure(file("oak.mtg")).value.skeleton.size(), skeleton_.size());
  run({"convert", project_, file("oak.ply"), "--points"});
  EXPECT_EQ(readPoints(file("oak.ply")).value.size(), cloud_.size() - 5000);
  expectRefusal(runProgram({"convert", project_, file("b.ply"), "--points", "--most", "10"}), 1,
                {"oak.espalier: is a project"});
  EXPECT_FALSE(std::filesystem::exists(file("b.ply")));
  expectRefusal(runProgram({"convert", project_, project_}), 1, {});
  expectRefusal(runProgram({"convert", scan_, file("b.ply"), "--points"}), 2, {"is no project"});
}

TEST_F(ProjectInput, KeepsWhatItsMtgSaysBeside) {
  std::string mtg = test::bytesOf(truth_);
  {
    Project project = Project::open(project_, Access::readWrite);
    project.setDocument("mtg", mtg);
  }
  run({"convert", project_, file("oak.mtg")});
  EXPECT_EQ(test::bytesOf(file("oak.mtg")), mtg);
}

TEST_F(ProjectInput, IsMeasuredAndComparedInItsUnit) {
  const std::string traits = run({"traits", project_, "--json", file("traits.json")});
  EXPECT_THAT(traits, HasSubstr(" m^3"));
  EXPECT_EQ(json::parse(test::bytesOf(file("traits.json")))["traits"]["nodes"], skeleton_.size());
  run({"evaluate", project_, truth_, "--json", file("same.json")});
  EXPECT_NEAR(json::parse(test::bytesOf(file("same.json")))["authors"]["geometric"], 1, 1e-9);
  EXPECT_THAT(run({"envelope", project_}), HasSubstr(" m^3"));
  expectRefusal(runProgram({"envelope", project_, "--unit", "mm"}), 2,
                {"--unit mm: ", "oak.espalier is in m: leave --unit out"});
}

TEST_F(ProjectInput, IsNamedWhereAScanIsAskedFor) {
  expectRefusal(runProgram({"reconstruct", project_, "-o", file("a.mtg")}), 1,
                {"oak.espalier: is a project: give the scan or the structure in it"});
}

TEST_F(ProjectInput, WithoutASkeletonSaysWhatIsMissing) {
  (void)Project::create(file("empty.espalier"), {});
  expectRefusal(runProgram({"traits", file("empty.espalier")}), 1,
                {"empty.espalier: has no skeleton: reconstruct it"});
}

} // namespace
} // namespace espalier
