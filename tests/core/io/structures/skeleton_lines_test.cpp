#include "core/io/formats.h"
#include "core/io/points/ply.h"
#include "core/io/structures/skeleton_lines.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <sstream>

namespace espalier {
namespace {

/// A node at (0, 0, 0) of radius 0.5, on it one at (0, 0, 1), and one at (1, 0, 0) that branches
/// off; a single node beside them.
Skeleton plant() {
  Skeleton skeleton;
  const NodeId root = skeleton.add({.radius = 0.5});
  skeleton.add({.position = {0, 0, 1}, .parent = root});
  skeleton.add({.position = {1, 0, 0}, .parent = root, .edge = EdgeType::branching});
  skeleton.add({.position = {5, 5, 5.25}});
  return skeleton;
}

template <class Write> std::string writtenLines(const Write& write) {
  std::ostringstream out;
  write(out, plant());
  return out.str();
}

TEST(WriteObjLines, WritesAVertexPerNodeAndALinePerEdge) {
  EXPECT_EQ(writtenLines(writeObjLines), "# exported by Espalier\n"
                                         "v 0 0 0\nv 5 5 5.25\nv 0 0 1\nv 1 0 0\n"
                                         "l 1 3\nl 1 4\n");
}

TEST(WritePlyLines, WritesVerticesWithRadiiAndEdges) {
  const std::string text = writtenLines(writePlyLines);
  EXPECT_TRUE(isPly(text));
  EXPECT_EQ(text.substr(text.find("element edge")),
            "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty uchar branching\n"
            "end_header\n0 0 0 0.5\n5 5 5.25 0\n0 0 1 0\n1 0 0 0\n0 2 0\n0 3 1\n");
}

TEST(WritePlyLines, CanBeReadAsPoints) {
  std::istringstream in(writtenLines(writePlyLines));
  const RawPoints points = readPly(in, "lines.ply").value;
  ASSERT_EQ(points.positions.size(), 4U);
  EXPECT_EQ(points.positions[1], Eigen::Vector3d(5, 5, 5.25));
}

TEST(FormatsOfLines, AreWrittenByTheirExtensions) {
  EXPECT_EQ(formatToWrite("a.lines.obj", Content::structure).name, "OBJ lines");
  EXPECT_EQ(formatToWrite("a.lines.ply", Content::structure).name, "PLY lines");
  EXPECT_EQ(formatToWrite("a.lines.ply", Content::points).name, "PLY");
}

} // namespace
} // namespace espalier
