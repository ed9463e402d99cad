#include "core/io/structures/node_list.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::HasSubstr;

Skeleton importNodeList(const std::string& text) {
  std::istringstream in(text);
  return readNodeList(in, "oak.txt").value;
}

std::string refusalOfNodeList(const std::string& text) {
  return test::errorOf([&] { return importNodeList(text); });
}

TEST(ReadNodeList, TakesWhatPlantScan3DExports) {
  const std::string text = "# automatically exported mtg\n"
                           "# vid parentid edgetype XX YY ZZ Radius\n3\n"
                           "2\t\t/\t1.5\t0\t-1\t0.25\n4\t3\t+\t3\t3\t3\t\n3\t2\t<\t2\t2\t2\tNone\n";
  EXPECT_TRUE(isNodeList(text));
  const Skeleton plant = importNodeList(text);
  ASSERT_EQ(plant.size(), 3U);
  EXPECT_EQ(plant[NodeId{0}], (Node{.position = {1.5, 0, -1}, .radius = 0.25}));
  EXPECT_EQ(plant[NodeId{1}], (Node{.position = {2, 2, 2}, .parent = NodeId{0}}));
  EXPECT_EQ(plant[NodeId{2}],
            (Node{.position = {3, 3, 3}, .parent = NodeId{1}, .edge = EdgeType::branching}));
}

TEST(ReadNodeList, NamesTheLineThatIsWrong) {
  const std::string header = "# vid parentid edgetype XX YY ZZ Radius\n";
  EXPECT_THAT(refusalOfNodeList(header), HasSubstr("holds no nodes"));
  EXPECT_THAT(refusalOfNodeList(header + "1\t\t/\t1\t2\n"),
              HasSubstr("oak.txt, line 2: expected 7 fields"));
  EXPECT_THAT(refusalOfNodeList(header + "1\t\t/\t1\t2\tz\t\n"),
              HasSubstr("line 2: expected a number as ZZ"));
  EXPECT_THAT(refusalOfNodeList(header + "1\t\t/\t1\t2\tnan\t\n"),
              HasSubstr("line 2: expected a number"));
  EXPECT_THAT(refusalOfNodeList(header + "1\t\t/\t1\t2\t3\t-1.5\n"),
              HasSubstr("radius is negative"));
  EXPECT_THAT(refusalOfNodeList(header + "\t\t/\t1\t2\t3\t\n"), HasSubstr("line 2: "));
  EXPECT_THAT(refusalOfNodeList(header + "1\t\t/\t1\t2\t3\t\n1\t\t/\t1\t2\t3\t\n"),
              HasSubstr("line 3: the id '1' occurs twice"));
  EXPECT_THAT(refusalOfNodeList(header + "1\t7\t<\t1\t2\t3\t\n"),
              HasSubstr("line 2: the parent '7'"));
  EXPECT_THAT(
      refusalOfNodeList(header + "1\t\t/\t0\t0\t0\t\n2\t3\t<\t1\t2\t3\t\n3\t2\t<\t1\t2\t3\t\n"),
      HasSubstr("line 3: the node is among its own ancestors"));
}

TEST(WriteNodeList, AndReadingGivesTheSamePlant) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Skeleton plant = test::randomPlant(200, seed);
    std::ostringstream out;
    writeNodeList(out, plant);
    EXPECT_TRUE(isNodeList(out.str()));
    EXPECT_EQ(test::canonical(importNodeList(out.str())), test::canonical(plant));
  }
}

} // namespace
} // namespace espalier
