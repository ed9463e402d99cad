// Trees, classes and rules that come to an MTG with an edit.
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_writer.h"
#include "core/mtg/unit_edits.h"
#include "core/mtg/unit_scales.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

Mtg readText(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg").value;
}

/// A stick of three nodes with a scale S between plant and nodes, of S1 and, from node 2 on, S2.
Skeleton committedStick(const Mtg* base, Skeleton plant) {
  SkeletonEditor editor(plant);
  toggleMarks(editor, {NodeId{2}});
  commitMarks(editor, {"S", {}}, base);
  (void)editor.commit();
  return plant;
}

/// "P2/S1/N" of the vertex of the finest scale that stands here.
std::string unitsAt(const Mtg& mtg, const Eigen::Vector3d& place) {
  const MtgView view = viewOf(mtg, "plant.mtg").value;
  for (const NodeId id : view.skeleton.ids()) {
    if (view.skeleton[id].position != place) continue;
    std::string text;
    for (std::optional<VertexId> at = view.vertices[indexOf(id)]; at;
         at = mtg.vertices[indexOf(*at)].complex) {
      const MtgVertex& vertex = mtg.vertices[indexOf(*at)];
      text.insert(0, (text.empty() ? "" : "/"));
      text.insert(0, vertex.symbol + (vertex.index ? vertex.index->text() : ""));
    }
    return text;
  }
  return "no node there";
}

void addTree(Skeleton& plant) {
  const NodeId root = plant.add({.position = {5, 0, 0}});
  plant.add({.position = {5, 0, 1}, .parent = root});
}

std::string textOf(const Mtg& mtg) {
  std::ostringstream out;
  writeMtg(out, mtg);
  return out.str();
}

TEST(NewTree, BeginsAUnitOfTheScaleThatMarksBecame) {
  Skeleton plant = committedStick(nullptr, test::stick(3));
  addTree(plant);
  const Mtg mtg = readText(textOf(mtgOf(plant)));
  EXPECT_EQ(unitsAt(mtg, {5, 0, 0}), "P2/S1/N");
  EXPECT_EQ(unitsAt(mtg, {5, 0, 1}), "P2/S1/N");
  EXPECT_EQ(unitsAt(mtg, {0, 0, 2}), "P1/S2/N");
}

TEST(NewTree, BeginsAUnitOfEachScaleOfTheMtgThatWasOpened) {
  const Mtg base = readText(textOf(mtgOf(test::stick(3))));
  Skeleton plant = committedStick(&base, skeletonOf(base, "plant.mtg").value);
  addTree(plant);
  const Mtg mtg = readText(mtgTextWith(textOf(base), withEdits(base, plant)));
  EXPECT_EQ(unitsAt(mtg, {5, 0, 0}), "P2/S1/N");
  EXPECT_EQ(unitsAt(mtg, {5, 0, 1}), "P2/S1/N");
  EXPECT_EQ(unitsAt(mtg, {0, 0, 2}), "P1/S2/N");
}

TEST(NewTree, OfAPlantThatWasCutGoesOnInUnitsOfItsOwn) {
  Skeleton plant = committedStick(nullptr, test::stick(3));
  plant.makeRoot(NodeId{1});
  const Mtg mtg = readText(textOf(mtgOf(plant)));
  EXPECT_EQ(unitsAt(mtg, {0, 0, 0}), "P1/S1/N");
  EXPECT_NE(unitsAt(mtg, {0, 0, 1}).find("/S"), std::string::npos);
  EXPECT_NE(unitsAt(mtg, {0, 0, 1}), unitsAt(mtg, {0, 0, 0}));
}

TEST(NewTree, LeavesAPlantWhoseRootsLackNothing) {
  Skeleton plant = committedStick(nullptr, test::stick(3));
  const Mtg before = mtgOf(plant);
  plant.setPosition(NodeId{1}, {0, 0, 1.5});
  EXPECT_EQ(mtgOf(plant).vertices.size(), before.vertices.size());
}

TEST(NewClass, OfACommitGetsItsRules) {
  const Mtg base = readText(textOf(mtgOf(test::stick(3))));
  const Skeleton plant = committedStick(&base, skeletonOf(base, "plant.mtg").value);
  std::vector<MtgRule> expected = base.rules;
  expected.push_back({"S", "S", "<", "?"});
  expected.push_back({"S", "S", "+", "?"});
  EXPECT_EQ(withEdits(base, plant).rules, expected);
  EXPECT_EQ(readText(mtgTextWith(textOf(base), withEdits(base, plant))).rules, expected);
}

TEST(NewClass, ThatIsTypedGetsRulesForItsLinksWithOthers) {
  const Mtg base = readText(textOf(mtgOf(test::stick(3)))); // N < N < N
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  SkeletonEditor editor(plant);
  setClass(editor, NodeId{1}, 2, "K", &base); // N < K < N
  (void)editor.commit();
  std::vector<MtgRule> expected = base.rules;
  for (const MtgRule& rule : {MtgRule{"K", "K", "<", "?"}, MtgRule{"K", "K", "+", "?"},
                              MtgRule{"N", "K", "<", "?"}, MtgRule{"K", "N", "<", "?"}})
    expected.push_back(rule);
  EXPECT_EQ(withEdits(base, plant).rules, expected);
}

TEST(NewClass, GetsNoRuleInAFileWithoutAny) {
  Mtg base = readText(textOf(mtgOf(test::stick(3))));
  base.rules.clear();
  const Skeleton plant = committedStick(&base, skeletonOf(base, "plant.mtg").value);
  EXPECT_TRUE(withEdits(base, plant).rules.empty());
}

TEST(NewClass, OfAPlantMadeHereHasRulesAtEachScaleBelowPlants) {
  const Mtg mtg = mtgOf(test::fork(2), MtgStyle::plantAxisNode);
  const std::vector<MtgRule> expected = {
      {"A", "A", "<", "?"}, {"A", "A", "+", "?"}, {"N", "N", "<", "?"}, {"N", "N", "+", "?"}};
  EXPECT_EQ(mtg.rules, expected);
}

} // namespace
} // namespace espalier
