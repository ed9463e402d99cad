#include "core/base/shown_message.h"
#include "core/io/formats.h"
#include "core/io/qsm/qsm_table.h"
#include "core/skeleton/assemble_axes.h"
#include "tests/core/io/qsm/qsm_samples.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <limits>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Imported<Skeleton> importQsmTable(const std::string& bytes) {
  std::istringstream in(bytes);
  return readQsmTable(in, "oak.csv");
}

std::string refusalOfQsmTable(const std::string& bytes) {
  return test::errorOf([&] { return importQsmTable(bytes); });
}

std::string written(const Skeleton& skeleton) {
  std::ostringstream out;
  writeQsmTable(out, skeleton);
  return out.str();
}

/// The plant of `treeQsmTable`.
Skeleton expectedTree() {
  Skeleton tree;
  const NodeId root = tree.add({{0, 0, 0}, 0.2, std::nullopt});
  const NodeId stem = tree.add({{0, 0, 2}, 0.2, root});
  (void)tree.add({{0, 0, 3}, 0.1, stem});
  const NodeId branch = tree.add({{0, 1.2, 2}, 0.05, stem, EdgeType::branching});
  (void)tree.add({{0, 1.7, 2}, 0.04, branch});
  return tree;
}

TEST(ReadQsmTable, FindsTheTreeInTheTableOfTreeQsm) {
  const Imported<Skeleton> tree = importQsmTable(test::treeQsmTable());
  EXPECT_EQ(test::canonical(tree.value), test::canonical(expectedTree()));
  EXPECT_THAT(eachInEnglish(tree.notes),
              ElementsAre("oak.csv: columns that are not kept: 'mad', 'SurfCov', "
                          "'added', 'UnmodRadius (m)'"));
}

TEST(ReadQsmTable, FindsItInTheTableWithoutNames) {
  const Imported<Skeleton> tree = importQsmTable(test::treeQsmTableWithoutNames());
  EXPECT_EQ(test::canonical(tree.value), test::canonical(expectedTree()));
}

TEST(ReadQsmTable, TakesOtherSpellingsOfTheNames) {
  const Imported<Skeleton> tree =
      importQsmTable("\"\",\"Radius\",\"start.x\",\"start.y\",\"start.z\","
                     "\"axis.x\",\"axis.y\",\"axis.z\",\"Length\",\"Parent\","
                     "\"Extension\"\r\n"
                     "\"1\",0.5,1,2,3,0,0,2,4,0,0\r\n\r\n");
  ASSERT_EQ(tree.value.size(), 2U);
  EXPECT_EQ(tree.value[NodeId{1}].position, Eigen::Vector3d(1, 2, 7)); // an axis of any length
  EXPECT_THAT(tree.notes, IsEmpty());
}

TEST(ReadQsmTable, TakesTheBranchOrElseTheFirstWithoutExtensions) {
  const std::string names = "radius;length;start_x;start_y;start_z;axis_x;axis_y;axis_z;parent";
  const Skeleton byBranch =
      importQsmTable(names + ";branch\n1;1;0;0;0;0;0;1;0;1\n1;1;0;0;1;1;0;0;1;2\n"
                             "1;1;0;0;1;0;0;1;1;1\n")
          .value;
  EXPECT_EQ(byBranch[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(byBranch[NodeId{3}].edge, EdgeType::successor);
  const Imported<Skeleton> byOrder =
      importQsmTable(names + "\n1;1;0;0;0;0;0;1;0\n1;1;0;0;1;1;0;0;1\n1;1;0;0;1;0;0;1;1\n");
  EXPECT_EQ(byOrder.value[NodeId{2}].edge, EdgeType::successor);
  EXPECT_EQ(byOrder.value[NodeId{3}].edge, EdgeType::branching);
  EXPECT_THAT(eachInEnglish(byOrder.notes),
              ElementsAre(HasSubstr("does not say which cylinder continues")));
}

TEST(ReadQsmTable, NotesCylindersThatBeginElsewhereAndFalseExtensions) {
  const Imported<Skeleton> tree =
      importQsmTable("radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension\n"
                     "0.1,4,0,0,0,0,0,1,0,1\n"
                     "0.1,1,0,0,1,1,0,0,1,9\n");
  EXPECT_EQ(tree.value[NodeId{2}].parent, NodeId{1});
  EXPECT_EQ(tree.value[NodeId{2}].edge, EdgeType::branching);
  EXPECT_THAT(eachInEnglish(tree.notes),
              ElementsAre(HasSubstr("1 cylinder begins farther than its radius from "
                                    "the end of the one that bears it, by up to 3;"),
                          HasSubstr("2 extensions are cylinders that are not attached")));
}

TEST(ReadQsmTable, TakesParentsThatComeLater) {
  const Skeleton tree =
      importQsmTable("radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent\n"
                     "1,1,0,0,1,0,0,1,2\n1,1,0,0,0,0,0,1,0\n")
          .value;
  ASSERT_EQ(tree.size(), 3U);
  EXPECT_EQ(tree[NodeId{2}].position.z(), 2);
}

TEST(ReadQsmTable, RefusesLinesThatAreNoCylinders) {
  const std::string names = "radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent\n";
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"", "holds no cylinders"},
      {"1,1,0,0,0,0,0,1\n", "line 2: expected 9 columns, found 8"},
      {"1,1,0,0,0,0,0,1,0\n1,x,0,0,0,0,0,1,0\n",
       "line 3: expected a number in column 2, found 'x'"},
      {"nan,1,0,0,0,0,0,1,0\n", "expected a number in column 1"},
      {"-1,1,0,0,0,0,0,1,0\n", "line 2: cylinder 1 has a negative radius"},
      {"1,-1,0,0,0,0,0,1,0\n", "the length is negative"},
      {"1,1,0,0,0,0,0,0,0\n", "the axis has no direction"},
      {"1,1,0,0,0,0,0,1,0.5\n", "expected a whole number in column 9"},
      {"1,1,0,0,0,0,0,1,-2\n", "expected a whole number in column 9"},
      {"1,1,0,0,0,0,0,1,1e99\n", "expected a whole number in column 9"},
      {"1,1,0,0,0,0,0,1,2\n", "cylinder 1 is attached to cylinder 2, and there are 1"},
      {"1,1,0,0,0,0,0,1,1\n", "cylinder 1 is among its own ancestors"},
      {"1,1,0,0,0,0,0,1,0\n1,1,0,0,0,0,0,1,3\n1,1,0,0,0,0,0,1,2\n",
       "line 3: cylinder 2 is among its own ancestors"},
      {"1,1e308,0,0,0,1e-320,0,0,0\n1,1e308,1e308,0,0,1,0,0,0\n", "not finite"}};
  for (const auto& [lines, what] : broken)
    EXPECT_THAT(refusalOfQsmTable(names + lines), HasSubstr(what)) << lines;
  EXPECT_THAT(refusalOfQsmTable("x,y,z\n1,2,3\n"), HasSubstr("is no table of cylinders"));
  EXPECT_THAT(refusalOfQsmTable(""), HasSubstr("is no table of cylinders"));
}

TEST(ReadQsmTable, IsChosenByItsColumns) {
  EXPECT_TRUE(isQsmTable(test::treeQsmTable()));
  EXPECT_TRUE(isQsmTable(test::treeQsmTableWithoutNames()));
  EXPECT_FALSE(isQsmTable(test::xyzFile()));
  EXPECT_FALSE(isQsmTable(test::nodeListFile()));
  EXPECT_FALSE(isQsmTable(""));
  EXPECT_FALSE(isQsmTable("1 2 3 4 5 6 7 8 9 10 11 12 13 14\n")); // its axis is too long
  EXPECT_FALSE(isQsmTable("radius,length,parent\n"));             // cylinders that are nowhere
}

TEST(WriteQsmTable, AndReadingGivesTheSamePlant) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Skeleton plant = withAssembledAxes(test::randomPlant(200, seed));
    const Imported<Skeleton> back = importQsmTable(written(plant));
    EXPECT_EQ(test::canonical(back.value), test::canonical(plant));
  }
}

// A stem of two edges, on whose middle node a shoot branches off.
TEST(WriteQsmTable, WritesTheColumnsOfTreeQsm) {
  Skeleton plant = test::stick(3, 2);
  (void)plant.add({{3, 4, 2}, 0.05, NodeId{1}, EdgeType::branching});
  EXPECT_EQ(written(plant),
            "radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension,branch,"
            "BranchOrder,PositionInBranch,added,UnmodRadius,end_x,end_y,end_z,start_radius\n"
            "0.1,2,0,0,0,0,0,1,0,2,1,0,1,0,0.1,0,0,2,0.1\n"
            "0.1,2,0,0,2,0,0,1,1,0,1,0,2,0,0.1,0,0,4,0.1\n"
            "0.05,5,0,0,2,0.6,0.8,0,1,0,2,1,1,0,0.05,3,4,2,0.1\n");
}

TEST(WriteQsmTable, KeepsZeroLengthEdgesSeveralTreesAndNodesAlone) {
  Skeleton plant = test::stick(2, 0);
  const NodeId second = plant.add({{5, 0, 0}, 0.3, std::nullopt});
  (void)plant.add({{5, 0, 1}, 0.2, second});
  (void)plant.add({{7, 0, 1}, 0.4, std::nullopt});
  EXPECT_EQ(test::canonical(importQsmTable(written(plant)).value), test::canonical(plant));
}

TEST(WriteQsmTable, RefusesWhatNoTableCanHold) {
  const auto errorOfWriting = [](const Skeleton& plant) {
    return test::errorOf([&] { return written(plant); });
  };
  Skeleton broken = test::stick(3);
  broken.setPosition(NodeId{1}, {0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_THAT(errorOfWriting(broken), HasSubstr("node 1 has a position or radius"));
}

} // namespace
} // namespace espalier
