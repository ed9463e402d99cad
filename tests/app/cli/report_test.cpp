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
  const test::Outcome outcome =
      runProgram({"evaluate", file("a.mtg"), truth_, "--scan", scan_, "--unit", "m", "--json",
                  file("a.json"), "--report", file("a.html")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("wrote " + file("a.html")));
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

TEST_F(EvaluateReport, IsNotNeededToReportRadiiByTheScan) {
  const test::Outcome outcome = runProgram({"evaluate", truth_, truth_, "--scan", scan_, "--unit",
                                            "m", "--json", file("a.json"), "--csv", file("a.csv")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("75 to 100% of the circumference seen: over "));
  const json radii = json::parse(bytesOf(file("a.json")))["radius"];
  const json& arcs = radii["by_arc"];
  ASSERT_EQ(arcs.size(), 4U);
  double compared = 0;
  for (const json& arc : arcs)
    compared += arc["compared"].get<double>();
  EXPECT_GT(arcs[3]["compared"].get<double>(), 0);
  EXPECT_NEAR(compared, radii["compared"].get<double>(), 1e-9 * compared) << "each place once";
  EXPECT_NEAR(arcs[3]["root_mean_square"].get<double>(), 0, 1e-12);
  EXPECT_THAT(bytesOf(file("a.csv")), HasSubstr("radius.by_arc.3.root_mean_square,"));
  expectRefusal(runProgram({"evaluate", truth_, truth_, "--scan", scan_, "--json", scan_}), 1,
                {"is what is read, and would be replaced"});
}

TEST_F(EvaluateReport, ReportsStemsAtBreastHeightOrWhyNot) {
  const auto numbers = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> words = {"evaluate",      file("thick.txt"), file("thin.txt"),
                                      "--no-register", "--json",          file("a.json")};
    words.insert(words.end(), flags.begin(), flags.end());
    const test::Outcome outcome = runProgram(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return std::pair(outcome.out, json::parse(bytesOf(file("a.json")))["breast_height"]);
  };
  const auto stem = [](const char* radius) {
    return std::string("# vid parentid edgetype XX YY ZZ Radius\n2\n1\t\t/\t0\t0\t0\t") + radius +
           "\n2\t1\t<\t0\t0\t2\t" + radius + "\n";
  };
  test::writeBytes(file("thick.txt"), stem("0.12"));
  test::writeBytes(file("thin.txt"), stem("0.1"));
  const auto [text, stems] = numbers({"--unit", "m"});
  EXPECT_THAT(text, HasSubstr("(DBH) 0.24 m, of the reference 0.2 m: +20.0%"));
  EXPECT_EQ(stems["height"], 1.3);
  EXPECT_NEAR(stems["error"].get<double>(), 0.04, 1e-12);
  EXPECT_NEAR(stems["relative_error"].get<double>(), 0.2, 1e-12);
  EXPECT_TRUE(stems["missing"].is_null());
  const auto [unknown, none] = numbers({});
  EXPECT_THAT(unknown,
              HasSubstr("not compared: the unit of the lengths is not known, which --unit sets"));
  EXPECT_TRUE(none["height"].is_null());
  EXPECT_TRUE(none["error"].is_null());
  const auto [low, short_] = numbers({"--unit", "mm"});
  EXPECT_THAT(low, HasSubstr("the stem of the reference does not rise that high"));
  EXPECT_EQ(short_["missing"], "the stem of the reference does not rise that high");
}

TEST_F(EvaluateReport, IsWrittenAsPdfToo) {
  const test::Outcome outcome = runProgram({"evaluate", truth_, truth_, "--report", file("a.pdf")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(bytesOf(file("a.pdf")), StartsWith("%PDF-"));
}

TEST_F(EvaluateReport, DoesWithoutPicturesWhereThereIsNoOpenGl) {
  // Neither Mesa's drivers nor those of a vendor are found then.
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  ::setenv("LIBGL_DRIVERS_PATH", "/dev/null", 1);
  const test::Outcome outcome =
      runProgram({"evaluate", truth_, truth_, "--report", file("a.html")});
  ::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  ::unsetenv("LIBGL_DRIVERS_PATH");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string html = bytesOf(file("a.html"));
  EXPECT_THAT(html, HasSubstr("there are no pictures: OpenGL: "));
  EXPECT_THAT(html, HasSubstr("Agreement over the tolerance"));
}

TEST_F(EvaluateReport, IsRefusedBeforeTheWork) {
  expectRefusal(runProgram({"evaluate", "missing.mtg", truth_, "--report", file("a.docx")}), 1,
                {"a.docx: a report is written as HTML or PDF", "ends in .html or .pdf"});
  expectRefusal(runProgram({"evaluate", "missing.mtg", truth_, "--report", file("nowhere/a.html")}),
                1, {"nowhere/a.html", "create the folder first"});
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
  const test::Outcome outcome = runProgram(
      {"evaluate", truth_, truth_, "--scan", file("scan.ply"), "--report", file("a.html")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("scan.ply"));
  EXPECT_EQ(test::namesIn(folder_), std::vector<std::string>{"scan.ply"});
}

} // namespace
} // namespace espalier
