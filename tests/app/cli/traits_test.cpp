// Traits and light of one plant without a reference.
#include "tests/app/cli/subcommands.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;
using testing::Not;

struct Traits : test::Subcommands {};

TEST_F(Traits, AreThoseThatEvaluateReports) {
  run({"traits", truth_, "--light", "--pixels", "64", "--unit", "m", "--json", file("a.json"),
       "--csv", file("a.csv")});
  run({"evaluate", truth_, truth_, "--light", "--pixels", "64", "--unit", "m", "--json",
       file("b.json")});
  const json alone = json::parse(bytesOf(file("a.json")));
  const json both = json::parse(bytesOf(file("b.json")));
  EXPECT_EQ(alone["traits"], both["traits"]["reference"]);
  EXPECT_EQ(alone["wood"]["whole"], both["wood"]["reference"]["whole"]);
  EXPECT_EQ(alone["light"], both["light"]["reference"]);
  EXPECT_EQ(alone["breast_height"]["diameter"], both["breast_height"]["diameter"]["reference"]);
  EXPECT_EQ(alone["unit"], "m");
  EXPECT_EQ(alone["inputs"]["plant"], both["inputs"]["reference"]);
  EXPECT_THAT(bytesOf(file("a.csv")),
              HasSubstr("\ntraits.tips," + alone["traits"]["tips"].dump() + "\n"));
}

TEST_F(Traits, ArePrintedWithTheirUnits) {
  const std::string printed = run({"traits", truth_, "--unit", "m"});
  for (const char* part :
       {"Size\n", "\nCrown\n", "\nWood\n", "Strahler number", " m^3\n", "leaves at"})
    EXPECT_THAT(printed, HasSubstr(part));
  EXPECT_THAT(printed, Not(HasSubstr("STAR"))) << "it takes a while, and was not asked for";
}

TEST_F(Traits, HaveCompartmentsWithBiomassWhereADensityIsGiven) {
  const std::string printed = run({"traits", truth_, "--unit", "m", "--density", "500", "--json",
                                   file("a.json"), "--csv", file("a.csv")});
  EXPECT_THAT(printed, HasSubstr("order    edges     length m   volume m^3   biomass kg\n"));
  EXPECT_THAT(printed, HasSubstr("diameter    edges"));
  const json numbers = json::parse(bytesOf(file("a.json")));
  EXPECT_NEAR(numbers["biomass"]["whole"].get<double>(),
              500 * numbers["wood"]["whole"]["volume"].get<double>(), 1e-9);
  EXPECT_THAT(bytesOf(file("a.csv")), HasSubstr("\nbiomass.density,500"));
  EXPECT_THAT(run({"traits", truth_, "--unit", "m"}), Not(HasSubstr("biomass")));
  expectRefusal(runProgram({"traits", truth_, "--density", "500"}), 2, {"--density", "--unit"});
  EXPECT_EQ(runProgram({"traits", truth_, "--unit", "m", "--density", "0"}).status, 2);
}

TEST_F(Traits, GoIntoAReport) {
  run({"traits", truth_, "--light", "--pixels", "64", "--scan", scan_, "--report",
       file("tree.html")});
  const std::string html = bytesOf(file("tree.html"));
  EXPECT_THAT(html, HasSubstr("<h1>young_tree.mtg</h1>"));
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(html, HasSubstr("young_tree.ply"));
  EXPECT_THAT(html, HasSubstr("From each direction"));
}

TEST_F(Traits, HaveTheEnvelopeThatTheCommandOfEnvelopesDraws) {
  const std::string printed =
      run({"traits", truth_, "--unit", "m", "--scan", scan_, "--envelope", "cone", "--json",
           file("a.json"), "--csv", file("a.csv"), "--report", file("tree.html")});
  run({"envelope", scan_, "--kind", "cone", "--unit", "m", "--json", file("b.json")});
  json alone = json::parse(bytesOf(file("a.json")))["envelope"];
  json drawn = json::parse(bytesOf(file("b.json")));
  EXPECT_EQ(alone["of"], "points");
  for (const char* key : {"kind", "of", "volume", "area", "height", "diameter", "parameters"})
    EXPECT_EQ(alone[key], drawn[key]) << key;
  EXPECT_THAT(printed, HasSubstr("\ncrown envelope: Cone, about the points\nvolume"));
  EXPECT_THAT(bytesOf(file("a.csv")), HasSubstr("\nenvelope.volume," + drawn["volume"].dump()));
  EXPECT_THAT(bytesOf(file("tree.html")), HasSubstr("Crown envelope"));
  const std::string below = printed.substr(printed.find("crown envelope"));
  EXPECT_EQ(below.find("height"), below.rfind("height")) << "a cone's is that of its surface";
  EXPECT_THAT(run({"traits", truth_, "--envelope", "cone"}), HasSubstr("about the skeleton\n"));
  EXPECT_THAT(run({"traits", truth_}), Not(HasSubstr("crown envelope")));
  EXPECT_EQ(runProgram({"traits", truth_, "--envelope", "egg"}).status, 2);
}

TEST_F(Traits, FollowTheAxisThatIsUp) {
  const auto heightAlong = [&](const char* up) {
    run({"traits", truth_, "--up", up, "--json", file("up.json")});
    return json::parse(bytesOf(file("up.json")))["traits"]["crown"]["height"].get<double>();
  };
  const auto bounds = json::parse(run({"info", truth_, "--json"}))["bounds"];
  int axis = 0;
  for (const char* up : {"x", "y", "z"}) {
    const double side =
        bounds["maximum"][axis].get<double>() - bounds["minimum"][axis].get<double>();
    EXPECT_NEAR(heightAlong(up), side, 1e-9) << up;
    ++axis;
  }
}

TEST_F(Traits, RefuseInOneLine) {
  expectRefusal(runProgram({"traits", scan_}), 1, {"young_tree.ply"});
  expectRefusal(runProgram({"traits", file("none.mtg")}), 1, {"none.mtg"});
  expectRefusal(runProgram({"traits", truth_, "--json", file("a"), "--csv", file("a")}), 2,
                {"two results", file("a")});
  expectRefusal(runProgram({"traits", truth_, "--json", truth_}), 1, {"young_tree.mtg"});
  expectRefusal(runProgram({"traits", truth_, "--report", file("a.txt")}), 1, {"a.txt", ".pdf"});
}

} // namespace
} // namespace espalier
