#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "tests/support/plants.h"
#include "ui/document/plant_document.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace espalier {
namespace {

struct GoToTest : testing::Test {
  PlantDocument document;
  void SetUp() override { document.openSkeleton(test::stick(3), "stick.mtg"); }
  void setRadius(double radius) {
    document.edit("Radius", [=](SkeletonEditor& editor) { editor.setRadius(NodeId{1}, radius); });
  }
  void remove(NodeId id) {
    document.edit("Remove", [=](SkeletonEditor& editor) { removeNode(editor, id); });
  }
};

TEST_F(GoToTest, TakesManyStepsBackAndReportsOneChange) {
  for (int i = 1; i <= 1000; ++i)
    setRadius(i);
  std::vector<SkeletonDelta> deltas;
  QObject::connect(&document, &PlantDocument::skeletonEdited,
                   [&](const SkeletonDelta& delta) { deltas.push_back(delta); });
  const QSignalSpy indices(&document.undoStack(), &QUndoStack::indexChanged);
  document.goTo(0);
  EXPECT_EQ(document.skeleton(), test::stick(3));
  EXPECT_EQ(document.undoStack().index(), 0);
  ASSERT_EQ(deltas.size(), 1U);
  ASSERT_EQ(deltas[0].changes.size(), 1U);
  EXPECT_EQ(deltas[0].changes[0].before->radius, 1000);
  EXPECT_EQ(deltas[0].changes[0].after->radius, 0.1) << "as it was at first";
  EXPECT_EQ(indices.size(), 1);
  document.goTo(700);
  EXPECT_EQ(document.skeleton()[NodeId{1}].radius, 700);
  EXPECT_EQ(deltas.size(), 2U);
}

TEST_F(GoToTest, BringsRemovedNodesBackAndForgetsAddedOnes) {
  const Skeleton start = document.skeleton();
  remove(NodeId{1});
  NodeId added{};
  document.edit("Add", [&](SkeletonEditor& editor) {
    added = addChild(editor, NodeId{2}, {1, 1, 1});
  });
  const Skeleton end = document.skeleton();
  std::vector<SkeletonDelta> deltas;
  QObject::connect(&document, &PlantDocument::skeletonEdited,
                   [&](const SkeletonDelta& delta) { deltas.push_back(delta); });
  document.selection().set({added});
  document.goTo(0);
  EXPECT_EQ(document.skeleton(), start);
  EXPECT_TRUE(document.selection().isEmpty());
  Skeleton mirrored = document.skeleton(); // as a view that follows by deltas
  document.goTo(2);
  EXPECT_EQ(document.skeleton(), end);
  ASSERT_EQ(deltas.size(), 2U);
  EXPECT_EQ(deltas[0].inverse().changes.size(), deltas[1].changes.size());
  deltas[1].apply(mirrored);
  EXPECT_EQ(mirrored, end);
}

TEST_F(GoToTest, ReportsNothingOfStepsThatCancelEachOther) {
  setRadius(2);
  setRadius(3);
  setRadius(2); // as it was
  const QSignalSpy edits(&document, &PlantDocument::skeletonEdited);
  document.goTo(1);
  EXPECT_EQ(edits.size(), 0);
  EXPECT_EQ(document.undoStack().index(), 1);
}

TEST_F(GoToTest, ReportsTheContractedPointsOnce) {
  const auto points = [](float at) {
    return std::make_shared<const Eigen::Matrix3Xf>(Eigen::Matrix3Xf::Constant(3, 2, at));
  };
  const auto first = points(1);
  document.reconstruct("Reconstruct", test::fork(2), first);
  document.reconstruct("Reconstruct", test::fork(3), points(2));
  document.reconstruct("Reconstruct", test::fork(4), points(3));
  const QSignalSpy changes(&document, &PlantDocument::contractedChanged);
  document.goTo(1);
  EXPECT_EQ(document.contracted(), first);
  EXPECT_EQ(changes.size(), 1);
}

TEST_F(GoToTest, IsRefusedWhileReadOnly) {
  setRadius(2);
  document.setReadOnly("open it elsewhere");
  EXPECT_THROW(document.goTo(0), Error);
  EXPECT_EQ(document.undoStack().index(), 1);
  EXPECT_NO_THROW(document.goTo(1)) << "it is there";
}

std::size_t bytesOf(const std::string& text) {
  return text.capacity();
}

std::size_t bytesOf(const Node& node) {
  std::size_t bytes = bytesOf(node.review.comment) + bytesOf(node.review.reviewer) +
                      node.entities.capacity() * sizeof(Entity);
  for (const Entity& entity : node.entities) {
    bytes += bytesOf(entity.symbol) + bytesOf(entity.alias) +
             entity.values.capacity() * sizeof(FeatureValue);
    for (const FeatureValue& value : entity.values)
      bytes += bytesOf(value.feature) + bytesOf(value.text);
  }
  return bytes;
}

// 1 000 edits of a node that carries a unit with 5 features and a comment.
TEST_F(GoToTest, AThousandStepsTakeUnderFiftyMegabytes) {
  document.edit("Describe", [](SkeletonEditor& editor) {
    Entity unit{.scale = 3, .symbol = "Internode", .index = 7};
    for (int i = 0; i < 5; ++i)
      unit.values.push_back({"a_feature_of_the_unit_" + std::to_string(i), "12.345678"});
    editor.setEntities(NodeId{1}, {unit});
    editor.setReview(NodeId{1}, {ReviewState::doubtful, std::string(200, 'c'), "Ada Lovelace"});
  });
  for (int i = 1; i <= 1000; ++i)
    setRadius(i);
  std::size_t bytes = 0;
  for (const HistoryStep& step : document.history().steps) {
    bytes += sizeof(HistoryStep) + bytesOf(step.text) + bytesOf(step.author) +
             step.delta.changes.capacity() * sizeof(SkeletonDelta::Change);
    for (const SkeletonDelta::Change& change : step.delta.changes) {
      EXPECT_EQ(step.delta.changes.size(), 1U) << "as large as the edit, not as the plant";
      if (change.before) bytes += bytesOf(*change.before);
      if (change.after) bytes += bytesOf(*change.after);
    }
  }
  RecordProperty("bytes", std::to_string(bytes));
  EXPECT_LT(bytes, 50'000'000U);
  EXPECT_GT(bytes, 1000 * sizeof(SkeletonDelta::Change)) << "all was counted";
}

} // namespace
} // namespace espalier
