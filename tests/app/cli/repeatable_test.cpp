// The same input, options and seed give the same files, byte for byte, on any number of threads.
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::runProgram;

class Repeatable : public testing::Test {
protected:
  /// Expects that `arguments` and `-o output` always write the same bytes to `files`.
  void expectSameBytes(const test::Arguments& arguments, const std::string& output,
                       const std::vector<std::string>& files) const {
    const std::vector<std::pair<std::string, test::Arguments>> runs = {
        {"a", {}}, {"b", {}}, {"one", {"--threads", "1"}}, {"two", {"--threads", "2"}}};
    for (const auto& [run, threads] : runs) {
      const fs::path folder = folder_ / run;
      fs::create_directory(folder);
      test::Arguments all = arguments;
      all.insert(all.end(), threads.begin(), threads.end());
      all.insert(all.end(), {"-o", (folder / output).string()});
      ASSERT_EQ(runProgram(all).status, 0);
      for (const std::string& file : files) {
        const std::string bytes = test::bytesOf(folder / file);
        EXPECT_FALSE(bytes.empty());
        EXPECT_TRUE(bytes == test::bytesOf(folder_ / "a" / file)) << run << ' ' << file;
      }
    }
  }

  fs::path folder_ = test::freshFolder();
};

TEST_F(Repeatable, IsReconstruct) {
  expectSameBytes({"reconstruct", test::sample("young_tree.ply")}, "x.mtg", {"x.mtg"});
}

TEST_F(Repeatable, IsContract) {
  expectSameBytes({"contract", test::sample("young_tree.ply")}, "x.ply", {"x.ply"});
}

TEST_F(Repeatable, IsSimulate) {
  expectSameBytes({"simulate", "--seed", "7", "--points", "5000", "--segments", "60"}, "x",
                  {"x.ply", "x.mtg"});
}

TEST_F(Repeatable, OnlyWithTheSameSeed) {
  for (const char* seed : {"1", "2"})
    ASSERT_EQ(runProgram({"simulate", "--seed", seed, "--points", "1000", "--segments", "30", "-o",
                          (folder_ / seed).string()})
                  .status,
              0);
  EXPECT_NE(test::bytesOf(folder_ / "1.ply"), test::bytesOf(folder_ / "2.ply"));
  EXPECT_NE(test::bytesOf(folder_ / "1.mtg"), test::bytesOf(folder_ / "2.mtg"));
}

TEST_F(Repeatable, IsPicture) {
  for (const char* name : {"a.png", "b.png"})
    ASSERT_EQ(runProgram({"picture", test::sample("young_tree.ply"), test::sample("young_tree.mtg"),
                          "-o", (folder_ / name).string(), "--width", "200", "--height", "150"})
                  .status,
              0);
  EXPECT_EQ(test::bytesOf(folder_ / "a.png"), test::bytesOf(folder_ / "b.png"));
}

TEST_F(Repeatable, AreTheFormatsThatHoldAllThereIs) {
  const auto convert = [&](const std::string& from, const std::string& to) {
    ASSERT_EQ(runProgram({"convert", from, (folder_ / to).string()}).status, 0);
  };
  const auto file = [&](const char* name) { return (folder_ / name).string(); };
  convert(test::sample("young_tree.ply"), "a.ply");
  convert(file("a.ply"), "a.xyz");
  convert(file("a.xyz"), "b.ply");
  EXPECT_TRUE(test::bytesOf(file("a.ply")) == test::bytesOf(file("b.ply")));
  convert(test::sample("young_tree.mtg"), "a.mtg");
  convert(file("a.mtg"), "a.txt");
  convert(file("a.txt"), "b.mtg");
  EXPECT_TRUE(test::bytesOf(file("a.mtg")) == test::bytesOf(file("b.mtg")));
}

} // namespace
} // namespace espalier
