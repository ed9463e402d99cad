#include "core/io/structures/swc.h"
#include "core/skeleton/assemble_axes.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::HasSubstr;

Skeleton importSwc(const std::string& text) {
  std::istringstream in(text);
  return readSwc(in, "oak.swc").value;
}

std::string refusalOfSwc(const std::string& text) {
  return test::errorOf([&] { return importSwc(text); });
}

TEST(ReadSwc, TakesNodesInAnyOrder) {
  const std::string text = "# id type x y z r parent\n\n"
                           "7 3 0 0 2 0.25 5\n"
                           "  5 1 0 0 1 0.5 -1\n"
                           "9 3 0 0 3.5 1e-1 7\n"
                           "8 3 1 0 3 0 7 extra columns\n";
  EXPECT_TRUE(isSwc(text.substr(0, text.find("8 3"))));
  const Skeleton plant = importSwc(text);
  ASSERT_EQ(plant.size(), 4U);
  EXPECT_EQ(plant[NodeId{0}], (Node{.position = {0, 0, 1}, .radius = 0.5}));
  EXPECT_EQ(plant[NodeId{1}], (Node{.position = {0, 0, 2}, .radius = 0.25, .parent = NodeId{0}}));
}

// From the node at 2 one child goes on for 1.5, the other for sqrt(1 + 1) = 1.41.
TEST(ReadSwc, LetsTheChildThatCarriesMostContinueTheAxis) {
  const Skeleton plant =
      importSwc("1 0 0 0 0 1 -1\n2 0 0 0 2 1 1\n3 0 1 0 3 1 2\n4 0 0 0 3.5 1 2\n");
  const std::vector<NodeId>& children = plant.children(NodeId{1});
  ASSERT_EQ(children.size(), 2U);
  EXPECT_EQ(plant[children[0]].position.z(), 3.5);
  EXPECT_EQ(plant[children[0]].edge, EdgeType::successor);
  EXPECT_EQ(plant[children[1]].edge, EdgeType::branching);
}

TEST(ReadSwc, TakesSeveralTrees) {
  EXPECT_EQ(importSwc("1 0 0 0 0 1 -1\n2 0 5 0 0 1 -1\n3 0 5 0 1 1 2\n").roots().size(), 2U);
}

TEST(ReadSwc, TakesRadiiThatAreNotAboveZeroAsNotEstimated) {
  const Skeleton plant = importSwc("1 0 0 0 0 -1 -1\n2 0 0 0 1 nan 1\n3 0 0 0 2 0 2\n");
  for (const NodeId id : plant.ids())
    EXPECT_EQ(plant[id].radius, 0);
}

TEST(ReadSwc, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refusalOfSwc("# nothing\n"), "oak.swc: holds no nodes");
  EXPECT_EQ(refusalOfSwc("#\n1 0 0 0 0 1\n"),
            "oak.swc, line 2: expected 7 numbers (id type x y z radius parent), found 6");
  EXPECT_THAT(refusalOfSwc("1 0 0 y 0 1 -1\n"),
              HasSubstr("line 1: expected a number as y, found 'y'"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 inf 1 -1\n"), HasSubstr("line 1: expected a number as z"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 0 r -1\n"), HasSubstr("line 1: expected a number as radius"));
  EXPECT_THAT(refusalOfSwc("1.5 0 0 0 0 1 -1\n"),
              HasSubstr("line 1: expected a whole number as id"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 0 1 none\n"),
              HasSubstr("a whole number as parent, found 'none'"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 0 1 -1\n1 0 0 0 1 1 1\n"),
              HasSubstr("line 2: the id '1' occurs twice"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 0 1 -1\n2 0 0 0 1 1 7\n"), HasSubstr("line 2: the parent '7'"));
  EXPECT_THAT(refusalOfSwc("1 0 0 0 0 1 -1\n2 0 0 0 1 1 3\n3 0 0 0 1 1 2\n"),
              HasSubstr("line 2: the node is among its own ancestors"));
}

TEST(ReadSwc, IsNotSlowedDownByANodeOfManyChildren) {
  std::string text = "0 0 0 0 0 1 -1\n";
  constexpr int children = 200'000;
  for (int i = 1; i <= children; ++i)
    text += std::to_string(i) + " 0 0 0 " + std::to_string(i) + " 1 0\n";
  const Skeleton plant = importSwc(text); // quadratic, it would not end within the time of a test
  EXPECT_EQ(plant.children(NodeId{0}).size(), std::size_t{children});
}

TEST(IsSwc, IsNotTrueOfPoints) {
  EXPECT_TRUE(isSwc("1 0 0 0 0 1 -1\n2 0 0 0 1 1 1\n3 0 0"));
  EXPECT_FALSE(isSwc("1 2 3 255 255 0 17\n4 5 6 255 0 0 19\n"));
  EXPECT_FALSE(isSwc("1.5 0 0 0 0 1 -1\n"));
  EXPECT_FALSE(isSwc("1 0 0 0 0 1\n"));
  EXPECT_FALSE(isSwc("a 0 0 0 0 1 -1\n"));
  EXPECT_FALSE(isSwc(""));
}

TEST(WriteSwc, PutsTheSuccessorRightAfterItsParent) {
  Skeleton plant = test::stick(2);
  plant.add({.position = {0, 0, 2}, .parent = NodeId{1}});
  plant.add(
      {.position = {1, 0, 1}, .radius = 0.5, .parent = NodeId{0}, .edge = EdgeType::branching});
  std::ostringstream out;
  writeSwc(out, plant);
  EXPECT_EQ(out.str(), "# exported by Espalier\n# id type x y z radius parent\n"
                       "1 0 0 0 0 0.1 -1\n2 0 0 0 1 0.1 1\n3 0 0 0 2 0 2\n4 0 1 0 1 0.5 1\n");
}

TEST(WriteSwc, AndReadingGivesTheSamePlantButForEdgeTypes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = withAssembledAxes(test::randomPlant(200, seed));
    std::ostringstream out;
    writeSwc(out, plant);
    EXPECT_TRUE(isSwc(out.str()));
    EXPECT_EQ(test::canonical(importSwc(out.str())), test::canonical(plant));
  }
}

} // namespace
} // namespace espalier
