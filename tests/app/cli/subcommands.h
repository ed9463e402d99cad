#pragma once

#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>
#include <string>

namespace espalier::test {

/// Each subcommand does its task on the bundled sample, whose truth is known.
class Subcommands : public testing::Test {
protected:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  /// Runs what must succeed without a word on standard error but what was written.
  static std::string run(const Arguments& arguments) {
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.status, 0);
    std::istringstream errorLines(outcome.err);
    for (std::string line; std::getline(errorLines, line);)
      EXPECT_THAT(line, testing::StartsWith("espalier: wrote "));
    return outcome.out;
  }

  const std::string scan_ = sample("young_tree.ply");
  const std::string truth_ = sample("young_tree.mtg");
  const std::filesystem::path folder_ = freshFolder();
};

} // namespace espalier::test
