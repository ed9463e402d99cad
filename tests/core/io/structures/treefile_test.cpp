#include "core/base/shown_message.h"
#include "core/io/structures/treefile.h"
#include "core/skeleton/assemble_axes.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Imported<Skeleton> importedTreefileFile(const std::string& text) {
  std::istringstream in(text);
  return readTreefile(in, "oak.txt");
}

Skeleton importTreefile(const std::string& text) {
  return importedTreefileFile(text).value;
}

std::string refusalOfTreefile(const std::string& text) {
  return test::errorOf([&] { return importTreefile(text); });
}

const std::string header = "x,y,z,radius,parent_id\n";

TEST(ReadTreefile, TakesATreeFromEachLine) {
  const std::string text = "# Tree file\n" + header + "0,0,0,0.5,-1, 0,0,2,0.25,0, 0,0,3,0.1,1\n" +
                           "# a remark\n\n" + "5,0,0,0.3,-1, 5,0,1,0.2,0\n";
  EXPECT_TRUE(isTreefile(text));
  const Skeleton plants = importTreefile(text);
  ASSERT_EQ(plants.size(), 5U);
  EXPECT_EQ(plants.roots().size(), 2U);
  const NodeId first = plants.roots().front();
  EXPECT_EQ(plants[first], (Node{.position = {0, 0, 0}, .radius = 0.5}));
  const NodeId next = plants.children(first).front();
  EXPECT_EQ(plants[next], (Node{.position = {0, 0, 2}, .radius = 0.25, .parent = first}));
}

// The foot has a height, its branches have a section and a parent.
TEST(ReadTreefile, TakesOtherFieldsForTheFootThanForBranches) {
  const auto plant = importedTreefileFile("x,y,z,radius,height x,y,z,radius,parent_id,section\n"
                                          "1,2,3,0.5,17, 1,2,4,0.25,0,9\n");
  ASSERT_EQ(plant.value.size(), 2U);
  EXPECT_EQ(plant.value[NodeId{1}].position, Eigen::Vector3d(1, 2, 4));
  EXPECT_EQ(plant.value[NodeId{1}].parent, NodeId{0});
  EXPECT_THAT(eachInEnglish(plant.notes),
              ElementsAre(HasSubstr("has no edge types"),
                          "oak.txt: its fields 'height', 'section' are left out"));
}

TEST(ReadTreefile, TakesTrunksThatAreFeetOnly) {
  EXPECT_EQ(importTreefile("x,y,z,radius\n1,2,3,0.5\n4,5,6,0.5\n").roots().size(), 2U);
}

TEST(ReadTreefile, LetsTheChildThatCarriesMostContinueTheAxis) {
  const Skeleton plant =
      importTreefile(header + "0,0,0,1,-1, 0,0,2,1,0, 0.5,0,3,1,1, 0,0,3,1,1, 0,0,4,1,3\n");
  for (const NodeId id : plant.ids())
    EXPECT_EQ(plant[id].edge,
              plant[id].position.x() > 0 ? EdgeType::branching : EdgeType::successor);
}

TEST(ReadTreefile, NamesTheLineAndSegmentThatIsWrong) {
  EXPECT_EQ(refusalOfTreefile(header), "oak.txt: holds no trees");
  EXPECT_THAT(refusalOfTreefile("#\n1,2,3,4\n"), HasSubstr("oak.txt, line 2: expected the names"));
  EXPECT_EQ(refusalOfTreefile(header + "0,0,0,1\n"),
            "oak.txt, line 2: expected 5 fields and then a multiple of 5, found 4");
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,0,0\n"),
              HasSubstr("line 2: expected 5 fields"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,b,0,1,0\n"),
              HasSubstr("line 2: segment 1: expected a number as y, found 'b'"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,nan,1,-1\n"),
              HasSubstr("segment 0: expected a number as z"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,0,1,1,2\n"),
              HasSubstr("segment 1: its parent_id is '2', but the tree has segments 0 to 1"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,0,1,1,0.5\n"),
              HasSubstr("its parent_id is '0.5'"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,0,1,1,1e300\n"),
              HasSubstr("its parent_id is"));
  EXPECT_THAT(refusalOfTreefile(header + "0,0,0,1,-1, 0,0,1,1,2, 0,0,1,1,1\n"),
              HasSubstr("line 2: the node is among its own ancestors"));
  EXPECT_THAT(refusalOfTreefile("x,y,z,radius\n0,0,0,1, 0,0,1,1\n"),
              HasSubstr("no parent_id to join them"));
}

TEST(IsTreefile, IsNotTrueOfPoints) {
  EXPECT_FALSE(isTreefile("x,y,z,radius\n1,2,3,4\n"));
  EXPECT_FALSE(isTreefile("x,y,z,intensity\n1,2,3,4\n"));
  EXPECT_FALSE(isTreefile("# x,y,z,radius,parent_id\n1,2,3,4\n"));
}

TEST(WriteTreefile, WritesALinePerTree) {
  std::ostringstream out;
  writeTreefile(out, test::stick(3));
  EXPECT_EQ(out.str(), "# Tree file, exported by Espalier\nx,y,z,radius,parent_id\n"
                       "0,0,0,0.1,-1, 0,0,1,0.1,0, 0,0,2,0.1,1\n");
}

TEST(WriteTreefile, AndReadingGivesTheSamePlantButForEdgeTypes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = withAssembledAxes(test::randomPlant(200, seed));
    std::ostringstream out;
    writeTreefile(out, plant);
    EXPECT_TRUE(isTreefile(out.str()));
    EXPECT_EQ(test::canonical(importTreefile(out.str())), test::canonical(plant));
  }
}

// Linear: by now it would take minutes otherwise.
TEST(ReadTreefile, TakesVeryManyFields) {
  std::string names = "x,y,z,radius,parent_id";
  std::string values = "0,0,0,1,-1";
  for (int i = 0; i < 200'000; ++i) {
    names += ",f" + std::to_string(i);
    values += ",0";
  }
  const Imported<Skeleton> trees = importedTreefileFile(names + '\n' + values + '\n');
  EXPECT_EQ(trees.value.size(), 1U);
  EXPECT_THAT(eachInEnglish(trees.notes),
              testing::Contains(testing::HasSubstr(", + 199990 are left out")));
}

} // namespace
} // namespace espalier
