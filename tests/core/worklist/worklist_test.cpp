#include "core/base/error.h"
#include "core/project/content_hash.h"
#include "core/skeleton/edits.h"
#include "core/worklist/worklist.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct WorklistTest : testing::Test {
  fs::path folder = test::freshFolder();

  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
    return fs::weakly_canonical(folder / name);
  }
  fs::path scan(const std::string& name) const {
    return write(name, "0 0 0\n0 0 1\n" + std::to_string(name.size()) + " 0 2\n");
  }
  /// A project of `scan`, in which `author` moved a node.
  fs::path project(const std::string& name, const fs::path& of, const std::string& author) const {
    History history{.skeleton = test::fork(3)};
    SkeletonEditor editor(history.skeleton);
    moveNode(editor, NodeId{3}, {9, 9, 9});
    history.steps.push_back(
        {.text = "Move", .author = author, .time = 1, .delta = editor.commit()});
    history.position = 1;
    Project made = Project::create(folder / name, history);
    if (!of.empty()) made.setScan(ScanReference::of(of, {}));
    return fs::weakly_canonical(folder / name);
  }
  static KnownWorks readAll(const Worklist& list) {
    KnownWorks known;
    for (const fs::path& each : list.projects) {
      try {
        const Project read = Project::open(each, Access::readOnly);
        known[each] = {.state = workState(read, read.lastWork().value)};
      } catch (const Error& error) {
        known[each] = {.problem = messageOf(error)};
      }
    }
    for (const fs::path& each : scansToHash(list, known))
      known[each] = {.hash = contentHashOfFile(each)};
    return known;
  }
  [[nodiscard]] std::vector<WorklistRow> rows(const fs::path& place) const {
    const Worklist list = readWorklist(place);
    return rowsOf(list, readAll(list));
  }
  static std::vector<std::string> filesOf(const std::vector<WorklistRow>& rows) {
    std::vector<std::string> names;
    for (const WorklistRow& row : rows)
      names.push_back(row.file().filename().string());
    return names;
  }
};

TEST_F(WorklistTest, OfAFolderHasItsProjectsAndTheScansWithoutOne) {
  project("b.espalier", scan("b.xyz"), "Anna");
  scan("a.xyz");
  write("notes.txt", "1 2 3\n");
  write("results.csv", "plant,score\na,1\n");
  write("expert.mtg", "MTG :");
  write(".hidden.xyz", "0 0 0\n");
  write("below/c.xyz", "0 0 0\n");
  const std::vector<WorklistRow> found = rows(folder);
  EXPECT_THAT(filesOf(found), ElementsAre("a.xyz", "b.espalier"));
  EXPECT_EQ(found[0].stage(), WorkStage::toDo);
  EXPECT_EQ(found[1].stage(), WorkStage::inReview);
  EXPECT_EQ(found[1].scan.filename(), "b.xyz");
  EXPECT_EQ(found[1].annotator, "Anna");
}

TEST_F(WorklistTest, ShowsAScanUntilItsProjectIsRead) {
  project("b.espalier", scan("b.xyz"), "Anna");
  const Worklist list = readWorklist(folder);
  const std::vector<WorklistRow> unread = rowsOf(list, {});
  EXPECT_THAT(filesOf(unread), ElementsAre("b.espalier", "b.xyz"));
  for (const WorklistRow& row : unread)
    EXPECT_FALSE(row.isRead) << "to do or not is not known yet";
  EXPECT_THAT(filesOf(rowsOf(list, readAll(list))), ElementsAre("b.espalier"));
}

TEST_F(WorklistTest, KnowsAScanThatWasMovedWithItsProject) {
  const fs::path before = folder / "before";
  fs::create_directories(before);
  project("b.espalier", scan("before/b.xyz"), "Anna");
  fs::rename(before / "b.xyz", folder / "b.xyz");
  EXPECT_THAT(filesOf(rows(folder)), ElementsAre("b.espalier"));
  write("b.xyz", "0 0 0\n"); // another scan, which only has its name
  EXPECT_THAT(filesOf(rows(folder)), ElementsAre("b.espalier", "b.xyz"));
}

TEST_F(WorklistTest, DoesNotTakeAScanOfOneNameAndSizeForAnother) {
  const fs::path first = write("first/plot.xyz", "0 0 0\n0 0 1\n1 0 2\n");
  write("second/plot.xyz", "0 0 0\n0 0 1\n2 0 2\n");
  project("first/plot.espalier", first, "Anna");
  const fs::path table = write("list.csv", "file\nfirst/plot.xyz\nsecond/plot.xyz\n");
  EXPECT_THAT(filesOf(rows(table)), ElementsAre("plot.espalier", "plot.xyz"));
  fs::rename(folder / "first", folder / "moved"); // where it was found last, there is none now
  write("list.csv", "file\nmoved/plot.xyz\nsecond/plot.xyz\n");
  const Worklist list = readWorklist(table);
  KnownWorks known = readAll(list);
  EXPECT_THAT(filesOf(rowsOf(list, known)), ElementsAre("plot.espalier", "plot.xyz"));
  for (const char* scan : {"moved/plot.xyz", "second/plot.xyz"})
    known.erase(fs::weakly_canonical(folder / scan));
  EXPECT_EQ(scansToHash(list, known).size(), 2U);
  for (const WorklistRow& row : rowsOf(list, known)) {
    EXPECT_FALSE(row.isRead) << "what they hold is not known yet";
    EXPECT_EQ(row.file().filename(), "plot.xyz");
  }
}

TEST_F(WorklistTest, KnowsAPlantThatIsListedByItsProjectAndByItsScan) {
  project("a.espalier", scan("a.xyz"), "Anna");
  const std::vector<WorklistRow> found = rows(write("list.csv", "file\na.xyz\na.espalier\n"));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0].problem);
  EXPECT_THAT(inEnglish(found[1].problem.value()),
              HasSubstr("a line before means this plant, too"));
}

TEST_F(WorklistTest, OfATableWaitsForTheProjectOfTheAnnotator) {
  const fs::path of = scan("a.xyz");
  const fs::path anna = project("a.espalier", of, "Anna");
  project("z.espalier", of, "Ben");
  const Worklist list = readWorklist(write("list.csv", "file,annotator\na.xyz,Ben\n"));
  KnownWorks known = readAll(list);
  EXPECT_EQ(filesOf(rowsOf(list, known)).front(), "z.espalier");
  std::erase_if(known, [&](const auto& each) { return each.first != anna; });
  EXPECT_FALSE(rowsOf(list, known).front().isRead);
}

TEST_F(WorklistTest, TakesALinkForTheFileItLeadsTo) {
  const fs::path of = project("plants/a.espalier", scan("plants/a.xyz"), "Anna");
  fs::create_directories(folder / "today");
  fs::create_symlink(of, folder / "today" / "first.espalier");
  fs::create_symlink(of, folder / "today" / "second.espalier");
  const std::vector<WorklistRow> found = rows(folder / "today");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].file(), of);
}

TEST_F(WorklistTest, SaysWhatIsWrongWithAScan) {
  const fs::path of = scan("a.xyz");
  const Worklist list = readWorklist(folder);
  const ShownMessage problem{"it is broken"};
  EXPECT_EQ(rowsOf(list, {{of, {.problem = problem}}}).front().problem, problem);
}

TEST_F(WorklistTest, SaysThatANameIsNoUtf8) {
  write("\xff.xyz", "0 0 0\n");
  EXPECT_THAT(inEnglish(rows(folder).front().problem.value()),
              HasSubstr("its name is no UTF-8: rename it"));
  EXPECT_THAT(inEnglish(rows(write("list.csv", "file\n\xff.xyz\n")).front().problem.value()),
              HasSubstr("is no UTF-8: rename the file"));
}

TEST_F(WorklistTest, KeepsTheBeginningOfLongFields) {
  scan("a.xyz");
  const std::string longNote(100'000, 'x');
  const std::string letters = "\"" + std::string(199, 'y') + "é…\"";
  std::vector<WorklistRow> found =
      rows(write("list.csv", "file,note,other\na.xyz," + longNote + "," + letters + "\n"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].others[0], std::string(200, 'x') + "…");
  EXPECT_EQ(found[0].others[1], std::string(199, 'y') + "…") << "no letter is cut in two";
  found = rows(write("list.csv", "file,annotator\na.xyz," + longNote + "\n"));
  EXPECT_THAT(inEnglish(found[0].problem.value()),
              HasSubstr("line 2: the annotator has over 200 bytes"));
  EXPECT_LT(found[0].annotator.size(), 300U);
}

TEST_F(WorklistTest, FindsAProjectInAFolderBelowAnother) {
  project("z.espalier", scan("z.xyz"), "Anna");
  project("c/a.espalier", scan("c/a.xyz"), "Anna");
  const Worklist list = readWorklist(write("list.csv", "file\nz.xyz\nc/a.xyz\n"));
  EXPECT_TRUE(std::ranges::is_sorted(list.projects)) << "they are looked up by halving";
}

TEST_F(WorklistTest, FindsTheSecondAnnotatorOfAScan) {
  const fs::path of = scan("a.xyz");
  const fs::path anna = project("a-anna.espalier", of, "Anna");
  const fs::path ben = project("a-ben.espalier", of, "Ben");
  project("b.espalier", scan("other.xyz"), "Carla");
  const std::vector<WorklistRow> found = rows(folder);
  ASSERT_THAT(filesOf(found), ElementsAre("a-anna.espalier", "a-ben.espalier", "b.espalier"));
  EXPECT_EQ(found[0].second, "Ben");
  EXPECT_EQ(found[0].secondProject, ben);
  EXPECT_EQ(found[1].second, "Anna");
  EXPECT_EQ(found[1].secondProject, anna);
  EXPECT_EQ(found[2].second, "");
}

TEST_F(WorklistTest, ADamagedProjectIsARowThatSaysSo) {
  scan("a.xyz");
  write("b.espalier", "no project");
  const std::vector<WorklistRow> found = rows(folder);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(inEnglish(found[1].problem.value()), HasSubstr("is no project of Espalier"));
  EXPECT_FALSE(found[1].state);
  EXPECT_FALSE(found[0].problem);
}

TEST_F(WorklistTest, OfATableHasItsLinesWithWhatTheySayBeside) {
  const fs::path of = scan("scans/a.xyz");
  project("scans/a.espalier", of, "Anna");
  project("scans/a2.espalier", of, "Ben");
  scan("scans/unnamed.xyz");
  project("b.espalier", {}, "Anna");
  const fs::path table = write("list.csv", "plot;file;annotator;Second Annotator;note\n"
                                           "1;scans/a.xyz;;Ben;tall\n"
                                           "2;b.espalier;Zoe;;\n");
  const Worklist list = readWorklist(table);
  EXPECT_THAT(list.others, ElementsAre("plot", "note"));
  const std::vector<WorklistRow> found = rows(table);
  ASSERT_THAT(filesOf(found), ElementsAre("a.espalier", "b.espalier"));
  EXPECT_EQ(found[0].annotator, "Anna");
  EXPECT_EQ(found[0].second, "Ben");
  EXPECT_EQ(found[0].secondProject.filename(), "a2.espalier");
  EXPECT_THAT(found[0].others, ElementsAre("1", "tall"));
  EXPECT_EQ(found[1].annotator, "Zoe") << "as the table says";
}

TEST_F(WorklistTest, TakesOfSeveralProjectsOfAScanThatOfTheAnnotator) {
  const fs::path of = scan("a.xyz");
  project("a.espalier", of, "Anna");
  project("z.espalier", of, "Ben");
  const auto fileOf = [&](const std::string& annotator) {
    const fs::path table = write("list.csv", "file,annotator\na.xyz," + annotator + "\n");
    return filesOf(rows(table)).front();
  };
  EXPECT_EQ(fileOf("Ben"), "z.espalier");
  EXPECT_EQ(fileOf("Anna"), "a.espalier");
  EXPECT_EQ(fileOf("Nobody"), "a.espalier") << "it is named like the scan";
}

TEST_F(WorklistTest, ALineThatCannotBeUsedSaysWhyAndTheRestGoesOn) {
  scan("a.xyz");
  write("plant.mtg", "MTG :");
  const fs::path table = write("list.csv", "file,annotator\n"
                                           "missing.las,Anna\n"
                                           ",Anna\n"
                                           "plant.mtg\n"
                                           "a.xyz\n"
                                           "a.xyz\n");
  const std::vector<WorklistRow> found = rows(table);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(inEnglish(found[0].problem.value()),
            "list.csv, line 2: there is no file 'missing.las': correct its "
            "name, or take the line out");
  EXPECT_EQ(found[0].named, "missing.las");
  EXPECT_EQ(inEnglish(found[1].problem.value()),
            "list.csv, line 3: no file is named: write a project or a scan");
  EXPECT_EQ(inEnglish(found[2].problem.value()),
            "list.csv, line 4: 'plant.mtg' is neither a project nor a scan: "
            "name one of these");
  EXPECT_FALSE(found[3].problem);
  EXPECT_EQ(found[3].file().filename(), "a.xyz");
  EXPECT_EQ(inEnglish(found[4].problem.value()),
            "list.csv, line 6: 'a.xyz' came before: take the line out");
}

TEST_F(WorklistTest, TakesTheTableOfABatch) {
  scan("a.xyz");
  const std::vector<WorklistRow> found = rows(write("list.csv", "scan,unit\na.xyz,mm\n"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].file().filename(), "a.xyz");
  EXPECT_EQ(found[0].others, std::vector<std::string>{"mm"});
}

TEST_F(WorklistTest, RefusesAPlaceWithoutAPlant) {
  const auto refusal = [](const fs::path& place) -> std::string {
    try {
      (void)readWorklist(place);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal(folder), HasSubstr("holds no project and no scan itself"));
  EXPECT_THAT(refusal(write("a.csv", "plant\na.xyz\n")),
              HasSubstr("there is no column 'file': name the columns in the first line, as "
                        "'file,annotator,second annotator'"));
  EXPECT_THAT(refusal(write("b.csv", "file\n")), HasSubstr("no plant is listed"));
  EXPECT_THAT(refusal(folder / "nowhere.csv"), HasSubstr("nowhere.csv"));
}

} // namespace
} // namespace espalier
