#include "tests/support/plants.h"
#include "tests/support/shared_data.h"
#include "ui/document/plant_document.h"
#include "ui/document/project_recorder.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

struct ProjectRecorderTest : testing::Test {
  fs::path file = test::freshFolder() / "fork.espalier";
  PlantDocument document;
  ProjectRecorder recorder{document};
  QStringList messages;

  void SetUp() override {
    QObject::connect(&recorder, &ProjectRecorder::failed, &document,
                     [this](const QString& message) { messages.append(message); });
    document.openSkeleton(test::fork(3), {});
    document.setAuthor("Anna");
    recorder.start(makeProject(document, file));
  }
  void setRadius(double radius, Gesture gesture = {}) {
    document.edit(
        "Radius", [=](SkeletonEditor& editor) { editor.setRadius(test::forkTop, radius); },
        gesture);
  }
  void setRadiusOfRoot() {
    document.edit("Radius", [](SkeletonEditor& editor) {
      editor.setRadius(editor.skeleton().roots().front(), 7);
    });
  }
  [[nodiscard]] History onDisk() const {
    return Project::open(file, Access::readOnly).history().value;
  }
};

TEST_F(ProjectRecorderTest, WritesEveryEditUndoAndRedoAtOnce) {
  setRadius(1);
  EXPECT_EQ(onDisk(), document.history());
  setRadius(2);
  EXPECT_EQ(onDisk(), document.history());
  document.undoStack().undo();
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_EQ(onDisk().position, 1U);
  document.undoStack().redo();
  EXPECT_EQ(onDisk(), document.history());
  document.undoStack().undo();
  setRadius(3);
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_EQ(onDisk().steps.size(), 2U) << "what was undone is dropped by the next edit";
  EXPECT_EQ(onDisk().steps[0].author, "Anna");
  EXPECT_GT(onDisk().steps[0].time, 1'700'000'000'000) << "milliseconds of this century";
}

TEST_F(ProjectRecorderTest, WritesADragAsOneStepOnceItRests) {
  const Gesture drag = Gesture::begin();
  for (int i = 1; i <= 20; ++i)
    setRadius(i, drag);
  EXPECT_EQ(onDisk().steps.size(), 1U) << "its beginning is safe at once";
  recorder.flush();
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_EQ(onDisk().skeleton[test::forkTop].radius, 20);
}

TEST_F(ProjectRecorderTest, ForgetsADragThatWasCanceled) {
  const Gesture drag = Gesture::begin();
  setRadius(4, drag);
  setRadius(5, drag);
  document.cancel(drag);
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_THAT(onDisk().steps, IsEmpty());
}

TEST_F(ProjectRecorderTest, BringsNoEnvelopeBackThatAnEditDroppedJustBefore) {
  recorder.keep("envelope", [this] { return document.envelope(); });
  const auto reopened = [this] {
    const Project project = Project::open(file, Access::readOnly);
    PlantDocument other;
    other.openHistory(project.history().value, nullptr, {});
    other.openEnvelope(project.document("envelope"));
    return other.envelope();
  };
  document.setEnvelope("Envelope", "a sphere");
  recorder.flush();
  EXPECT_EQ(reopened(), "a sphere");
  document.undoStack().undo();
  EXPECT_EQ(reopened(), "");
  setRadius(1); // no pause since
  EXPECT_EQ(reopened(), "");
  document.setEnvelope("Envelope", "a cone");
  EXPECT_EQ(reopened(), "a cone");
}

TEST_F(ProjectRecorderTest, BringsTheHistoryBackIntoAnotherDocument) {
  setRadius(1);
  setRadius(2);
  setRadius(3);
  document.undoStack().undo();
  const History saved = onDisk();
  PlantDocument other;
  other.openHistory(saved, nullptr, {});
  EXPECT_EQ(other.history(), document.history());
  EXPECT_EQ(other.undoStack().undoText(), "Radius");
  other.undoStack().redo();
  EXPECT_EQ(other.skeleton()[test::forkTop].radius, 3);
  for (int i = 0; i < 3; ++i)
    other.undoStack().undo();
  EXPECT_EQ(other.skeleton(), test::fork(3));
  EXPECT_FALSE(other.undoStack().canUndo());
}

TEST_F(ProjectRecorderTest, GoesOnInMemoryWhenTheFileIsGoneAndReportsItOnce) {
  fs::remove(file);
  setRadius(1);
  setRadius(2);
  EXPECT_TRUE(recorder.isBehind());
  ASSERT_EQ(messages.size(), 1);
  EXPECT_THAT(messages[0].toStdString(), HasSubstr("was removed"));
  EXPECT_EQ(document.skeleton()[test::forkTop].radius, 2);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton()[test::forkTop].radius, 1);
}

TEST_F(ProjectRecorderTest, WritesAllThatIsMissingOnceItCanAgain) {
  fs::permissions(file, fs::perms::owner_read);
  setRadius(1);
  setRadius(2);
  EXPECT_TRUE(recorder.isBehind());
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  document.undoStack().undo();
  EXPECT_FALSE(recorder.isBehind());
  EXPECT_EQ(onDisk(), document.history());
}

TEST_F(ProjectRecorderTest, KeepsTheContractedPointsOfTheReconstructionThatIsDone) {
  const auto points = [](int count) {
    return std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, count));
  };
  const auto stored = [this] {
    std::unique_ptr<Project> project = recorder.stop(); // once all is written
    const ContractedPoints contracted = contractedIn(*project);
    recorder.start(std::move(project));
    return std::pair(contracted.positions ? contracted.positions->cols() : 0, contracted.step);
  };
  const StepId first = document.reconstruct("Reconstruct", test::fork(2), points(4));
  EXPECT_EQ(stored(), std::pair(Eigen::Index{4}, first));
  setRadiusOfRoot();
  const StepId second = document.reconstruct("Reconstruct", test::fork(4), points(5));
  EXPECT_EQ(stored(), std::pair(Eigen::Index{5}, second));
  document.undoStack().undo();
  EXPECT_EQ(stored(), std::pair(Eigen::Index{4}, first));
  document.undoStack().setIndex(0);
  EXPECT_EQ(stored(), std::pair(Eigen::Index{0}, StepId{}));
}

// A program may be killed between the writes: the points are then none, never those of another
// step.
TEST_F(ProjectRecorderTest, SaysOfNoContractedPointsThatTheyAreFromAnotherStep) {
  document.reconstruct("Reconstruct", test::fork(2),
                       std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 4)));
  recorder.start(recorder.stop());
  document.reconstruct("Reconstruct", test::fork(4),
                       std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 5)));
  recorder.flush();
  const Project killed = Project::open(file, Access::readOnly);
  const ContractedPoints contracted = contractedIn(killed);
  EXPECT_EQ(contracted.positions->cols(), 4);
  EXPECT_EQ(contracted.step, killed.history().value.steps[0].id);
}

TEST_F(ProjectRecorderTest, ShowsNoContractedPointsBeforeTheStepThatAProjectHasThemFrom) {
  const StepId step = document.reconstruct("Reconstruct", test::fork(2), nullptr);
  PlantDocument other;
  const auto points = std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 4));
  other.openHistory(onDisk(), nullptr, {}, {step, points});
  EXPECT_EQ(other.contracted(), points);
  EXPECT_EQ(other.contractedStep(), step);
  other.undoStack().undo();
  EXPECT_EQ(other.contracted(), nullptr);
  other.undoStack().redo();
  EXPECT_EQ(other.contracted(), points);
}

TEST_F(ProjectRecorderTest, ShowsContractedPointsOnlyWithTheStepThatTheyAreFrom) {
  const auto none = nullptr;
  const StepId first = document.reconstruct("Reconstruct", test::fork(2), none);
  document.reconstruct("Reconstruct", test::fork(4), none);
  const auto points = std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 4));
  PlantDocument other;
  other.openHistory(onDisk(), nullptr, {}, {first, points});
  EXPECT_EQ(other.contracted(), nullptr);
  other.undoStack().undo();
  EXPECT_EQ(other.contracted(), points);
  other.openHistory(onDisk(), nullptr, {}, {StepId{}, points});
  other.undoStack().setIndex(0);
  EXPECT_EQ(other.contracted(), points) << "they were there before the first step";
}

TEST_F(ProjectRecorderTest, KeepsWhichStepIsWhichWhenAHistoryBranchesAfterItWasReopened) {
  setRadius(1);
  setRadius(2);
  document.undoStack().undo();
  auto project = recorder.stop();
  const History saved = project->history().value;
  PlantDocument other;
  other.openHistory(saved, nullptr, {});
  ProjectRecorder next(other);
  next.start(std::move(project));
  other.edit("Other", [](SkeletonEditor& editor) { editor.setRadius(test::forkTop, 5); });
  const History branched = onDisk();
  EXPECT_EQ(branched, other.history());
  ASSERT_EQ(branched.steps.size(), 2U);
  EXPECT_EQ(branched.steps[0], saved.steps[0]);
  EXPECT_NE(branched.steps[1].id, saved.steps[1].id);
  EXPECT_NE(branched.steps[1].id, branched.steps[0].id);
}

TEST_F(ProjectRecorderTest, KeepsUnitAndContractedPoints) {
  document.setUnit(LengthUnit::meter);
  document.setContracted(std::make_shared<Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 4)));
  const std::unique_ptr<Project> project = recorder.stop();
  EXPECT_EQ(project->document("unit"), "m");
  EXPECT_EQ(project->bytes("contracted").size(), 3U * 4U * sizeof(float));
}

// A scan of three points is joined with one of two.
TEST_F(ProjectRecorderTest, WritesAScanThatGrewWithItsStepOnceItCan) {
  const auto scanOf = [](int points) {
    RawPoints raw;
    for (int i = 0; i < points; ++i)
      raw.positions.emplace_back(i, 0, 0);
    return std::make_unique<const Scan>(PointCloud(std::move(raw)));
  };
  const PointSet added = PointSet::of({3, 4});
  document.setScan(scanOf(3), "north.ply");
  recorder.project()->setScan(ScanReference{.path = "/a/north.ply"});
  setRadius(1);
  fs::permissions(file, fs::perms::owner_read);
  recorder.growScan({.scan = {.path = "/a/both.ply", .isByFile = true}, .added = added});
  document.growScan(scanOf(5), "both.ply");
  document.leaveOut("Join", {});
  EXPECT_TRUE(recorder.isBehind());
  EXPECT_EQ(Project::open(file, Access::readOnly).scan()->path, "/a/north.ply");
  EXPECT_EQ(onDisk().steps.size(), 1U);
  EXPECT_TRUE(onDisk().leftOut.isEmpty());
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  setRadius(2);
  EXPECT_FALSE(recorder.isBehind());
  EXPECT_EQ(Project::open(file, Access::readOnly).scan()->path, "/a/both.ply");
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_EQ(beginningOf(onDisk()).leftOut, added);
}

TEST_F(ProjectRecorderTest, WritesWhatIsSetAsideAtOnceAndBringsItBack) {
  document.leaveOut("Set aside", PointSet::of({3, 4, 9}));
  EXPECT_EQ(onDisk(), document.history());
  setRadius(2);
  document.leaveOut("Bring back", PointSet::of({3}));
  document.undoStack().undo();
  EXPECT_EQ(onDisk(), document.history());
  EXPECT_EQ(onDisk().leftOut, PointSet::of({3, 4, 9}));
  PlantDocument other;
  other.openHistory(onDisk(), nullptr, {});
  EXPECT_EQ(other.leftOut(), PointSet::of({3, 4, 9}));
  other.undoStack().redo();
  EXPECT_EQ(other.leftOut(), PointSet::of({3}));
  other.undoStack().setIndex(0);
  EXPECT_TRUE(other.leftOut().isEmpty());
}

} // namespace
} // namespace espalier
