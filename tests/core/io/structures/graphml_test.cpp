#include "core/base/shown_message.h"
#include "core/io/structures/graphml.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::Contains;
using testing::HasSubstr;

Imported<Skeleton> importedGraphmlFile(const std::string& text) {
  std::istringstream in(text);
  return readGraphml(in, "oak.graphml");
}

Skeleton importGraphml(const std::string& text) {
  return importedGraphmlFile(text).value;
}

std::string node(const std::string& id, const std::string& x, const std::string& more = "") {
  return "<node id=\"" + id + "\"><data key=\"x\">" + x +
         "</data><data key=\"y\">0</data><data key=\"z\">0</data>" + more + "</node>\n";
}

std::string edge(const std::string& source, const std::string& target,
                 const std::string& more = "") {
  return "<edge source=\"" + source + "\" target=\"" + target + "\">" + more + "</edge>\n";
}

std::string graph(const std::string& content, const std::string& start = "<graph>") {
  return "<?xml version=\"1.0\"?>\n<graphml>" + start + "\n" + content + "</graph></graphml>";
}

std::string refusalOfGraphml(const std::string& content) {
  return test::errorOf([&] { return importGraphml(graph(content)); });
}

/// Positions along x from the root to the only apex.
std::vector<double> chain(const Skeleton& plant) {
  std::vector<double> places;
  for (const NodeId id : plant.ids())
    places.push_back(plant[id].position.x());
  return places;
}

TEST(ReadGraphml, TakesKeysByTheirNames) {
  const std::string text = "<graphml><key id=\"d0\" for=\"node\" attr.name=\"X\"/>"
                           "<key id=\"d1\" for=\"node\" attr.name=\"Y\"/>"
                           "<key id=\"d2\" for=\"node\" attr.name=\"Z\"><default>7</default></key>"
                           "<key id=\"d3\" for=\"node\" attr.name=\"Diameter\"/>"
                           "<graph edgedefault=\"directed\"><node id=\"a\">"
                           "<data key=\"d0\"> 1.5 </data><data key=\"d1\">-2</data>"
                           "<data key=\"d3\">0.5</data></node></graph></graphml>";
  EXPECT_TRUE(isGraphml(text));
  const Skeleton plant = importGraphml(text);
  ASSERT_EQ(plant.size(), 1U);
  EXPECT_EQ(plant[NodeId{0}], (Node{.position = {1.5, -2, 7}, .radius = 0.25}));
}

TEST(ReadGraphml, TakesEdgeTypes) {
  const Skeleton plant = importGraphml(graph(node("a", "0") + node("b", "1") + node("c", "2") +
                                             edge("a", "b", "<data key=\"type\">+</data>") +
                                             edge("a", "c", "<data key=\"type\">&lt;</data>")));
  for (const NodeId id : plant.children(NodeId{0}))
    EXPECT_EQ(plant[id].edge,
              plant[id].position.x() == 1 ? EdgeType::branching : EdgeType::successor);
}

TEST(ReadGraphml, LetsTheChildThatCarriesMostContinueTheAxisWhereNoEdgeHasAType) {
  const auto plant =
      importedGraphmlFile(graph(node("a", "0") + node("b", "1") + node("c", "2") + node("d", "3") +
                                edge("a", "b") + edge("b", "c") + edge("b", "d")));
  EXPECT_EQ(plant.value[plant.value.children(NodeId{1}).front()].position.x(), 3);
  EXPECT_THAT(eachInEnglish(plant.notes), Contains(HasSubstr("has no edge types")));
}

TEST(ReadGraphml, TakesDirectedEdgesFromParentsToChildren) {
  EXPECT_THAT(chain(importGraphml(graph(node("a", "0") + node("b", "1") + node("c", "2") +
                                        edge("b", "a") + edge("c", "b")))),
              testing::ElementsAre(2, 1, 0));
}

// Both edges lead to a, which would have two parents: so they lead from children.
TEST(ReadGraphml, TakesDirectedEdgesTheOtherWayIfOnlySoEachNodeHasOneParent) {
  const Skeleton plant = importGraphml(
      graph(node("a", "0") + node("b", "1") + node("c", "2") + edge("b", "a") + edge("c", "a")));
  ASSERT_EQ(plant.roots().size(), 1U);
  EXPECT_EQ(plant[plant.roots().front()].position.x(), 0);
  EXPECT_EQ(plant.children(plant.roots().front()).size(), 2U);
}

// As CATMAID's export_all_graphml.py writes them: nodes and edges mixed, a child before its parent.
TEST(ReadGraphml, TakesWhatCatmaidExports) {
  const auto plant = importedGraphmlFile(
      "<graphml><key id=\"skid\" for=\"node\" attr.name=\"skeleton id\" attr.type=\"long\"/>"
      "<key id=\"x\" for=\"node\" attr.name=\"x\" attr.type=\"float\"/>"
      "<key id=\"y\" for=\"node\" attr.name=\"y\" attr.type=\"float\"/>"
      "<key id=\"z\" for=\"node\" attr.name=\"z\" attr.type=\"float\"/>"
      "<key id=\"pre_skid\" for=\"edge\" attr.name=\"presynaptic skeleton id\"/><graph "
      "id=\"CNS\">" +
      node("n7", "1", "<data key=\"skid\">1</data>") +
      "<edge id=\"e7\" directed=\"false\" source=\"n7\" target=\"n5\" />" + node("n5", "0") +
      node("n9", "2") +
      "<edge id=\"e9\" directed=\"false\" source=\"n9\" target=\"n7\" />"
      "<edge id=\"e3\" directed=\"true\" source=\"n9\" target=\"n5\">"
      "<data key=\"pre_skid\">1</data></edge></graph></graphml>");
  EXPECT_THAT(chain(plant.value), testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(eachInEnglish(plant.notes),
              Contains(HasSubstr("1 directed edge among undirected ones")));
  EXPECT_THAT(eachInEnglish(plant.notes), Contains(HasSubstr("'skeleton id' are left out")));
}

TEST(ReadGraphml, TakesIdsOfAnyCharacters) {
  EXPECT_EQ(importGraphml(graph(node("a&lt;&amp;&quot;", "0") + node("Lärche", "1") +
                                edge("a&lt;&amp;&quot;", "Lärche")))
                .roots()
                .size(),
            1U);
}

TEST(ReadGraphml, NamesTheLineThatIsWrong) {
  const std::string a = node("a", "0");
  const std::string b = node("b", "1");
  const std::string c = node("c", "2");
  EXPECT_EQ(test::errorOf([] { return importGraphml("<graphml/>"); }),
            "oak.graphml: holds no graph");
  EXPECT_EQ(refusalOfGraphml(""), "oak.graphml: holds no nodes");
  EXPECT_THAT(refusalOfGraphml(a + "<node id=\"b\"/>"),
              HasSubstr("oak.graphml, line 4: the node 'b' has no x"));
  EXPECT_THAT(refusalOfGraphml(node("a", "one")),
              HasSubstr("line 3: expected a number as x, found 'one'"));
  EXPECT_THAT(refusalOfGraphml(node("a", "0", "<data key=\"radius\">r</data>")),
              HasSubstr("line 3: expected a number as radius, found 'r'"));
  EXPECT_THAT(refusalOfGraphml(node("", "0")), HasSubstr("line 3: the node has no id"));
  EXPECT_THAT(refusalOfGraphml(a + a), HasSubstr("line 4: the id 'a' occurs twice"));
  EXPECT_THAT(refusalOfGraphml(a + edge("a", "b")),
              HasSubstr("line 4: the target of the edge, 'b', is no"));
  EXPECT_THAT(refusalOfGraphml(a + edge("b", "a")),
              HasSubstr("line 4: the source of the edge, 'b', is no"));
  EXPECT_THAT(refusalOfGraphml(a + b + c + edge("a", "c") + edge("b", "c") + edge("a", "b")),
              HasSubstr("line 7: the node 'c' has two parents"));
  EXPECT_THAT(refusalOfGraphml(a + b + edge("a", "b") + edge("b", "a")),
              HasSubstr("line 3: the node is among its own ancestors"));
}

TEST(WriteGraphml, NamesNodesAndEdges) {
  std::ostringstream out;
  Skeleton plant;
  plant.add(
      {.position = {1, 2, 3}, .parent = plant.add({.radius = 0.5}), .edge = EdgeType::branching});
  writeGraphml(out, plant);
  EXPECT_THAT(out.str(),
              HasSubstr("<node id=\"n1\">\n<data key=\"x\">0</data>\n<data key=\"y\">0</data>\n"
                        "<data key=\"z\">0</data>\n<data key=\"radius\">0.5</data>\n</node>\n"));
  EXPECT_THAT(out.str(),
              HasSubstr("<edge source=\"n1\" target=\"n2\">\n<data key=\"type\">+</data>\n"));
}

TEST(WriteGraphml, AndReadingGivesTheSamePlant) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = test::randomPlant(200, seed);
    std::ostringstream out;
    writeGraphml(out, plant);
    EXPECT_TRUE(isGraphml(out.str()));
    EXPECT_EQ(test::canonical(importGraphml(out.str())), test::canonical(plant));
  }
}

} // namespace
} // namespace espalier
