#include "core/base/random.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace espalier {
namespace {

// A1 of E1 < E2 < E4, and A2 of E3 on E2; a plant around both.
Mtg twoAxes() {
  return test::readMtgRows("/P1\n^/A1\t\t\t9\t9\t9\n^/E1\t\t\t0\t0\t0\t0.50\n"
                           "^<E2\t\t\t0\t0\t1.00\t\n\t+A2/E3\t\t1\t0\t1\n^<E4\t\t\t0\t0\t2\n")
      .value;
}

Skeleton edited(const Mtg& base, const std::function<void(SkeletonEditor&)>& change) {
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  SkeletonEditor editor(plant);
  change(editor);
  (void)editor.commit();
  return plant;
}

Skeleton writtenAndRead(const Mtg& mtg) {
  return skeletonOf(mtg, "plant.mtg").value;
}

TEST(WithEdits, GivesTheSameMtgIfNothingWasEdited) {
  const Mtg base = twoAxes();
  EXPECT_EQ(withEdits(base, writtenAndRead(base)), base);
}

TEST(WithEdits, WritesThePositionThatMovedAndNothingElse) {
  const Mtg base = twoAxes();
  Mtg expected = base;
  expected.vertices[3].values[2] = "1.25"; // E2: XX and YY stay as written
  EXPECT_EQ(withEdits(base, edited(base,
                                   [](SkeletonEditor& e) {
                                     moveNode(e, NodeId{1}, {0, 0, 1.25});
                                   })),
            expected);
}

TEST(WithEdits, LetsAUnitThatLostItsLastNodeLeave) {
  const Mtg base = twoAxes();
  Mtg expected = base;
  expected.vertices.resize(4);
  expected.vertices.push_back(base.vertices.back()); // E4, which is on E2, before A2 and E3
  EXPECT_EQ(withEdits(base, edited(base, [](SkeletonEditor& e) { removeNode(e, NodeId{2}); })),
            expected);
}

TEST(WithEdits, NumbersANewNodeAmongTheNodesOfItsUnit) {
  const Mtg base = twoAxes();
  const Mtg result = withEdits(base, edited(base, [](SkeletonEditor& e) {
                                 addChild(e, NodeId{2}, {2, 0, 1});
                               }));
  ASSERT_EQ(result.vertices.size(), base.vertices.size() + 1);
  const MtgVertex& added = result.vertices[6]; // right after E3, in A2
  EXPECT_EQ(added.symbol, "E");
  EXPECT_EQ(added.index, 4);
  EXPECT_EQ(added.complex, VertexId{4});
  EXPECT_EQ(added.parent, VertexId{5});
}

/// E16 bears E16.1 and E16.2; E17 follows it.
Mtg shootsOfPlaces() {
  return test::readMtgRows("/P1/A1\n\t/E16\t\t0\t0\t0\n\t\t+E16.1\t1\t0\t1\n"
                           "\t\t+E16.2\t-1\t0\t1\n\t^<E17\t\t0\t0\t2\n")
      .value;
}

TEST(WithEdits, NumbersABranchAfterThoseOfItsPlace) {
  const Mtg base = shootsOfPlaces();
  const Mtg result =
      withEdits(base, edited(base, [](SkeletonEditor& e) {
                  for (const double x : {2.0, 3.0})
                    e.setEdge(addChild(e, NodeId{0}, {x, 0, 1}), EdgeType::branching);
                }));
  std::multiset<std::string> added;
  for (const MtgVertex& vertex : result.vertices)
    if (vertex.index && vertex.index->isDotted()) added.insert(vertex.index->text());
  EXPECT_EQ(added, (std::multiset<std::string>{"16.1", "16.2", "16.3", "16.4"}));
}

TEST(WithEdits, NumbersABranchOfAnotherPlaceAfterTheHighestOfItsUnit) {
  const Mtg base = shootsOfPlaces();
  const Mtg result = withEdits(base, edited(base, [](SkeletonEditor& e) {
                                 addChild(e, NodeId{3}, {0, 0, 3});
                               }));
  EXPECT_EQ(result.vertices.back().index, 18);
}

/// Four scales: P1 of A1 of E1 < E2 < E3, and A2 of E4 < E5 on E3; E2 has no position; each of E1
/// to E4 has a part F, finer than the nodes.
Mtg fourScales() {
  const auto at = [](std::uint32_t id) { return std::optional(VertexId{id}); };
  constexpr auto follows = EdgeType::successor;
  constexpr auto branches = EdgeType::branching;
  return {.classes = {{.symbol = "P", .scale = 1},
                      {.symbol = "A", .scale = 2},
                      {.symbol = "E", .scale = 3},
                      {.symbol = "F", .scale = 4}},
          .rules = {},
          .features = {{"XX", "REAL"},
                       {"YY", "REAL"},
                       {"ZZ", "REAL"},
                       {"Diameter", "REAL"},
                       {"Color", "ALPHA"}},
          .vertices = {{"P", 1, 1, {}, {}, follows, {}},
                       {"A", 1, 2, at(0), {}, follows, {"", "", "", "", "brown"}},
                       {"E", 1, 3, at(1), {}, follows, {"0", "0", "0.00", "0.50", "red"}},
                       {"F", 1, 4, at(2), {}, follows, {"", "", "", "", "a"}},
                       {"E", 2, 3, at(1), at(2), follows, {"", "", "", "", "blue"}},
                       {"F", 2, 4, at(4), at(3), follows, {}},
                       {"E", 3, 3, at(1), at(4), follows, {"0", "0", "2.0"}},
                       {"F", 3, 4, at(6), at(5), follows, {"", "", "", "", "c"}},
                       {"A", 2, 2, at(0), at(1), branches, {"", "", "", "", "green"}},
                       {"E", 4, 3, at(8), at(6), branches, {"1", "0", "3", "0.2"}},
                       {"F", 4, 4, at(9), at(7), branches, {}},
                       {"E", 5, 3, at(8), at(9), follows, {"2", "0", "4", "0.10", "red"}}}};
}

Mtg afterEdit(const Mtg& base, const std::function<void(SkeletonEditor&)>& change) {
  return withEdits(base, edited(base, change));
}

TEST(WithEdits, WritesARadiusTwiceInDiameter) {
  Mtg expected = fourScales();
  expected.vertices[2].values[3] = "0.75";
  EXPECT_EQ(afterEdit(fourScales(), [](SkeletonEditor& e) { e.setRadius(NodeId{0}, 0.375); }),
            expected);
}

TEST(WithEdits, LeavesAVertexWithoutPositionWhereItStaysBetweenItsNeighbors) {
  Mtg expected = fourScales();
  expected.vertices[2].values[2] = "1";
  expected.vertices[6].values[2] = "3";
  expected.vertices[9].values[2] = "4";
  expected.vertices[11].values[2] = "5";
  const Mtg result = afterEdit(fourScales(), [](SkeletonEditor& e) { moveAll(e, {0, 0, 1}); });
  for (std::size_t i = 0; i < expected.vertices.size(); ++i)
    EXPECT_EQ(result.vertices[i].values, expected.vertices[i].values) << i;
  EXPECT_EQ(result, expected);
}

TEST(WithEdits, WritesAVertexWithoutPositionThatWasMoved) {
  Mtg expected = fourScales();
  expected.vertices[4].values = {"0.5", "0", "1", "", "blue"};
  EXPECT_EQ(afterEdit(fourScales(),
                      [](SkeletonEditor& e) {
                        moveNode(e, NodeId{1}, {0.5, 0, 1});
                      }),
            expected);
}

TEST(WithEdits, WritesAVertexWithoutPositionThatIsTheLastNode) {
  const Mtg result = afterEdit(fourScales(), [](SkeletonEditor& e) {
    for (const std::uint32_t id : {4U, 3U, 2U, 0U})
      removeNode(e, NodeId{id});
  });
  const Skeleton back = writtenAndRead(result);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[back.roots().front()].position, Eigen::Vector3d(0, 0, 1));
}

TEST(WithEdits, WritesAVertexWithoutPositionWhereItsNeighborMovedAlone) {
  Mtg expected = fourScales();
  expected.vertices[2].values[2] = "1";
  expected.vertices[4].values = {"0", "0", "1", "", "blue"}; // where it was, between 0 and 2
  EXPECT_EQ(afterEdit(fourScales(),
                      [](SkeletonEditor& e) {
                        moveNode(e, NodeId{0}, {0, 0, 1});
                      }),
            expected);
}

// F3 goes with E3; F4, part of E4 which is attached to E2 then, is attached to F2.
TEST(WithEdits, AttachesFinerPartsWhereTheirNodesAre) {
  const Mtg result = afterEdit(fourScales(), [](SkeletonEditor& e) { removeNode(e, NodeId{2}); });
  ASSERT_EQ(result.vertices.size(), 10U);
  const auto labeled = [&](const std::string& symbol, int index) {
    const auto found = std::ranges::find_if(result.vertices, [&](const MtgVertex& each) {
      return each.symbol == symbol && each.index == index;
    });
    EXPECT_NE(found, result.vertices.end()) << symbol << index;
    return VertexId{static_cast<std::uint32_t>(found - result.vertices.begin())};
  };
  const auto vertex = [&](VertexId id) { return result.vertices[indexOf(id)]; };
  EXPECT_EQ(vertex(labeled("E", 4)).parent, labeled("E", 2));
  EXPECT_EQ(vertex(labeled("F", 4)).parent, labeled("F", 2));
  EXPECT_EQ(vertex(labeled("F", 4)).edge, EdgeType::branching);
  EXPECT_EQ(vertex(labeled("A", 2)).parent, labeled("A", 1));
  const auto& values = vertex(labeled("E", 2)).values; // nothing is above it on its axis
  ASSERT_GE(values.size(), 3U);
  EXPECT_EQ(values[2], "1");
}

TEST(WithEdits, KeepsTheUnitsOfARootThatIsRemoved) {
  const Mtg base = fourScales();
  const Mtg result = afterEdit(base, [](SkeletonEditor& e) { removeNode(e, NodeId{0}); });
  ASSERT_EQ(result.vertices.size(), base.vertices.size() - 2); // E1 and F1
  EXPECT_EQ(result.vertices[0], base.vertices[0]);
  EXPECT_EQ(result.vertices[1], base.vertices[1]);
  const MtgVertex& root = result.vertices[2];
  EXPECT_EQ(root.index, 2);
  EXPECT_EQ(root.parent, std::nullopt);
  EXPECT_EQ(root.complex, VertexId{1});
  EXPECT_EQ(root.values, (std::vector<std::string>{"0", "0", "1", "", "blue"}));
  EXPECT_EQ(result.vertices[3].symbol, "F");
  EXPECT_EQ(result.vertices[3].parent, std::nullopt);
}

TEST(WithEdits, TakesASubtreeWithItsUnitsAndFinerParts) {
  Mtg expected = fourScales();
  expected.vertices.resize(8); // A2 and what follows are all of it
  EXPECT_EQ(afterEdit(fourScales(), [](SkeletonEditor& e) { removeSubtree(e, NodeId{3}); }),
            expected);
}

TEST(WithEdits, PutsAReconstructionInUnitsOfTheClassesThatTheRootWasIn) {
  const Mtg base = fourScales();
  const Mtg result = afterEdit(base, [](SkeletonEditor& e) { replaceSkeleton(e, test::stick(3)); });
  EXPECT_EQ(result.classes, base.classes);
  EXPECT_EQ(result.features, base.features);
  std::vector<std::string> symbols;
  for (const MtgVertex& each : result.vertices)
    symbols.push_back(each.symbol);
  EXPECT_EQ(symbols, (std::vector<std::string>{"P", "A", "E", "E", "E"}));
  EXPECT_EQ(test::canonical(test::withoutEntities(writtenAndRead(result))),
            test::canonical(test::stick(3)));
}

TEST(MtgOf, NumbersPlantsAndAxes) {
  const Mtg mtg = mtgOf(test::fork(2), MtgStyle::plantAxisNode);
  std::vector<std::string> labels;
  for (const MtgVertex& vertex : mtg.vertices)
    labels.push_back(vertex.symbol + (vertex.index ? vertex.index->text() : ""));
  std::ranges::sort(labels);
  EXPECT_EQ(labels, (std::vector<std::string>{"A1", "A2", "N", "N", "N", "N", "P1"}));
  EXPECT_EQ(test::canonical(test::withoutEntities(writtenAndRead(mtg))),
            test::canonical(test::fork(2)));
}

void editAtRandom(SkeletonEditor& editor, Random& random) {
  const std::vector<NodeId> ids = editor.skeleton().ids();
  const NodeId id = ids[random.below(ids.size())];
  const NodeId other = ids[random.below(ids.size())];
  switch (random.below(12)) {
  case 7:
    if (editor.skeleton()[id].parent) cutOff(editor, id);
    break;
  case 8:
    if (editor.skeleton().roots().size() > 1)
      joinTree(editor, id, nearestInOtherTree(editor.skeleton(), id));
    break;
  case 9:
    reroot(editor, id);
    break;
  case 10:
    if (editor.skeleton()[id].parent && editor.skeleton().size() > 4)
      mergeNodes(editor, {id, *editor.skeleton()[id].parent});
    break;
  case 11:
    resample(editor, grown(editor.skeleton(), {id}), random.uniform(0.2, 2));
    break;
  case 0:
    moveNode(editor, id, random.direction());
    break;
  case 1:
    addChild(editor, id, random.direction());
    break;
  case 2:
    if (editor.skeleton()[id].parent) splitEdge(editor, id, 0.25 + 0.5 * random.uniform());
    break;
  case 3:
    if (editor.skeleton().size() > 2) removeNode(editor, id);
    break;
  case 5:
    if (editor.skeleton()[id].parent && editor.skeleton().size() > 4) removeSubtree(editor, id);
    break;
  case 4:
    if (!editor.skeleton().isAncestor(id, other) && editor.skeleton()[id].parent)
      reparentNode(editor, id, other);
    break;
  default:
    editor.setRadius(id, random.uniform());
  }
}

/// What a vertex says of itself, whatever it is attached to and is a part of.
MtgVertex alone(MtgVertex vertex) {
  vertex.parent.reset();
  vertex.complex.reset();
  vertex.edge = EdgeType::successor;
  return vertex;
}

/// Vertices whose nodes were not edited say what they said; nodes keep what they carry.
/// @return how many such vertices there are
std::size_t expectTheUntouchedAsTheyWere(const Mtg& base, const Skeleton& edited, const Mtg& result,
                                         std::uint64_t seed) {
  const auto key = [](const Node& node) {
    return std::tuple(node.position.x(), node.position.y(), node.position.z(), node.radius);
  };
  const MtgView before = viewOf(base, "plant.mtg").value;
  const MtgView after = viewOf(result, "plant.mtg").value;
  std::map<decltype(key(Node())), NodeId> nodes;
  for (const NodeId id : after.skeleton.ids())
    nodes[key(after.skeleton[id])] = id;
  const std::set<NodeId> interpolated(before.interpolated.begin(), before.interpolated.end());
  std::size_t compared = 0;
  for (const NodeId id : edited.ids()) {
    if (!before.skeleton.contains(id)) continue;
    const auto found = nodes.find(key(edited[id]));
    EXPECT_NE(found, nodes.end()) << seed;
    if (found == nodes.end()) continue;
    EXPECT_EQ(after.skeleton[found->second].entities.back(), edited[id].entities.back()) << seed;
    if (interpolated.contains(id)) continue; // it may have a position now
    if (key(edited[id]) != key(before.skeleton[id])) continue;
    EXPECT_EQ(alone(result.vertices[indexOf(after.vertices[indexOf(found->second)])]),
              alone(base.vertices[indexOf(before.vertices[indexOf(id)])]))
        << seed;
    ++compared;
  }
  return compared;
}

Skeleton namesAlone(Skeleton skeleton) {
  for (const NodeId id : skeleton.ids()) {
    std::vector<Entity> entities = skeleton[id].entities;
    for (Entity& entity : entities)
      entity.values.clear();
    skeleton.setEntities(id, std::move(entities));
  }
  return skeleton;
}

/// @return how many vertices stayed as they were
std::size_t expectEditsComeBack(const Mtg& base, std::uint64_t seed) {
  Random random(seed);
  const Skeleton start = writtenAndRead(base);
  Skeleton plant = start;
  SkeletonDelta all;
  for (int i = 0; i < 40; ++i) {
    SkeletonEditor editor(plant);
    editAtRandom(editor, random);
    all = all.then(editor.commit());
  }
  const Mtg result = withEdits(base, plant);
  const Skeleton back = writtenAndRead(result);
  EXPECT_EQ(test::canonical(test::withoutEntities(back)),
            test::canonical(test::withoutEntities(test::withoutOrigins(plant))))
      << seed;
  const std::size_t untouched = expectTheUntouchedAsTheyWere(base, plant, result, seed);
  // Own entities of new nodes are given on writing: they are compared by what they start only.
  const auto units = [&](Skeleton each) {
    const int scale = start[start.roots().front()].entities.back().scale;
    for (const NodeId id : each.ids()) {
      std::vector<Entity> entities = each[id].entities;
      std::erase_if(entities, [&](const Entity& e) { return e.scale >= scale; });
      each.setEntities(id, std::move(entities));
    }
    return test::canonical(test::withoutOrigins(std::move(each)));
  };
  const Skeleton unitsBack = units(back);
  const Skeleton unitsOfPlant = units(plant);
  EXPECT_EQ(namesAlone(unitsBack), namesAlone(unitsOfPlant)) << seed;
  // What a unit says can come back though the node it was said at is gone: the MTG still knows it.
  for (const NodeId id : unitsOfPlant.ids())
    for (const Entity& unit : unitsOfPlant[id].entities)
      EXPECT_TRUE(unit.values.empty() || std::ranges::count(unitsBack[id].entities, unit) == 1)
          << seed;
  all.inverse().apply(plant);
  EXPECT_EQ(withEdits(base, plant), base) << seed;
  return untouched;
}

TEST(WithEdits, ComeBackWhateverWasEdited) {
  std::size_t untouched = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    untouched +=
        expectEditsComeBack(mtgOf(test::randomPlant(60, seed), MtgStyle::plantAxisNode), seed);
  EXPECT_GT(untouched, 50U * 5);
}

TEST(WithEdits, ComeBackInFourScales) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    expectEditsComeBack(fourScales(), seed);
}

TEST(WithEdits, ComeBackInFilesOfOthers) {
  for (const char* name :
       {"structures/arabidopsis_reference.mtg", "mtg/reconstructed_appletree.mtg"}) {
    ESPALIER_SHARED_FILE(path, name);
    std::ifstream in(path);
    const Mtg base = readMtg(in, name).value;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      expectEditsComeBack(base, seed);
  }
}

} // namespace
} // namespace espalier
