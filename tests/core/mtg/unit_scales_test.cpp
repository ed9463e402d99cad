#include "core/base/error.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_writer.h"
#include "core/mtg/unit_scales.h"
#include "core/skeleton/edits.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace espalier {
namespace {

// As PlantScan3D writes: a trunk of nodes 0, 1, 2, 3 and a branch of 4, 5 on node 1.
const std::string plantAndNodes =
    "CODE :\tFORM-A\n\nCLASSES :\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
    "$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tEXPLICIT\nN\t2\tFREE\tFREE\tEXPLICIT\n\n"
    "DESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\nN\tN\t<\t?\nN\tN\t+\t?\n\n"
    "FEATURES :\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\nradius\tREAL\n\nMTG :\n"
    "ENTITY-CODE\t\tXX\tYY\tZZ\tradius\n/P1\n^/N\t\t0\t0\t0.00\t0.10\n^<N\t\t0\t0\t1.00\t0.10\n"
    "^<N\t\t0\t0\t2.00\t0.10\n^<N\t\t0\t0\t3.00\t0.10\n";
const std::string branch = "\t+N\t1\t0\t1.50\t0.050\n\t^<N\t2\t0\t2.00\t0.050\n";

std::string plantText() {
  std::string text = plantAndNodes; // the branch stands before what continues the trunk
  return text.insert(text.find("^<N\t\t0\t0\t2.00"), branch);
}

Mtg readUnits(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg").value;
}

NodeId nodeAt(const Skeleton& plant, const Eigen::Vector3d& position) {
  for (const NodeId id : plant.ids())
    if (plant[id].position == position) return id;
  throw Error("no node is there");
}

std::size_t commit(Skeleton& plant, const std::vector<NodeId>& marks, const NewScale& scale,
                   const Mtg* base = nullptr) {
  SkeletonEditor editor(plant);
  toggleMarks(editor, marks);
  const std::size_t units = commitMarks(editor, scale, base);
  (void)editor.commit();
  return units;
}

std::map<int, int> verticesPerScale(const Mtg& mtg) {
  std::map<int, int> counts;
  for (const MtgVertex& vertex : mtg.vertices)
    ++counts[vertex.scale];
  return counts;
}

std::string label(const MtgVertex& vertex) {
  return vertex.symbol + (vertex.index ? vertex.index->text() : "");
}

/// The units that each node is in, by the height and distance of the node: "P1 S2".
std::map<std::string, std::string> unitsByPlace(const Mtg& mtg) {
  std::map<std::string, std::string> result;
  for (const MtgVertex& vertex : mtg.vertices) {
    if (vertex.symbol != "N") continue;
    std::string units;
    for (auto unit = vertex.complex; unit; unit = mtg.vertices[indexOf(*unit)].complex)
      units = label(mtg.vertices[indexOf(*unit)]) + (units.empty() ? "" : " ") + units;
    result[vertex.values[0] + " " + vertex.values[2]] = units;
  }
  return result;
}

TEST(Marks, AreTakenOffWhereAllAreMarkedElseSet) {
  Skeleton plant = test::stick(4);
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{1}});
  toggleMarks(editor, {NodeId{1}, NodeId{2}});
  EXPECT_EQ(markedNodes(plant), (std::vector{NodeId{1}, NodeId{2}}));
  toggleMarks(editor, {NodeId{1}});
  EXPECT_EQ(markedNodes(plant), std::vector{NodeId{2}});
  clearMarks(editor);
  EXPECT_TRUE(markedNodes(plant).empty());
}

TEST(Marks, AreUndoneWithTheEdit) {
  Skeleton plant = test::stick(4);
  const Skeleton before = plant;
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{1}, NodeId{3}});
  const SkeletonDelta delta = editor.commit();
  const Skeleton after = plant;
  EXPECT_EQ(delta.changes.size(), 2U);
  delta.inverse().apply(plant);
  EXPECT_EQ(plant, before);
  delta.apply(plant);
  EXPECT_EQ(plant, after);
}

TEST(Marks, AreNeverWritten) {
  const Mtg base = readUnits(plantText());
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{1}});
  (void)editor.commit();
  EXPECT_EQ(withEdits(base, plant), base);
  Skeleton bare = test::stick(3);
  const Mtg unmarked = mtgOf(bare);
  bare.setMarked(NodeId{1}, true);
  EXPECT_EQ(mtgOf(bare), unmarked);
}

TEST(Marks, MoveWithTheirPlaceWhenAnEdgeIsSplitAndANodeRemoved) {
  Skeleton plant = test::stick(4);
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{2}});
  const NodeId between = splitEdge(editor, NodeId{2}, 0.5);
  EXPECT_EQ(markedNodes(plant), std::vector{between});
  removeNode(editor, between);
  EXPECT_EQ(markedNodes(plant), std::vector{NodeId{2}});
}

TEST(CommitMarks, MakesAScaleBetweenPlantAndNodesThatIsReadAgain) {
  const std::string text = plantText();
  const Mtg base = readUnits(text);
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  const std::vector<NodeId> marks = {nodeAt(plant, {0, 0, 2}), nodeAt(plant, {1, 0, 1.5})};
  EXPECT_EQ(commit(plant, marks, {"S", {}}, &base), 3U);

  const Mtg back = readUnits(mtgTextWith(text, withEdits(base, plant)));
  EXPECT_EQ(verticesPerScale(back), (std::map<int, int>{{1, 1}, {2, 3}, {3, 6}}));
  EXPECT_EQ(unitsByPlace(back),
            (std::map<std::string, std::string>{// coordinates as they were written
                                                {"0 0.00", "P1 S1"},
                                                {"0 1.00", "P1 S1"},
                                                {"0 2.00", "P1 S2"},
                                                {"0 3.00", "P1 S2"},
                                                {"1 1.50", "P1 S3"},
                                                {"2 2.00", "P1 S3"}}));
  EXPECT_EQ(back.features, base.features);
  std::vector<MtgRule> rules = base.rules;
  for (const char* edge : {"<", "+"})
    rules.push_back({"S", "S", edge, "?"});
  EXPECT_EQ(back.rules, rules);
  ASSERT_EQ(back.classes.size(), 4U);
  EXPECT_EQ(back.classes[2].scale, 3); // N
  EXPECT_EQ(back.classes[3].symbol, "S");
  EXPECT_EQ(back.classes[3].scale, 2);
}

TEST(CommitMarks, JoinsUnitsAsTheNodesTheyBeginAt) {
  const Mtg base = readUnits(plantText());
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  commit(plant, {nodeAt(plant, {0, 0, 2}), nodeAt(plant, {1, 0, 1.5})}, {"S", {}}, &base);
  const Mtg mtg = withEdits(base, plant);
  std::map<std::string, std::string> joins;
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.scale == 2)
      joins[label(vertex)] = vertex.parent ? static_cast<char>(vertex.edge) +
                                                 label(mtg.vertices[indexOf(*vertex.parent)])
                                           : "/";
  EXPECT_EQ(joins, (std::map<std::string, std::string>{{"S1", "/"}, {"S2", "<S1"}, {"S3", "+S1"}}));
}

TEST(CommitMarks, IsUndoneToTheMtgThatWasOpened) {
  const Mtg base = readUnits(plantText());
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{2}});
  commitMarks(editor, {"S", {}}, &base);
  editor.commit().inverse().apply(plant);
  EXPECT_EQ(withEdits(base, plant), base);
}

TEST(CommitMarks, CountsWithinEachCoarserUnit) {
  // P1 of A1 (E1 < E2 < E4) and A2 (E3, on E2); units begin at E4 besides.
  const Mtg base = test::readMtgRows("/P1\n^/A1\n^/E1\t\t\t0\t0\t0\n^<E2\t\t\t0\t0\t1\n"
                                     "\t+A2/E3\t\t1\t0\t1\n^<E4\t\t\t0\t0\t2\n")
                       .value;
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  EXPECT_EQ(commit(plant, {nodeAt(plant, {0, 0, 2})}, {"S", {}}, &base), 3U);
  std::map<std::string, std::string> complexes;
  const Mtg mtg = withEdits(base, plant);
  for (const MtgVertex& vertex : mtg.vertices)
    if (vertex.symbol == "E")
      complexes[label(vertex)] =
          label(mtg.vertices[indexOf(*mtg.vertices[indexOf(*vertex.complex)].complex)]) +
          label(mtg.vertices[indexOf(*vertex.complex)]);
  EXPECT_EQ(complexes, (std::map<std::string, std::string>{
                           {"E1", "A1S1"}, {"E2", "A1S1"}, {"E3", "A2S1"}, {"E4", "A1S2"}}));
  EXPECT_EQ(verticesPerScale(mtg), (std::map<int, int>{{1, 1}, {2, 2}, {3, 3}, {4, 4}}));
}

TEST(CommitMarks, CutsFinerUnitsWhereACoarserOneBegins) {
  // A mark inside A1, for a scale above the axes: A1 ends there, so that units nest.
  const Mtg base = test::readMtgRows("/P1\n^/A1\n^/E1\t\t\t0\t0\t0\n^<E2\t\t\t0\t0\t1\n"
                                     "^<E3\t\t\t0\t0\t2\n")
                       .value;
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  EXPECT_EQ(commit(plant, {NodeId{2}}, {"S", 2}, &base), 2U);
  const Mtg mtg = withEdits(base, plant);
  EXPECT_EQ(verticesPerScale(mtg), (std::map<int, int>{{1, 1}, {2, 2}, {3, 2}, {4, 3}}));
  const MtgVertex& last = mtg.vertices.back(); // E3
  const MtgVertex& axis = mtg.vertices[indexOf(*last.complex)];
  EXPECT_EQ(label(last), "E3");
  EXPECT_EQ(axis.symbol, "A");
  EXPECT_EQ(label(mtg.vertices[indexOf(*axis.complex)]), "S2");
  std::ostringstream out;
  writeMtg(out, mtg); // which throws if it would be read as another plant
}

TEST(CommitMarks, MayBeDoneTwice) {
  const Mtg base = readUnits(plantText());
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  commit(plant, {nodeAt(plant, {0, 0, 2})}, {"S", {}}, &base);
  commit(plant, {nodeAt(plant, {0, 0, 1}), nodeAt(plant, {1, 0, 1.5})}, {"U", {}}, &base);
  const Mtg back = readUnits(mtgTextWith(plantText(), withEdits(base, plant)));
  EXPECT_EQ(unitsByPlace(back), (std::map<std::string, std::string>{{"0 0.00", "P1 S1 U1"},
                                                                    {"0 1.00", "P1 S1 U2"},
                                                                    {"0 2.00", "P1 S2 U1"},
                                                                    {"0 3.00", "P1 S2 U1"},
                                                                    {"1 1.50", "P1 S1 U3"},
                                                                    {"2 2.00", "P1 S1 U3"}}));
}

TEST(CommitMarks, MakesPlantsOfASkeletonWithoutAny) {
  Skeleton plant = test::stick(4);
  EXPECT_EQ(commit(plant, {NodeId{2}}, {"S", {}}), 2U);
  const Mtg mtg = mtgOf(plant);
  EXPECT_EQ(verticesPerScale(mtg), (std::map<int, int>{{1, 1}, {2, 2}, {3, 4}}));
  std::ostringstream out;
  writeMtg(out, mtg);
  EXPECT_EQ(test::canonical(skeletonOf(readUnits(out.str()), "plant.mtg").value),
            test::canonical([&] {
              Skeleton all = plant; // nodes that carry nothing are of the class of their parents
              for (const NodeId id : all.ids())
                if (all[id].entities.empty())
                  all.setEntities(id, {{.scale = 3, .symbol = "N", .index = std::nullopt}});
              return all;
            }()));
}

TEST(CommitMarks, IsRefusedWithoutAnyMark) {
  Skeleton plant = test::stick(3);
  const Skeleton before = plant;
  EXPECT_THROW(commit(plant, {}, {"S", {}}), Error);
  EXPECT_EQ(plant, before);
}

TEST(CommitMarks, IsRefusedForASymbolThatIsTakenOrNone) {
  const Mtg base = readUnits(plantText());
  for (const char* symbol : {"P", "N", "$", "", "S1", "a b"}) {
    Skeleton plant = skeletonOf(base, "plant.mtg").value;
    EXPECT_THROW(commit(plant, {NodeId{1}}, {symbol, {}}, &base), Error) << symbol;
    EXPECT_EQ(plant, skeletonOf(base, "plant.mtg").value);
  }
}

/// Label and values of all vertices but those of a class, in no order: units come before their
/// parts.
std::multiset<std::vector<std::string>> texts(const Mtg& mtg, const std::string& without) {
  std::multiset<std::vector<std::string>> result;
  for (const MtgVertex& vertex : mtg.vertices) {
    if (vertex.symbol == without) continue;
    std::vector<std::string> text = vertex.values;
    text.insert(text.begin(), label(vertex));
    result.insert(text);
  }
  return result;
}

TEST(CommitMarks, KeepsAllElseOfAFileOfOthers) {
  for (const char* name :
       {"structures/arabidopsis_reference.mtg", "mtg/reconstructed_appletree.mtg"}) {
    ESPALIER_SHARED_FILE(path, name);
    std::ifstream in(path);
    const Mtg base = readMtg(in, name).value;
    Skeleton plant = skeletonOf(base, name).value;
    std::vector<NodeId> marks;
    for (std::size_t i = 0; i < plant.ids().size(); i += 7)
      marks.push_back(plant.ids()[i]);
    const std::size_t units = commit(plant, marks, {"Shoot", {}}, &base);
    const Mtg mtg = withEdits(base, plant);
    ASSERT_EQ(mtg.vertices.size(), base.vertices.size() + units) << name;
    EXPECT_EQ(texts(mtg, "Shoot"), texts(base, "")) << name;
    std::ostringstream out;
    writeMtg(out, mtg); // which reads it back
  }
}

} // namespace
} // namespace espalier
