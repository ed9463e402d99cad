#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/io/atomic_file.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <array>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void writeText(const fs::path& path, const std::string& text) {
  writeAtomically(path, [&](std::ostream& out) { out << text; });
}

std::string textOf(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::ptrdiff_t filesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(WriteAtomically, WritesAndReplaces) {
  const fs::path file = test::freshFolder() / "oak.mtg";
  writeText(file, "first");
  EXPECT_EQ(textOf(file), "first");
  const std::string long_(3'000'000, 'x');
  writeText(file, long_);
  EXPECT_EQ(textOf(file), long_);
  EXPECT_EQ(filesIn(file.parent_path()), 1);
}

TEST(WriteAtomically, LeavesTheOldFileIfWritingFails) {
  const fs::path file = test::freshFolder() / "oak.mtg";
  writeText(file, "old");
  const auto fail = [](std::ostream& out) {
    out << std::string(1'000'000, 'x');
    throw Error("oak: has no root");
  };
  EXPECT_THROW(writeAtomically(file, fail), Error);
  EXPECT_THROW(writeAtomically(file, [](std::ostream&) { throw Cancelled{}; }), Cancelled);
  EXPECT_EQ(textOf(file), "old");
  EXPECT_EQ(filesIn(file.parent_path()), 1) << "no temporary file is left";
}

TEST(StagedFile, CanBeReadBeforeItTakesItsPlaceAndIsRemovedIfItDoesNot) {
  const fs::path file = test::freshFolder() / "oak.mtg";
  writeText(file, "old");
  const auto write = [](std::ostream& out) { out << "new"; };
  {
    const StagedFile staged(file, write);
    EXPECT_EQ(textOf(staged.written()), "new");
    EXPECT_EQ(filesIn(file.parent_path()), 2);
  }
  EXPECT_EQ(textOf(file), "old");
  EXPECT_EQ(filesIn(file.parent_path()), 1);
  StagedFile staged(file, write);
  staged.show();
  EXPECT_EQ(textOf(file), "new");
  EXPECT_EQ(filesIn(file.parent_path()), 1);
}

TEST(WriteAtomically, ReportsThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  for (const std::size_t size : {std::size_t{1}, std::size_t{3'000'000}}) {
    const std::string error = test::errorOf([&] {
      writeText("/dev/full", std::string(size, 'x'));
      return 0;
    });
    EXPECT_THAT(error, HasSubstr("/dev/full: cannot be written: No space left on device")) << size;
  }
}

TEST(WriteAtomically, WritesThroughDevices) {
  if (!fs::exists("/dev/null")) GTEST_SKIP() << "there is no /dev/null here";
  writeText("/dev/null", "anything");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteAtomically, NamesWhatStandsInTheWay) {
  const fs::path folder = test::freshFolder();
  const auto errorFor = [](const fs::path& path) {
    return test::errorOf([&] {
      writeText(path, "text");
      return 0;
    });
  };
  EXPECT_THAT(errorFor(folder / "missing" / "oak.mtg"), HasSubstr("create the folder first"));
  EXPECT_THAT(errorFor(folder), HasSubstr("Is a directory"));
  writeText(folder / "file", "text");
  EXPECT_THAT(errorFor(folder / "file" / "oak.mtg"), HasSubstr("Not a directory"));
  EXPECT_EQ(filesIn(folder), 1);
}

TEST(WriteAtomically, ReportsThatAFolderIsReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const fs::path folder = test::freshFolder();
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(test::errorOf([&] {
                writeText(folder / "oak.mtg", "text");
                return 0;
              }),
              HasSubstr("Permission denied"));
  fs::permissions(folder, fs::perms::owner_all);
}

TEST(WriteAtomically, KeepsAFileThatIsWriteProtected) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const fs::path file = test::freshFolder() / "oak.mtg";
  writeText(file, "before");
  fs::permissions(file, fs::perms::owner_read);
  for (const bool isWritten : {true, false})
    EXPECT_THAT(test::errorOf([&] {
                  isWritten ? writeText(file, "after") : requireWritable(file);
                  return 0;
                }),
                HasSubstr("Permission denied"));
  EXPECT_EQ(textOf(file), "before");
}

TEST(WriteAtomically, FollowsLinks) {
  const fs::path folder = test::freshFolder();
  fs::create_directory(folder / "plants");
  fs::create_symlink("plants/oak.mtg", folder / "link.mtg"); // leads nowhere yet
  writeText(folder / "link.mtg", "one");
  EXPECT_TRUE(fs::is_symlink(folder / "link.mtg"));
  EXPECT_EQ(textOf(folder / "plants/oak.mtg"), "one");
  writeText(folder / "link.mtg", "two");
  EXPECT_TRUE(fs::is_symlink(folder / "link.mtg"));
  EXPECT_EQ(textOf(folder / "plants/oak.mtg"), "two");
}

TEST(WriteAtomically, RefusesLinksInACircle) {
  const fs::path folder = test::freshFolder();
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_THROW(writeText(folder / "a", "text"), Error);
}

TEST(WriteAtomically, KeepsPermissions) {
  const fs::path file = test::freshFolder() / "oak.mtg";
  writeText(file, "one");
  const fs::perms wanted = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(file, wanted);
  writeText(file, "two");
  EXPECT_EQ(fs::status(file).permissions(), wanted);
}

TEST(RequireWritable, WritesNothing) {
  const fs::path folder = test::freshFolder();
  requireWritable(folder / "oak.mtg");
  EXPECT_EQ(filesIn(folder), 0);
  writeText(folder / "oak.mtg", "old");
  requireWritable(folder / "oak.mtg");
  EXPECT_EQ(textOf(folder / "oak.mtg"), "old");
  EXPECT_EQ(filesIn(folder), 1);
}

TEST(RequireWritable, SaysWhatWritingWouldSay) {
  const fs::path folder = test::freshFolder();
  writeText(folder / "file", "text");
  for (const fs::path& path :
       {folder, folder / "missing" / "oak.mtg", folder / "file" / "oak.mtg"}) {
    const auto errorOf = [](const auto& act) {
      return test::errorOf([&] {
        act();
        return 0;
      });
    };
    const std::string error = errorOf([&] { requireWritable(path); });
    EXPECT_EQ(error, errorOf([&] { writeText(path, "new"); }));
    EXPECT_THAT(error, HasSubstr(path.string() + ": cannot be written: "));
  }
}

/// A process that has ended.
pid_t endedProcess() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

/// The name that the temporary file of this process has while "oak.mtg" is written.
std::string temporaryName(const fs::path& folder) {
  std::string name;
  writeAtomically(folder / "oak.mtg", [&](std::ostream&) {
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename() != "oak.mtg") name = entry.path().filename().string();
  });
  return name;
}

TEST(RemoveLeftovers, RemovesThoseOfProcessesThatHaveEnded) {
  const fs::path folder = test::freshFolder();
  const std::string own = temporaryName(folder);
  const std::string mark = '-' + std::to_string(::getpid()) + '-';
  ASSERT_NE(own.find(mark), std::string::npos) << own;
  std::string left = own;
  left.replace(own.find(mark), mark.size(), '-' + std::to_string(endedProcess()) + '-');
  const std::vector<std::string> kept = {
      own,        "oak.mtg",  "x" + left,
      left + "x", ".oak.tmp", ".oak.elsewhere-" + std::to_string(endedProcess()) + "-0.tmp"};
  for (const std::string& name : kept)
    writeText(folder / name, "text");
  fs::copy_file(folder / "oak.mtg", folder / left);
  removeLeftovers(folder);
  EXPECT_FALSE(fs::exists(folder / left));
  for (const std::string& name : kept)
    EXPECT_TRUE(fs::exists(folder / name)) << name;
}

TEST(RemoveLeftovers, TouchesNoLinkAndNoFolder) {
  const fs::path folder = test::freshFolder();
  const std::string own = temporaryName(folder);
  const std::string mark = '-' + std::to_string(::getpid()) + '-';
  std::string left = own;
  left.replace(own.find(mark), mark.size(), '-' + std::to_string(endedProcess()) + '-');
  fs::create_symlink("oak.mtg", folder / left);
  removeLeftovers(folder);
  EXPECT_TRUE(fs::is_symlink(folder / left));
  removeLeftovers(folder / "missing"); // and does not fail
}

TEST(WriteAtomically, WritesToAPipe) {
  const fs::path folder = test::freshFolder();
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const fs::path named = "/dev/fd/" + std::to_string(ends[1]);
  EXPECT_TRUE(isStream(named));
  requireWritable(named);
  writeText(named, "text");
  std::array<char, 8> got{};
  EXPECT_EQ(::read(ends[0], got.data(), got.size()), 4);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(PlaceOf, IsOneForAllPathsToAFile) {
  const fs::path folder = fs::canonical(test::freshFolder());
  fs::create_directory(folder / "a");
  fs::create_symlink("../oak.mtg", folder / "a" / "link");
  const fs::path place = placeOf(folder / "oak.mtg");
  EXPECT_EQ(place, folder / "oak.mtg");
  EXPECT_EQ(placeOf(folder / "a" / ".." / "oak.mtg"), place);
  EXPECT_EQ(placeOf(folder / "a" / "link"), place);
  EXPECT_NE(placeOf(folder / "a" / "oak.mtg"), place);
  EXPECT_EQ(placeOf("./none_there.mtg"), placeOf("none_there.mtg"));
}

} // namespace
} // namespace espalier
