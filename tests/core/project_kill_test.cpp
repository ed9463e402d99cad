// A program edits at random and is killed at random moments, over and over on one file. What it
// had reported as saved must be there each time, with a valid history.
#include "core/base/random.h"
#include "core/project/contracted_points.h"
#include "core/project/project.h"
#include "core/project/project_schema.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/older_project.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// The program: opens the project and edits until it is killed; a byte into `saved` for each act
/// that is.
[[noreturn]] void editUntilKilled(const fs::path& file, std::uint64_t seed, int saved) {
  try {
    Project project = Project::open(file, Access::readWrite);
    test::EditsAtRandom edits(project.history().value, seed);
    for (;;) {
      const auto act = edits.next();
      project.record(act.kept, act.added, act.position);
      if (::write(saved, "s", 1) != 1) ::_exit(3);
      if (project.needsSnapshot())
        project.takeSnapshot(edits.history().skeleton, edits.history().leftOut,
                             edits.history().organs);
    }
  } catch (const std::exception& error) {
    (void)!::write(STDERR_FILENO, error.what(), std::string_view(error.what()).size());
    ::_exit(4);
  }
}

void spin(std::chrono::microseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end)
    continue;
}

/// Reads bytes of the pipe, at most `most`; fewer if it ends.
int readBytes(int pipe, int most) {
  int count = 0;
  char byte = 0;
  while (count < most && ::read(pipe, &byte, 1) == 1)
    ++count;
  return count;
}

/// A scan of so many points.
ScanReference scanOf(std::size_t points) {
  return {.path = "/a/" + std::to_string(points) + ".ply", .size = points, .isByFile = true};
}

/// The same of a program that joins scans of one point each to that of the project.
[[noreturn]] void joinUntilKilled(const fs::path& file, int saved) {
  try {
    Project project = Project::open(file, Access::readWrite);
    for (std::size_t points = project.history().value.steps.size();; ++points) {
      const PointSet added = PointSet::of({static_cast<std::uint32_t>(points)});
      const HistoryStep step{
          .id = StepId{points + 1}, .text = "Join", .delta = {}, .points = added};
      project.record(points, {&step, 1}, points + 1, GrownReference{scanOf(points + 1), added});
      if (::write(saved, "s", 1) != 1) ::_exit(3);
    }
  } catch (const std::exception& error) {
    (void)!::write(STDERR_FILENO, error.what(), std::string_view(error.what()).size());
    ::_exit(4);
  }
}

/// The same of a program that names the state after each edit.
[[noreturn]] void nameUntilKilled(const fs::path& file, int saved) {
  try {
    Project project = Project::open(file, Access::readWrite);
    for (std::size_t count = project.versions().value.size();; ++count) {
      project.addVersion({.name = std::to_string(count),
                          .time = static_cast<std::int64_t>(count),
                          .skeleton = test::randomPlant(200, count)});
      if (::write(saved, "s", 1) != 1) ::_exit(3);
    }
  } catch (const std::exception& error) {
    (void)!::write(STDERR_FILENO, error.what(), std::string_view(error.what()).size());
    ::_exit(4);
  }
}

/// Runs a program until it has saved `acts` and a moment longer.
/// @param program  reports each act to a pipe
/// @return how many acts it reported as saved
int runAndKill(const std::function<void(int saved)>& program, int acts,
               std::chrono::microseconds longer) {
  int saved[2];
  EXPECT_EQ(::pipe(saved), 0);
  const pid_t child = ::fork();
  if (child == 0) program(saved[1]);
  ::close(saved[1]);
  int count = readBytes(saved[0], acts);
  spin(longer);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "it ended by itself";
  count += readBytes(saved[0], 1'000'000);
  ::close(saved[0]);
  return count;
}

TEST(KilledProgram, LosesNoEditThatItReportedAsSaved) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  Random random(20);
  History truth{.skeleton = test::randomPlant(200, 1)};
  (void)Project::create(file, truth);
  int savedInAll = 0;
  int keptUnreported = 0;
  for (std::uint64_t round = 0; round < 250; ++round) {
    const int acts = static_cast<int>(random.below(8)); // 0: perhaps while it opens
    const int saved = runAndKill([&](int pipe) { editUntilKilled(file, round, pipe); }, acts,
                                 std::chrono::microseconds(random.below(6000)));
    savedInAll += saved;
    test::EditsAtRandom edits(std::move(truth), round);
    for (int i = 0; i < saved; ++i)
      (void)edits.next();
    const Imported<History> found = Project::open(file, Access::readWrite).history();
    ASSERT_TRUE(found.notes.empty()) << inEnglish(found.notes[0]);
    if (found.value != edits.history()) { // one more was saved, and not reported any more
      (void)edits.next();
      ++keptUnreported;
    }
    ASSERT_EQ(found.value, edits.history()) << "round " << round << ", " << saved << " saved";
    truth = found.value;
  }
  EXPECT_GT(savedInAll, 500);
  RecordProperty("saved", savedInAll);
  RecordProperty("kept_unreported", keptUnreported);
}

TEST(KilledProgram, HasAScanThatGrewWithItsStepOrNeither) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  Project::create(file, {.skeleton = test::fork(3)}).setScan(scanOf(0));
  Random random(4);
  std::size_t joined = 0;
  for (int round = 0; round < 100; ++round) {
    const int acts = static_cast<int>(random.below(6));
    joined +=
        static_cast<std::size_t>(runAndKill([&](int pipe) { joinUntilKilled(file, pipe); }, acts,
                                            std::chrono::microseconds(random.below(6000))));
    const Project project = Project::open(file, Access::readWrite);
    const Imported<History> found = project.history();
    ASSERT_TRUE(found.notes.empty()) << inEnglish(found.notes[0]);
    const std::size_t steps = found.value.steps.size();
    ASSERT_GE(steps, joined) << "round " << round;
    joined = steps; // one more was saved, and not reported any more
    ASSERT_EQ(project.scan()->size, steps) << "round " << round;
    ASSERT_TRUE(found.value.leftOut.isEmpty());
    ASSERT_EQ(beginningOf(found.value).leftOut,
              PointSet::firstOf(static_cast<Eigen::Index>(steps)));
  }
  EXPECT_GT(joined, 200U);
}

/// Opens a project in another process, and kills that.
void openAndKill(const fs::path& file, std::chrono::microseconds after) {
  const pid_t child = ::fork();
  if (child == 0) {
    const Project project = Project::open(file, Access::readWrite);
    ::pause();
  }
  spin(after);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "it ended by itself";
}

TEST(KilledProgram, UpgradesAProjectOfVersion01WholeOrNotAtAll) {
  const fs::path folder = test::freshFolder();
  test::EditsAtRandom edits({.skeleton = test::randomPlant(200, 1)}, 1);
  for (int i = 0; i < 300; ++i)
    (void)edits.next();
  {
    Project project = Project::create(folder / "today.espalier", edits.history());
    const StepId step = edits.history().steps[20].id;
    replaceContracted(project, step);
    project.setDocument("made_with", std::to_string(static_cast<std::uint64_t>(step)) + " \n{}");
  }
  test::writeAsVersion01(folder / "today.espalier", folder / "older.espalier");
  const fs::path file = folder / "oak.espalier";
  fs::copy_file(folder / "older.espalier", file);
  const auto begin = std::chrono::steady_clock::now();
  const History truth = Project::open(file, Access::readWrite).history().value;
  auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - begin);
  Random random(3);
  int upgraded = 0;
  constexpr int rounds = 200;
  for (int round = 0; round < rounds; ++round) {
    fs::copy_file(folder / "older.espalier", file, fs::copy_options::overwrite_existing);
    openAndKill(file, whole * random.below(300) / 100);
    const bool isUpgraded =
        Database(file, Opening::readOnly).integer("PRAGMA user_version") == currentSchema();
    upgraded += isUpgraded ? 1 : 0;
    whole += (isUpgraded ? -whole : whole) / 20; // it takes as long as the machine lets it
    const Project project = Project::open(file, Access::readWrite);
    const Imported<History> found = project.history();
    ASSERT_TRUE(found.notes.empty()) << inEnglish(found.notes[0]);
    ASSERT_EQ(found.value, truth) << "round " << round;
    EXPECT_EQ(project.document("contracted_by"), "21");
    EXPECT_EQ(project.document("made_with").substr(0, 3), "21 ");
  }
  RecordProperty("upgraded", upgraded);
  EXPECT_GT(upgraded, 0);
  EXPECT_LT(upgraded, rounds) << "some were killed before the end";
}

TEST(KilledProgram, LosesNoVersionThatItReportedAsSaved) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, {.skeleton = test::fork(3)});
  Random random(22);
  std::size_t savedInAll = 0;
  for (int round = 0; round < 40; ++round) {
    const int saved = runAndKill([&](int pipe) { nameUntilKilled(file, pipe); },
                                 static_cast<int>(random.below(4)),
                                 std::chrono::microseconds(random.below(6000)));
    savedInAll += static_cast<std::size_t>(saved);
    const auto read = Project::open(file, Access::readOnly).versions();
    ASSERT_TRUE(read.notes.empty()) << inEnglish(read.notes[0]);
    ASSERT_TRUE(read.value.size() == savedInAll || read.value.size() == savedInAll + 1);
    savedInAll = read.value.size(); // one more was saved, and not reported any more
    for (std::size_t i = 0; i < savedInAll; ++i)
      ASSERT_EQ(read.value[i].skeleton, test::randomPlant(200, i));
  }
  EXPECT_GT(savedInAll, 40U);
}

} // namespace
} // namespace espalier
