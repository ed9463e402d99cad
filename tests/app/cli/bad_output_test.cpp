// What cannot be written is reported before the work where that can be known, and leaves nothing.
#include "tests/app/cli/program.h"
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
using testing::IsEmpty;

const std::string scan = test::sample("young_tree.ply");
const std::string structure = test::sample("young_tree.mtg");

/// Each subcommand that writes, with inputs that do not exist: an error about the output can then
/// only come before they are read.
std::vector<test::Arguments> commandsWriting(const std::string& stem) {
  return {{"reconstruct", "missing.ply", "-o", stem + ".mtg"},
          {"reconstruct", "missing.ply", "-o", "result.mtg", "--json", stem + ".json"},
          {"contract", "missing.ply", "-o", stem + ".ply"},
          {"evaluate", "missing.mtg", "missing.mtg", "--json", stem + ".json"},
          {"evaluate", "missing.mtg", "missing.mtg", "--report", stem + ".html"},
          {"simulate", "--from", "missing.mtg", "-o", stem},
          {"picture", "missing.ply", "-o", stem + ".png"}};
}

TEST(BadOutput, AMissingFolderIsReportedBeforeTheWork) {
  const fs::path folder = test::freshFolder();
  for (const auto& command : commandsWriting((folder / "nowhere" / "result").string())) {
    SCOPED_TRACE(command.front());
    expectRefusal(runProgram(command), 1,
                  {"nowhere/result", "No such file or directory", "create the folder first"});
  }
  expectRefusal(runProgram({"convert", scan, (folder / "nowhere" / "result.xyz").string()}), 1,
                {"nowhere/result.xyz", "create the folder first"});
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadOutput, AFolderOfThatNameIsReportedBeforeTheWork) {
  const fs::path folder = test::freshFolder();
  for (const char* extension : {".mtg", ".json", ".html", ".ply", ".png"})
    fs::create_directory(folder / ("taken" + std::string(extension)));
  for (const auto& command : commandsWriting((folder / "taken").string())) {
    SCOPED_TRACE(command.front());
    expectRefusal(runProgram(command), 1, {"taken.", "Is a directory", "choose a file name"});
  }
}

TEST(BadOutput, AFolderOneMayNotWriteToIsReportedBeforeTheWork) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const fs::path folder = test::freshFolder();
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  for (const auto& command : commandsWriting((folder / "result").string())) {
    SCOPED_TRACE(command.front());
    expectRefusal(runProgram(command), 1, {"Permission denied", "choose a folder you may write"});
  }
  fs::permissions(folder, fs::perms::owner_all);
}

TEST(BadOutput, AnExtensionNobodyKnowsIsReportedBeforeTheWork) {
  const fs::path folder = test::freshFolder();
  const auto file = [&](const char* name) { return (folder / name).string(); };
  expectRefusal(runProgram({"reconstruct", "missing.ply", "-o", file("a.las")}), 1,
                {"a.las: a structure cannot be written", "MTG (.mtg), node list (.txt)"});
  expectRefusal(runProgram({"reconstruct", "missing.ply", "-o", file("a")}), 1,
                {"a: a structure cannot be written", "MTG (.mtg), node list (.txt)"});
  expectRefusal(runProgram({"contract", "missing.ply", "-o", file("a.las")}), 1,
                {"a.las: points cannot be written", "PLY (.ply), XYZ"});
  expectRefusal(runProgram({"convert", scan, file("a.mtg")}), 1,
                {"a.mtg: points cannot be written", "PLY (.ply), XYZ"});
  expectRefusal(runProgram({"convert", structure, file("a.pcd")}), 1,
                {"a.pcd: a structure cannot be written", "MTG (.mtg), node list (.txt)"});
  expectRefusal(runProgram({"picture", "missing.ply", "-o", file("a.jpg")}), 1,
                {"a.jpg: pictures are written as PNG", "ends in .png"});
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(BadOutput, AFullDiskIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const std::vector<std::string> parts = {"/dev/full: cannot be written", "No space left",
                                          "free some room"};
  expectRefusal(runProgram({"reconstruct", scan, "-o", "/dev/full"}), 1, parts);
  expectRefusal(runProgram({"contract", scan, "-o", "/dev/full"}), 1, parts);
  expectRefusal(runProgram({"convert", scan, "/dev/full"}), 1, parts);
  expectRefusal(runProgram({"convert", structure, "/dev/full"}), 1, parts);
  expectRefusal(runProgram({"picture", structure, "-o", "/dev/full"}), 1, parts);
}

TEST(BadOutput, AFullDiskBehindStandardOutputIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const std::vector<std::string> parts = {"standard output cannot be written", "free some room"};
  expectRefusal(runProgram({"info", structure}, "/dev/full"), 1, parts);
  expectRefusal(runProgram({"methods", "--json"}, "/dev/full"), 1, parts);
  expectRefusal(runProgram({"evaluate", structure, structure}, "/dev/full"), 1, parts);
}

TEST(BadOutput, AnInputIsNeverReplaced) {
  const fs::path folder = test::freshFolder();
  const std::string points = (folder / "plant.txt").string();
  const std::string plant = (folder / "plant.mtg").string();
  const std::string link = (folder / "link.txt").string();
  ASSERT_EQ(runProgram({"convert", scan, points}).status, 0);
  ASSERT_EQ(runProgram({"convert", structure, plant}).status, 0);
  fs::create_symlink(points, link);
  const std::string pointsBefore = test::bytesOf(points);
  const std::string plantBefore = test::bytesOf(plant);
  const std::string advice = "choose another output file";
  expectRefusal(runProgram({"reconstruct", points, "-o", points}), 1, {points, advice});
  expectRefusal(runProgram({"reconstruct", points, "-o", link}), 1, {link, advice});
  expectRefusal(runProgram({"contract", points, "-o", points}), 1, {points, advice});
  expectRefusal(runProgram({"convert", points, points}), 1, {points, advice});
  expectRefusal(runProgram({"evaluate", structure, plant, "--json", plant}), 1, {plant, advice});
  expectRefusal(runProgram({"simulate", "--from", plant, "-o", (folder / "plant").string()}), 1,
                {plant, advice});
  EXPECT_EQ(test::bytesOf(points), pointsBefore);
  EXPECT_EQ(test::bytesOf(plant), plantBefore);
  EXPECT_THAT(namesIn(folder), ElementsAre("link.txt", "plant.mtg", "plant.txt"));
}

TEST(BadOutput, AnOldFileIsReplacedWhole) {
  const fs::path folder = test::freshFolder();
  const std::string output = (folder / "plant.txt").string();
  test::writeBytes(output, std::string(10 << 20, '\1'));
  ASSERT_EQ(runProgram({"convert", structure, output}).status, 0);
  EXPECT_EQ(test::bytesOf(output).find('\1'), std::string::npos);
  EXPECT_THAT(namesIn(folder), ElementsAre("plant.txt"));
}

} // namespace
} // namespace espalier
