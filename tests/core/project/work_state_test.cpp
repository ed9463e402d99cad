#include "core/project/work_state.h"
#include "core/skeleton/edits.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <functional>

namespace espalier {
namespace {

constexpr std::int64_t oneMinute = 60'000; // [ms]

struct WorkStateTest : testing::Test {
  std::filesystem::path file = test::freshFolder() / "plant.espalier";
  History history;

  void step(std::int64_t time, const std::function<void(SkeletonEditor&)>& change,
            bool isRun = false) {
    SkeletonEditor editor(history.skeleton);
    change(editor);
    history.steps.push_back({.text = "Edit",
                             .author = "Anna",
                             .time = time,
                             .delta = editor.commit(),
                             .replacesContracted = isRun});
    ++history.position;
  }
  void reconstruct() {
    step(
        0, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::fork(3)); }, true);
  }
  void reviewAll(std::int64_t time) {
    step(time, [](SkeletonEditor& editor) {
      for (const NodeId id : editor.skeleton().ids())
        editor.setReview(id, {.state = ReviewState::reviewed, .reviewer = "Anna"});
    });
  }
  /// As another program reads it.
  [[nodiscard]] WorkState state(const std::string& seal = {}, const std::string& findings = {}) {
    {
      Project project = Project::create(file, history);
      project.setDocument("seal", seal);
      project.setDocument(openFindingsName, findings);
    }
    const Project project = Project::open(file, Access::readOnly);
    return workState(project, project.lastWork().value);
  }
};

TEST_F(WorkStateTest, IsToDoWithoutASkeleton) {
  EXPECT_EQ(state().stage, WorkStage::toDo);
  EXPECT_EQ(state().openFindings, std::nullopt) << "nothing is known of them";
}

TEST_F(WorkStateTest, IsAutomaticUntilAHandEditsOrMarks) {
  reconstruct();
  WorkState now = state();
  EXPECT_EQ(now.stage, WorkStage::automatic);
  EXPECT_EQ(now.nodes, 5U);
  EXPECT_EQ(now.time, 0);
  step(2 * oneMinute, [&](SkeletonEditor& editor) {
    editor.setReview(editor.skeleton().roots().front(), {.state = ReviewState::doubtful});
  });
  now = state();
  EXPECT_EQ(now.stage, WorkStage::inReview);
  EXPECT_EQ(now.time, 2 * oneMinute);
  history.skeleton = {};
  history.steps.clear();
  history.position = 0;
  reconstruct();
  step(oneMinute,
       [&](SkeletonEditor& editor) { editor.setRadius(editor.skeleton().roots().front(), 0.5); });
  EXPECT_EQ(state().stage, WorkStage::inReview);
}

TEST_F(WorkStateTest, IsOfWhoMadeMostOfTheSteps) {
  EXPECT_EQ(state().annotator, "");
  reconstruct();
  const auto work = [this] {
    step(oneMinute, [](SkeletonEditor& editor) {
      const NodeId root = editor.skeleton().roots().front();
      editor.setRadius(root, editor.skeleton()[root].radius + 0.1);
    });
  };
  work();
  work();
  history.steps.back().author = "Berta";
  EXPECT_EQ(state().annotator, "Anna") << "two of three steps";
  work();
  history.steps.back().author = "Berta";
  EXPECT_EQ(state().annotator, "Berta") << "of two who made as many, who came last";
}

TEST_F(WorkStateTest, ARemarkIsAMarkOfTheReview) {
  history.skeleton = test::fork(3);
  EXPECT_EQ(state().stage, WorkStage::automatic) << "it was opened";
  history.skeleton.setReview(history.skeleton.roots().front(), {.comment = "thin"});
  EXPECT_EQ(state().stage, WorkStage::inReview);
}

TEST_F(WorkStateTest, IsSignedWhileTheSealHolds) {
  reconstruct();
  reviewAll(3 * oneMinute);
  const std::string seal = textOf(signedBy("Berta", 5, history));
  WorkState now = state(seal);
  EXPECT_EQ(now.stage, WorkStage::finished);
  EXPECT_EQ(now.annotator, "Berta");
  step(4 * oneMinute,
       [&](SkeletonEditor& editor) { editor.setRadius(editor.skeleton().roots().front(), 0.5); });
  now = state(seal);
  EXPECT_EQ(now.stage, WorkStage::inReview);
  EXPECT_EQ(now.annotator, "Anna");
  ASSERT_TRUE(now.seal) << "it is broken, not lost";
  EXPECT_EQ(state("no seal").stage, WorkStage::inReview);
  EXPECT_EQ(state("no seal").seal, std::nullopt);
}

TEST_F(WorkStateTest, KnowsTheFindingsThatWereOpenLast) {
  reconstruct();
  EXPECT_EQ(state({}, "12").openFindings, 12U);
  EXPECT_EQ(state({}, "0").openFindings, 0U);
  EXPECT_EQ(state({}, "-1").openFindings, std::nullopt);
  EXPECT_EQ(state({}, "many").openFindings, std::nullopt);
  reviewAll(0);
  const std::string seal =
      textOf(signedBy("Berta", 5, history, SealedState{.findings = {{"bare_twig", 2}}}));
  EXPECT_EQ(state(seal, "12").openFindings, 2U) << "as it was signed";
  step(1,
       [&](SkeletonEditor& editor) { editor.setRadius(editor.skeleton().roots().front(), 0.5); });
  EXPECT_EQ(state(seal, "12").openFindings, 12U) << "the seal is broken";
}

} // namespace
} // namespace espalier
