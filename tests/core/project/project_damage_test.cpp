// Files that no program should have written, and those that a disk or a person has changed.
#include "core/base/random.h"
#include "core/project/node_bytes.h"
#include "core/project/project.h"
#include "tests/core/io/samples.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A project of ten moves of a stick of five nodes, all done.
History tenMoves() {
  History history{.skeleton = test::stick(5)};
  for (int i = 0; i < 10; ++i) {
    SkeletonEditor editor(history.skeleton);
    editor.setRadius(NodeId{2}, 1 + i);
    history.steps.push_back({.text = "Radius", .delta = editor.commit()});
  }
  history.position = 10;
  return history;
}

fs::path projectOfTenMoves() {
  fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, tenMoves());
  return file;
}

std::string messageOnOpening(const fs::path& file) {
  return test::errorOf([&] { return Project::open(file, Access::readOnly).history(); });
}

TEST(DamagedProject, ThatIsAnotherKindOfFileIsRefused) {
  const fs::path folder = test::freshFolder();
  std::ofstream(folder / "text.espalier") << "not a database, however long it may be made";
  EXPECT_THAT(messageOnOpening(folder / "text.espalier"), HasSubstr("is no project"));
  std::ofstream(folder / "empty.espalier") << "";
  EXPECT_THAT(messageOnOpening(folder / "empty.espalier"), HasSubstr("is no project"));
  Database(folder / "other.espalier", Opening::created).execute("CREATE TABLE journal (x)");
  EXPECT_THAT(messageOnOpening(folder / "other.espalier"), HasSubstr("is no project"));
}

TEST(DamagedProject, OfOtherTablesIsRefused) {
  const fs::path file = projectOfTenMoves();
  Database(file, Opening::readWrite)
      .execute("CREATE TRIGGER t AFTER INSERT ON journal BEGIN DELETE FROM journal; END");
  EXPECT_THAT(messageOnOpening(file), HasSubstr("not those of a project"));
}

TEST(DamagedProject, GivesTheVersionsThatCanBeRead) {
  const fs::path file = projectOfTenMoves();
  {
    Project project = Project::open(file, Access::readWrite);
    for (const char* name : {"one", "two", "three"})
      project.addVersion({.name = name, .skeleton = test::stick(4)});
  }
  Database(file, Opening::readWrite)
      .execute("UPDATE version SET nodes = substr(nodes, 1, 40) WHERE name = 'two'");
  const auto read = Project::open(file, Access::readOnly).versions();
  EXPECT_EQ(read.value.size(), 2U);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(inEnglish(read.notes[0]),
              HasSubstr("its version 'two' is damaged: the others can be read"));
  EXPECT_THAT(Project::open(file, Access::readOnly).history().notes, testing::IsEmpty())
      << "the plant is whole";
}

TEST(DamagedProject, GivesAsLastWorkWhatItsHistoryIs) {
  const fs::path file = projectOfTenMoves();
  Database(file, Opening::readWrite).execute("UPDATE journal SET delta = x'00' WHERE step = 4");
  const Project project = Project::open(file, Access::readOnly);
  const Imported<History> last = project.lastWork();
  EXPECT_EQ(last.value, project.history().value);
  EXPECT_EQ(last.notes, project.history().notes);
  EXPECT_EQ(last.notes.size(), 1U);
}

TEST(DamagedProject, GivesThePlantUpToTheLastGoodStep) {
  const fs::path file = projectOfTenMoves();
  const Database database(file, Opening::readWrite);
  database.execute("DELETE FROM snapshot WHERE step > 0");
  database.execute("UPDATE journal SET delta = x'0102' WHERE step = 7");
  const Imported<History> read = Project::open(file, Access::readOnly).history();
  EXPECT_EQ(read.value.position, 7U);
  EXPECT_EQ(read.value.steps.size(), 7U);
  EXPECT_EQ(read.value.skeleton[NodeId{2}].radius, 7);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(inEnglish(read.notes[0]), HasSubstr("after 7 of 10 edits"));
}

TEST(DamagedProject, KeepsThePlantIfASnapshotStandsBehindTheBadStep) {
  const fs::path file = projectOfTenMoves();
  Database(file, Opening::readWrite).execute("UPDATE journal SET delta = x'0102' WHERE step = 7");
  const Imported<History> read = Project::open(file, Access::readOnly).history();
  EXPECT_EQ(read.value.skeleton, tenMoves().skeleton);
  EXPECT_EQ(read.value.steps.size(), 2U) << "undo reaches back to the gap";
  EXPECT_EQ(read.notes.size(), 1U);
}

TEST(DamagedProject, DoesWithoutABadSnapshot) {
  const fs::path file = projectOfTenMoves();
  Database(file, Opening::readWrite).execute("UPDATE snapshot SET nodes = x'00' WHERE step = 10");
  const Imported<History> read = Project::open(file, Access::readOnly).history();
  EXPECT_EQ(read.value, tenMoves());
}

TEST(DamagedProject, WithoutAnySnapshotIsAnError) {
  const fs::path file = projectOfTenMoves();
  Database(file, Opening::readWrite).execute("DELETE FROM snapshot");
  EXPECT_THAT(messageOnOpening(file), HasSubstr("nothing of its plant can be read"));
}

// The bytes are whole, but describe a node that is not as they say.
TEST(DamagedProject, DoesNotApplyAStepThatDoesNotFit) {
  const fs::path file = projectOfTenMoves();
  const Database database(file, Opening::readWrite);
  SkeletonDelta delta = tenMoves().steps[3].delta;
  delta.changes[0].before->radius = 55;
  const std::string bytes = bytesOf(delta);
  database.execute("DELETE FROM snapshot WHERE step > 0");
  database.prepare("UPDATE journal SET delta = ? WHERE step = 3").bindBytes(1, bytes).run();
  const Imported<History> read = Project::open(file, Access::readOnly).history();
  EXPECT_EQ(read.value.position, 3U);
  EXPECT_EQ(read.notes.size(), 1U);
}

TEST(DamagedProject, OfOddNumbersDoesNoHarm) {
  for (const char* change :
       {"UPDATE position SET step = -5", "UPDATE position SET step = 9000000000000",
        "DELETE FROM position", "UPDATE journal SET step = step + 4000000000000 WHERE step > 4",
        "UPDATE snapshot SET step = -1 WHERE step = 10", "UPDATE journal SET delta = ''",
        "UPDATE journal SET time = 'noon', text = x'FF00'"}) {
    const fs::path file = projectOfTenMoves();
    Database(file, Opening::readWrite).execute(change);
    const Imported<History> read = Project::open(file, Access::readOnly).history();
    EXPECT_EQ(read.value.skeleton.size(), 5U) << change;
  }
}

TEST(DamagedProject, BytesThatChangedAreRecognized) {
  const fs::path file = projectOfTenMoves();
  Project project = Project::open(file, Access::readWrite);
  project.setBytes("contracted", "abcdef");
  Database(file, Opening::readWrite).execute("UPDATE piece SET bytes = 'abcdeg'");
  EXPECT_THAT(test::errorOf([&] { return project.bytes("contracted"); }), HasSubstr("damaged"));
}

// A disk that lost a page, a copy that was cut: whatever comes back is a plant that once was.
TEST(DamagedProject, GivesAPlantOfItsHistoryOrAnErrorHoweverBytesChange) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(60, 1)}, 1);
  std::vector<Skeleton> plants = {edits.history().skeleton};
  {
    Project project = Project::create(file, edits.history());
    for (int i = 0; i < 100; ++i) {
      const auto act = edits.next();
      project.record(act.kept, act.added, act.position);
      plants.push_back(edits.history().skeleton);
    }
  }
  std::ostringstream whole;
  whole << std::ifstream(file, std::ios::binary).rdbuf();
  Random random(4);
  int recovered = 0;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole.str();
    if (round % 3 == 0) bytes.resize(random.below(bytes.size()));
    for (int i = 0; i < 20 && !bytes.empty(); ++i)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    std::ofstream(file, std::ios::binary) << bytes;
    try {
      const History read = Project::open(file, Access::readOnly).history().value;
      EXPECT_THAT(plants, testing::Contains(read.skeleton)) << "round " << round;
      ++recovered;
    } catch (const Error&) { // said so: as good
    }
  }
  EXPECT_GT(recovered, 50) << "most of a file is no reason to give up all of it";
}

/// A project whose first node has this id.
fs::path projectFromNode(std::uint32_t id) {
  Skeleton plant;
  growIds(plant, id);
  (void)plant.add({});
  fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, {.skeleton = plant});
  return file;
}

// A plant has a table by id: a file of 40 kB must not take gigabytes.
TEST(DamagedProject, OfFarTooLargeIdsIsRefused) {
  EXPECT_EQ(messageOnOpening(projectFromNode(1'000'000)), "") << "as after many reconstructions";
  const fs::path file = projectOfTenMoves();
  const auto withId = [&](std::uint32_t id) {
    const SkeletonDelta delta{{{NodeId{id}, std::nullopt, Node{}}}};
    Database database(file, Opening::readWrite);
    database.prepare("UPDATE journal SET delta = ? WHERE step = 9")
        .bindBytes(1, bytesOf(delta))
        .run();
  };
  withId(33'554'400);
  EXPECT_THAT(messageOnOpening(file), HasSubstr("oak.espalier: numbers its nodes up to 33554401"));
  withId(5'000'000);
  EXPECT_THAT(messageOnOpening(file), HasSubstr("numbers its nodes up to 5000001"));
}

// The steps behind the first may be dropped, and with them the bytes that its id follows from.
TEST(DamagedProject, IsNeverWrittenByStepsThatAreDropped) {
  const fs::path file = projectOfTenMoves();
  Project project = Project::open(file, Access::readWrite);
  const std::uint32_t far = 4'200'000;
  SkeletonDelta many;
  for (std::uint32_t i = 1; i <= 1000; ++i)
    many.changes.push_back({NodeId{far + i}, std::nullopt, Node{}});
  const std::vector<HistoryStep> steps = {
      {.text = "Add", .delta = {{{NodeId{far}, std::nullopt, Node{}}}}},
      {.text = "Add", .delta = many}};
  const std::string problem = test::errorOf([&] {
    project.record(10, steps, 12);
    return 0;
  });
  EXPECT_THAT(problem, HasSubstr("numbers its nodes up to 4200001"));
  EXPECT_THAT(problem, HasSubstr("save the plant as an MTG, and begin a new project with that"));
  EXPECT_EQ(project.history().value.steps.size(), 10U);
}

TEST(DamagedProject, IsNeverWrittenByIdsThatRunOut) {
  const fs::path file = projectOfTenMoves();
  Project project = Project::open(file, Access::readWrite);
  const HistoryStep step{.text = "Add", .delta = {{{NodeId{5'000'000}, std::nullopt, Node{}}}}};
  EXPECT_THAT(test::errorOf([&] {
                project.record(10, {&step, 1}, 11);
                return 0;
              }),
              HasSubstr("numbers its nodes up to 5000001"));
  EXPECT_EQ(project.history().value, Project::open(file, Access::readOnly).history().value);
  EXPECT_EQ(project.history().value.steps.size(), 10U);
}

TEST(Project, ThatIsMissingIsAnError) {
  EXPECT_THAT(
      test::errorOf([] {
        return Project::open(test::freshFolder() / "none.espalier", Access::readWrite).path();
      }),
      HasSubstr("there is no such file: check its name"));
}

TEST(Project, ThatIsAFolderIsAnError) {
  EXPECT_THAT(
      test::errorOf([] { return Project::open(test::freshFolder(), Access::readOnly).path(); }),
      HasSubstr("is a folder, choose a file in it"));
}

} // namespace
} // namespace espalier
