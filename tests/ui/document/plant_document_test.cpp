#include "core/base/error.h"
#include "core/cloud/file_order.h"
#include "core/skeleton/edits.h"
#include "tests/support/plants.h"
#include "ui/document/plant_document.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

void moveTo(PlantDocument& document, double height, Gesture gesture = {}) {
  document.edit(
      "Move node 2",
      [=](SkeletonEditor& editor) {
        moveNode(editor, NodeId{2}, {0, 0, height});
      },
      gesture);
}

double height(const PlantDocument& document) {
  return document.skeleton()[NodeId{2}].position.z();
}

struct PlantDocumentTest : testing::Test {
  PlantDocument document;
  void SetUp() override { document.openSkeleton(test::stick(3), "stick.mtg"); }
};

TEST_F(PlantDocumentTest, TakesAnEditBackAndMakesItAgain) {
  moveTo(document, 5);
  EXPECT_EQ(document.undoStack().undoText(), "Move node 2");
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::stick(3));
  document.undoStack().redo();
  EXPECT_EQ(height(document), 5);
}

TEST_F(PlantDocumentTest, MakesNoStepOfAnEditThatChangesNothing) {
  moveTo(document, 2); // where it is
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_FALSE(document.isModified());
}

TEST_F(PlantDocumentTest, KnowsNoScaleWithoutAScan) {
  EXPECT_EQ(document.scale().spacing, 0);
  EXPECT_EQ(document.scale().height, 0);
}

TEST_F(PlantDocumentTest, MakesOneStepOfADrag) {
  const Gesture drag = Gesture::begin();
  for (const double z : {3.0, 4.0, 5.0})
    moveTo(document, z, drag);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::stick(3));
  document.undoStack().redo();
  EXPECT_EQ(height(document), 5);
}

TEST_F(PlantDocumentTest, KeepsTwoDragsApart) {
  moveTo(document, 3, Gesture::begin());
  moveTo(document, 4, Gesture::begin());
  EXPECT_EQ(document.undoStack().count(), 2);
}

TEST_F(PlantDocumentTest, MakesNoStepOfADragThatComesBack) {
  const Gesture drag = Gesture::begin();
  moveTo(document, 3, drag);
  moveTo(document, 2, drag);
  EXPECT_EQ(document.undoStack().count(), 0);
  moveTo(document, 4, drag);
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(PlantDocumentTest, ForgetsACanceledDrag) {
  moveTo(document, 9);
  const Gesture drag = Gesture::begin();
  for (const double z : {3.0, 4.0})
    moveTo(document, z, drag);
  document.cancel(drag);
  EXPECT_EQ(height(document), 9);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_FALSE(document.undoStack().canRedo());
}

TEST_F(PlantDocumentTest, CancelsNothingForADragWithoutEdits) {
  moveTo(document, 9, Gesture::begin());
  document.cancel(Gesture::begin());
  document.cancel({});
  EXPECT_EQ(height(document), 9);
}

TEST_F(PlantDocumentTest, TakesBackAnEditThatThrows) {
  const auto refused = [](SkeletonEditor& editor) {
    moveNode(editor, NodeId{2}, {1, 1, 1});
    reparentNode(editor, NodeId{0}, NodeId{2});
  };
  EXPECT_THROW(document.edit("Reparent", refused), Error);
  EXPECT_EQ(document.skeleton(), test::stick(3));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(PlantDocumentTest, ReportsTheDeltaOfEveryEditUndoAndRedo) {
  std::vector<SkeletonDelta> deltas;
  QObject::connect(&document, &PlantDocument::skeletonEdited,
                   [&](const SkeletonDelta& delta) { deltas.push_back(delta); });
  moveTo(document, 5);
  document.undoStack().undo();
  document.undoStack().redo();
  ASSERT_EQ(deltas.size(), 3U);
  EXPECT_EQ(deltas[0].changes.at(0).id, NodeId{2});
  EXPECT_EQ(deltas[1], deltas[0].inverse());
  EXPECT_EQ(deltas[2], deltas[0]);
}

TEST_F(PlantDocumentTest, IsModifiedFromAnEditUntilItIsSavedOrUndone) {
  const QSignalSpy titles(&document, &PlantDocument::titleChanged);
  moveTo(document, 5);
  EXPECT_TRUE(document.isModified());
  document.markSaved("other.mtg");
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.filePath(), "other.mtg");
  document.undoStack().undo();
  EXPECT_TRUE(document.isModified()) << "the file has the other state";
  EXPECT_GE(titles.size(), 3);
}

TEST_F(PlantDocumentTest, NeverMergesADragIntoASavedState) {
  const Gesture drag = Gesture::begin();
  moveTo(document, 3, drag);
  document.markSaved("stick.mtg");
  moveTo(document, 4, drag);
  EXPECT_TRUE(document.isModified());
  document.undoStack().undo();
  EXPECT_EQ(height(document), 3);
  EXPECT_FALSE(document.isModified());
}

TEST_F(PlantDocumentTest, DropsRemovedNodesFromTheSelection) {
  document.selection().set({NodeId{1}, NodeId{2}});
  document.edit("Remove", [](SkeletonEditor& editor) { removeNode(editor, NodeId{2}); });
  EXPECT_THAT(document.selection().nodes(), testing::ElementsAre(NodeId{1}));
}

TEST_F(PlantDocumentTest, OpensAPlantWithoutHistory) {
  moveTo(document, 5);
  document.selection().set({NodeId{2}});
  document.openSkeleton(test::fork(2), "fork.mtg");
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_FALSE(document.isModified());
  EXPECT_TRUE(document.selection().isEmpty());
  EXPECT_EQ(document.filePath(), "fork.mtg");
}

TEST_F(PlantDocumentTest, ContractsThePointsAndKeepsTheSkeleton) {
  const auto contracted = std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 2));
  document.openSkeleton(test::fork(2), {});
  document.contract("Contract", contracted);
  EXPECT_EQ(document.contracted(), contracted);
  EXPECT_EQ(document.skeleton(), test::fork(2));
  EXPECT_EQ(document.undoStack().text(0), "Contract");
  document.undoStack().undo();
  EXPECT_EQ(document.contracted(), nullptr);
  document.undoStack().redo();
  EXPECT_EQ(document.contracted(), contracted);
  EXPECT_EQ(document.skeleton(), test::fork(2));
  document.setReadOnly("a copy");
  EXPECT_THROW(document.contract("Contract", nullptr), Error);
}

TEST_F(PlantDocumentTest, ShowsTheContractedPointsOfTheReconstructionThatIsDone) {
  const auto first = std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Zero(3, 2));
  const auto second = std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Ones(3, 2));
  EXPECT_EQ(document.contractedStep(), StepId{});
  document.reconstruct("Reconstruct", test::fork(2), first);
  const Skeleton before = document.skeleton();
  document.edit("Thicken", [&](SkeletonEditor& editor) {
    editor.setRadius(editor.skeleton().roots().front(), 1);
  });
  const StepId last = document.reconstruct("Reconstruct", test::fork(4), second);
  EXPECT_EQ(document.contracted(), second);
  EXPECT_EQ(document.contractedStep(), last);
  document.undoStack().undo();
  EXPECT_EQ(document.contracted(), first) << "the same, not a copy";
  document.undoStack().undo();
  EXPECT_EQ(document.contracted(), first);
  EXPECT_EQ(document.skeleton(), before);
  document.undoStack().undo();
  EXPECT_EQ(document.contracted(), nullptr);
  EXPECT_EQ(document.contractedStep(), StepId{});
  while (document.undoStack().canRedo())
    document.undoStack().redo();
  EXPECT_EQ(document.contracted(), second);
}

TEST_F(PlantDocumentTest, GivesEachStepAnIdThatUndoAndRedoKeep) {
  document.openSkeleton(test::fork(2), {});
  const auto setRadius = [this](double radius, Gesture gesture = {}) {
    document.edit(
        "Radius", [=](SkeletonEditor& editor) { editor.setRadius(test::forkTop, radius); },
        gesture);
    return document.step(document.undoStack().index() - 1).id;
  };
  const StepId first = setRadius(1);
  const StepId second = setRadius(2);
  EXPECT_NE(first, StepId{});
  EXPECT_NE(first, second);
  document.undoStack().undo();
  EXPECT_TRUE(document.isDone(first));
  EXPECT_FALSE(document.isDone(second));
  document.undoStack().redo();
  EXPECT_EQ(document.step(1).id, second);
  document.undoStack().undo();
  const StepId branch = setRadius(2);
  EXPECT_NE(branch, second) << "another step, though it does the same at the same place";
  const Gesture drag = Gesture::begin();
  const StepId begun = setRadius(3, drag);
  EXPECT_NE(setRadius(4, drag), begun) << "what a step does never changes";
  EXPECT_EQ(document.undoStack().count(), 3);
}

TEST_F(PlantDocumentTest, DropsContractedPointsWithTheirScan) {
  RawPoints raw;
  raw.positions = {{0, 0, 0}, {0, 0, 1}};
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  document.setContracted(std::make_shared<Eigen::Matrix3Xf>(3, 2));
  document.setScan(std::make_unique<Scan>(PointCloud(raw)), "other.ply");
  EXPECT_EQ(document.contracted(), nullptr);
}

TEST_F(PlantDocumentTest, IsEmptyOnceCleared) {
  moveTo(document, 5);
  document.setUnit(LengthUnit::meter);
  document.clear();
  EXPECT_TRUE(document.isEmpty());
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.filePath(), "");
  EXPECT_EQ(document.unit(), LengthUnit::unknown);
}

TEST(PlantDocument, IsDestroyedWithHistory) {
  PlantDocument document;
  document.openSkeleton(test::stick(3), "stick.mtg");
  moveTo(document, 5);
}

/// Ten points in a row.
std::unique_ptr<const Scan> rowOfPoints() {
  RawPoints raw;
  for (int i = 0; i < 10; ++i)
    raw.positions.emplace_back(i, 0, 0);
  return std::make_unique<const Scan>(PointCloud(std::move(raw)));
}

TEST_F(PlantDocumentTest, SetsPointsAsideAsAStep) {
  document.setScan(rowOfPoints(), "row.xyz");
  const QSignalSpy changed(&document, &PlantDocument::leftOutChanged);
  const PointSet some = PointSet::of({1, 2, 7});
  document.pointSelection().set(PointSet::of({2, 3}));
  document.leaveOut("Set 3 points aside", some);
  EXPECT_EQ(document.leftOut(), some);
  EXPECT_EQ(document.scan()->leftOut(), some);
  EXPECT_EQ(document.pointSelection().points(), PointSet::of({3})) << "what takes part";
  EXPECT_EQ(document.history().leftOut, some);
  EXPECT_EQ(document.skeleton(), test::stick(3));
  document.undoStack().undo();
  EXPECT_TRUE(document.leftOut().isEmpty());
  EXPECT_TRUE(document.scan()->leftOut().isEmpty());
  document.undoStack().redo();
  EXPECT_EQ(document.scan()->leftOut(), some);
  EXPECT_EQ(changed.size(), 3);
  document.leaveOut("Again", some);
  EXPECT_EQ(document.undoStack().count(), 1) << "nothing changed: no step";
}

TEST_F(PlantDocumentTest, SetsOrgansAsSteps) {
  document.setScan(rowOfPoints(), "row.xyz");
  const QSignalSpy changed(&document, &PlantDocument::organsChanged);
  document.setOrgans("Blades", PointSet::of({1, 2, 7}), Organ::blade);
  document.setOrgans("Wood", PointSet::of({2}), Organ::wood);
  EXPECT_EQ(document.organs().of(Organ::blade), PointSet::of({1, 7}));
  EXPECT_EQ(document.organs().of(Organ::wood), PointSet::of({2}));
  document.setOrgans("Again", PointSet::of({2}), Organ::wood);
  document.setOrgans("Nothing", PointSet::of({5}), std::nullopt);
  EXPECT_EQ(document.undoStack().count(), 2) << "nothing changed: no step";
  EXPECT_EQ(changed.size(), 2);
  document.undoStack().undo();
  EXPECT_EQ(document.organs().of(Organ::blade), PointSet::of({1, 2, 7}));
  document.undoStack().redo();
  EXPECT_EQ(document.organs().of(Organ::wood), PointSet::of({2}));
  EXPECT_EQ(changed.size(), 4);
  document.goTo(0);
  EXPECT_TRUE(document.organs().isEmpty());
  EXPECT_EQ(changed.size(), 5) << "several steps are one change";
  document.goTo(2);
  document.setOrgans("As found", PointSet::of({1, 2, 7}), std::nullopt);
  EXPECT_TRUE(document.organs().isEmpty());
}

TEST_F(PlantDocumentTest, OpensTheOrgansThatItsStepsLeadTo) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.setOrgans("Blades", PointSet::of({1, 2}), Organ::blade);
  document.setOrgans("Needles", PointSet::of({2, 3}), Organ::needle);
  document.undoStack().undo();
  PlantDocument opened;
  opened.openHistory(document.history(), nullptr, {});
  EXPECT_EQ(opened.organs(), document.organs());
  opened.undoStack().redo();
  EXPECT_EQ(opened.organs().of(Organ::needle), PointSet::of({2, 3}));
  opened.goTo(0);
  EXPECT_TRUE(opened.organs().isEmpty());
}

TEST_F(PlantDocumentTest, ForgetsOrgansWhenAnotherScanComes) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.setOrgans("Blades", PointSet::of({1, 2}), Organ::blade);
  document.setFoundScan(rowOfPoints(), "elsewhere/row.xyz");
  EXPECT_EQ(document.organs().of(Organ::blade), PointSet::of({1, 2}));
  document.setScan(rowOfPoints(), "other.xyz");
  EXPECT_TRUE(document.organs().isEmpty());
  document.undoStack().setIndex(0);
  document.undoStack().setIndex(document.undoStack().count());
  EXPECT_TRUE(document.organs().isEmpty()) << "no step is of points of another scan";
  document.setReadOnly("read-only");
  EXPECT_THROW(document.setOrgans("Blades", PointSet::of({1}), Organ::blade), Error);
}

TEST_F(PlantDocumentTest, MixesStepsOfPointsAndOfNodes) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.leaveOut("One", PointSet::of({1}));
  moveTo(document, 5);
  document.leaveOut("Two", PointSet::of({2}));
  document.undoStack().setIndex(2);
  EXPECT_EQ(document.leftOut(), PointSet::of({1}));
  EXPECT_EQ(height(document), 5);
  document.undoStack().setIndex(0);
  EXPECT_TRUE(document.leftOut().isEmpty());
  EXPECT_EQ(document.skeleton(), test::stick(3));
  document.undoStack().setIndex(3);
  EXPECT_EQ(document.leftOut(), PointSet::of({2}));
}

TEST_F(PlantDocumentTest, KeepsWhatWasSetAsideUntilAnotherScanComes) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.leaveOut("One", PointSet::of({1}));
  moveTo(document, 5);
  document.setFoundScan(rowOfPoints(), "elsewhere/row.xyz");
  EXPECT_EQ(document.scan()->leftOut(), PointSet::of({1}));
  document.setScan(rowOfPoints(), "other.xyz");
  EXPECT_TRUE(document.leftOut().isEmpty());
  for (int index : {0, 2})
    document.undoStack().setIndex(index);
  EXPECT_TRUE(document.leftOut().isEmpty()) << "no step sets points of another scan aside";
  EXPECT_EQ(height(document), 5);
}

// A scan that lists the points of the one before first, and others behind them.
TEST_F(PlantDocumentTest, GrowsItsScanByPointsThatAreSetAsideInAllSteps) {
  document.setScan(rowOfPoints(), "row.xyz");
  const Eigen::Index points = document.scan()->cloud()->size();
  document.leaveOut("One", PointSet::of({1}));
  document.contract("Contract", std::make_shared<const Eigen::Matrix3Xf>(
                                    document.scan()->cloud()->positions() * 0.5F));
  const Eigen::Vector3d contracted =
      document.contracted()->col(2).cast<double>() + document.scan()->cloud()->origin();
  RawPoints raw;
  for (Eigen::Index i = 0; i < points; ++i)
    raw.positions.push_back(document.scan()->cloud()->position(i));
  for (int i = 0; i < 5; ++i)
    raw.positions.emplace_back(100 + i, 0, 0);
  document.growScan(std::make_unique<const Scan>(sortedAsInFile(PointCloud(std::move(raw)))),
                    "both.ply");
  const PointSet added = PointSet::firstOf(points + 5) - PointSet::firstOf(points);
  EXPECT_EQ(document.leftOut(), PointSet::of({1}) | added);
  EXPECT_EQ(document.scan()->leftOut(), document.leftOut());
  ASSERT_EQ(document.contracted()->cols(), points + 5);
  const Eigen::Vector3d now =
      document.contracted()->col(2).cast<double>() + document.scan()->cloud()->origin();
  EXPECT_LT((now - contracted).norm(), 1e-4);
  document.undoStack().setIndex(0);
  EXPECT_EQ(document.leftOut(), added);
  EXPECT_EQ(document.contracted(), nullptr);
  document.undoStack().setIndex(2);
  EXPECT_EQ(document.contracted()->cols(), points + 5);
}

TEST_F(PlantDocumentTest, TakesAnEnvelopeBackAndMakesItAgain) {
  int changes = 0;
  QObject::connect(&document, &PlantDocument::envelopeChanged, [&] { ++changes; });
  document.setEnvelope("Ball", "ball");
  document.setEnvelope("Cone", "cone");
  document.setEnvelope("Cone", "cone");
  ASSERT_EQ(document.undoStack().count(), 2) << "one that is there already is no step";
  EXPECT_EQ(document.step(1).envelope, (EnvelopeChange{"ball", "cone"}));
  document.undoStack().undo();
  EXPECT_EQ(document.envelope(), "ball");
  document.undoStack().undo();
  EXPECT_EQ(document.envelope(), "");
  document.undoStack().redo();
  EXPECT_EQ(document.envelope(), "ball");
  EXPECT_EQ(changes, 5);
  document.goTo(2);
  EXPECT_EQ(document.envelope(), "cone");
  changes = 0;
  document.goTo(0);
  EXPECT_EQ(document.envelope(), "");
  EXPECT_EQ(changes, 1) << "several steps are one change";
}

TEST_F(PlantDocumentTest, MakesOneStepOfAnEnvelopeThatIsChosenFurther) {
  const Gesture choosing = Gesture::begin();
  document.setEnvelope("Ball", "ball", choosing);
  document.setEnvelope("Cone", "cone", choosing);
  ASSERT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.step(0).text, "Cone");
  EXPECT_EQ(document.undoStack().text(0), "Cone");
  EXPECT_EQ(document.step(0).envelope, (EnvelopeChange{"", "cone"}));
  document.setEnvelope("None", "", choosing);
  EXPECT_EQ(document.undoStack().count(), 0) << "as it was";
}

TEST_F(PlantDocumentTest, OpensTheEnvelopeThatItsStepsLeadTo) {
  document.setEnvelope("Ball", "ball");
  document.setEnvelope("Cone", "cone");
  document.undoStack().undo();
  const History history = document.history();
  PlantDocument opened;
  opened.openEnvelope("of another plant");
  opened.openHistory(history, nullptr, {});
  EXPECT_EQ(opened.envelope(), "ball");
  opened.openEnvelope("cone");
  EXPECT_EQ(opened.envelope(), "ball") << "what is beside the plant was written before";
  opened.undoStack().redo();
  EXPECT_EQ(opened.envelope(), "cone");
  opened.openSkeleton({}, {});
  opened.openEnvelope("box");
  EXPECT_EQ(opened.envelope(), "box") << "no step changed it";
}

TEST_F(PlantDocumentTest, ShowsAnotherEnvelopeOfAReadOnlyPlantWithoutAStep) {
  document.setReadOnly("read-only");
  document.setEnvelope("Ball", "ball");
  EXPECT_EQ(document.envelope(), "ball");
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(PlantDocumentTest, ItsSkeletonIsNotEditedWhileItIsHeld) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.reconstruct("Reconstruct", test::fork(2), nullptr);
  const Skeleton before = document.skeleton();
  document.setHeld("a preview is shown");
  const auto thicken = [](SkeletonEditor& editor) {
    editor.setRadius(editor.skeleton().roots().front(), 1);
  };
  EXPECT_THROW(document.edit("Thicken", thicken), Error);
  EXPECT_THROW(document.goTo(0), Error);
  EXPECT_EQ(document.skeleton(), before);
  document.leaveOut("One", PointSet::of({1}));
  EXPECT_EQ(document.leftOut(), PointSet::of({1}));
  document.reconstruct("Reconstruct", test::fork(3), nullptr);
  document.setHeld({});
  document.edit("Thicken", thicken);
  EXPECT_EQ(document.undoStack().count(), 4);
}

TEST_F(PlantDocumentTest, SetsNothingAsideInAReadOnlyPlant) {
  document.setScan(rowOfPoints(), "row.xyz");
  document.setReadOnly("it is signed");
  EXPECT_THROW(document.leaveOut("One", PointSet::of({1})), Error);
  EXPECT_TRUE(document.leftOut().isEmpty());
}

} // namespace
} // namespace espalier
