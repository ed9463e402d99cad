#include "core/base/shown_message.h"
#include "core/io/structures/rsml.h"
#include "core/skeleton/assemble_axes.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Imported<Skeleton> importedRsmlFile(const std::string& text) {
  std::istringstream in(text);
  return readRsml(in, "beet.rsml");
}

std::string rsml(const std::string& roots) {
  return "<?xml version=\"1.0\"?>\n<rsml xmlns:po=\"http://www.plantontology.org/xml-dtd/po.dtd\">"
         "<metadata><unit>cm</unit><resolution>1</resolution></metadata>\n<scene><plant "
         "id=\"1\">\n" +
         roots + "</plant></scene></rsml>";
}

Skeleton importRsml(const std::string& roots) {
  return importedRsmlFile(rsml(roots)).value;
}

/// A root along x, y = 0, with what is within it; `points` are its x.
std::string root(const std::vector<double>& points, const std::string& more = "", double y = 0) {
  std::string text = "<root id=\"r\"><geometry><polyline>";
  for (const double x : points)
    text += "<point x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" z=\"0\"/>";
  return text + "</polyline></geometry>" + more + "</root>\n";
}

std::string diameters(const std::string& samples, const std::string& name = "diameter") {
  return "<functions><function name='" + name + "' domain='polyline'>" + samples +
         "</function></functions>";
}

std::string parentNode(const std::string& number) {
  return "<properties><parent-node value=\"" + number + "\"/></properties>";
}

std::string refusalOfRsml(const std::string& roots) {
  return test::errorOf([&] { return importRsml(roots); });
}

TEST(ReadRsml, TakesARootAsAnAxis) {
  const std::string text =
      rsml(root({0, 1, 3}, diameters("<sample>0.5</sample><sample value=\"0.25\"/>")));
  EXPECT_TRUE(isRsml(text));
  const auto plant = importedRsmlFile(text);
  ASSERT_EQ(plant.value.size(), 3U);
  EXPECT_EQ(plant.value[NodeId{0}], (Node{.position = {0, 0, 0}, .radius = 0.25}));
  EXPECT_EQ(plant.value[NodeId{1}],
            (Node{.position = {1, 0, 0}, .radius = 0.125, .parent = NodeId{0}}));
  EXPECT_EQ(plant.value[NodeId{2}], (Node{.position = {3, 0, 0}, .parent = NodeId{1}}));
  EXPECT_THAT(eachInEnglish(plant.notes),
              ElementsAre("beet.rsml: its unit is 'cm', at a resolution of '1'"));
}

// The first point of the lateral lies on point 1 of the root that bears it: it is no node twice.
TEST(ReadRsml, LetsALateralBranchOffThePointThatItNames) {
  const Skeleton plant = importRsml(root({0, 1, 2}, root({1, 9}, parentNode("1"))));
  ASSERT_EQ(plant.size(), 4U);
  EXPECT_EQ(plant[NodeId{3}],
            (Node{.position = {9, 0, 0}, .parent = NodeId{1}, .edge = EdgeType::branching}));
}

TEST(ReadRsml, LetsALateralBranchOffTheNearestPointIfItNamesNone) {
  const Skeleton plant = importRsml(root({0, 1, 2}, root({1.75, 3}, "", 5)));
  ASSERT_EQ(plant.size(), 5U);
  EXPECT_EQ(plant[NodeId{3}].position, Eigen::Vector3d(1.75, 5, 0));
  EXPECT_EQ(plant[NodeId{3}].parent, NodeId{2});
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::successor);
}

// The lateral of a lateral is on point 0 of it, which lies on the first root.
TEST(ReadRsml, CountsThePointThatLiesOnTheParent) {
  const Skeleton plant =
      importRsml(root({0, 1, 2}, root({1, 9}, parentNode("1") + root({1, 7}, parentNode("0"), 3))));
  ASSERT_EQ(plant.size(), 6U);
  EXPECT_EQ(plant[NodeId{4}].position, Eigen::Vector3d(1, 3, 0));
  EXPECT_EQ(plant[NodeId{4}].parent, NodeId{1});
}

TEST(ReadRsml, TakesSeveralPlantsAndRoots) {
  EXPECT_EQ(importRsml(root({0, 1}) + root({5}) + "</plant><plant>" + root({7, 8})).roots().size(),
            3U);
}

TEST(ReadRsml, TakesPointsOfTwoCoordinatesAndSaysSo) {
  const auto plant = importedRsmlFile(
      rsml("<root><geometry><polyline><point x=\"1\" y=\"2\"/></polyline></geometry></root>"));
  EXPECT_EQ(plant.value[NodeId{0}].position, Eigen::Vector3d(1, 2, 0));
  EXPECT_THAT(eachInEnglish(plant.notes), Contains(HasSubstr("no z, which is taken as 0")));
}

TEST(ReadRsml, NotesWhatIsLeftOut) {
  const auto plant = importedRsmlFile(rsml(root({0, 1}, diameters("<sample>1</sample>", "age")) +
                                           "<root id=\"bare\">" + root({5, 6}) + "</root>" +
                                           root({7, 8}, root({9}, parentNode("5")))));
  EXPECT_EQ(plant.value.roots().size(), 3U) << "what is within a root without polyline is read";
  EXPECT_THAT(eachInEnglish(plant.notes), Contains("beet.rsml: its functions 'age' are left out"));
  EXPECT_THAT(eachInEnglish(plant.notes),
              Contains("beet.rsml: 1 root has no polyline and is left out"));
  EXPECT_THAT(eachInEnglish(plant.notes),
              Contains(HasSubstr("1 root names a parent-node that is not there")));
}

TEST(ReadRsml, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refusalOfRsml(""), "beet.rsml: holds no polylines of roots");
  const auto withPoint = [](const std::string& point) {
    return "<root><geometry><polyline>\n" + point + "</polyline></geometry></root>";
  };
  EXPECT_EQ(refusalOfRsml(withPoint("<point x=\"one\" y=\"2\"/>")),
            "beet.rsml, line 5: expected a number as x, found 'one'");
  EXPECT_THAT(refusalOfRsml(withPoint("<point x=\"1\"/>")),
              HasSubstr("line 5: expected a number as y"));
  EXPECT_THAT(refusalOfRsml(withPoint("<point x=\"1\" y=\"2\" z=\"\"/>")),
              HasSubstr("a number as z"));
  EXPECT_THAT(refusalOfRsml(root({0, 1}, diameters("<sample>thick</sample>"))),
              HasSubstr("line 4: expected a number as diameter, found 'thick'"));
  EXPECT_THAT(refusalOfRsml(root({0, 1}, root({1, 2}, parentNode("first")))),
              HasSubstr("line 4: expected a number as parent-node, found 'first'"));
}

TEST(ReadRsml, RefusesToLookForNearestNodesForever) {
  std::string laterals;
  for (int i = 0; i < 4'000; ++i)
    laterals += root({1});
  EXPECT_THAT(refusalOfRsml(root(std::vector<double>(30'000, 0.0), laterals)),
              HasSubstr("have no parent-node"));
}

TEST(WriteRsml, WritesAxesWithinAxes) {
  Skeleton plant = test::stick(3);
  plant.add({.position = {1, 0, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  std::ostringstream out;
  writeRsml(out, plant);
  EXPECT_THAT(out.str(), HasSubstr("<root id=\"r2\">\n"
                                   "<properties>\n<parent-node value=\"1\" />\n</properties>\n"
                                   "<geometry>\n<polyline>\n"
                                   "<point x=\"0\" y=\"0\" z=\"1\" />\n"
                                   "<point x=\"1\" y=\"0\" z=\"1\" />\n"
                                   "</polyline>\n</geometry>\n</root>\n</root>\n</plant>\n"));
  EXPECT_THAT(out.str(), HasSubstr("<sample>0.2</sample>\n<sample>0.2</sample>\n"));
}

TEST(WriteRsml, AndReadingGivesTheSamePlant) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = withAssembledAxes(test::randomPlant(200, seed));
    std::ostringstream out;
    writeRsml(out, plant);
    EXPECT_TRUE(isRsml(out.str()));
    EXPECT_EQ(test::canonical(importedRsmlFile(out.str()).value), test::canonical(plant));
  }
}

TEST(WriteRsml, AndReadingKeepsEdgesWithoutLength) {
  Skeleton plant = test::stick(2);
  const NodeId same =
      plant.add({.position = {0, 0, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  plant.add({.position = {1, 0, 1}, .parent = same});
  std::ostringstream out;
  writeRsml(out, plant);
  EXPECT_EQ(test::canonical(importedRsmlFile(out.str()).value), test::canonical(plant));
}

} // namespace
} // namespace espalier
