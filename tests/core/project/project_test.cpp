#include "core/project/corrections.h"
#include "core/project/piece_writer.h"
#include "core/project/project.h"
#include "core/project/project_schema.h"
#include "core/skeleton/edits.h"
#include "tests/core/io/samples.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <sys/resource.h>
#include <thread>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

History withEdits(int acts, std::uint64_t seed = 1) {
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, seed)}, seed);
  for (int i = 0; i < acts || edits.history().position == edits.history().steps.size(); ++i)
    (void)edits.next(); // and on until some of it is undone
  return edits.history();
}

History readBack(const fs::path& path) {
  const Imported<History> read = Project::open(path, Access::readOnly).history();
  EXPECT_THAT(read.notes, testing::IsEmpty());
  return read.value;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

TEST(Project, KeepsAPlantAndItsHistory) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(60);
  (void)Project::create(file, history);
  EXPECT_EQ(readBack(file), history);
}

TEST(Project, KeepsNamedVersionsWhateverBecomesOfTheHistory) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const PlantVersion first{
      .name = "first", .author = "Anna", .time = 7, .skeleton = test::randomPlant(30, 1)};
  const PlantVersion second{
      .name = "\"second\", after lunch", .time = 3, .skeleton = test::fork(2)};
  {
    Project project = Project::create(file, withEdits(10));
    project.addVersion(first);
    project.addVersion(second);
    EXPECT_EQ(test::errorOf([&] {
                project.addVersion(first);
                return 0;
              }),
              "there is a version 'first' already: choose another name");
    project.reset(test::stick(3));
    project.record(0, {}, 0);
  }
  EXPECT_THAT(Project::open(file, Access::readOnly).versions().value,
              testing::ElementsAre(second, first))
      << "by time";
  Project project = Project::open(file, Access::readWrite);
  project.removeVersion("first");
  project.removeVersion("none of this name");
  EXPECT_THAT(project.versions().value, testing::ElementsAre(second));
  EXPECT_THAT(test::errorOf([&] {
                Project::open(file, Access::readOnly).addVersion(first);
                return 0;
              }),
              HasSubstr("open to read only"));
}

// What a list of plants reads of it, however much was done before.
TEST(Project, ReadsTheLastWorkAlone) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const fs::path file = test::freshFolder() / "oak.espalier";
    History history = withEdits(40, seed);
    const std::size_t before = history.position;
    history.steps.resize(before);
    if (seed % 2 == 0) { // half of them end in a reconstruction and an edit
      const auto step = [&](const auto& change, bool isRun) {
        SkeletonEditor editor(history.skeleton);
        change(editor);
        history.steps.push_back({.id = StepId{1000 + history.position},
                                 .delta = editor.commit(),
                                 .replacesContracted = isRun});
        ++history.position;
      };
      step([](SkeletonEditor& editor) { replaceSkeleton(editor, test::fork(3)); }, true);
      step([](SkeletonEditor& editor) { (void)editor.add({}); }, false);
    }
    (void)Project::create(file, history);
    const History last = Project::open(file, Access::readOnly).lastWork().value;
    EXPECT_EQ(last.skeleton, history.skeleton);
    EXPECT_EQ(last.leftOut, history.leftOut);
    EXPECT_EQ(last.organs, history.organs);
    EXPECT_EQ(handWork(last.steps, last.skeleton), handWork(history.steps, history.skeleton));
    EXPECT_EQ(last.position, last.steps.size());
    if (seed % 2 == 0) {
      EXPECT_EQ(last.steps.size(), 2U);
    }
  }
}

TEST(Project, ReadsTheLastWorkOfAPlantThatIsPartlyUndone) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 5)}, 5);
  Project project = Project::create(file, edits.history());
  for (int i = 0; i < 60; ++i) {
    const auto act = edits.next();
    project.record(act.kept, act.added, act.position);
    const History last = project.lastWork().value;
    ASSERT_EQ(last.skeleton, edits.history().skeleton) << "after act " << i;
    const auto done = std::span(edits.history().steps).first(edits.history().position);
    ASSERT_EQ(handWork(last.steps, last.skeleton), handWork(done, edits.history().skeleton));
  }
}

// The points of the scan before come first, so that all steps keep theirs.
TEST(Project, GrowsItsScanBySetAsidePointsInEveryState) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  History history{.skeleton = test::fork(3), .leftOut = PointSet::of({1, 5, 7})};
  history.steps = {{.text = "Set points aside", .delta = {}, .points = PointSet::of({2, 7})}};
  history.position = 1;
  const PointSet added = *PointSet::ofRuns({{10, 30}});
  Project project = Project::create(file, history);
  project.setBytes(keptCloudName, "points of the scan before");
  project.setScan(ScanReference{.path = "/a/north.ply", .size = 1, .hash = 2, .bounds = {}});
  project.record(
      1, {}, 1,
      GrownReference{
          .scan = {.path = "/a/both.ply", .size = 3, .hash = 4, .bounds = {}, .isByFile = true},
          .added = added});
  EXPECT_EQ(project.scan()->path, "/a/both.ply");
  EXPECT_TRUE(project.scan()->isByFile);
  EXPECT_FALSE(project.hasBytes(keptCloudName));
  History grown = history;
  grown.leftOut = history.leftOut | added;
  EXPECT_EQ(readBack(file), grown);
  EXPECT_EQ(beginningOf(readBack(file)).leftOut, PointSet::of({1, 2, 5}) | added);
}

TEST(Project, KeepsEachActAsItHappens) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 2)}, 2);
  Project project = Project::create(file, edits.history());
  for (int i = 0; i < 150; ++i) {
    const auto act = edits.next();
    project.record(act.kept, act.added, act.position);
    ASSERT_EQ(readBack(file), edits.history()) << "after act " << i; // while it is open
    if (project.needsSnapshot())
      project.takeSnapshot(edits.history().skeleton, edits.history().leftOut,
                           edits.history().organs);
  }
}

TEST(Project, ReplaysALongHistoryOfAllEdits) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(10'000);
  (void)Project::create(file, history);
  EXPECT_EQ(readBack(file), history);
}

/// Nodes that would make a project read as damaged.
std::vector<Node> unreadableNodes() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {{.radius = infinity},
          {.radius = none},
          {.radius = -1},
          {.position = {0, none, 0}},
          {.position = {0, 0, -infinity}}};
}

TEST(Project, RefusesAnEditThatCouldNotBeReadBack) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(20);
  Project project = Project::create(file, history);
  const NodeId id{static_cast<std::uint32_t>(history.skeleton.idEnd())};
  for (const Node& node : unreadableNodes()) {
    const HistoryStep step{.text = "Measure", .delta = {{{id, std::nullopt, node}}}};
    const std::string problem = test::errorOf([&] {
      project.record(history.position, {&step, 1}, history.position + 1);
    });
    EXPECT_THAT(problem, HasSubstr("not finite"));
    EXPECT_THAT(problem, testing::Not(HasSubstr("\n")));
    EXPECT_EQ(readBack(file), history) << "it is as it was before";
  }
}

TEST(Project, RefusesAPlantThatCouldNotBeReadBack) {
  const fs::path folder = test::freshFolder();
  const History history = withEdits(20);
  Project project = Project::create(folder / "oak.espalier", history);
  for (const Node& node : unreadableNodes()) {
    Skeleton plant;
    (void)plant.add(node);
    EXPECT_THAT(test::errorOf([&] { project.reset(plant); }), HasSubstr("not finite"));
    EXPECT_THAT(test::errorOf([&] { project.takeSnapshot(plant, {}, {}); }),
                HasSubstr("not finite"));
    EXPECT_THAT(
        test::errorOf([&] { (void)Project::create(folder / "new.espalier", {.skeleton = plant}); }),
        HasSubstr("not finite"));
    EXPECT_FALSE(fs::exists(folder / "new.espalier"));
    EXPECT_EQ(readBack(folder / "oak.espalier"), history);
  }
}

TEST(Project, UndoneStepsComeBackByRedo) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(60);
  (void)Project::create(file, history);
  History read = readBack(file);
  const History beginning = beginningOf(history);
  for (std::size_t i = read.position; i < read.steps.size(); ++i) {
    read.steps[i].delta.apply(read.skeleton); // which needs ids that were handed out
    read.leftOut = read.leftOut ^ read.steps[i].points;
  }
  for (std::size_t i = read.steps.size(); i-- > 0;) {
    ASSERT_TRUE(tryToApply(read.steps[i].delta.inverse(), read.skeleton));
    read.leftOut = read.leftOut ^ read.steps[i].points;
  }
  EXPECT_EQ(read.skeleton, beginning.skeleton);
  EXPECT_EQ(read.leftOut, beginning.leftOut);
}

TEST(Project, KeepsWhatWasSetAsideBeforeItsFirstStep) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  History history{.skeleton = test::fork(3), .leftOut = PointSet::of({1, 2, 5})};
  history.steps = {{.text = "Set points aside", .delta = {}, .points = PointSet::of({2, 7})}};
  (void)Project::create(file, history); // the step is undone
  EXPECT_EQ(readBack(file), history);
  history.position = 1;
  history.leftOut = PointSet::of({1, 5, 7});
  Project::open(file, Access::readWrite).record(1, {}, 1);
  EXPECT_EQ(readBack(file), history);
}

TEST(Project, AsksForASnapshotWhenItsJournalIsLongerThanThePlant) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::stick(3)}, 2);
  Project project = Project::create(file, edits.history());
  EXPECT_FALSE(project.needsSnapshot());
  while (!project.needsSnapshot()) {
    const auto act = edits.next();
    project.record(act.kept, act.added, act.position);
  }
  project.takeSnapshot(edits.history().skeleton, edits.history().leftOut, edits.history().organs);
  EXPECT_FALSE(project.needsSnapshot());
  EXPECT_EQ(readBack(file), edits.history());
}

TEST(Project, ForgetsItsHistoryWhenAnotherPlantComes) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  Project project = Project::create(file, withEdits(20));
  project.reset(test::fork(3));
  EXPECT_EQ(readBack(file), History{.skeleton = test::fork(3)});
}

TEST(Project, KeepsDocumentsBytesAndTheirAbsence) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const std::string many(40'000'000, 'p'); // more than one piece
  {
    Project project = Project::create(file, {});
    project.setDocument("view", R"({"zoom":2})");
    project.setDocument("options", "old");
    project.setDocument("options", "");
    project.setBytes("contracted", many);
    project.setBytes("states", "x");
    project.setBytes("states", "");
  }
  const Project project = Project::open(file, Access::readOnly);
  EXPECT_EQ(project.document("view"), R"({"zoom":2})");
  EXPECT_EQ(project.document("options"), "");
  EXPECT_TRUE(project.bytes("contracted") == many);
  EXPECT_EQ(project.bytes("states"), "");
}

TEST(Project, HasBytesOnceTheirLastPieceIsWritten) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  Project project = Project::create(file, {});
  project.setBytes("cloud", "an old one, which is longer");
  PieceWriter writer("cloud", "abcdefgh", 3);
  EXPECT_EQ(writer.fraction(), 0);
  writer.writeNext(project);
  writer.writeNext(project);
  EXPECT_EQ(project.bytes("cloud"), "");
  EXPECT_FALSE(project.hasBytes("cloud"));
  EXPECT_FALSE(writer.isDone());
  writer.writeNext(project);
  EXPECT_TRUE(writer.isDone());
  EXPECT_EQ(writer.fraction(), 1);
  EXPECT_EQ(project.bytes("cloud"), "abcdefgh");
  EXPECT_TRUE(project.hasBytes("cloud"));
  PieceWriter none("cloud", "");
  none.writeNext(project);
  EXPECT_TRUE(none.isDone());
  EXPECT_FALSE(project.hasBytes("cloud"));
}

TEST(Project, HasNoBytesOfAWriteThatWasCanceled) {
  Project project = Project::create(test::freshFolder() / "oak.espalier", {});
  std::stop_source stop;
  const Progress progress(stop.get_token(), [&](double fraction, std::string_view) {
    if (fraction >= 0.5) stop.request_stop();
  });
  const std::string many(4 * PieceWriter::standardSize, 'p');
  EXPECT_THROW(writeBytes(project, "cloud", many, progress), Cancelled);
  EXPECT_FALSE(project.hasBytes("cloud"));
  writeBytes(project, "cloud", many, {});
  EXPECT_TRUE(project.bytes("cloud") == many);
}

TEST(Project, IsWrittenFromTwoThreadsWithoutLosingAnything) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  {
    Project project = Project::create(file, {});
    Project worker = project.another();
    std::jthread thread([&] { writeBytes(worker, "cloud", std::string(8 << 20, 'p'), {}); });
    for (int i = 0; i < 50; ++i)
      project.setDocument("count", std::to_string(i));
  }
  EXPECT_FALSE(ProjectLock::holder(file));
  const Project project = Project::open(file, Access::readOnly);
  EXPECT_EQ(project.bytes("cloud").size(), std::size_t{8} << 20);
  EXPECT_EQ(project.document("count"), "49");
}

TEST(Project, FindsItsScanWhereverItWent) {
  const fs::path folder = test::freshFolder();
  const fs::path scan = folder / "scans" / "oak.xyz";
  fs::create_directories(scan.parent_path());
  write(scan, "0 0 0\n1 1 1\n");
  Project project = Project::create(folder / "oak.espalier", {});
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  project.setScan(ScanReference::of(scan, bounds));
  EXPECT_EQ(project.findScan(), fs::canonical(scan));
  EXPECT_EQ(project.scan()->bounds.max(), bounds.max());

  fs::rename(scan, folder / "renamed.xyz");
  EXPECT_EQ(project.findScan(), fs::canonical(folder / "renamed.xyz")) << "beside the project";
  write(scan, "0 0 0\n1 1 2\n");
  EXPECT_EQ(project.findScan(), fs::canonical(folder / "renamed.xyz"))
      << "another scan of that name";
  fs::remove(folder / "renamed.xyz");
  EXPECT_EQ(project.findScan(), std::nullopt);
}

TEST(Project, FindsItsScanAfterBothMoved) {
  const fs::path folder = test::freshFolder();
  fs::create_directories(folder / "old" / "scans");
  write(folder / "old" / "scans" / "oak.xyz", "0 0 0\n1 1 1\n");
  Project::create(folder / "old" / "oak.espalier", {})
      .setScan(ScanReference::of(folder / "old" / "scans" / "oak.xyz", {}));
  fs::rename(folder / "old", folder / "new");
  EXPECT_EQ(Project::open(folder / "new" / "oak.espalier", Access::readOnly).findScan(),
            fs::canonical(folder / "new" / "scans" / "oak.xyz"));
}

TEST(Project, GetsSmallerWhenCompacted) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(30);
  Project project = Project::create(file, history);
  project.setBytes("contracted", std::string(4'000'000, 'x'));
  project.setBytes("contracted", "");
  project.compact();
  EXPECT_LT(fs::file_size(file), 1'000'000U);
  EXPECT_EQ(project.history().value, history);
}

TEST(Project, ReplacesAFileOfItsName) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, withEdits(20));
  (void)Project::create(file, {.skeleton = test::fork(2)});
  EXPECT_EQ(readBack(file).skeleton, test::fork(2));
  EXPECT_EQ(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()), 1)
      << "nothing is left beside it";
}

TEST(Project, IsMarkedAsOneForOtherPrograms) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, {});
  std::ifstream in(file, std::ios::binary);
  std::string header(100, '\0');
  in.read(header.data(), 100);
  EXPECT_EQ(header.substr(0, 15), "SQLite format 3");
  EXPECT_EQ(header.substr(68, 4), "Espl"); // application id, as file(1) reads it
  EXPECT_TRUE(isProject(file));
  write(file, "0 0 0\n");
  EXPECT_FALSE(isProject(file));
  EXPECT_FALSE(isProject(file.string() + ".none"));
}

TEST(Project, OfReadOnlyAccessIsNotWritten) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, withEdits(5));
  Project project = Project::open(file, Access::readOnly);
  EXPECT_THAT(test::errorOf([&] {
                project.reset({});
                return 0;
              }),
              HasSubstr("read only"));
}

TEST(Project, ReportsThatItWasRemovedReplacedOrMadeReadOnly) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const History history = withEdits(5);
  const auto messageAfter = [&](const auto& mishap) {
    fs::remove(file);
    Project project = Project::create(file, {});
    mishap();
    return test::errorOf([&] {
      project.record(0, history.steps, history.position);
      return 0;
    });
  };
  EXPECT_THAT(messageAfter([&] { fs::remove(file); }), HasSubstr("was removed"));
  EXPECT_THAT(messageAfter([&] {
                fs::copy_file(file, file.string() + "2");
                fs::rename(file.string() + "2", file);
              }),
              HasSubstr("was replaced"));
  EXPECT_THAT(messageAfter([&] { fs::permissions(file, fs::perms::owner_read); }),
              HasSubstr("read-only"));
}

/// While it lives, files of this process cannot grow beyond `bytes`: as on a full disk.
class FullDisk {
public:
  explicit FullDisk(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit low{bytes, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &low);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  void (*before_)(int);
  rlimit limit_{};
};

TEST(Project, SurvivesAFullDisk) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 2)}, 2);
  Project project = Project::create(file, edits.history());
  History saved = edits.history();
  std::string error;
  {
    const FullDisk full(400'000);
    while (error.empty()) {
      const auto act = edits.next();
      error = test::errorOf([&] {
        project.record(act.kept, act.added, act.position);
        return 0;
      });
      if (error.empty()) saved = edits.history();
    }
    EXPECT_THAT(error, HasSubstr("save elsewhere"));
    EXPECT_EQ(project.history().value, saved) << "as before the edit that found no room";
  }
  const History& now = edits.history(); // there is room again: what is missing is written
  project.record(0, now.steps, now.position);
  EXPECT_EQ(readBack(file), now);
}

TEST(Project, ThatCannotBeMadeLeavesNothingBehind) {
  const fs::path folder = test::freshFolder();
  const History history = {.skeleton = test::randomPlant(3000, 1)};
  {
    const FullDisk full(50'000);
    EXPECT_THROW((void)Project::create(folder / "oak.espalier", history), Error);
  }
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_THROW((void)Project::create(folder / "none" / "oak.espalier", history), Error);
}

} // namespace
} // namespace espalier
