#include "core/base/error.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_writer.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <sstream>

namespace espalier {
namespace {

using test::mtgText;

Mtg readWith(const std::string& text, const MtgReadOptions& options = {}) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg", options).value;
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The text after a value of a vertex was set.
std::string textWithValue(const std::string& text, std::size_t vertex, std::size_t feature,
                          const std::string& value) {
  Mtg mtg = readWith(text);
  std::vector<std::string>& values = mtg.vertices[vertex].values;
  values.resize(std::max(values.size(), feature + 1));
  values[feature] = value;
  return mtgTextWith(text, mtg);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

constexpr const char* commented = "# mine\nCODE: FORM-A\n# kinds\nCLASSES:\nA\t1\nFEATURES: # few\n"
                                  "NAME\tTYPE\nx\tINT # one\n\n# all\nMTG:\nTOPO\t\tx # last\n"
                                  "# base\n/A1\t\t2 # two\n# upper\n^<A2\n";

TEST(MtgTextWith, NoChangeIsTheSameText) {
  for (const char* name : {"mtg/code_file.mtg", "mtg/mtg_dynamic.mtg", "mtg/mtg_fig32.mtg",
                           "mtg/jl_simple_plant.mtg", "mtg/test7.mtg", "puu1/expert.mtg"}) {
    ESPALIER_SHARED_FILE(path, name);
    const std::string text = bytesOf(path);
    EXPECT_EQ(mtgTextWith(text, readWith(text)), text) << name;
  }
}

// What an expert cares for: one node moved, one position in the text changed.
TEST(MtgTextWith, AMovedNodeChangesItsPositionAlone) {
  ESPALIER_SHARED_FILE(path, "puu1/expert.mtg");
  const std::string text = bytesOf(path);
  Mtg mtg = readWith(text);
  ASSERT_EQ(mtg.vertices[2].values[0], "-218.881989"); // the second node
  mtg.vertices[2].values[0] = "-200.5";
  mtg.vertices[2].values[2] = "1600";
  const std::string expected =
      replaced(replaced(text, "-218.881989", "-200.5"), "1612.983936", "1600");
  EXPECT_EQ(mtgTextWith(text, mtg), expected);
}

TEST(MtgTextWith, CommentsAndSpacingStay) {
  const std::string text =
      mtgText("# a remark\n\n/P1\t\t\t 1.50 # x\t2\n  ^/A1 (# two\nlines #)\n\n");
  EXPECT_EQ(textWithValue(text, 0, 0, "8"), replaced(text, "1.50", "8"));
  EXPECT_EQ(textWithValue(text, 0, 1, "8"), replaced(text, "\t2\n", "\t8\n"));
}

TEST(MtgTextWith, EmptyCellsAreFilledBeforeTheirComments) {
  const std::string text = mtgText("/P1\t\t\t#none\t7\n^/A1\t\t\t;none\t7\n");
  EXPECT_EQ(textWithValue(text, 0, 0, "8"), replaced(text, "#none", "8 #none"));
  EXPECT_EQ(textWithValue(text, 1, 0, "8"), replaced(text, ";none", "8 ;none"));
}

TEST(MtgTextWith, ShortLinesGetTheTabsTheyNeed) {
  const std::string text = mtgText("/P1/A1\n/P2\t\t\t1 # one\n");
  Mtg mtg = readWith(text);
  mtg.vertices[1].values = {"1", "", "3"};
  EXPECT_EQ(mtgTextWith(text, mtg), replaced(text, "/A1\n", "/A1\t\t\t1\t\t3\n"));
  EXPECT_EQ(textWithValue(text, 2, 2, "3"), replaced(text, "1 # one\n", "1\t\t3 # one\n"));
}

TEST(MtgTextWith, NumbersKeepTheirSpellingIfTheyAreTheSame) {
  const std::string text = mtgText("/P1\t\t\t1.50\t2e+01\tNA\n");
  Mtg mtg = readWith(text);
  mtg.vertices[0].values = {"1.5", "20", ""};
  EXPECT_EQ(mtgTextWith(text, mtg), text);
  mtg.vertices[0].values = {"1.5", "3e+01", ""};
  EXPECT_EQ(mtgTextWith(text, mtg), replaced(text, "2e+01", "30"));
}

TEST(MtgTextWith, ValuesAtOtherDatesChangeInTheirLine) {
  const std::string text = mtgText("/P1\t\t\t1\n*\t\t\t1\n*\t\t\t1\n");
  Mtg mtg = readWith(text);
  mtg.vertices[0].later[1][0] = "9";
  EXPECT_EQ(mtgTextWith(text, mtg), mtgText("/P1\t\t\t1\n*\t\t\t1\n*\t\t\t9\n"));
}

TEST(MtgTextWith, LineEndsOfWindowsStay) {
  std::string text;
  for (const char c : mtgText("/P1/A1\t\t\t1\n"))
    text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(textWithValue(text, 1, 1, "8"), replaced(text, "\t1\r\n", "\t1\t8\r\n"));
  Mtg mtg = readWith(text);
  mtg.vertices.pop_back();
  const std::string shorter = mtgTextWith(text, mtg);
  EXPECT_EQ(readWith(shorter), mtg);
  EXPECT_EQ(std::count(shorter.begin(), shorter.end(), '\n'),
            std::count(shorter.begin(), shorter.end(), '\r'));
}

TEST(MtgTextWith, Latin1StaysUnlessACharacterIsBeyondIt) {
  const std::string text = mtgText("/P1\t\t\t1\t2\t3\tch\xEAne\n");
  EXPECT_EQ(textWithValue(text, 0, 0, "8"), replaced(text, "\t1\t", "\t8\t"));
  EXPECT_EQ(textWithValue(text, 0, 3, "\xC3\xA9"), replaced(text, "ch\xEAne", "\xE9"));
  EXPECT_EQ(textWithValue(text, 0, 3, "\xCF\x80"), replaced(text, "ch\xEAne", "\xCF\x80"));
}

TEST(MtgTextWith, FeaturesThatThePlantDoesNotKnowStay) {
  const std::string text = mtgText("/P1\t\t\t1\t2\t3\tthick\n");
  Mtg mtg = readWith(text);
  mtg.features.pop_back();
  mtg.vertices[0].values = {"1", "8", "3"};
  EXPECT_EQ(mtgTextWith(text, mtg), replaced(text, "1\t2\t3", "1\t8\t3"));
}

TEST(MtgTextWith, ANewVertexGetsALineOfItsOwn) {
  const std::string head = "# mine\n" + mtgText("");
  const std::string text = head + "/P1/A1\t\t\t1\n";
  Mtg mtg = readWith(text);
  mtg.vertices.push_back({.symbol = "E", .index = 7, .scale = 3, .complex = VertexId{1}});
  mtg.vertices.back().values = {"1", "2", "3", "4"};
  EXPECT_EQ(mtgTextWith(text, mtg), head + "/P1/A1\t\t\t1\n^/E7\t\t\t1\t2\t3\t4\n");
}

TEST(MtgTextWith, AVertexThatIsPutBetweenTwoGetsTheLineBetween) {
  const std::string text = mtgText("/P1/A1/E1 # foot\n\t+E2\t\t1\n# up\n^<E3 # top\n");
  Mtg mtg = readWith(text);
  MtgVertex between = mtg.vertices[4]; // E3
  ASSERT_EQ(between.index, 3);
  mtg.vertices[4].parent = VertexId{5};
  between.index = 9;
  mtg.vertices.push_back(between);
  std::swap(mtg.vertices[4], mtg.vertices[5]);
  mtg.vertices[5].parent = VertexId{4};
  EXPECT_EQ(mtgTextWith(text, mtg),
            mtgText("/P1/A1/E1 # foot\n\t+E2\t\t1\n^<E9\t\t\t\t\t\t\n# up\n^<E3 # top\n"));
}

TEST(MtgTextWith, ALineThatGoesLeavesItsComment) {
  const std::string text = mtgText("/P1/A1/E1\n\t+E2\t\t1 # dead, cut\n^<E3\n");
  Mtg mtg = readWith(text);
  mtg.vertices.erase(mtg.vertices.begin() + 3);
  EXPECT_EQ(mtgTextWith(text, mtg), mtgText("/P1/A1/E1\n# at E2: dead, cut\n^<E3\n"));
}

TEST(MtgTextWith, ALabelChangesWithinACodeOfSeveral) {
  const std::string text = mtgText("/P1 / A1/E1 <E2\t\t\t1\n^<E3\n");
  Mtg mtg = readWith(text);
  mtg.vertices[1].index = LabelIndex::in("7.1");
  mtg.vertices[2].index = 10;
  EXPECT_EQ(mtgTextWith(text, mtg), mtgText("/P1 / A7.1/E10 <E2\t\t\t1\n^<E3\n"));
}

TEST(MtgTextWith, CommentsGoToTheEndWithNewVertices) {
  const std::string head = "# mine\n" + mtgText("");
  const std::string text = head +
                           "# base\n/P1/A1\t\t\t1 # dead\t2 ; sure\n\n(# was\ncut #)\n#\t/A2\n"
                           "^/E1\t\t\t1\n#\n# all of it\n";
  Mtg mtg = readWith(text);
  // It is attached to P1, which stands within a line.
  mtg.vertices.push_back({.symbol = "A", .index = 3, .scale = 2, .complex = VertexId{0}});
  const std::string rows = "/P1\t\t\t\t\t\t\n\t/A1\t\t1\t2\t\t\n\t^/E1\t\t1\t\t\t\n"
                           "^/A3\t\t\t\t\t\t\n";
  const std::string comments =
      "# before A1: base\n# at A1: dead\n# at A1: sure\n"
      "# before E1: was\n# before E1: cut\n# before E1: /A2\n# all of it\n";
  const std::string result = mtgTextWith(text, mtg);
  EXPECT_EQ(result, head + rows + comments);
  mtg.vertices.pop_back();
  EXPECT_EQ(mtgTextWith(result, mtg), replaced(result, "^/A3\t\t\t\t\t\t\n", "")); // and stay
}

TEST(MtgTextWith, CommentsOfSectionsThatAreMadeAnewGoToTheEnd) {
  const std::string text =
      "# mine\nCODE: FORM-A\n# kinds\nCLASSES:\nA\t1\nMTG:\nTOPO\n# base\n/A1\n";
  Mtg mtg = readWith(text);
  mtg.features.push_back({"age", "INT"});
  mtg.vertices[0].values = {"4"};
  const std::string result = mtgTextWith(text, mtg);
  EXPECT_THAT(result, testing::StartsWith("# mine\nCODE"));
  EXPECT_THAT(result, testing::EndsWith("\n/A1\t4\n# kinds\n# before A1: base\n"));
}

TEST(MtgTextWith, TheOrderOfColumnsStaysWithNewVertices) {
  const std::string head = "CODE: FORM-A\nCLASSES:\nA\t1\nFEATURES:\nx\tINT\ny\tINT\nMTG:\n"
                           "TOPO\t\ty\t\t\tx\n";
  const std::string text = head + "/A1\t\t2\t\t\t1\n";
  Mtg mtg = readWith(text);
  mtg.vertices.push_back({.symbol = "A", .parent = VertexId{0}, .values = {"4", "3"}});
  EXPECT_EQ(mtgTextWith(text, mtg), head + "/A1\t\t2\t\t\t1\n^<A\t\t4\t\t\t3\n");
}

TEST(MtgTextWith, MoreColumnsAreMadeWhereTheyDoNotSuffice) {
  const std::string head = "CODE: FORM-A\nCLASSES:\nA\t1\nMTG:\n";
  const std::string text = head + "TOPO\tx\n/A1\t2\n^<A\t\n";
  Mtg mtg = readWith(text);
  mtg.vertices.push_back({.symbol = "A", .parent = VertexId{0}, .edge = EdgeType::branching});
  EXPECT_EQ(mtgTextWith(text, mtg), head + "ENTITY-CODE\t\tx\n/A1\t\t2\n\t+A\t\n^<A\t\t\n");
}

TEST(MtgTextWith, ABranchAtATipNeedsNoFurtherColumn) {
  const std::string text = "CODE: FORM-A\nCLASSES:\nA\t1\nMTG:\nTOPO\tx\n/A1\t2\n";
  Mtg mtg = readWith(text);
  mtg.vertices.push_back({.symbol = "A", .parent = VertexId{0}, .edge = EdgeType::branching});
  EXPECT_EQ(mtgTextWith(text, mtg), text + "^+A\t\n");
}

TEST(MtgTextWith, NewClassesAndFeaturesGetTheirSections) {
  const std::string text = "# mine\n" + mtgText("/P1\n");
  Mtg mtg = readWith(text);
  mtg.classes.push_back({.symbol = "B", .scale = 4});
  mtg.features.push_back({"age", "INT"});
  mtg.vertices.push_back({.symbol = "B", .scale = 4, .complex = VertexId{0}});
  mtg.vertices.back().values = {"", "", "", "", "5"};
  const std::string result = mtgTextWith(text, mtg);
  EXPECT_THAT(result, testing::StartsWith("# mine\nCODE"));
  EXPECT_EQ(readWith(result), mtg);
}

TEST(MtgTextWith, ANewFeatureGetsALineAndAColumnAndLeavesAllElse) {
  Mtg mtg = readWith(commented);
  mtg.features.push_back({"age", "REAL"});
  mtg.vertices[0].values = {"2", "5.5"};
  mtg.vertices[1].values = {"", "3"};
  std::string expected = replaced(commented, "x\tINT # one\n", "x\tINT # one\nage\tREAL\n");
  expected = replaced(expected, "TOPO\t\tx # last", "TOPO\t\tx\tage # last");
  expected = replaced(expected, "/A1\t\t2 # two", "/A1\t\t2\t5.5 # two");
  expected = replaced(expected, "^<A2\n", "^<A2\t\t\t3\n");
  EXPECT_EQ(mtgTextWith(commented, mtg), expected);
}

TEST(MtgTextWith, ANewFeatureWithNewVerticesLeavesTheSections) {
  Mtg mtg = readWith(commented);
  mtg.features.push_back({"age", "REAL"});
  mtg.vertices.push_back({.symbol = "A", .parent = VertexId{1}, .values = {"", "7"}});
  const std::string result = mtgTextWith(commented, mtg);
  EXPECT_THAT(result, testing::StartsWith("# mine\nCODE: FORM-A\n# kinds\nCLASSES:\nA\t1\n"
                                          "FEATURES: # few\nNAME\tTYPE\nx\tINT # one\n"
                                          "age\tREAL\n\n# all\nMTG:\nTOPO\t\tx\tage # last\n"));
  EXPECT_EQ(readWith(result), mtg);
}

TEST(MtgTextWith, AFirstFeatureMakesTheSectionsAnew) {
  const std::string text = "CODE: FORM-A\nCLASSES:\nA\t1\nMTG:\nTOPO\n/A1\n";
  Mtg mtg = readWith(text);
  mtg.features.push_back({"age", "INT"});
  mtg.vertices[0].values = {"4"};
  EXPECT_EQ(readWith(mtgTextWith(text, mtg)), mtg);
}

TEST(MtgTextWith, AChangedVertexOfARangeIsWrittenOut) {
  const std::string text = mtgText("/P1/A1/E1<<E3\t\t\t1\n");
  const std::string result = textWithValue(text, 3, 0, "8");
  EXPECT_EQ(readWith(result).vertices[3].values, std::vector<std::string>{"8"});
  EXPECT_EQ(readWith(result).vertices[4].values, std::vector<std::string>{"1"});
  EXPECT_EQ(textWithValue(text, 4, 0, "8"), replaced(text, "\t1\n", "\t8\n"));
}

TEST(MtgTextWith, RefusesValuesThatNoTextCanHold) {
  const std::string text = mtgText("/P1\t\t\t1\n");
  EXPECT_THROW((void)textWithValue(text, 0, 3, "a#b"), Error);
}

TEST(MtgTextWith, IsReadByTheDialectOfTheFile) {
  const std::string text = mtgText("/P1/A1/E1\n\t+E3\n\t<E4\n");
  const MtgReadOptions options{.dialect = MtgDialect::continuation};
  Mtg mtg = readWith(text, options);
  mtg.vertices[4].values = {"8"};
  EXPECT_EQ(mtgTextWith(text, mtg, options), replaced(text, "<E4\n", "<E4\t\t8\n"));
}

} // namespace
} // namespace espalier
