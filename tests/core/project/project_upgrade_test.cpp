#include "core/project/contracted_points.h"
#include "core/project/point_bytes.h"
#include "core/project/project.h"
#include "core/project/project_schema.h"
#include "core/skeleton/edits.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/older_project.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <fstream>
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
    history.steps.push_back({.id = StepId{77},
                             .text = "Mark node 1 reviewed",
                             .author = "Emil",
                             .time = 5,
                             .delta = editor.commit()});
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

/// As it was before organs could be set by hand.
History withoutOrgans(History history) {
  history.organs = {};
  for (HistoryStep& step : history.steps)
    step.organs = {};
  return history;
}

/// A project of version 0.1, and what it holds; the steps as they are numbered once it is read.
struct Version01 {
  fs::path file = test::freshFolder() / "older.espalier";
  History history;
  std::size_t contractedAt = 0; // the place of the step that the contracted points are from

  Version01() {
    test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 4)}, 4);
    while (edits.history().position < 12)
      (void)edits.next();
    history = withoutOrgans(edits.history());
    contractedAt = history.position - 2;
    for (std::size_t i = 0; i < history.steps.size(); ++i)
      history.steps[i].time = static_cast<std::int64_t>(1'700'000'000'000 + i);
    const fs::path today = file.parent_path() / "today.espalier";
    writeToday(today);
    test::writeAsVersion01(today, file);
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
      history.steps[i].id = StepId{i + 1};
      history.steps[i].replacesContracted = i == contractedAt; // of others it was not noted
      history.steps[i].envelope.reset();                       // it was no step
    }
  }

  void writeToday(const fs::path& path) const {
    Project project = Project::create(path, history);
    const StepId step = history.steps[contractedAt].id;
    replaceContracted(project, step);
    project.setBytes(contractedName, bytesOf(Eigen::Matrix3Xf(Eigen::Matrix3Xf::Ones(3, 4))));
    project.setDocument("made_with",
                        std::to_string(static_cast<std::uint64_t>(step)) + " radius\n{}");
    project.setDocument("unit", "cm");
  }

  void expectIn(const Project& project) const {
    EXPECT_EQ(historyOf(project), history);
    const ContractedPoints contracted = contractedIn(project);
    EXPECT_EQ(contracted.step, history.steps[contractedAt].id);
    EXPECT_EQ(*contracted.positions, Eigen::Matrix3Xf(Eigen::Matrix3Xf::Ones(3, 4)));
    EXPECT_EQ(project.document("made_with"), std::to_string(contractedAt + 1) + " radius\n{}");
    EXPECT_EQ(project.document("contracted_step"), "");
    EXPECT_EQ(project.document("unit"), "cm");
  }
};

TEST(ProjectUpgrade, NamesTheStepsOfVersion01ByIds) {
  const Version01 older;
  older.expectIn(Project::open(older.file, Access::readWrite));
  EXPECT_EQ(Database(older.file, Opening::readOnly).integer("PRAGMA user_version"),
            currentSchema());
  older.expectIn(Project::open(older.file, Access::readOnly));
}

TEST(ProjectUpgrade, ReadsAProjectOfVersion01AndLeavesItAlone) {
  const Version01 older;
  const auto size = fs::file_size(older.file);
  older.expectIn(Project::open(older.file, Access::readOnly));
  EXPECT_EQ(fs::file_size(older.file), size);
  EXPECT_EQ(Database(older.file, Opening::frozen).integer("PRAGMA user_version"), 3);
}

TEST(ProjectUpgrade, KeepsTheIdsOfOlderStepsWhereOthersFollow) {
  const Version01 older;
  History history = older.history;
  Project project = Project::open(older.file, Access::readWrite);
  SkeletonEditor editor(history.skeleton);
  (void)editor.add({});
  history.steps.resize(history.position); // those that were undone are dropped
  history.steps.push_back({.id = StepId{1'000'000}, .text = "Add", .delta = editor.commit()});
  project.record(history.position, std::span(history.steps).last(1), history.position + 1);
  ++history.position;
  EXPECT_EQ(historyOf(project), history);
}

// Before steps could change the crown envelope.
TEST(ProjectUpgrade, KeepsEnvelopesInTheStepsThatFollowThoseOfSchema5) {
  const fs::path file = test::freshFolder() / "older.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 4)}, 5);
  while (edits.history().position < 12)
    (void)edits.next();
  History history = withoutOrgans(edits.history());
  for (HistoryStep& step : history.steps)
    step.envelope.reset();
  (void)Project::create(file, history);
  test::writeAsSchema5(file);
  EXPECT_EQ(historyOf(Project::open(file, Access::readOnly)), history);
  EXPECT_EQ(Database(file, Opening::readOnly).integer("PRAGMA user_version"), 5) << "left alone";
  Project project = Project::open(file, Access::readWrite);
  EXPECT_EQ(historyOf(project), history);
  history.steps.resize(history.position);
  history.steps.push_back({.id = StepId{77},
                           .text = "Crown envelope: ball",
                           .envelope = EnvelopeChange{.before = "", .after = "ball"}});
  history.steps.push_back({.id = StepId{78},
                           .text = "Crown envelope: none",
                           .envelope = EnvelopeChange{.before = "ball", .after = ""}});
  project.record(history.position, std::span(history.steps).last(2), history.position + 2);
  history.position += 2;
  EXPECT_EQ(historyOf(project), history);
}

// Before organs of points could be set by hand.
TEST(ProjectUpgrade, KeepsOrgansInTheStepsThatFollowThoseOfSchema6) {
  const fs::path file = test::freshFolder() / "older.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 4)}, 6);
  while (edits.history().position < 12)
    (void)edits.next();
  History history = withoutOrgans(edits.history());
  (void)Project::create(file, history);
  for (const char* statement : {"DROP TABLE version", "PRAGMA user_version = 6"})
    Database(file, Opening::readWrite).execute(statement);
  EXPECT_EQ(historyOf(Project::open(file, Access::readOnly)), history);
  EXPECT_EQ(Database(file, Opening::readOnly).integer("PRAGMA user_version"), 6) << "left alone";
  Project project = Project::open(file, Access::readWrite);
  EXPECT_EQ(Database(file, Opening::readOnly).integer("PRAGMA user_version"), currentSchema())
      << "older programs say that a newer one wrote it";
  history.organs = OrganMarks().with(PointSet::of({3, 4, 9}), Organ::blade);
  history.steps.resize(history.position);
  history.steps.push_back(
      {.id = StepId{77}, .text = "Set 3 points to blade", .organs = history.organs});
  project.record(history.position, std::span(history.steps).last(1), history.position + 1);
  ++history.position;
  EXPECT_EQ(historyOf(project), history);
  EXPECT_TRUE(beginningOf(historyOf(project)).organs.isEmpty());
}

// Before states could be named.
TEST(ProjectUpgrade, NamesStatesInAProjectOfSchema7) {
  const fs::path file = test::freshFolder() / "older.espalier";
  const History history{.skeleton = test::fork(3)};
  (void)Project::create(file, history);
  for (const char* statement : {"DROP TABLE version", "PRAGMA user_version = 7"})
    Database(file, Opening::readWrite).execute(statement);
  {
    const Project project = Project::open(file, Access::readOnly);
    EXPECT_EQ(historyOf(project), history);
    EXPECT_THAT(project.versions().value, testing::IsEmpty());
    EXPECT_THAT(project.versions().notes, testing::IsEmpty());
  }
  EXPECT_EQ(Database(file, Opening::frozen).integer("PRAGMA user_version"), 7) << "left alone";
  Project project = Project::open(file, Access::readWrite);
  const PlantVersion version{.name = "as found", .skeleton = history.skeleton};
  project.addVersion(version);
  EXPECT_THAT(project.versions().value, testing::ElementsAre(version));
  EXPECT_EQ(historyOf(project), history);
}

// Version 0.1 reads the plant of such a file from its last snapshot, and so does this.
TEST(ProjectUpgrade, SavesThePlantOfADamagedProject) {
  const Version01 older;
  std::int64_t page = 0;
  std::int64_t size = 0;
  {
    const Database database(older.file, Opening::readOnly);
    page = database.integer("SELECT rootpage FROM sqlite_schema WHERE name = 'journal'");
    size = database.integer("PRAGMA page_size");
  }
  std::fstream file(older.file, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp((page - 1) * size);
  file << std::string(static_cast<std::size_t>(size), '\xff');
  file.close();
  for (const Access access : {Access::readOnly, Access::readWrite}) {
    const Project project = Project::open(older.file, access);
    const Imported<History> read = project.history();
    EXPECT_THAT(read.notes, testing::SizeIs(1));
    EXPECT_EQ(project.document("unit"), "cm");
  }
}

TEST(Project, WrittenByANewerProgramIsRefusedAndLeftAlone) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, {});
  Database(file, Opening::readWrite).execute("PRAGMA user_version = 99");
  const std::string error =
      test::errorOf([&] { return Project::open(file, Access::readWrite).path(); });
  EXPECT_THAT(error, HasSubstr("newer Espalier"));
  EXPECT_EQ(Database(file, Opening::frozen).integer("PRAGMA user_version"), 99);
}

} // namespace
} // namespace espalier
