// The manual as web pages.
#include "tests/app/cli/program.h"
#include "tests/support/manual.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>
#include <regex>
#include <string>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class ManualPages : public testing::Test {
protected:
  void SetUp() override {
    const test::Outcome outcome = test::runProgram({"manual", "--html", folder_.string()});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  [[nodiscard]] std::string page(const std::string& name) const {
    return test::bytesOf(folder_ / name);
  }

  const fs::path folder_ = test::freshFolder() / "deep" / "manual";
};

/// Whether each tag that begins also ends, in the right order.
bool isWellFormed(const std::string& html) {
  const std::regex tag(R"(<(/?)([a-z0-9]+)[^<>]*?(/?)>)");
  std::vector<std::string> open;
  for (std::sregex_iterator at(html.begin(), html.end(), tag), end; at != end; ++at) {
    if ((*at)[3] == "/") continue;
    if ((*at)[1] != "/") {
      open.push_back((*at)[2]);
    } else {
      if (open.empty() || open.back() != (*at)[2]) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

TEST_F(ManualPages, AreOneForEachChapterWithAListOfAll) {
  for (const std::string& file : test::manualFiles()) {
    const std::string name =
        file == "README.md" ? "index.html" : file.substr(0, file.size() - 3) + ".html";
    const std::string html = page(name);
    EXPECT_TRUE(isWellFormed(html)) << name;
    EXPECT_THAT(html, HasSubstr("<a href=\"troubleshooting.html\""));
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr(".md\""))) << "a link to a chapter is one to its page";
    EXPECT_THAT(html, Not(HasSubstr("{methods")));
    EXPECT_THAT(html, Not(HasSubstr("<th class=\"word\" scope=\"col\"></th>"))) << name;
  }
}

TEST_F(ManualPages, LeadToWhatIsThereAndFetchNothingElse) {
  const std::regex link(R"x((href|src)="([^"]*)")x");
  const std::regex heading(R"x( id="([^"]*)")x");
  for (const auto& file : fs::directory_iterator(folder_)) {
    if (file.path().extension() != ".html") continue;
    const std::string html = test::bytesOf(file.path());
    for (std::sregex_iterator at(html.begin(), html.end(), link), end; at != end; ++at) {
      const std::string target = (*at)[2];
      SCOPED_TRACE(file.path().filename().string() + ": " + target);
      if (target.find("://") != std::string::npos) {
        EXPECT_EQ((*at)[1], "href") << "nothing is fetched";
        continue;
      }
      const std::size_t hash = std::min(target.find('#'), target.size());
      const fs::path to = hash == 0 ? file.path() : folder_ / target.substr(0, hash);
      ASSERT_TRUE(fs::exists(to));
      if (hash == target.size()) continue;
      EXPECT_THAT(test::bytesOf(to), HasSubstr(" id=\"" + target.substr(hash + 1) + "\""));
    }
  }
}

TEST_F(ManualPages, HaveWhatTheChaptersHave) {
  const std::string methods = page("methods.html");
  EXPECT_THAT(methods, HasSubstr("<code>contract.radius</code>"));
  EXPECT_THAT(methods, HasSubstr("Branch structure graph"));
  const std::string commands = page("command-line.html");
  EXPECT_THAT(commands, HasSubstr("<pre>espalier info pine.ply\nespalier reconstruct"));
  EXPECT_THAT(page("several-scans.html"), HasSubstr("<ol>\n<li><b>Targets.</b>"));
  EXPECT_THAT(page("files.html"), HasSubstr("<h2 id=\"projects\">Projects</h2>"));
  EXPECT_THAT(page("correct.html"), HasSubstr("<img src=\"tools.png\" alt=\""));
  EXPECT_THAT(page("manual.css"), HasSubstr("@media print"));
}

TEST_F(ManualPages, AreTheSameEachTime) {
  const std::string before = page("methods.html");
  ASSERT_EQ(test::runProgram({"manual", "--html", folder_.string()}).status, 0);
  EXPECT_EQ(page("methods.html"), before);
}

TEST(ManualFolder, IsRefusedWhereAFileHasItsName) {
  const fs::path file = test::freshFolder() / "pages";
  test::writeBytes(file, "a file");
  test::expectRefusal(test::runProgram({"manual", "--html", file.string()}), 1,
                      {"pages", "choose another"});
  test::expectRefusal(test::runProgram({"manual"}), 2, {"--html"});
}

} // namespace
} // namespace espalier
