#include "core/base/error.h"
#include "tests/support/plants.h"
#include "ui/document/plant_document.h"
#include "ui/panels/node_filter.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;
using testing::IsEmpty;

struct NodeFilterTest : testing::Test {
  PlantDocument document;
  NodeFacts facts{document};
  std::vector<NodeId> shoots;

  void SetUp() override {
    document.openSkeleton(test::fork(3), "fork.mtg");
    shoots = document.skeleton().children(forkTop);
    document.edit("Describe", [&](SkeletonEditor& editor) {
      editor.setRadius(shoots[1], 12.5);
      editor.setEntities(shoots[2], {{.scale = 1, .symbol = "Leaf", .index = 7}});
      editor.setReview(forkRoot, {ReviewState::doubtful, "is it, really?", "Ada"});
      editor.setMarked(forkTop, true);
    });
    facts.update();
  }
  std::vector<NodeId> found(const QString& text) {
    const NodeFilter filter(text);
    std::vector<NodeId> nodes = document.skeleton().ids();
    std::erase_if(nodes, [&](NodeId id) { return !filter.accepts(facts, id); });
    return nodes;
  }
  std::string errorOf(const QString& text) {
    try {
      NodeFilter filter(text);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(NodeFilterTest, TakesAllWithoutAText) {
  EXPECT_EQ(found("").size(), 5U);
  EXPECT_EQ(found("  , ").size(), 5U);
}

TEST_F(NodeFilterTest, ComparesNumbers) {
  EXPECT_THAT(found("radius > 10"), ElementsAre(shoots[1]));
  EXPECT_THAT(found("RADIUS>=12.5"), ElementsAre(shoots[1]));
  EXPECT_THAT(found("radius > 12.5"), IsEmpty());
  EXPECT_EQ(found("radius <= 0.1").size(), 4U);
  EXPECT_EQ(found("radius != 12.5").size(), 4U);
  EXPECT_THAT(found("z = 1"), ElementsAre(forkTop));
  EXPECT_THAT(found("z < 1e-3"), ElementsAre(forkRoot));
}

TEST_F(NodeFilterTest, ComparesTexts) {
  EXPECT_EQ(found("edge = +").size(), 2U);
  EXPECT_THAT(found("edge = <"), ElementsAre(forkTop, shoots[0]));
  EXPECT_THAT(found("review = doubtful"), ElementsAre(forkRoot));
  EXPECT_THAT(found("class = leaf"), ElementsAre(shoots[2]));
  EXPECT_EQ(found("class != Leaf").size(), 4U);
}

TEST_F(NodeFilterTest, LeavesOutWhatHasNoSuchNumber) {
  EXPECT_EQ(found("parent >= 0").size(), 4U) << "a root has none";
  EXPECT_EQ(found("length < 100").size(), 4U);
  EXPECT_EQ(found("parent != 1").size(), 2U) << "none is not 1";
}

TEST_F(NodeFilterTest, JoinsConditions) {
  EXPECT_THAT(found("order = 1 and radius > 10"), ElementsAre(shoots[1]));
  EXPECT_THAT(found("order = 1, radius < 10"), ElementsAre(shoots[2]));
}

TEST_F(NodeFilterTest, FindsATextWhereverItIsWritten) {
  EXPECT_THAT(found("leaf7"), ElementsAre(shoots[2]));
  EXPECT_THAT(found("unit start"), ElementsAre(forkTop));
  EXPECT_THAT(found("really?"), ElementsAre(forkRoot));
  EXPECT_THAT(found("1"), ElementsAre(forkTop)) << "the number of a node is the whole number";
  EXPECT_THAT(found("nonsense"), IsEmpty());
}

TEST_F(NodeFilterTest, SaysWhatIsWrong) {
  EXPECT_THAT(errorOf("girth > 3"), testing::HasSubstr("no column “girth”"));
  EXPECT_THAT(errorOf("radius >"), testing::HasSubstr("compared with a number"));
  EXPECT_THAT(errorOf("radius > 3 mm"), testing::HasSubstr("compared with a number"));
  EXPECT_THAT(errorOf("review > doubtful"), testing::HasSubstr("= or !="));
}

} // namespace
} // namespace espalier
