#include "app/window/review/answered_doubts.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

AnsweredDoubt answeredEnd() {
  return {.kind = Doubt::Kind::end,
          .node = NodeId(12),
          .learned = {.kind = Doubt::Kind::end, .said = 0.25, .spacings = 8.5, .wasWrong = true},
          .step = StepId(9'007'199'254'740'993)}; // more digits than a number of JSON holds
}

AnsweredDoubt answeredMissing() {
  return {.kind = Doubt::Kind::missing,
          .node = NodeId(3),
          .tip = {1.5, -2, 0.25},
          .foot = Eigen::Vector3d(0, 0, 0),
          .box = std::array{Eigen::Vector3d(0, -2, 0), Eigen::Vector3d(1.5, 0, 0.25)},
          .learned = {.kind = Doubt::Kind::missing, .said = 0.75, .spacings = 20}};
}

TEST(AnsweredDoubts, ComeBackAsTheyWereKept) {
  AnsweredDoubt ignored = answeredMissing();
  ignored.isIgnored = true;
  const std::vector<AnsweredDoubt> answered = {answeredEnd(), answeredMissing(), ignored};
  EXPECT_EQ(answeredFrom(textOf(answered)), answered);
  EXPECT_EQ(textOf(std::vector<AnsweredDoubt>()), "");
  EXPECT_TRUE(answeredFrom("").empty());
}

TEST(AnsweredDoubts, AreRefusedWhereTheyCannotBeRead) {
  for (const char* text :
       {"{}", "[1]", "nonsense",
        R"([{"kind": "end", "node": 1, "said": 2, "spacings": 1, "step": "0"}])",
        R"([{"kind": "end", "node": -1, "said": 0.5, "spacings": 1, "step": "0"}])",
        R"([{"kind": "end", "node": 1, "said": 0.5, "spacings": 1, "step": 5}])",
        R"([{"kind": "twig", "node": 1, "said": 0.5, "spacings": 1, "step": "0"}])",
        R"([{"kind": "missing", "node": 1, "said": 0.5, "spacings": 1, "step": "0", "tip": [1]}])",
        R"([{"kind": "missing", "node": 1, "said": 0.5, "spacings": 1, "step": "0",
             "tip": [1, 2, 3], "foot": [1]}])",
        R"([{"kind": "missing", "node": 1, "said": 0.5, "spacings": 1, "step": "0",
             "tip": [1, 2, 3], "foot": [1, 2, 3], "box": [[1, 2, 3]]}])"})
    EXPECT_THROW((void)answeredFrom(text), Error) << text;
}

TEST(AnsweredDoubts, AreAboutTheSameWoodWhateverWasDoubtedOfIt) {
  const Doubt attachment{.kind = Doubt::Kind::attachment, .node = NodeId(12)};
  EXPECT_TRUE(isAbout(answeredEnd(), attachment, 0));
  EXPECT_FALSE(isAbout(answeredEnd(), {.kind = Doubt::Kind::end, .node = NodeId(13)}, 0));
  Doubt missing{.kind = Doubt::Kind::missing, .node = NodeId(12)};
  EXPECT_FALSE(isAbout(answeredEnd(), missing, 1));
  GrownBranch branch{.on = NodeId(12), .part = {}};
  const NodeId root = branch.part.add({.position = {0, 0, 0}});
  branch.part.add({.position = {1.5, -2, 0.2}, .parent = root});
  missing.alternatives = {{.kind = Alternative::Kind::add, .branch = branch}};
  EXPECT_TRUE(isAbout(answeredMissing(), missing, 0.1));
  EXPECT_FALSE(isAbout(answeredMissing(), missing, 0.01));
  GrownBranch other{.on = NodeId(7), .part = {}}; // to the same tip, from elsewhere
  other.part.add({.position = {1.5, -2, 0.2}, .parent = other.part.add({.position = {3, 0, 0}})});
  missing.alternatives = {{.kind = Alternative::Kind::add, .branch = other}};
  EXPECT_FALSE(isAbout(answeredMissing(), missing, 0.1));
  AnsweredDoubt older = answeredMissing(); // of a project of before
  older.foot.reset();
  older.box.reset();
  EXPECT_TRUE(isAbout(older, missing, 0.1));
  EXPECT_EQ(answeredFrom(textOf(std::vector{older})), std::vector{older});
}

TEST(AnsweredDoubts, ThatNoBranchIsThereAreAboutTheFindingOfItsPoints) {
  AnsweredDoubt answered = answeredMissing(); // its box is 2.51 wide
  EXPECT_TRUE(leavesOut(answered));
  const Finding points{
      .kind = Finding::Kind::unexplainedPoints, .place = {0.2, -1.8, 0.2}, .reach = 1.3};
  EXPECT_TRUE(isAbout(answered, points, 0.1)) << "it may be bent";
  Finding beside = points;
  beside.place.z() = 0.5;
  EXPECT_FALSE(isAbout(answered, beside, 0.1));
  EXPECT_TRUE(isAbout(answered, beside, 0.3));
  Finding larger = points;
  larger.reach = 3;
  EXPECT_FALSE(isAbout(answered, larger, 0.1)) << "more than that branch has no wood";
  Finding turn = points;
  turn.kind = Finding::Kind::sharpTurn;
  EXPECT_FALSE(isAbout(answered, turn, 1));
  AnsweredDoubt older = answered; // of a project of before
  older.box.reset();
  EXPECT_FALSE(isAbout(older, points, 0.1));
  answered.learned.wasWrong = true; // there is a branch
  EXPECT_FALSE(leavesOut(answered));
  answered.isIgnored = true;
  EXPECT_TRUE(leavesOut(answered));
  EXPECT_FALSE(leavesOut(answeredEnd()));
}

} // namespace
} // namespace espalier
