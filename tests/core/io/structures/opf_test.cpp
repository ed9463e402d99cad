#include "core/base/shown_message.h"
#include "core/io/structures/opf.h"
#include "core/mtg/mtg_skeleton.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <map>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Imported<Mtg> importedOpfFile(const std::string& text) {
  std::istringstream in(text);
  return readOpf(in, "oak.opf");
}

std::string opf(const std::string& topology, const std::string& attributes = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<opf version=\"2.0\" editable=\"true\">\n"
         "<attributeBDD>" +
         attributes + "</attributeBDD>\n<topology class=\"Scene\" scale=\"0\" id=\"1\">\n" +
         topology + "</topology></opf>\n";
}

Mtg importOpf(const std::string& topology, const std::string& attributes = "") {
  return importedOpfFile(opf(topology, attributes)).value;
}

std::string refusalOfOpf(const std::string& topology) {
  return test::errorOf([&] { return importOpf(topology); });
}

std::string written(const Skeleton& skeleton) {
  std::ostringstream out;
  writeOpf(out, skeleton);
  return out.str();
}

Skeleton readBack(const std::string& text) {
  return test::withoutEntities(skeletonOf(importedOpfFile(text).value, "oak.opf").value);
}

TEST(ReadOpf, TakesPartsSuccessorsAndBranches) {
  const Mtg mtg =
      importOpf("<decomp class=\"P\" scale=\"1\" id=\"2\">"
                "<decomp class=\"N\" scale=\"2\" id=\"3\"><Length>0.5</Length>"
                "<branch class=\"L\" scale=\"2\" id=\"4\"/>"
                "<follow class=\"N\" scale=\"2\" id=\"5\"><State> cut\n off </State></follow>"
                "</decomp></decomp>",
                "<attribute name=\"Length\" class=\"Metre_100\"/>"
                "<attribute name=\"State\" class=\"String\"/>");
  ASSERT_EQ(mtg.vertices.size(), 4U);
  EXPECT_EQ(mtg.vertices[0], (MtgVertex{.symbol = "P", .scale = 1}));
  EXPECT_EQ(mtg.vertices[1],
            (MtgVertex{.symbol = "N", .scale = 2, .complex = VertexId{0}, .values = {"0.5"}}));
  EXPECT_EQ(mtg.vertices[2], (MtgVertex{.symbol = "L",
                                        .scale = 2,
                                        .complex = VertexId{0},
                                        .parent = VertexId{1},
                                        .edge = EdgeType::branching}));
  EXPECT_EQ(mtg.vertices[3], (MtgVertex{.symbol = "N",
                                        .scale = 2,
                                        .complex = VertexId{0},
                                        .parent = VertexId{1},
                                        .values = {"", "cut  off"}}));
  EXPECT_THAT(mtg.features,
              ElementsAre(MtgFeature{"Length", "REAL"}, MtgFeature{"State", "ALPHA"}));
  ASSERT_EQ(mtg.classes.size(), 4U);
  EXPECT_EQ(mtg.classes[0].symbol, "$");
}

// An axis that branches off an internode: its parent is the axis of that, and its own first
// internode branches off the internode itself.
TEST(ReadOpf, AttachesTheFirstPartOfACoarserVertexToTheFinerOneItBranchesOff) {
  const Mtg mtg = importOpf("<decomp class=\"A\" scale=\"1\" id=\"2\">"
                            "<decomp class=\"N\" scale=\"2\" id=\"3\">"
                            "<branch class=\"A\" scale=\"1\" id=\"4\">"
                            "<decomp class=\"N\" scale=\"2\" id=\"5\"/>"
                            "<decomp class=\"N\" scale=\"2\" id=\"6\"/>"
                            "</branch></decomp></decomp>");
  ASSERT_EQ(mtg.vertices.size(), 5U);
  const MtgVertex& axis = mtg.vertices[2];
  EXPECT_EQ(axis.scale, 1);
  EXPECT_EQ(axis.parent, VertexId{0});
  EXPECT_EQ(axis.edge, EdgeType::branching);
  EXPECT_EQ(mtg.vertices[3].complex, VertexId{2});
  EXPECT_EQ(mtg.vertices[3].parent, VertexId{1});
  EXPECT_EQ(mtg.vertices[3].edge, EdgeType::branching);
  EXPECT_EQ(mtg.vertices[4].parent, std::nullopt);
}

TEST(ReadOpf, TakesATopologyThatIsThePlantItself) {
  const Mtg mtg =
      importedOpfFile("<opf version=\"2.0\"><topology class=\"Plant\" scale=\"1\" id=\"1\">"
                      "<decomp class=\"N\" scale=\"2\" id=\"2\"/></topology></opf>")
          .value;
  ASSERT_EQ(mtg.vertices.size(), 2U);
  EXPECT_EQ(mtg.vertices[1].complex, VertexId{0});
}

// The shape extends along x from 0 to 1. The first matrix turns x to z and makes it 10 long; the
// second also moves it to (1, 2, 10).
TEST(ReadOpf, PlacesNodesAtTheUpperEndsOfTheirShapes) {
  const auto mtg = importedOpfFile(opf("<decomp class=\"N\" scale=\"1\" id=\"2\">"
                                       "<geometry class=\"Mesh\"><shapeIndex>0</shapeIndex>"
                                       "<mat>\n0 0 -1 0\n0 1 0 0\n10 0 0 0\n</mat></geometry>"
                                       "<follow class=\"N\" scale=\"1\" id=\"3\"><geometry>"
                                       "<mat>\n0 0 -1 1\n\t0 1 0 2\n\t10 0 0 10\n</mat></geometry>"
                                       "</follow></decomp>"));
  EXPECT_THAT(eachInEnglish(mtg.notes),
              ElementsAre(HasSubstr("oak.opf: nodes are placed at the upper ends")));
  const Skeleton plant = skeletonOf(mtg.value, "oak.opf").value;
  ASSERT_EQ(plant.size(), 2U);
  EXPECT_EQ(plant[NodeId{0}].position, Eigen::Vector3d(0, 0, 10));
  EXPECT_EQ(plant[NodeId{1}].position, Eigen::Vector3d(1, 2, 20));
}

TEST(ReadOpf, PrefersCoordinatesToShapes) {
  const auto mtg =
      importedOpfFile(opf("<decomp class=\"N\" scale=\"1\" id=\"2\"><XX>1</XX><YY>2</YY>"
                          "<ZZ>3</ZZ><radius>0.5</radius><geometry>"
                          "<mat>0 0 -1 0 0 1 0 0 10 0 0 0</mat></geometry></decomp>"));
  EXPECT_THAT(mtg.notes, IsEmpty());
  const Skeleton plant = test::withoutEntities(skeletonOf(mtg.value, "oak.opf").value);
  EXPECT_EQ(plant[NodeId{0}], (Node{.position = {1, 2, 3}, .radius = 0.5}));
}

TEST(ReadOpf, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refusalOfOpf(""), "oak.opf: holds no vertices");
  EXPECT_EQ(test::errorOf([] { return importedOpfFile("<opf/>"); }), "oak.opf: holds no topology");
  EXPECT_EQ(refusalOfOpf("<decomp class=\"P\" scale=\"one\"/>"),
            "oak.opf, line 5: expected a number as scale, found 'one'");
  EXPECT_THAT(refusalOfOpf("<decomp class=\"P\" scale=\"0\"/>"),
              HasSubstr("line 5: expected a scale"));
  EXPECT_THAT(refusalOfOpf("<decomp class=\"P\" scale=\"1e9\"/>"), HasSubstr("found '1e9'"));
  EXPECT_THAT(refusalOfOpf("<decomp class=\"P\" scale=\"1.5\"/>"), HasSubstr("found '1.5'"));
  EXPECT_THAT(refusalOfOpf("<decomp scale=\"1\"/>"), HasSubstr("line 5: the vertex has no class"));
  EXPECT_THAT(refusalOfOpf("<branch class=\"P\" scale=\"1\"/>"),
              HasSubstr("line 5: this vertex of scale 1 is attached to nothing of its scale"));
  EXPECT_THAT(
      refusalOfOpf("<decomp class=\"P\" scale=\"1\">\n<follow class=\"N\" scale=\"2\"/></decomp>"),
      HasSubstr("line 6: this vertex of scale 2 is attached to nothing of its scale"));
  EXPECT_THAT(
      refusalOfOpf("<decomp class=\"P\" scale=\"2\">\n<decomp class=\"N\" scale=\"2\"/></decomp>"),
      HasSubstr("line 6: a part of a vertex of scale 2 must have a finer scale, not 2"));
  const std::string start = "<decomp class=\"P\" scale=\"1\"><geometry><mat>";
  const std::string end = "</mat></geometry></decomp>";
  EXPECT_THAT(refusalOfOpf(start + "1 2 3" + end), HasSubstr("a matrix of 12 numbers, found 3"));
  EXPECT_THAT(refusalOfOpf(start + "1 2 3 4 5 6 7 8 9 10 11 12 13" + end), HasSubstr("found more"));
  EXPECT_THAT(refusalOfOpf(start + "1 2 three" + end),
              HasSubstr("expected a number as mat, found 'three'"));
}

TEST(ReadOpf, RefusesFeaturesThatWouldFillTheMemory) {
  std::string text = "<decomp class=\"N\" scale=\"1\">";
  for (int i = 0; i < 20'000; ++i)
    text += "<f" + std::to_string(i) + ">1</f" + std::to_string(i) + ">";
  text += "</decomp>";
  for (int i = 0; i < 600; ++i)
    text += "<decomp class=\"N\" scale=\"1\"><f19999>1</f19999></decomp>";
  EXPECT_EQ(refusalOfOpf(text),
            "oak.opf: has more features, on more vertices, than fit into memory");
}

TEST(WriteOpf, NestsWhatIsAttachedToANode) {
  Skeleton plant;
  plant.add(
      {.position = {0, 0, 1}, .radius = 0.5, .parent = plant.add({}), .edge = EdgeType::branching});
  EXPECT_THAT(written(plant), HasSubstr("<topology class=\"Scene\" scale=\"0\" id=\"1\">\n"
                                        "<decomp class=\"P\" scale=\"1\" id=\"2\">\n"
                                        "<decomp class=\"N\" scale=\"2\" id=\"3\">\n"
                                        "<XX>0</XX>\n<YY>0</YY>\n<ZZ>0</ZZ>\n"
                                        "<branch class=\"N\" scale=\"2\" id=\"4\">\n"
                                        "<XX>0</XX>\n<YY>0</YY>\n<ZZ>1</ZZ>\n<radius>0.5</radius>\n"
                                        "</branch>\n</decomp>\n</decomp>\n</topology>\n</opf>\n"));
}

TEST(WriteOpf, AndReadingGivesTheSamePlant) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = test::randomPlant(200, seed);
    const std::string text = written(plant);
    EXPECT_TRUE(isOpf(text));
    EXPECT_EQ(test::canonical(readBack(text)), test::canonical(plant));
  }
}

TEST(WriteOpf, KeepsPlantsAsTallAsTheyCome) {
  EXPECT_EQ(readBack(written(test::stick(20'000))).size(), 20'000U);
}

TEST(WriteOpf, KeepsAnyCharactersOfClassesAndValues) {
  for (const std::string text : {"a<b> & \"c\" 'd'", "Lärche 落叶松", "]]> &amp;"}) {
    Skeleton plant;
    plant.add({.entities = {{.scale = 1, .symbol = text, .values = {{"note", text}}}}});
    const Mtg mtg = importedOpfFile(written(plant)).value;
    ASSERT_EQ(mtg.vertices.size(), 1U);
    EXPECT_EQ(mtg.vertices[0].symbol, text);
    EXPECT_THAT(mtg.vertices[0].values, testing::Contains(text));
  }
}

// A shoot A of units U: the second unit follows the first, a second shoot branches off it.
TEST(WriteOpf, KeepsClassesScalesAndFeatures) {
  Skeleton plant;
  const auto node = [](double z, std::optional<NodeId> parent, EdgeType edge) {
    return Node{.position = {0, 0, z}, .parent = parent, .edge = edge};
  };
  Node root = node(0, {}, EdgeType::successor);
  root.entities = {{.scale = 1, .symbol = "A"},
                   {.scale = 2, .symbol = "U", .values = {{"year of growth", "2020"}}},
                   {.scale = 3, .symbol = "I", .values = {{"state", "a < b & c"}}}};
  Node second = node(1, plant.add(root), EdgeType::successor);
  second.entities = {{.scale = 2, .symbol = "U"}, {.scale = 3, .symbol = "I"}};
  const NodeId unit = plant.add(second);
  plant.add(node(2, unit, EdgeType::successor)); // of no entity: it goes on with the unit
  Node shoot = node(3, unit, EdgeType::branching);
  shoot.entities = {
      {.scale = 1, .symbol = "A"}, {.scale = 2, .symbol = "U"}, {.scale = 3, .symbol = "I"}};
  plant.add(shoot);

  const Mtg mtg = importedOpfFile(written(plant)).value;
  std::map<int, int> perScale;
  for (const MtgVertex& vertex : mtg.vertices)
    ++perScale[vertex.scale];
  EXPECT_THAT(perScale, ElementsAre(std::pair(1, 2), std::pair(2, 3), std::pair(3, 4)));
  const auto value = [&](const std::string& feature) -> std::string {
    for (std::size_t i = 0; i < mtg.features.size(); ++i)
      for (const MtgVertex& vertex : mtg.vertices)
        if (mtg.features[i].name == feature && i < vertex.values.size() &&
            !vertex.values[i].empty())
          return vertex.values[i];
    return {};
  };
  EXPECT_EQ(value("year_of_growth"), "2020");
  EXPECT_EQ(value("state"), "a < b & c");
  std::vector<MtgVertex> branching;
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.parent && vertex.edge == EdgeType::branching) branching.push_back(vertex);
  ASSERT_EQ(branching.size(), 3U) << "the shoot, its unit and its internode";
  for (const MtgVertex& vertex : branching) {
    const MtgVertex& bearer = mtg.vertices[indexOf(*vertex.parent)];
    EXPECT_EQ(bearer.symbol, vertex.symbol);
    EXPECT_TRUE(vertex.scale == 1 || bearer.complex != vertex.complex) << vertex.scale;
  }
}

} // namespace
} // namespace espalier
