// Every command that the manual gives as an example does what it says: each is run as it stands
// there, in a shell, in a folder with files of those names.
#include "tests/app/cli/program.h"
#include "tests/support/manual.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// Those that are not run, and why.
const std::map<std::string, std::string> notRun = {
    {"/usr/share/espalier/workflow/run scans results -j 8",
     "needs Snakemake; the test packaging.workflow runs it"},
    {"sudo apt install ./python3-espalier_0.1.0_amd64.deb",
     "changes the system; the test packaging.package installs it into a folder"}};

struct Example {
  std::string chapter;
  std::string command;
};

/// The lines of all blocks ```sh of the manual.
std::vector<Example> examples() {
  std::vector<Example> all;
  for (const std::string& chapter : test::manualFiles()) {
    std::ifstream in(test::sourceFolder() / "resources/manual" / chapter);
    bool isShell = false;
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("```"))
        isShell = line == "```sh";
      else if (isShell)
        all.push_back({chapter, line});
  }
  return all;
}

/// What a shell says of a command that is run in `folder`; the status is its own.
std::string runInShell(const fs::path& folder, const std::string& command, int& status) {
  const fs::path said = folder / "said.txt";
  const std::string line = "cd '" + folder.string() + "' && PATH='" +
                           fs::path(ESPALIER_PROGRAM).parent_path().string() + "':\"$PATH\" && ( " +
                           command + " ) >'" + said.string() + "' 2>&1 </dev/null";
  status = std::system(line.c_str());
  return test::bytesOf(said);
}

void make(const fs::path& folder, const std::string& command) {
  int status = 0;
  const std::string said = runInShell(folder, command, status);
  ASSERT_EQ(status, 0) << command << '\n' << said;
}

/// The files that examples speak of, of small simulated plants.
void makeFiles(const fs::path& folder) {
  const std::string small = " --segments 40 --points 12000";
  make(folder, "espalier simulate -o pine --architecture conifer --seed 3" + small);
  make(folder, "mv pine.mtg expert.mtg && espalier reconstruct pine.ply -o pine.mtg");
  make(folder, "espalier reconstruct pine.ply -o a.mtg --set prune.length=40sp");
  make(folder, "cp pine.mtg b.mtg && cp pine.mtg anna.mtg && cp a.mtg ben.mtg");
  make(folder, "espalier simulate -o maple --stations 3 --apart 0.3,10" + small);
  make(folder, "cp maple_1.ply north.ply && cp maple_2.ply south.ply");
  make(folder, "grep -v maple_3 maple_pairs.csv >targets.csv");
  make(folder, "sed -i s/maple_2/south/ targets.csv");
  make(folder, "espalier simulate -o maize --architecture herb --segments 1 --foliage 1"
               " --foliage-length 0.5 --points 8000");
  make(folder, "espalier simulate -o plot --plants 2 --points 40000 --segments 30");
  std::ofstream(folder / "preset.json") << R"({"contract": {"radius": "12 spacings"}})";
  std::ofstream(folder / "orchard.csv") << "scan,name,reference,root\npine.ply,,expert.mtg,lowest\n"
                                           "maple_1.ply,maple,,\n";
}

/// The files that a command names behind "-o", --json and its like; what it is to write.
std::vector<std::string> outputsOf(const std::string& command) {
  std::vector<std::string> files;
  std::istringstream words(command);
  for (std::string word, before; words >> word; before = word)
    if (before == "-o" || before == "--json" || before == "--csv" || before == "--report" ||
        before == "--html" || before == "--left-out")
      if (command.find(" simulate ") == std::string::npos) files.push_back(word);
  return files;
}

TEST(ManualExamples, AllRunAsTheyStandThere) {
  const fs::path folder = test::freshFolder();
  ASSERT_NO_FATAL_FAILURE(makeFiles(folder));
  std::size_t ran = 0;
  for (const auto& [chapter, command] : examples()) {
    if (notRun.contains(command)) continue;
    SCOPED_TRACE(chapter + ": " + command);
    ASSERT_TRUE(command.starts_with("espalier "))
        << "another program: run it here, or name it in `notRun` with the reason";
    int status = 0;
    const std::string said = runInShell(folder, command, status);
    EXPECT_EQ(status, 0) << said;
    for (const std::string& file : outputsOf(command))
      EXPECT_TRUE(fs::exists(folder / file)) << file;
    ++ran;
  }
  EXPECT_GT(ran, 30U);
}

TEST(ManualExamples, NameEachSubcommandThatThereIs) {
  const std::string help = test::runProgram({"--help"}).out;
  const std::string manual = test::manualText();
  std::istringstream lines(help.substr(0, help.find("\nOptions")));
  std::size_t subcommands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line.size() < 3 || line[2] == ' ') continue; // of two lines
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    EXPECT_NE(manual.find("| `" + name + "` |"), std::string::npos) << name;
    ++subcommands;
  }
  EXPECT_GT(subcommands, 15U);
}

TEST(ManualExamples, LeaveOutNoMoreThanTheyNeed) {
  for (const auto& [command, reason] : notRun) {
    EXPECT_FALSE(reason.empty());
    const std::vector<Example> all = examples();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [&](const Example& each) { return each.command == command; }))
        << command << " is no example any more";
  }
}

} // namespace
} // namespace espalier
