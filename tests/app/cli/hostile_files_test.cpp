// Files that are none, names that are odd, numbers that are absurd: each is refused in one line.
#include "core/project/project.h"
#include "tests/app/cli/program.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::expectRefusal;
using test::namesIn;
using test::runProgram;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string sampleScan = test::sample("young_tree.ply");
const std::string sampleStructure = test::sample("young_tree.mtg");

class HostileFiles : public testing::Test {
protected:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string pipe(const std::string& name) const {
    EXPECT_EQ(::mkfifo(file(name).c_str(), 0600), 0);
    return file(name);
  }

  fs::path folder_ = test::freshFolder();
};

TEST_F(HostileFiles, APipeThatNobodyWritesToIsRefusedByAll) {
  const std::string mute = pipe("mute");
  const std::vector<std::string> parts = {mute, "is a pipe"};
  const std::string output = file("result.mtg");
  for (const test::Arguments& command : std::vector<test::Arguments>{
           {"info", mute},
           {"reconstruct", mute, "-o", output},
           {"reconstruct", sampleScan, "-o", output, "--preset", mute},
           {"convert", mute, output},
           {"register", mute, sampleScan, "-o", file("x.ply")},
           {"register", sampleScan, mute, "-o", file("x.ply")},
           {"register", sampleScan, sampleScan, "-o", file("x.ply"), "--pairs", mute},
           {"evaluate", sampleStructure, mute},
           {"noise", mute},
           {"sweep", mute, "contract.radius"},
           {"simulate", "--from", mute, "-o", file("x")},
           {"picture", mute, "-o", file("x.png")},
           {"batch", mute, "-o", file("results")}}) {
    SCOPED_TRACE(command.front());
    expectRefusal(runProgram(command), 1, parts);
  }
  EXPECT_THAT(namesIn(folder_), ElementsAre("mute"));
}

TEST_F(HostileFiles, APresetMayComeThroughAPipe) {
  const std::string preset = pipe("preset");
  const int holder = ::open(preset.c_str(), O_RDWR | O_CLOEXEC); // else writing to it would wait
  const std::string text = R"({"contract": {"magic": 1}})";
  ASSERT_EQ(::write(holder, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  std::thread closer([holder] {
    for (int left = 1; left > 0;) { // until it is read
      ::ioctl(holder, FIONREAD, &left);
      std::this_thread::yield();
    }
    ::close(holder);
  });
  expectRefusal(runProgram({"reconstruct", sampleScan, "-o", file("a.mtg"), "--preset", preset}), 1,
                {preset + ", line 1: ", "magic"});
  closer.join();
}

TEST_F(HostileFiles, APlantWhoseScanIsADeviceFailsAlone) {
  test::writeBytes(file("plants.csv"), "scan,name\n/dev/zero,zero\n" + pipe("mute") + ",mute\n" +
                                           sampleScan + ",tree\n");
  const auto outcome = runProgram({"batch", file("plants.csv"), "-o", file("results")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("zero: /dev/zero: is a pipe or device"));
  EXPECT_THAT(outcome.err, HasSubstr("mute: " + file("mute") + ": is a pipe or device"));
  EXPECT_TRUE(fs::exists(file("results/tree.mtg")));
}

TEST_F(HostileFiles, ANameThatIsTooLongFailsAloneInEachRun) {
  const std::string vast(300, 'n');
  test::writeBytes(file("plants.csv"),
                   "scan,name\n" + sampleScan + "," + vast + "\n" + sampleScan + ",tree\n");
  for (const bool isFirst : {true, false}) {
    const auto outcome = runProgram({"batch", file("plants.csv"), "-o", file("results")});
    EXPECT_EQ(outcome.status, 1) << isFirst;
    EXPECT_THAT(outcome.err, HasSubstr("line 2: the name 'nnnn"));
    EXPECT_THAT(outcome.err, HasSubstr("has 300 bytes, too many for a file"));
    EXPECT_THAT(outcome.err, HasSubstr("1 of 2 plants failed"));
    EXPECT_EQ(outcome.err.find("of them done before") == std::string::npos, isFirst);
  }
  EXPECT_TRUE(fs::exists(file("results/tree.mtg")));
}

TEST_F(HostileFiles, ANameOfAPlantLeavesRoomForAllItsFiles) {
  const std::string longest(243, 'n');
  test::writeBytes(file("stick.xyz"), "0 0 0\n0 0 1\n0 0 2\n0 0 3\n0 0 4\n");
  test::writeBytes(file("plants.csv"),
                   "scan,name\nstick.xyz," + longest + "n\n" + sampleScan + "," + longest + "\n");
  const auto outcome = runProgram({"batch", file("plants.csv"), "-o", file("results")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("has 244 bytes, too many for a file: leave it at 243"));
  EXPECT_THAT(outcome.err, HasSubstr("1 of 2 plants failed"));
  EXPECT_THAT(namesIn(file("results")),
              ElementsAre(longest + ".doubts.json", longest + ".mtg", "summary.csv"));
}

TEST_F(HostileFiles, ANameAsLongAsAFileMayHaveIsWritten) {
  const std::string name = std::string(251, 'n') + ".mtg";
  EXPECT_EQ(runProgram({"convert", sampleStructure, file(name)}).status, 0);
  EXPECT_THAT(namesIn(folder_), ElementsAre(name));
  expectRefusal(runProgram({"convert", sampleStructure, file("n" + name)}), 1,
                {"File name too long", "choose a shorter name"});
}

TEST_F(HostileFiles, ResultsGoThroughAPipeBehindStandardOutput) {
  const std::string out = pipe("out");
  std::string text;
  std::thread reader([&] {
    std::ifstream in(out, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(in), {});
  });
  const auto outcome = runProgram({"convert", sampleStructure, "/dev/stdout"}, out);
  reader.join();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(text, testing::StartsWith("CODE"));
}

TEST_F(HostileFiles, ResultsGoIntoAFileBehindStandardOutput) {
  test::writeBytes(file("out.mtg"), "");
  const auto outcome = runProgram({"convert", sampleStructure, "/dev/stdout"}, file("out.mtg"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(test::bytesOf(file("out.mtg")), testing::StartsWith("CODE"));
}

TEST_F(HostileFiles, TwoResultsNeverGoToOneFile) {
  fs::create_directory(file("inner"));
  fs::create_symlink(folder_ / "a.mtg", folder_ / "inner" / "link.mtg"); // leads nowhere yet
  const std::string one = file("a.mtg");
  const std::vector<std::string> parts = {"two results would be written to"};
  for (const std::string& other : {one, file("inner/../a.mtg"), file("inner/link.mtg")}) {
    SCOPED_TRACE(other);
    expectRefusal(runProgram({"reconstruct", sampleScan, "-o", one, "--json", other}), 2, parts);
    expectRefusal(runProgram({"contract", sampleScan, "-o", one, "--json", other}), 2, parts);
    expectRefusal(
        runProgram({"sweep", sampleScan, "contract.radius", "--csv", one, "--json", other}), 2,
        parts);
    expectRefusal(runProgram({"noise", sampleStructure, "--csv", one, "--json", other}), 2, parts);
    expectRefusal(runProgram({"traits", sampleStructure, "--csv", one, "--json", other}), 2, parts);
    for (const char* more : {"--csv", "--json", "--mapping"})
      for (const char* than : {"--csv", "--json", "--mapping"})
        if (std::string(more) != than)
          expectRefusal(
              runProgram({"evaluate", sampleStructure, sampleStructure, more, one, than, other}), 2,
              parts);
  }
  EXPECT_THAT(namesIn(folder_), ElementsAre("inner"));
  expectRefusal(
      runProgram({"traits", sampleStructure, "--csv", "two_results", "--json", "./two_results"}), 2,
      parts);
}

TEST_F(HostileFiles, NamesNeverSteerTheTerminal) {
  const std::string odd = file("a\nb\33[31mc\u009b\u202e.ply");
  expectRefusal(runProgram({"info", odd}), 1, {"a?b?[31mc??.ply: there is no such file"});
  fs::copy_file(sampleScan, odd);
  const auto outcome = runProgram({"convert", odd, file("x\33]0;y\7.xyz")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("x?]0;y?.xyz"));
  const auto info = runProgram({"info", odd});
  for (const std::string& text : {outcome.err, info.out, info.err})
    EXPECT_EQ(text.find('\33'), std::string::npos) << text;
  EXPECT_THAT(info.out, HasSubstr("a?b?[31mc"));
}

TEST_F(HostileFiles, NamesThatAreNoUtf8AreReportedInOneLine) {
  const std::string odd = file("t\xff.ply");
  fs::copy_file(sampleScan, odd);
  const auto info = runProgram({"info", odd, "--json"});
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_THAT(info.err, HasSubstr("is no UTF-8, as JSON is"));
  EXPECT_THAT(info.out, HasSubstr("t\uFFFD.ply"));
  const auto outcome = runProgram({"contract", odd, "-o", file("a.ply"), "--json", file("a.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("is no UTF-8, as JSON is"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("json.exception")));
}

TEST_F(HostileFiles, APresetWithANumberBeyondAllIsRefusedWithItsLine) {
  test::writeBytes(file("vast.json"), "{\"contract\": {\n\"radius\": 1e999}}");
  expectRefusal(
      runProgram({"reconstruct", sampleScan, "-o", file("a.mtg"), "--preset", file("vast.json")}),
      1, {"vast.json, line 2: a number is too large"});
}

TEST_F(HostileFiles, TextsInUtf16AreNamed) {
  const auto inUtf16 = [](const std::string& text) {
    std::string bytes = "\xFF\xFE";
    for (const char c : text) {
      bytes += c;
      bytes += '\0';
    }
    return bytes;
  };
  for (const auto& [name, text] :
       {std::pair{"a.xyz", "1 2 3\n4 5 6\n"}, std::pair{"a.swc", "1 0 0 0 0 1 -1\n2 0 0 0 1 1 1\n"},
        std::pair{"a.txt", "# vid\tparentid\n1\n1\t\t<\t0\t0\t0\t0\n"},
        std::pair{"a.csv", "radius,length\n1,2\n"}, std::pair{"a.treefile", "x,y,z,radius\n"},
        std::pair{"a.pcd", "VERSION 0.7\n"}, std::pair{"a.ply", "ply\nformat ascii 1.0\n"}}) {
    test::writeBytes(file(name), inUtf16(text));
    expectRefusal(runProgram({"info", file(name)}), 1, {name, "UTF-16", "save it as UTF-8"});
    test::writeBytes(file(name), inUtf16(text).substr(2)); // without its mark
    expectRefusal(runProgram({"info", file(name)}), 1, {name, "UTF-16", "save it as UTF-8"});
  }
  test::writeBytes(file("p.csv"), inUtf16("scan\na.ply\n"));
  expectRefusal(runProgram({"batch", file("p.csv"), "-o", file("r")}), 1, {"p.csv", "UTF-16"});
  test::writeBytes(file("p.json"), inUtf16("{}"));
  expectRefusal(
      runProgram({"reconstruct", sampleScan, "-o", file("r.mtg"), "--preset", file("p.json")}), 1,
      {"p.json", "UTF-16"});
}

TEST_F(HostileFiles, FormulasOfSpreadsheetsAreNoneInASummary) {
  test::writeBytes(file("plants.csv"),
                   "scan,name\n" + sampleScan + ",=1+1\n" + sampleScan + ",@SUM(A1)\n");
  for (const bool isFirst : {true, false}) {
    const auto outcome = runProgram({"batch", file("plants.csv"), "-o", file("results")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("2 of them done before") == std::string::npos, isFirst)
        << "names read back as they were";
  }
  const std::string summary = test::bytesOf(file("results/summary.csv"));
  EXPECT_THAT(summary, HasSubstr("\n'=1+1,done"));
  EXPECT_THAT(summary, HasSubstr("\n'@SUM(A1),done"));
  EXPECT_TRUE(fs::exists(file("results/=1+1.mtg")));
}

TEST_F(HostileFiles, OneIsNotMany) {
  test::writeBytes(file("one.xyz"), "1 2 3\n");
  EXPECT_EQ(runProgram({"convert", file("one.xyz"), file("two.xyz")}).err,
            "espalier: wrote " + file("two.xyz") + ": 1 point\n");
}

TEST_F(HostileFiles, ANodeBeyondAnyPlantIsRefusedWithItsLine) {
  test::writeBytes(file("far.swc"), "1 0 0 0 0 1 -1\n2 0 0 0 1e60 1 1\n");
  const std::vector<std::string> parts = {"far.swc, line 2: ", "is beyond 1e12"};
  expectRefusal(runProgram({"info", file("far.swc")}), 1, parts);
  expectRefusal(runProgram({"convert", file("far.swc"), file("a.mtg")}), 1, parts);
  expectRefusal(runProgram({"evaluate", sampleStructure, file("far.swc")}), 1, parts);
  expectRefusal(runProgram({"picture", file("far.swc"), "-o", file("a.png")}), 1, parts);
  expectRefusal(runProgram({"simulate", "--from", file("far.swc"), "-o", file("a")}), 1, parts);
  test::writeBytes(file("thick.swc"), "1 0 0 0 0 1e13 -1\n2 0 0 0 1 1 1\n");
  expectRefusal(runProgram({"info", file("thick.swc")}), 1, {"thick.swc, line 1: "});
}

TEST_F(HostileFiles, InfoShowsWhatAProjectHolds) {
  History history{.skeleton = test::fork(2)};
  SkeletonEditor editor(history.skeleton);
  editor.setReview(NodeId{0}, {.state = ReviewState::reviewed, .reviewer = "Ada"});
  history.steps.push_back({.text = "Mark", .author = "Ada", .time = 0, .delta = editor.commit()});
  history.position = 1;
  {
    Project project = Project::create(file("oak.espalier"), history);
    project.setDocument("unit", "mm");
    project.setScan(ScanReference::of(sampleScan, {}));
  }
  const auto info = runProgram({"info", file("oak.espalier")});
  EXPECT_EQ(info.status, 0) << info.err;
  const auto line = [](const std::string& key, const std::string& value) {
    return HasSubstr("\n" + key + std::string(24 - key.size(), ' ') + value + "\n");
  };
  EXPECT_THAT(info.out, line("format", "Espalier project"));
  EXPECT_THAT(info.out, line("plant", "oak"));
  EXPECT_THAT(info.out, line("unit", "mm"));
  EXPECT_THAT(info.out, line("nodes", std::to_string(history.skeleton.size())));
  EXPECT_THAT(info.out, line("edits.done", "1"));
  EXPECT_THAT(info.out, line("edits.authors", "[Ada]"));
  EXPECT_THAT(info.out, line("edits.last", "1970-01-01 00:00 UTC"));
  EXPECT_THAT(info.out, line("scan.file", sampleScan));
  EXPECT_THAT(info.out, line("scan.found", sampleScan));
  EXPECT_THAT(info.out, line("nodes_to_do", std::to_string(history.skeleton.size() - 1)));
  EXPECT_THAT(runProgram({"info", file("oak.espalier"), "--json"}).out, HasSubstr("\"review\": {"));
  EXPECT_THAT(namesIn(folder_), ElementsAre("oak.espalier")) << "it is only read";
}

} // namespace
} // namespace espalier
