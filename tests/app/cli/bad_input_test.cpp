// What is no scan is refused in one line that names the file and what to try; nothing is written.
#include "tests/app/cli/program.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::expectRefusal;
using test::namesIn;
using test::runProgram;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint64_t million = 1'000'000;

struct BadScan {
  const char* name;
  const char* file;
  std::string bytes;
  const char* advice;
  bool canBeRead = false; // it is only no plant
};

void PrintTo(const BadScan& scan, std::ostream* out) {
  *out << scan.name;
}

std::string cutShort(const std::string& bytes) {
  return bytes.substr(0, bytes.size() - bytes.size() / 3);
}

std::string pcdPromising(const std::string& points) {
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + points +
         "\nHEIGHT 1\nPOINTS " + points + "\nDATA binary\n" + std::string(120, '\1');
}

std::string plyPromising(const std::string& points) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + points +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
         std::string(120, '\1');
}

std::vector<BadScan> badScans() {
  const std::string coincident = [] {
    std::string text;
    for (int i = 0; i < 200; ++i)
      text += "500000.25 4000000.5 100\n";
    return text;
  }();
  return {
      {"Empty", "empty.ply", "", "copy or export it again"},
      {"Blank", "blank.xyz", " \n\n\t\n", "copy or export it again"},
      {"Words", "words.xyz", "no numbers here\nnor here are any\n", "no points"},
      {"WordsBetweenNumbers", "half.xyz", "1 2 3\n4 5 6\n7 eight 9\n", "line 3: expected a num"},
      {"NoPointIsFinite", "nan.xyz", "nan nan nan\n1 inf 2\n-inf 3 4\n", "export it again"},
      {"CutPly", "cut.ply", cutShort(test::bytesOf(test::sample("young_tree.ply"))),
       "cut short or damaged, copy or export it again"},
      {"CutPlyHeader", "cut.ply", "ply\nformat ascii 1.0\nelement ver", "line 3: expected"},
      {"CutLas", "cut.las", cutShort(test::lasFile({.points = 1000})),
       "cut short or damaged, copy or export it again"},
      {"CutLasHeader", "cut.las", test::lasFile({}).substr(0, 100), "copy or export it again"},
      {"PlyOfTooManyPoints", "vast.ply", plyPromising("1000000000000"),
       "promises 1000000000000 points"},
      {"LasOfTooManyPoints", "vast.las",
       test::lasFile({.minorVersion = 4, .format = 6, .promised = million * million}),
       "promises 1000000000000 points"},
      {"PcdOfTooManyPoints", "vast.pcd", pcdPromising("1000000000000"),
       "promises 1000000000000 points"},
      {"LazWithoutItsRecord", "oak.laz", test::lasFile({.formatBits = 0x80}),
       "copy or export it again"},
      {"UnknownKind", "oak.docx", "PK\3\4", "can be read: PLY (.ply)"},
      {"OnePoint", "one.xyz", "1 2 3\n", "at least 2 points: check the scan", true},
      {"AllPointsEqual", "same.xyz", coincident, "at the same place: check the scan", true}};
}

class BadScans : public testing::TestWithParam<BadScan> {
protected:
  BadScans() : folder_(test::freshFolder()), scan_((folder_ / GetParam().file).string()) {
    test::writeBytes(scan_, GetParam().bytes);
  }

  /// Expects the refusal, and that nothing is written, whether there is an output already or not.
  void expectRefused(test::Arguments command, const std::string& output) const {
    command.insert(command.end(), {scan_, "-o", (folder_ / output).string()});
    expectRefusal(runProgram(command), 1, {GetParam().file, GetParam().advice});
    EXPECT_THAT(namesIn(folder_), ElementsAre(GetParam().file));

    test::writeBytes(folder_ / output, "precious");
    expectRefusal(runProgram(command), 1, {GetParam().file, GetParam().advice});
    EXPECT_EQ(test::bytesOf(folder_ / output), "precious");
    fs::remove(folder_ / output);
    EXPECT_THAT(namesIn(folder_), ElementsAre(GetParam().file));
  }

  fs::path folder_;
  std::string scan_;
};

TEST_P(BadScans, AreNotReconstructed) {
  expectRefused({"reconstruct"}, "result.mtg");
}

TEST_P(BadScans, AreNotContracted) {
  expectRefused({"contract"}, "result.ply");
}

TEST_P(BadScans, AreNeitherDrawnNorWarnedOf) {
  if (!GetParam().canBeRead) {
    expectRefused({"picture"}, "result.png");
    expectRefusal(runProgram({"info", scan_}), 1, {GetParam().file, GetParam().advice});
    return;
  }
  const std::string picture = (folder_ / "result.png").string();
  const auto drawn = runProgram({"picture", scan_, "-o", picture, "--width", "64"});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(runProgram({"info", scan_}).status, 0);
}

INSTANTIATE_TEST_SUITE_P(All, BadScans, testing::ValuesIn(badScans()),
                         [](const auto& scan) { return std::string(scan.param.name); });

TEST(BadInput, PointsThatAreNotFiniteAreLeftOutWithANote) {
  const fs::path folder = test::freshFolder();
  const std::string scan = (folder / "some.xyz").string();
  test::writeBytes(scan, "0 0 0\n0 0 1\nnan 0 2\n0 0 2\n0 inf 3\n0 0 3\n");
  const auto outcome = runProgram({"convert", scan, (folder / "all.xyz").string()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "espalier: note: " + scan +
                ": 2 of 6 points are not finite, or beyond any plant, and are left out\n"
                "espalier: wrote " +
                (folder / "all.xyz").string() + ": 4 points\n");
  EXPECT_THAT(test::bytesOf(folder / "all.xyz"), testing::Not(HasSubstr("n")));
}

TEST(BadInput, AMissingFileIsNamed) {
  const fs::path folder = test::freshFolder();
  const std::string missing = (folder / "missing.ply").string();
  const std::string output = (folder / "result.mtg").string();
  const std::vector<std::string> parts = {missing + ": there is no such file: check its name"};
  expectRefusal(runProgram({"reconstruct", missing, "-o", output}), 1, parts);
  expectRefusal(runProgram({"info", missing}), 1, parts);
  expectRefusal(runProgram({"convert", missing, output}), 1, parts);
  expectRefusal(runProgram({"evaluate", missing, test::sample("young_tree.mtg")}), 1, parts);
  expectRefusal(runProgram({"evaluate", test::sample("young_tree.mtg"), missing}), 1, parts);
  expectRefusal(runProgram({"simulate", "--from", missing, "-o", (folder / "x").string()}), 1,
                parts);
  expectRefusal(runProgram({"batch", missing, "-o", (folder / "x").string()}), 1, parts);
  expectRefusal(runProgram({"picture", missing, "-o", (folder / "x.png").string()}), 1, parts);
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadInput, APresetThatIsNoneIsNamed) {
  const fs::path folder = test::freshFolder();
  const std::string output = (folder / "result.mtg").string();
  expectRefusal(runProgram({"reconstruct", test::sample("young_tree.ply"), "-o", output, "--preset",
                            "thessis"}),
                1,
                {"thessis: there is no such preset or file",
                 "default, thesis, leaves, bare, needles, in_leaf, herb, grass, plot, or"});
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadInput, AFolderIsNoFile) {
  const fs::path folder = test::freshFolder();
  const std::string inside = (folder / "inside").string();
  fs::create_directory(inside);
  const std::string output = (folder / "result.mtg").string();
  const std::vector<std::string> parts = {inside, "is a folder, choose a file in it"};
  expectRefusal(runProgram({"reconstruct", inside, "-o", output}), 1, parts);
  expectRefusal(runProgram({"evaluate", inside, test::sample("young_tree.mtg")}), 1, parts);
  expectRefusal(runProgram({"batch", inside, "-o", (folder / "results").string()}), 1, parts);
  expectRefusal(
      runProgram({"reconstruct", test::sample("young_tree.ply"), "-o", output, "--preset", inside}),
      1, parts);
  EXPECT_THAT(namesIn(folder), ElementsAre("inside"));
}

TEST(BadInput, AFileThatMayNotBeReadIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read anything";
  const fs::path folder = test::freshFolder();
  const std::string scan = (folder / "secret.xyz").string();
  test::writeBytes(scan, "1 2 3\n");
  fs::permissions(scan, fs::perms::none);
  expectRefusal(runProgram({"info", scan}), 1, {scan, "may not be read", "change its rights"});
}

TEST(BadInput, AStructureIsNoScan) {
  const fs::path folder = test::freshFolder();
  const std::string structure = test::sample("young_tree.mtg");
  const std::vector<std::string> parts = {"young_tree.mtg: holds a structure", "choose a scan"};
  expectRefusal(runProgram({"reconstruct", structure, "-o", (folder / "a.mtg").string()}), 1,
                parts);
  expectRefusal(runProgram({"contract", structure, "-o", (folder / "a.ply").string()}), 1, parts);
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadInput, AScanIsNoStructure) {
  const fs::path folder = test::freshFolder();
  const std::string scan = test::sample("young_tree.ply");
  const std::string structure = test::sample("young_tree.mtg");
  const std::vector<std::string> parts = {"young_tree.ply: holds points", "choose an MTG"};
  expectRefusal(runProgram({"evaluate", scan, structure}), 1, parts);
  expectRefusal(runProgram({"evaluate", structure, scan}), 1, parts);
  expectRefusal(runProgram({"simulate", "--from", scan, "-o", (folder / "a").string()}), 1, parts);
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadInput, AStructureWithoutLengthIsNoReference) {
  const fs::path folder = test::freshFolder();
  const std::string dot = (folder / "dot.txt").string();
  test::writeBytes(dot, "# vid\tparentid\tedgetype\tXX\tYY\tZZ\tRadius\n1\n1\t\t<\t0\t0\t0\t0\n");
  expectRefusal(runProgram({"evaluate", test::sample("young_tree.mtg"), dot}), 1,
                {"dot.txt", "choose another structure"});
}

} // namespace
} // namespace espalier
