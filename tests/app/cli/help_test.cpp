#include "tests/app/cli/program.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <regex>
#include <sstream>

namespace espalier {
namespace {

using test::Outcome;
using test::runProgram;
using testing::HasSubstr;
using testing::IsEmpty;

const test::Arguments subcommands = {"reconstruct", "clean",    "smooth",   "plants",  "batch",
                                     "contract",    "evaluate", "noise",    "convert", "info",
                                     "simulate",    "methods",  "manual",   "picture", "answer",
                                     "sweep",       "traits",   "envelope", "register"};

void expectPage(const Outcome& help) {
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.err, IsEmpty());
  EXPECT_THAT(help.out, HasSubstr("\nUsage: espalier "));
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    EXPECT_EQ(line.find_first_not_of("\n !\"#$%&'()*+,-./0123456789:;<=>?@[\\]_|~"
                                     "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"),
              std::string::npos)
        << line;
  }
}

TEST(Help, OfTheProgramListsAllSubcommandsAndExitStatuses) {
  const Outcome help = runProgram({"--help"});
  expectPage(help);
  for (const std::string& subcommand : subcommands)
    EXPECT_THAT(help.out, HasSubstr("\n  " + subcommand + ' '));
  EXPECT_THAT(help.out, HasSubstr("2 wrong"));
  EXPECT_EQ(runProgram({"-h"}).out, help.out);
}

TEST(Help, OfEachSubcommandFitsThePage) {
  for (const std::string& subcommand : subcommands) {
    SCOPED_TRACE(subcommand);
    const Outcome help = runProgram({subcommand, "--help"});
    expectPage(help);
    EXPECT_THAT(help.out, HasSubstr("\nUsage: espalier " + subcommand + ' '));
  }
}

TEST(Help, SaysWhatMustBeGivenAndWhatOptionsAreByDefault) {
  const std::string help = runProgram({"simulate", "--help"}).out;
  EXPECT_THAT(help, HasSubstr("Usage: espalier simulate -o PREFIX [OPTION]...\n"));
  EXPECT_THAT(help, HasSubstr("(default: 100000)"));
  EXPECT_THAT(help, HasSubstr("(default: broadleaf)"));
  const std::string unbroken = std::regex_replace(help, std::regex("\\s+"), " ");
  EXPECT_THAT(unbroken, HasSubstr("in the unit of the plant (default: extent / 2500)"));
  EXPECT_THAT(runProgram({"picture", "--help"}).out,
              HasSubstr("Usage: espalier picture FILE... -o FILE [OPTION]...\n"));
}

TEST(Help, SaysTheVersion) {
  EXPECT_THAT(runProgram({"--version"}).out,
              testing::MatchesRegex(
                  "espalier [0-9]+.[0-9]+.[0-9]+([~+][0-9]+.[0-9]+.g[0-9a-f]+)?(.changed)?\n"));
}

} // namespace
} // namespace espalier
