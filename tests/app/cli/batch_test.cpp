#include "core/evaluate/registration/registration.h"
#include "core/io/csv.h"
#include "core/io/formats.h"
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::expectRefusal;
using test::namesIn;
using test::Outcome;
using test::runAndSignal;
using test::runProgram;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A folder with a scan of a stick and the sample tree, and one for results.
class Batch : public testing::Test {
protected:
  Batch() {
    std::string stick = "x y z\n";
    for (int i = 0; i < 400; ++i)
      stick +=
          std::to_string(i % 2) + ' ' + std::to_string(i / 2 % 2) + ' ' + std::to_string(i) + '\n';
    test::writeBytes(folder_ / "stick.xyz", stick);
    fs::copy_file(test::sample("young_tree.ply"), folder_ / "tree.ply");
    fs::copy_file(test::sample("young_tree.mtg"), folder_ / "truth.mtg");
  }

  void writeManifest(const std::string& text) const {
    test::writeBytes(folder_ / "plants.csv", text);
  }

  [[nodiscard]] test::Arguments arguments(const test::Arguments& more = {}) const {
    test::Arguments result = {"batch", (folder_ / "plants.csv").string(), "-o", results_.string()};
    result.insert(result.end(), more.begin(), more.end());
    return result;
  }

  [[nodiscard]] Outcome run(const test::Arguments& more = {}) const {
    return runProgram(arguments(more));
  }

  /// What the summary says of a plant in a column.
  [[nodiscard]] std::string cell(const std::string& plant, const std::string& column) const {
    const CsvTable table = readCsv(test::bytesOf(results_ / "summary.csv"), "summary.csv");
    for (const CsvTable::Row& row : table.rows)
      if (row.fields[*table.column("name")] == plant) return row.fields[*table.column(column)];
    return "not listed";
  }

  [[nodiscard]] fs::file_time_type timeOf(const std::string& result) const {
    return fs::last_write_time(results_ / result);
  }

  /// Makes a result old, so that writing it again shows.
  void age(const std::string& result) const {
    fs::last_write_time(results_ / result, timeOf(result) - std::chrono::hours(1));
  }

  fs::path folder_ = test::freshFolder();
  fs::path results_ = folder_ / "out" / "results";
};

TEST_F(Batch, ReconstructsEachPlantAndReportsItInALine) {
  writeManifest("scan,name,reference\nstick.xyz,,\ntree.ply,my tree,truth.mtg\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "espalier: wrote " + (results_ / "summary.csv").string() + ": 2 plants\n");
  EXPECT_THAT(namesIn(results_), ElementsAre("my tree.doubts.json", "my tree.mtg",
                                             "stick.doubts.json", "stick.mtg", "summary.csv"));
  const Skeleton stick = readStructure(results_ / "stick.mtg").value.skeleton;
  EXPECT_EQ(cell("stick", "status"), "done");
  EXPECT_EQ(cell("stick", "points"), "400");
  EXPECT_EQ(cell("stick", "nodes"), std::to_string(stick.size()));
  EXPECT_EQ(cell("stick", "tips"), "1");
  EXPECT_EQ(cell("stick", "height"), "399");
  EXPECT_EQ(cell("stick", "geometric"), "") << "there is no reference";
  EXPECT_GT(std::stod(cell("my tree", "geometric")), 0.8);
  EXPECT_GT(std::stod(cell("my tree", "f")), 0.8);
}

TEST_F(Batch, ListsWhatTraitsMeasures) {
  writeManifest("scan,name\ntree.ply,tree\n");
  ASSERT_EQ(run({"--unit", "m"}).status, 0);
  const std::string mtg = (results_ / "tree.mtg").string();
  const std::string json = (folder_ / "traits.json").string();
  ASSERT_EQ(runProgram({"traits", mtg, "--unit", "m", "--json", json}).status, 0);
  const auto traits = nlohmann::json::parse(test::bytesOf(json));
  const auto expectSame = [&](const char* column, const nlohmann::json& value) {
    const std::string written = cell("tree", column);
    if (value.is_null())
      EXPECT_EQ(written, "") << column;
    else
      EXPECT_NEAR(std::stod(written), value.get<double>(), 1e-4 * value.get<double>()) << column;
  };
  EXPECT_EQ(cell("tree", "unit"), "m");
  expectSame("volume", traits["wood"]["whole"]["volume"]);
  expectSame("crown_area", traits["traits"]["crown"]["area"]);
  expectSame("stem_diameter", traits["breast_height"]["diameter"]);
  ASSERT_EQ(run().status, 0) << "done again, as its unit is not known now";
  EXPECT_EQ(cell("tree", "unit"), "");
  EXPECT_EQ(cell("tree", "stem_diameter"), "");
}

TEST_F(Batch, NotesWhatIsOddAboutAScan) {
  test::writeBytes(folder_ / "stick.xyz",
                   test::bytesOf(folder_ / "stick.xyz") + "90000 0 0\nnan 0 0\n");
  writeManifest("scan\nstick.xyz\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: stick: " + (folder_ / "stick.xyz").string() +
                                     ": 1 of 402 points are not finite"));
  EXPECT_THAT(outcome.err, HasSubstr("/stick.xyz: 1 point lies far from all others"));
}

TEST_F(Batch, TurnsAPlantOntoItsReferenceAndSaysSo) {
  const auto turn = [&](const Eigen::Vector3d& axis, double degrees) {
    const Eigen::Isometry3d motion(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
    writeStructure(folder_ / "truth.mtg",
                   moved(readStructure(folder_ / "truth.mtg").value.skeleton, motion));
  };
  turn(Eigen::Vector3d::UnitZ(), 90);
  writeManifest("scan,reference\ntree.ply,truth.mtg\n");
  EXPECT_THAT(run().err, HasSubstr("note: tree: the plant lay "));
  const double turned = std::stod(cell("tree", "geometric"));
  EXPECT_GT(turned, 0.8);
  const Outcome kept = run({"--no-rotate"});
  EXPECT_THAT(kept.err, Not(HasSubstr("of them done before")));
  EXPECT_THAT(kept.err, HasSubstr("note: tree: the two fit poorly"));
  EXPECT_LT(std::stod(cell("tree", "geometric")), turned - 0.1);
  EXPECT_THAT(run({"--no-rotate"}).err, HasSubstr("1 of them done before"));
}

// A plant that lies, and a reference turned about the axis along which it grew.
TEST_F(Batch, TurnsAPlantAboutTheAxisThatPointsUp) {
  const auto scan = readPoints(folder_ / "tree.ply").value;
  std::string text = "x y z\n";
  for (Eigen::Index i = 0; i < scan.size(); ++i) { // along x, as turned by 90 degrees about y
    const Eigen::Vector3d place = scan.position(i);
    text += std::to_string(place.z()) + ' ' + std::to_string(place.y()) + ' ' +
            std::to_string(-place.x()) + '\n';
  }
  test::writeBytes(folder_ / "lying.xyz", text);
  const Eigen::Isometry3d lie(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitX()) *
                              Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()));
  writeStructure(folder_ / "lying.mtg",
                 moved(readStructure(folder_ / "truth.mtg").value.skeleton, lie));
  writeManifest("scan,reference\nlying.xyz,lying.mtg\n");
  EXPECT_EQ(run({"--up", "x"}).status, 0);
  EXPECT_GT(std::stod(cell("lying", "geometric")), 0.8);
}

TEST_F(Batch, ReportsColumnsThatItDoesNotKnow) {
  writeManifest("scan,refrence,Species\nstick.xyz,truth.mtg,pine\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("plants.csv: passed over 'refrence', 'Species', which are no "
                                     "columns of a plant: these are scan, name, reference and "
                                     "root"));
  writeManifest("Scan,Name\nstick.xyz,stick\n");
  EXPECT_THAT(run().err, Not(HasSubstr("passed over '")));
}

TEST_F(Batch, GivesWhatReconstructGives) {
  writeManifest("scan\ntree.ply\n");
  ASSERT_EQ(run({"--set", "prune.length=0.3"}).status, 0);
  ASSERT_EQ(runProgram({"reconstruct", (folder_ / "tree.ply").string(), "-o",
                        (folder_ / "one.mtg").string(), "--set", "prune.length=0.3"})
                .status,
            0);
  EXPECT_TRUE(test::bytesOf(results_ / "tree.mtg") == test::bytesOf(folder_ / "one.mtg"));
}

TEST_F(Batch, GoesOnAfterABadPlantAndNamesItInTheEnd) {
  test::writeBytes(folder_ / "bad.xyz", "x y z\n1 2 three\n");
  writeManifest("scan\nbad.xyz\nmissing.ply\nstick.xyz\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("\nespalier: bad: "));
  EXPECT_THAT(outcome.err, HasSubstr("\nespalier: missing: "));
  EXPECT_THAT(outcome.err, HasSubstr("\nespalier: 2 of 3 plants failed: "));
  EXPECT_THAT(namesIn(results_), ElementsAre("stick.doubts.json", "stick.mtg", "summary.csv"));
  EXPECT_EQ(cell("stick", "status"), "done");
  EXPECT_EQ(cell("bad", "status"), "failed");
  EXPECT_THAT(cell("bad", "problem"), HasSubstr("bad.xyz, line 2"));
  EXPECT_THAT(cell("missing", "problem"), HasSubstr("missing.ply"));
}

TEST_F(Batch, TakesAPlantWhoseLineIsWrongForAFailedOne) {
  writeManifest("scan,name,root\nstick.xyz,a,1 2\n,b,\nstick.xyz,../c,\nstick.xyz,d,\n"
                "stick.xyz,d,\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("\nespalier: a: " + (folder_ / "plants.csv").string() +
                                     ", line 2: root '1 2': write lowest, or three numbers as X Y "
                                     "Z\n"));
  EXPECT_THAT(outcome.err, HasSubstr("\nespalier: 4 of 5 plants failed: "));
  EXPECT_THAT(namesIn(results_), ElementsAre("d.doubts.json", "d.mtg", "summary.csv"));
  EXPECT_EQ(cell("d", "status"), "done");
  EXPECT_EQ(cell("a", "status"), "failed");
  EXPECT_THAT(cell("b", "problem"), HasSubstr("line 3: no scan is named"));
  EXPECT_THAT(cell("line 4", "problem"), HasSubstr("line 4: the name '../c' is none for a file"));
  EXPECT_THAT(cell("line 6", "problem"), HasSubstr("line 6: the name 'd' comes twice"));
}

TEST_F(Batch, DropsAFailureThatLeftTheManifest) {
  writeManifest("scan,root\nmissing.ply,\n,lowest\n");
  ASSERT_EQ(run().status, 1);
  writeManifest("scan\nstick.xyz\n");
  ASSERT_EQ(run().status, 0);
  EXPECT_EQ(cell("missing", "status"), "not listed");
  EXPECT_EQ(cell("line 3", "status"), "not listed");
}

TEST_F(Batch, PassesOverWhatIsDoneAndTriesTheRestAgain) {
  writeManifest("scan\nstick.xyz\nlate.xyz\n");
  ASSERT_EQ(run().status, 1);
  age("stick.mtg");
  const auto before = timeOf("stick.mtg");
  const std::string seconds = cell("stick", "seconds");
  fs::copy_file(folder_ / "stick.xyz", folder_ / "late.xyz");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("2 plants, 1 of them done before\n"));
  EXPECT_EQ(timeOf("stick.mtg"), before);
  EXPECT_EQ(cell("stick", "seconds"), seconds);
  EXPECT_EQ(cell("late", "status"), "done");
  EXPECT_EQ(cell("late", "problem"), "");
}

TEST_F(Batch, DoesAgainWhatChangedInAnyWay) {
  const std::string plain = "scan\nstick.xyz\n";
  const std::string rooted = "scan,root\nstick.xyz,0 0 399\n";
  writeManifest(plain);
  ASSERT_EQ(run().status, 0);
  const auto isDoneAgain = [&](const test::Arguments& more) {
    age("stick.mtg");
    const auto before = timeOf("stick.mtg");
    EXPECT_EQ(run(more).status, 0);
    return timeOf("stick.mtg") != before;
  };
  EXPECT_FALSE(isDoneAgain({}));
  EXPECT_TRUE(isDoneAgain({"--set", "prune.length=9"}));
  EXPECT_TRUE(isDoneAgain({"--mtg-scales", "plant-axis-node"}));
  writeManifest(rooted);
  EXPECT_TRUE(isDoneAgain({}));
  EXPECT_FALSE(isDoneAgain({}));
  test::writeBytes(folder_ / "stick.xyz", test::bytesOf(folder_ / "stick.xyz") + "0 0 400\n");
  EXPECT_TRUE(isDoneAgain({}));
  for (const char* result : {"stick.mtg", "stick.doubts.json"}) {
    fs::remove(results_ / result);
    EXPECT_EQ(run().status, 0);
    EXPECT_TRUE(fs::exists(results_ / result));
  }
}

TEST_F(Batch, ReadsScansAsIsAsked) {
  writeManifest("scan\nstick.xyz\n");
  ASSERT_EQ(run({"--columns", "z,y,x", "--up", "x"}).status, 0);
  EXPECT_EQ(cell("stick", "height"), "399");
  ASSERT_EQ(run({"--columns", "z,y,x", "--up", "x", "--most", "200"}).status, 0);
  EXPECT_EQ(cell("stick", "points"), "200") << "it is done again";
}

TEST_F(Batch, SeeksScansFromWhereOneIsIfTheTableIsPiped) {
  writeManifest("scan\nstick.xyz\n");
  const std::string piped = "cd '" + folder_.string() + "' && cat plants.csv | '" +
                            ESPALIER_PROGRAM + "' batch /dev/stdin -o out/results 2>said.txt";
  EXPECT_EQ(std::system(piped.c_str()), 0) << test::bytesOf(folder_ / "said.txt");
  EXPECT_EQ(cell("stick", "status"), "done");
}

TEST_F(Batch, StartsAtTheRootThatThePlantHas) {
  writeManifest("scan,name,root\nstick.xyz,down,\"0,0,399\"\nstick.xyz,up,lowest\n");
  ASSERT_EQ(run().status, 0);
  const auto rootOf = [&](const std::string& file) {
    const Skeleton skeleton = readStructure(results_ / file).value.skeleton;
    return skeleton[skeleton.roots().front()].position.z();
  };
  EXPECT_GT(rootOf("down.mtg"), 390);
  EXPECT_LT(rootOf("up.mtg"), 9);
}

TEST_F(Batch, KeepsALineOfPlantsThatLeftTheManifest) {
  writeManifest("scan,name\nstick.xyz,a\nstick.xyz,b\n");
  ASSERT_EQ(run().status, 0);
  writeManifest("scan,name\nstick.xyz,c\nstick.xyz,b\n");
  ASSERT_EQ(run().status, 0);
  const CsvTable table = readCsv(test::bytesOf(results_ / "summary.csv"), "summary.csv");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].fields[0], "c") << "in the order of the manifest";
  EXPECT_EQ(table.rows[1].fields[0], "b");
  EXPECT_EQ(table.rows[2].fields[0], "a");
}

TEST_F(Batch, StoppedLeavesAWholeSummaryAndCanGoOn) {
  writeManifest("scan\nstick.xyz\ntree.ply\n");
  const test::Arguments slow = {"--threads", "1", "--set", "contract.neighbors=64"};
  // The bar of the second plant shows that the first is written.
  const Outcome stopped = runAndSignal(arguments(slow), "2 of 2, tree: Contract", SIGINT);
  EXPECT_EQ(stopped.status, 130);
  EXPECT_THAT(stopped.err, HasSubstr("espalier: stopped after 1 of 2 plants; start again"));
  EXPECT_THAT(namesIn(results_), ElementsAre("stick.doubts.json", "stick.mtg", "summary.csv"));
  EXPECT_EQ(cell("stick", "status"), "done");
  EXPECT_EQ(cell("tree", "status"), "not listed");
  const Outcome rest = run(slow);
  EXPECT_EQ(rest.status, 0);
  EXPECT_THAT(rest.err, HasSubstr("1 of them done before"));
  EXPECT_EQ(cell("tree", "status"), "done");
}

TEST_F(Batch, RefusesABadManifestBeforeAnythingIsDone) {
  const auto refuses = [&](const std::string& text, const std::string& why) {
    writeManifest(text);
    expectRefusal(run(), 1, {"plants.csv", why});
    EXPECT_FALSE(fs::exists(results_));
  };
  refuses("", "line 1: there are no names");
  refuses("file\nstick.xyz\n", "line 1: there is no column scan");
  refuses("scan\n", "no plant is listed");
  refuses("scan,root\nstick.xyz,0,0,399\n", "line 2: expected 2 fields, found 4");
  expectRefusal(runProgram({"batch", (folder_ / "none.csv").string(), "-o", results_.string()}), 1,
                {"none.csv: there is no such file"});
}

TEST_F(Batch, RefusesWhatItCannotDo) {
  writeManifest("scan\nstick.xyz\n");
  expectRefusal(run({"--set", "contract.size=3"}), 2, {"no option \"size\""});
  test::writeBytes(folder_ / "out", "a file");
  expectRefusal(run(), 1, {"is no folder and cannot be made one"});
  fs::remove(folder_ / "out");
  fs::create_directories(results_);
  test::writeBytes(results_ / "summary.csv", "year,yield\n2024,3\n");
  expectRefusal(run(), 1, {"summary.csv: is no summary of a batch"});
  EXPECT_EQ(test::bytesOf(results_ / "summary.csv"), "year,yield\n2024,3\n");
}

TEST_F(Batch, NeverReplacesWhatItReads) {
  writeManifest("scan,name,reference\ntree.ply,truth,truth.mtg\n");
  const std::string before = test::bytesOf(folder_ / "truth.mtg");
  expectRefusal(runProgram({"batch", (folder_ / "plants.csv").string(), "-o", folder_.string()}), 1,
                {"truth.mtg: is what is read, and would be replaced"});
  EXPECT_EQ(test::bytesOf(folder_ / "truth.mtg"), before);
}

} // namespace
} // namespace espalier
