#include "core/base/shown_message.h"
#include "core/io/formats.h"
#include "core/io/plantgl/bmtg.h"
#include "core/mtg/mtg_skeleton.h"
#include "tests/core/io/plantgl/pickle_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/shared_data.h"

#include <gmock/gmock.h>
#include <map>
#include <sstream>

namespace espalier {
namespace {

using test::PickleWriter;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Imported<Mtg> importBmtg(const std::string& bytes) {
  std::istringstream in(bytes);
  return readBmtg(in, "oak.bmtg");
}

std::string refusalOfBmtg(const std::string& bytes) {
  return test::errorOf([&] { return importBmtg(bytes); });
}

TEST(ReadBmtg, FindsScalesClassesIndicesEdgesAndPositions) {
  const Imported<Mtg> mtg = importBmtg(pickled(test::pickledPlant()));
  EXPECT_THAT(mtg.notes, IsEmpty());
  const Mtg& plant = mtg.value;
  ASSERT_EQ(plant.classes.size(), 3U);
  EXPECT_EQ(plant.classes[0].symbol, "$");
  EXPECT_EQ(plant.classes[1], (MtgClass{.symbol = "P", .scale = 1}));
  EXPECT_EQ(plant.classes[2], (MtgClass{.symbol = "N", .scale = 2}));
  EXPECT_EQ(plant.features,
            (std::vector<MtgFeature>{{"XX", "REAL"}, {"YY", "REAL"}, {"ZZ", "REAL"}}));
  ASSERT_EQ(plant.vertices.size(), 5U);
  EXPECT_EQ(plant.vertices[0].index, 1);
  EXPECT_EQ(plant.vertices[0].complex, std::nullopt);
  EXPECT_EQ(plant.vertices[3].symbol, "N");
  EXPECT_EQ(plant.vertices[3].index, 12);
  EXPECT_EQ(plant.vertices[3].complex, VertexId{0});
  EXPECT_EQ(plant.vertices[4].parent, VertexId{2});
  EXPECT_EQ(plant.vertices[4].edge, EdgeType::branching);
  EXPECT_THAT(plant.vertices[4].values, ElementsAre("1", "0", "1.5"));
  EXPECT_EQ(plant.rules, (std::vector<MtgRule>{{"N", "N", "<", "?"}, {"N", "N", "+", "?"}}));
}

TEST(ReadBmtg, MakesFeaturesOfTheTypeOfTheirValues) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.extra["count"] = {{2, PickleWriter::integer(3)}, {3, PickleWriter::integer(-4)}};
  mtg.extra["mass"] = {{2, PickleWriter::integer(3)}, {3, PickleWriter::real(0.5)}};
  mtg.extra["name"] = {{4, PickleWriter::text("old shoot")}, {5, PickleWriter::integer(7)}};
  mtg.extra["normal"] = {{2, PickleWriter::vector(1, 0, 0)}};
  mtg.extra["radius"] = {{2, PickleWriter::integer(0)}, {3, "N"}, {4, PickleWriter::real(0.25)}};
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_THAT(plant.notes, IsEmpty());
  EXPECT_EQ(plant.value.features, (std::vector<MtgFeature>{{"XX", "REAL"},
                                                           {"YY", "REAL"},
                                                           {"ZZ", "REAL"},
                                                           {"radius", "REAL"},
                                                           {"count", "INT"},
                                                           {"mass", "REAL"},
                                                           {"name", "ALPHA"},
                                                           {"normal_x", "REAL"},
                                                           {"normal_y", "REAL"},
                                                           {"normal_z", "REAL"}}));
  EXPECT_THAT(plant.value.vertices[1].values,
              ElementsAre("0", "0", "0", "0", "3", "3", "", "1", "0", "0"));
  EXPECT_THAT(plant.value.vertices[2].values, ElementsAre("0", "0", "1", "", "-4", "0.5"));
  EXPECT_THAT(plant.value.vertices[3].values,
              ElementsAre("0", "0", "2", "0.25", "", "", "old shoot"));
}

TEST(ReadBmtg, LeavesOutValuesOfErasedVertices) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.positions[99] = {1, 2, 3};
  mtg.labels[99] = "N";
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_EQ(plant.value.vertices.size(), 5U);
  EXPECT_THAT(eachInEnglish(plant.notes),
              ElementsAre("oak.bmtg: 2 values are of vertices that were erased: left "
                          "out"));
}

TEST(ReadBmtg, TakesAnUnclearEdgeAsSuccessorIfThereIsNoOther) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.edges = {{3, "N"}, {4, "N"}, {5, "<"}};
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_EQ(plant.value.vertices[2].edge, EdgeType::successor);
  EXPECT_EQ(plant.value.vertices[3].edge, EdgeType::branching);
  EXPECT_EQ(plant.value.vertices[4].edge, EdgeType::successor);
  EXPECT_THAT(eachInEnglish(plant.notes), ElementsAre(HasSubstr("2 edges are neither < nor +")));
}

TEST(ReadBmtg, NotesSeveralSuccessorsAndNodesAtOnePlace) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.edges[5] = "<";
  mtg.positions[5] = mtg.positions[3];
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_EQ(plant.value.vertices[4].edge, EdgeType::successor);
  EXPECT_THAT(eachInEnglish(plant.notes),
              ElementsAre(HasSubstr("1 vertex has more than one successor"),
                          HasSubstr("1 vertex lies where its parent lies")));
}

TEST(ReadBmtg, GivesASymbolOfTwoScalesASecondName) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.labels = {{1, "B"}, {2, "N"}, {3, "N"}, {4, "B"}, {5, "3rd"}};
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_EQ(plant.value.vertices[0].symbol, "B");
  EXPECT_EQ(plant.value.vertices[3].symbol, "BB");
  EXPECT_EQ(plant.value.vertices[4].symbol, "N");
  EXPECT_THAT(eachInEnglish(plant.notes),
              ElementsAre(HasSubstr("1 vertex has no label"),
                          HasSubstr("label B is used on several scales, and becomes BB on scale "
                                    "2")));
}

TEST(ReadBmtg, PutsParentsFirstWhateverTheirNumbers) {
  test::PickledMtg mtg;
  mtg.scales = {{0, 0}, {9, 1}, {2, 2}, {3, 2}, {1, 2}};
  mtg.parents = {{1, 3}, {3, 2}};
  mtg.complexes = {{9, 0}, {2, 9}};
  mtg.positions = {{1, {0, 0, 3}}, {2, {0, 0, 1}}, {3, {0, 0, 2}}};
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  const Skeleton skeleton = skeletonOf(plant.value, "oak.bmtg").value;
  ASSERT_EQ(skeleton.size(), 3U);
  EXPECT_EQ(skeleton[NodeId{2}].position.z(), 3);
  EXPECT_EQ(skeleton[NodeId{2}].parent, NodeId{1});
  EXPECT_EQ(plant.value.vertices[3].complex, VertexId{0}); // through its ancestors
}

TEST(ReadBmtg, LeavesOutWhatAnMtgCannotHold) {
  test::PickledMtg mtg = test::pickledPlant();
  mtg.extra["bad name"] = {{2, PickleWriter::integer(1)}};
  mtg.extra["xx"] = {{2, PickleWriter::integer(1)}};
  mtg.extra["lists"] = {{2, "]"}, {3, PickleWriter::integer(1)}};
  mtg.extra["tabs"] = {{2, PickleWriter::text("a\tb")}, {3, PickleWriter::text("c")}};
  mtg.extra["wide"] = {{2, PickleWriter::real(std::numeric_limits<double>::infinity())}};
  const Imported<Mtg> plant = importBmtg(pickled(mtg));
  EXPECT_THAT(eachInEnglish(plant.notes),
              AllOf(Contains(HasSubstr("property 'bad name' is left out")),
                    Contains(HasSubstr("property 'xx' is left out")),
                    Contains(HasSubstr("3 values are not finite, or of a kind"))));
}

TEST(ReadBmtg, RefusesTablesThatAreNoPlant) {
  const auto errorWith = [](const auto& change) {
    test::PickledMtg mtg = test::pickledPlant();
    change(mtg);
    return refusalOfBmtg(pickled(mtg));
  };
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.parents[3] = 4; }),
              HasSubstr("is among its own ancestors"));
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.parents[3] = 77; }),
              HasSubstr("vertex 3 needs vertex 77, which is missing"));
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.parents[3] = 1; }),
              HasSubstr("vertex 3 is attached to vertex 1 of another scale"));
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.complexes[3] = 2; }), HasSubstr("which is no coarser"));
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.scales[5] = -1; }), HasSubstr("of scale -1"));
  EXPECT_THAT(errorWith([](auto& mtg) { mtg.scales = {{0, 0}}; }), HasSubstr("holds no vertices"));
}

TEST(ReadBmtg, RefusesPicklesOfSomethingElse) {
  EXPECT_THAT(refusalOfBmtg("N."), HasSubstr("something else than an MTG"));
  EXPECT_THAT(refusalOfBmtg("copenalea.mtg.mtg\nMTG\n)\x81."), HasSubstr("something else"));
  EXPECT_THAT(refusalOfBmtg("copenalea.mtg.mtg\nMTG\n)\x81}b."), HasSubstr("no table _scale"));
  EXPECT_THAT(refusalOfBmtg("copenalea.mtg.mtg\nMTG\n)\x81]b."),
              HasSubstr("its state is no table"));
  EXPECT_THAT(refusalOfBmtg("copenalea.mtg.mtg\nMTG\n)\x81}U\x06_scaleNsb."),
              HasSubstr("its table _scale is no table"));
  EXPECT_THAT(refusalOfBmtg("copenalea.mtg.mtg\nMTG\n)\x81}U\x06_scale}NK\x01ssb."),
              HasSubstr("has a key that is no number"));
  EXPECT_THAT(refusalOfBmtg("cos\nsystem\n(S'ls'\ntR."), HasSubstr("'system' of 'os'"));
}

// Each of 3000 properties is the same table of 3000 entries: 9 million values in 60 kB.
TEST(ReadBmtg, RefusesTablesThatGrowByBeingShared) {
  std::string table = "}q\x01(";
  for (int i = 0; i < 3000; ++i)
    table += PickleWriter::integer(i) + "K\x01";
  table += "u";
  std::string bytes = "copenalea.mtg.mtg\nMTG\n)\x81}(U\x06_scale" + table + "U\x0b_properties}(";
  for (int i = 0; i < 3000; ++i)
    bytes += PickleWriter::text("p" + std::to_string(i)) + "h\x01";
  EXPECT_THAT(refusalOfBmtg(bytes + "uub."), HasSubstr("share one another too often"));
}

// A text of 100 kB at each of 20 000 vertices would be 2 GB.
TEST(ReadBmtg, RefusesTextsThatGrowByBeingShared) {
  test::PickledMtg mtg;
  for (int i = 1; i <= 20000; ++i)
    mtg.scales[i] = 1;
  mtg.extra["text"][1] = PickleWriter::text(std::string(100000, 'a')) + "q\x07";
  for (int i = 2; i <= 20000; ++i)
    mtg.extra["text"][i] = "h\x07";
  EXPECT_THAT(refusalOfBmtg(pickled(mtg)), HasSubstr("far more memory"));
}

Skeleton rounded(const Skeleton& skeleton) {
  Skeleton result = skeleton;
  for (const NodeId id : skeleton.ids())
    result.setPosition(id, (skeleton[id].position * 1e6).array().round() / 1e6);
  return result;
}

TEST(ReadBmtg, EqualsTheSamePlantAsText) {
  ESPALIER_SHARED_FILE(binary, "plantscan3d/arabido.bmtg");
  ESPALIER_SHARED_FILE(text, "structures/arabidopsis_reference.mtg");
  const Imported<Structure> plant = readStructure(binary);
  EXPECT_EQ(formatOf(binary).name, "BMTG");
  EXPECT_EQ(plant.value.skeleton.size(), 208U);
  EXPECT_EQ(test::canonical(test::withoutEntities(rounded(plant.value.skeleton))),
            test::canonical(test::withoutEntities(readStructure(text).value.skeleton)));
  EXPECT_THAT(eachInEnglish(plant.notes), Contains(HasSubstr("label B is used on several scales")));
}

} // namespace
} // namespace espalier
