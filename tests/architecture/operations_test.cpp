// Keeps the manual's table of operations and the list of their tests in step.
#include "tests/support/manual.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Operation {
  std::string name;
  std::string test; // empty: it is not there yet
};

std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<Operation> operations() {
  std::ifstream in(test::sourceFolder() / "tests/architecture/operations.txt");
  std::vector<Operation> result;
  for (std::string line; std::getline(in, line);) {
    const std::size_t bar = line.find(" |");
    if (line.starts_with('#') || bar == std::string::npos) continue;
    const std::size_t test = line.find_first_not_of(' ', bar + 2);
    result.push_back(
        {line.substr(0, bar), test == std::string::npos ? std::string() : line.substr(test)});
  }
  return result;
}

/// "Suite.Test" of all sources of tests.
std::set<std::string> allTests() {
  const std::regex test(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::sourceFolder() / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = textOf(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), test), end; at != end; ++at)
      names.insert((*at)[1].str() + "." + (*at)[2].str());
  }
  return names;
}

TEST(Operations, HaveTheTestsThatTheListNames) {
  const std::set<std::string> tests = allTests();
  ASSERT_GT(operations().size(), 40U);
  for (const Operation& operation : operations())
    EXPECT_TRUE(operation.test.empty() || tests.contains(operation.test))
        << operation.name << ": " << operation.test;
}

TEST(Operations, StandInTheManualAsDoneWhereTheyHaveATest) {
  std::istringstream manual(test::manualText());
  std::vector<std::string> rows;
  for (std::string line; std::getline(manual, line);)
    rows.push_back(line);
  for (const Operation& operation : operations()) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const std::string& line) {
      return line.starts_with("| " + operation.name + " |");
    });
    ASSERT_NE(row, rows.end()) << operation.name;
    EXPECT_EQ(row->find("| not yet |") != std::string::npos, operation.test.empty())
        << operation.name;
  }
}

} // namespace
} // namespace espalier
