#include "core/base/random.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/skeleton/edits.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>

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

Skeleton readBack(const Mtg& mtg) {
  return skeletonOf(mtg, "plant.mtg").value;
}

TEST(WithEdits, GivesTheSameMtgIfNothingWasEdited) {
  const Mtg base = twoAxes();
  EXPECT_EQ(withEdits(base, readBack(base)), base);
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

TEST(MtgOf, NumbersPlantsAndAxes) {
  const Mtg mtg = mtgOf(test::fork(2), MtgStyle::plantAxisNode);
  std::vector<std::string> labels;
  for (const MtgVertex& vertex : mtg.vertices)
    labels.push_back(vertex.symbol + (vertex.index ? std::to_string(*vertex.index) : ""));
  std::ranges::sort(labels);
  EXPECT_EQ(labels, (std::vector<std::string>{"A1", "A2", "N", "N", "N", "N", "P1"}));
  EXPECT_EQ(test::canonical(test::withoutEntities(readBack(mtg))), test::canonical(test::fork(2)));
}

void editAtRandom(SkeletonEditor& editor, Random& random) {
  const std::vector<NodeId> ids = editor.skeleton().ids();
  const NodeId id = ids[random.below(ids.size())];
  const NodeId other = ids[random.below(ids.size())];
  switch (random.below(6)) {
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
    if (editor.skeleton()[id].parent) removeNode(editor, id);
    break;
  case 4:
    if (!editor.skeleton().isAncestor(id, other) && editor.skeleton()[id].parent)
      reparentNode(editor, id, other);
    break;
  default:
    editor.setRadius(id, random.uniform());
  }
}

void expectEditsComeBack(const Mtg& base, std::uint64_t seed) {
  Random random(seed);
  const Skeleton start = readBack(base);
  Skeleton plant = start;
  SkeletonDelta all;
  for (int i = 0; i < 40; ++i) {
    SkeletonEditor editor(plant);
    editAtRandom(editor, random);
    all = all.then(editor.commit());
  }
  const Mtg result = withEdits(base, plant);
  const Skeleton back = readBack(result);
  EXPECT_EQ(test::canonical(test::withoutEntities(back)),
            test::canonical(test::withoutEntities(plant)))
      << seed;
  // Own entities of new nodes are given on writing: they are compared by what they start only.
  const auto units = [&](Skeleton each) {
    const int scale = start[start.roots().front()].entities.back().scale;
    for (const NodeId id : each.ids()) {
      std::vector<Entity> entities = each[id].entities;
      std::erase_if(entities, [&](const Entity& e) { return e.scale >= scale; });
      each.setEntities(id, std::move(entities));
    }
    return test::canonical(each);
  };
  EXPECT_EQ(units(back), units(plant)) << seed;
  all.inverse().apply(plant);
  EXPECT_EQ(withEdits(base, plant), base) << seed;
}

TEST(WithEdits, ComeBackWhateverWasEdited) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    expectEditsComeBack(mtgOf(test::randomPlant(60, seed), MtgStyle::plantAxisNode), seed);
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
