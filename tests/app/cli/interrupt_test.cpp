#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::namesIn;
using test::Outcome;
using test::runAndSignal;
using testing::ElementsAre;
using testing::HasSubstr;

/// A run that would take minutes, stopped once the progress bar shows that it works. One thread, so
/// that the one that gets the signal is the one that works.
Outcome stoppedRun(const fs::path& folder, int signal) {
  return runAndSignal({"reconstruct", test::sample("young_tree.ply"), "-o",
                       (folder / "result.mtg").string(), "--json", (folder / "a.json").string(),
                       "--threads", "1", "--set", "contract.neighbors=64", "--set",
                       "contract.radius=0.45"},
                      "Contract", signal);
}

TEST(Interrupt, StopsTheWorkAndWritesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const fs::path folder = test::freshFolder();
    test::writeBytes(folder / "result.mtg", "precious");
    const Outcome outcome = stoppedRun(folder, signal);
    EXPECT_EQ(outcome.status, 130);
    EXPECT_THAT(outcome.err, HasSubstr("\r\33[Kespalier: stopped; nothing was written\r\n"));
    EXPECT_THAT(namesIn(folder), ElementsAre("result.mtg"));
    EXPECT_EQ(test::bytesOf(folder / "result.mtg"), "precious");
  }
}

TEST(Progress, IsABarOnATerminalThatIsClearedInTheEnd) {
  const fs::path folder = test::freshFolder();
  const Outcome outcome = runAndSignal(
      {"reconstruct", test::sample("young_tree.ply"), "-o", (folder / "result.mtg").string()},
      "this text is never seen", SIGINT);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("[##"));
  EXPECT_THAT(outcome.err, HasSubstr("Contract"));
  EXPECT_TRUE(outcome.err.ends_with("\r\33[K"));
}

TEST(Progress, NeverRunsIntoALineThatIsPrinted) {
  const std::string prefix = (test::freshFolder() / "a").string();
  const Outcome outcome =
      runAndSignal({"simulate", "-o", prefix, "--points", "2000", "--segments", "20"},
                   "this text is never seen", SIGINT);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("Scan\r\33[Kespalier: wrote " + prefix + ".ply"));
  EXPECT_THAT(outcome.err, HasSubstr("\r\33[Kespalier: wrote " + prefix + ".mtg"));
}

} // namespace
} // namespace espalier
