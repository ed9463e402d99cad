#include "core/project/project.h"
#include "core/project/project_schema.h"
#include "core/skeleton/edits.h"
#include "tests/support/shared_data.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// A copy of tests/data/schema_1.espalier, which was written before nodes had review marks: a stick
/// of three nodes; a child was added to node 1 and node 2 marked; that child was moved and put
/// back.
fs::path oldProject() {
  const fs::path file = test::freshFolder() / "old.espalier";
  fs::copy_file(test::sourceFolder() / "tests/data/schema_1.espalier", file);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  return file;
}

History historyOf(const Project& project) {
  const Imported<History> read = project.history();
  EXPECT_THAT(read.notes, testing::IsEmpty());
  return read.value;
}

void expectThePlant(const History& history) {
  ASSERT_EQ(history.steps.size(), 3U);
  EXPECT_EQ(history.position, 2U);
  EXPECT_EQ(history.steps[0].text, "New child of node 1");
  EXPECT_EQ(history.steps[0].author, "Anna");
  const Skeleton& plant = history.skeleton;
  ASSERT_EQ(plant.size(), 4U);
  EXPECT_EQ(plant[NodeId{2}].position, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(plant[NodeId{2}].radius, 0.125);
  EXPECT_TRUE(plant[NodeId{2}].isMarked);
  ASSERT_EQ(plant[NodeId{2}].entities.size(), 1U);
  EXPECT_EQ(plant[NodeId{2}].entities[0].values[0].text, "old");
  EXPECT_EQ(plant[NodeId{3}].position, Eigen::Vector3d(1, 0, 2));
  for (const NodeId id : plant.ids())
    EXPECT_EQ(plant[id].review, ReviewMark());
}

TEST(ProjectUpgrade, ReadsAProjectOfTheFirstSchemaAndLeavesItAlone) {
  const fs::path file = oldProject();
  expectThePlant(historyOf(Project::open(file, Access::readOnly)));
  EXPECT_EQ(Database(file, Opening::frozen).integer("PRAGMA user_version"), 1);
}

TEST(ProjectUpgrade, WritesReviewMarksIntoAProjectOfTheFirstSchema) {
  const fs::path file = oldProject();
  History history;
  {
    Project project = Project::open(file, Access::readWrite);
    history = historyOf(project);
    expectThePlant(history);
    SkeletonEditor editor(history.skeleton);
    editor.setReview(NodeId{1}, {ReviewState::reviewed, "fine", "Emil"});
    history.steps.resize(2);
    history.steps.push_back({"Mark node 1 reviewed", "Emil", 5, editor.commit()});
    history.position = 3;
    project.record(2, std::span(history.steps).last(1), 3);
    EXPECT_EQ(project.document("unit"), "m");
  }
  EXPECT_EQ(historyOf(Project::open(file, Access::readOnly)), history);
  EXPECT_EQ(Database(file, Opening::readOnly).integer("PRAGMA user_version"), currentSchema());
}

TEST(ProjectUpgrade, KeepsAnOldProgramFromReadingReviewMarksAsDamage) {
  const fs::path file = test::freshFolder() / "new.espalier";
  (void)Project::create(file, {});
  EXPECT_GT(Database(file, Opening::frozen).integer("PRAGMA user_version"), 1)
      << "a program that knows schema 1 says that a newer one wrote it";
}

} // namespace
} // namespace espalier
