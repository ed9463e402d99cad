// The report of `evaluate`, as a file that users open.
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class EvaluateReport : public testing::Test {
protected:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  std::filesystem::path folder_ = test::freshFolder();
  std::string truth_ = test::sample("young_tree.mtg");
  std::string scan_ = test::sample("young_tree.ply");
};

TEST_F(EvaluateReport, HoldsTheNumbersOfTheJson) {
  ASSERT_EQ(runProgram({"reconstruct", scan_, "-o", file("a.mtg")}).status, 0);
  const test::Outcome told =
      runProgram({"evaluate", file("a.mtg"), truth_, "--scan", scan_, "--unit", "m", "--json",
                  file("a.json"), "--report", file("a.html")});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("wrote " + file("a.html")));
  const std::string html = bytesOf(file("a.html"));
  EXPECT_THAT(html, HasSubstr("<h1>a.mtg compared with young_tree.mtg</h1>"));
  EXPECT_THAT(html, HasSubstr("young_tree.ply"));
  const json numbers = json::parse(bytesOf(file("a.json")));
  for (const double value :
       {numbers["authors"]["mapping"].get<double>(), numbers["authors"]["geometric"].get<double>(),
        numbers["authors"]["structural"].get<double>(), numbers["diadem"]["score"].get<double>()}) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), ">%.5f<", value);
    EXPECT_THAT(html, HasSubstr(text.data()));
  }
  EXPECT_THAT(html, Not(HasSubstr("there are no pictures")));
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,"));
}

TEST_F(EvaluateReport, IsWrittenAsPdfToo) {
  const test::Outcome told = runProgram({"evaluate", truth_, truth_, "--report", file("a.pdf")});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_THAT(bytesOf(file("a.pdf")), StartsWith("%PDF-"));
}

TEST_F(EvaluateReport, DoesWithoutPicturesWhereThereIsNoOpenGl) {
  // Neither Mesa's drivers nor those of a vendor are found then.
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  ::setenv("LIBGL_DRIVERS_PATH", "/dev/null", 1);
  const test::Outcome told = runProgram({"evaluate", truth_, truth_, "--report", file("a.html")});
  ::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  ::unsetenv("LIBGL_DRIVERS_PATH");
  ASSERT_EQ(told.status, 0) << told.err;
  const std::string html = bytesOf(file("a.html"));
  EXPECT_THAT(html, HasSubstr("there are no pictures: OpenGL: "));
  EXPECT_THAT(html, HasSubstr("Agreement over the tolerance"));
}

TEST_F(EvaluateReport, IsRefusedBeforeTheWork) {
  expectRefusal(runProgram({"evaluate", "missing.mtg", truth_, "--report", file("a.docx")}), 1,
                {"a.docx: a report is written as HTML or PDF", "ends in .html or .pdf"});
  expectRefusal(runProgram({"evaluate", "missing.mtg", truth_, "--report", file("nowhere/a.html")}),
                1, {"nowhere/a.html", "create the folder first"});
  expectRefusal(runProgram({"evaluate", "missing.mtg", truth_, "--scan", scan_}), 2,
                {"--scan shows the points in a report", "give --report, too"});
  EXPECT_THAT(test::namesIn(folder_), IsEmpty());
}

TEST_F(EvaluateReport, TakesNoInputForItsOutput) {
  const std::string copy = file("plant.html"); // whatever it holds
  test::writeBytes(copy, bytesOf(scan_));
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--scan", copy, "--report", copy}), 1,
                {"plant.html: is what is read, and would be replaced"});
  EXPECT_EQ(bytesOf(copy), bytesOf(scan_));
}

TEST_F(EvaluateReport, LeavesNothingBehindIfTheScanCannotBeRead) {
  test::writeBytes(file("scan.ply"), "no points");
  const test::Outcome told = runProgram(
      {"evaluate", truth_, truth_, "--scan", file("scan.ply"), "--report", file("a.html")});
  EXPECT_EQ(told.status, 1);
  EXPECT_THAT(told.err, HasSubstr("scan.ply"));
  EXPECT_EQ(test::namesIn(folder_), std::vector<std::string>{"scan.ply"});
}

} // namespace
} // namespace espalier
