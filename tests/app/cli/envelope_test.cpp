// Crown envelopes of a scan, a structure and a project.
#include "core/io/formats.h"
#include "core/project/project.h"
#include "tests/app/cli/subcommands.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;

struct EnvelopeCommand : test::Subcommands {
  json numbers(const test::Arguments& more) const {
    test::Arguments arguments = {"envelope", scan_, "--json", file("numbers.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    run(arguments);
    return json::parse(bytesOf(file("numbers.json")));
  }
};

TEST_F(EnvelopeCommand, DrawsEachKindAboutAScan) {
  const double convex = numbers({"--kind", "convex"})["volume"];
  for (const char* kind : {"ball", "ellipsoid", "cylinder", "cone", "frustum", "paraboloid", "box"})
    EXPECT_GE(numbers({"--kind", kind})["volume"], convex) << kind << ": it is about all";
  for (const char* kind : {"skinned", "alpha"})
    EXPECT_LE(numbers({"--kind", kind})["volume"], 1.01 * convex) << kind;
  for (const char* kind : {"asymmetric", "extruded"})
    EXPECT_GT(numbers({"--kind", kind})["parameters"]["inside"], 0.5) << kind;
}

TEST_F(EnvelopeCommand, WritesAClosedSurface) {
  const std::string printed =
      run({"envelope", scan_, "--kind", "box", "--unit", "m", "-o", file("crown.obj")});
  EXPECT_THAT(printed, HasSubstr(" m^3\n"));
  EXPECT_THAT(bytesOf(file("crown.obj")), HasSubstr("\nf 1 "));
  run({"envelope", truth_, "--kind", "alpha", "-o", file("crown.ply")});
  EXPECT_THAT(bytesOf(file("crown.ply")), HasSubstr("element face "));
}

TEST_F(EnvelopeCommand, TakesOptionsOfTheKind) {
  const json narrow = numbers({"--kind", "alpha", "--set", "radius=0.05 heights"});
  const json wide = numbers({"--kind", "alpha", "--set", "radius=0.5 heights"});
  EXPECT_LT(narrow["volume"], wide["volume"]);
  expectRefusal(runProgram({"envelope", scan_, "--kind", "alpha", "--set", "radios=3"}), 2,
                {"has no option \"radios\""});
}

TEST_F(EnvelopeCommand, OfAStructureIsThatOfItsNodes) {
  run({"envelope", truth_, "--json", file("truth.json")});
  const json numbers = json::parse(bytesOf(file("truth.json")));
  EXPECT_EQ(numbers["of"], "skeleton");
  EXPECT_EQ(numbers["points"], readStructure(truth_).value.skeleton.size());
}

TEST_F(EnvelopeCommand, OfAProjectIsThatOfThePointsThatAreNotSetAside) {
  const PointCloud cloud = readPoints(scan_).value;
  History history{.skeleton = readStructure(truth_).value.skeleton};
  history.leftOut = PointSet::firstOf(cloud.size() / 2);
  {
    Project project = Project::create(file("tree.espalier"), history);
    project.setScan(ScanReference::of(std::filesystem::absolute(scan_), cloud.bounds()));
  }
  run({"envelope", file("tree.espalier"), "--json", file("points.json")});
  const json points = json::parse(bytesOf(file("points.json")));
  EXPECT_EQ(points["of"], "points");
  EXPECT_EQ(points["points"], cloud.size() - cloud.size() / 2);
  run({"envelope", file("tree.espalier"), "--of", "skeleton", "--json", file("nodes.json")});
  EXPECT_EQ(json::parse(bytesOf(file("nodes.json")))["of"], "skeleton");
}

TEST_F(EnvelopeCommand, RefusesWhatItCannotDoInOneLine) {
  test::writeBytes(file("flat.xyz"), "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 3 0\n");
  expectRefusal(runProgram({"envelope", file("flat.xyz")}), 1, {"flat.xyz", "lie in a plane"});
  test::writeBytes(file("two.xyz"), "0 0 0\n1 0 1\n");
  expectRefusal(runProgram({"envelope", file("two.xyz")}), 1, {"two.xyz", "4 or more"});
  expectRefusal(runProgram({"envelope", scan_, "-o", file("crown.stl")}), 1, {".ply or .obj"});
}

} // namespace
} // namespace espalier
