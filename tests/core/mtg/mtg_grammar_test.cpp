// Each rule of the grammar of codes, dialects, comments and encodings; expected values follow from
// OpenAlea's "MTG file syntax".
#include "core/base/error.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"
#include "tests/core/mtg/mtg_text.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::mtgText;
using test::readMtgRows;

Imported<Mtg> importText(const std::string& text, const MtgReadOptions& options = {}) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg", options);
}

std::string refusalOf(const std::string& text, const MtgReadOptions& options = {}) {
  try {
    (void)importText(text, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "read without an error";
}

std::string labelOf(const MtgVertex& vertex) {
  return vertex.symbol + (vertex.index ? vertex.index->text() : "");
}

/// Each vertex with what it is a part of and what it is attached to: "E2(A1)<E1".
std::string shapeOf(const Mtg& mtg) {
  std::string text;
  for (const MtgVertex& vertex : mtg.vertices) {
    text += (text.empty() ? "" : " ") + labelOf(vertex);
    if (vertex.complex) text += '(' + labelOf(mtg.vertices[indexOf(*vertex.complex)]) + ')';
    if (vertex.parent)
      text += static_cast<char>(vertex.edge) + labelOf(mtg.vertices[indexOf(*vertex.parent)]);
  }
  return text;
}

std::string shapeOfRows(const std::string& rows) {
  return shapeOf(readMtgRows(rows).value);
}

/// The values of each vertex at the feature XX.
std::vector<std::string> valuesOf(const Mtg& mtg) {
  std::vector<std::string> values;
  for (const MtgVertex& vertex : mtg.vertices)
    values.push_back(vertex.values.empty() ? "" : vertex.values[0]);
  return values;
}

/// Notes but that on the feature radius, which `mtgText` does not declare.
std::vector<std::string> notesOf(const std::string& rows, const MtgReadOptions& options = {}) {
  std::vector<std::string> notes = eachInEnglish(importText(mtgText(rows), options).notes);
  std::erase_if(notes, [](const std::string& note) { return note.find("'radius'") < note.size(); });
  return notes;
}

TEST(MtgRanges, StandForAllVerticesBetweenTwoIndices) {
  const Mtg mtg = readMtgRows("/P1/A1/E7<<E9+E3\t\t\t1\n").value;
  EXPECT_EQ(shapeOf(mtg), "P1 A1(P1) E7(A1) E8(A1)<E7 E9(A1)<E8 E3(A1)+E9");
  EXPECT_THAT(valuesOf(mtg), testing::ElementsAre("", "", "", "", "", "1"));
}

TEST(MtgRanges, BranchWithTwoPlusSigns) {
  EXPECT_EQ(shapeOfRows("/P1/A1/E7++E9\n"), "P1 A1(P1) E7(A1) E8(A1)+E7 E9(A1)+E8");
}

TEST(MtgRanges, ShareTheValuesOfTheirLineIfAskedTo) {
  EXPECT_THAT(valuesOf(readMtgRows("/P1/A1/E7<<E9\t\t\t1\n").value),
              testing::ElementsAre("", "", "", "", "1"));
  EXPECT_THAT(valuesOf(readMtgRows("/P1/A1/E7<.<E9\t\t\t1\n").value),
              testing::ElementsAre("", "", "1", "1", "1"));
  EXPECT_THAT(valuesOf(readMtgRows("/P1/A1/E7+.+E9\t\t\t1\n").value),
              testing::ElementsAre("", "", "1", "1", "1"));
}

TEST(MtgRanges, ShareNothingWithTheLineBefore) {
  EXPECT_THAT(valuesOf(readMtgRows("/P1/A1/E7\t\t\t5\n^<.<E9\t\t\t1\n").value),
              testing::ElementsAre("", "", "5", "1", "1"));
}

TEST(MtgRanges, ContinueTheVertexOfTheLineBefore) {
  EXPECT_EQ(shapeOfRows("/P1/A1/E1\n^<<E3\n"), "P1 A1(P1) E1(A1) E2(A1)<E1 E3(A1)<E2");
}

TEST(MtgRanges, ThatDoNotCountUpAreSingleEdges) {
  EXPECT_EQ(shapeOfRows("/P1/A1/E5<<E3\n"), "P1 A1(P1) E5(A1) E3(A1)<E5");
  EXPECT_THAT(notesOf("/P1/A1/E5<<E3\n"),
              testing::ElementsAre(testing::HasSubstr("line 21, column 1: the range to 'E3'")));
}

TEST(MtgRanges, OfAbsurdLengthAreRefused) {
  EXPECT_THAT(refusalOf(mtgText("/P1/A1/E1<<E2000000000\n")), testing::HasSubstr("line 21"));
  std::string rows = "/P1/A1/E0\n";
  for (int i = 1; i <= 30; ++i)
    rows += "^<<E" + std::to_string(i * 9000) + '\n';
  EXPECT_THAT(refusalOf(mtgText(rows)), testing::HasSubstr("more than 200000 vertices"));
  EXPECT_THAT(refusalOf(mtgText("/P1/A1/E1<.<E190000\t\t\t1" + std::string(1000, '0') + "\n")),
              testing::HasSubstr("share too many values"));
}

// "AMAPmod" writes the first plant of its manual so.
TEST(MtgNames, InFullReachVerticesReadBefore) {
  const std::string shape = "P1 A1(P1) E1(A1) E2(A1)<E1 E8(A1)+E2 E9(A1)+E2 E3(A1)<E2 E4(A1)+E3";
  EXPECT_EQ(shapeOfRows("/P1/A1\n/P1/A1/E1<E2+E8\n/P1/A1/E1<E2+E9\n/P1/A1/E1<E2<E3+E4\n"), shape);
  EXPECT_EQ(shapeOfRows("/P1/A1\n^/E1<E2\n\t+E8\n\t+E9\n^<E3\n\t+E4\n"), shape);
}

TEST(MtgNames, AreNewForPlantsOfAnotherIndex) {
  EXPECT_EQ(shapeOfRows("/P1/A1\n/P2/A1\n"), "P1 A1(P1) P2 A1(P2)");
}

TEST(MtgNames, WithoutAnIndexAreAlwaysNew) {
  EXPECT_EQ(shapeOfRows("/P/A1\n/P/A1\n"), "P A1(P) P A1(P)");
}

std::string textWithAlias(const std::string& rows) {
  return "CODE: FORM-A\nCLASSES:\n$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\nA\t2\nE\t3\nFEATURES:\n"
         "Alias\tALPHA\nlen\tREAL\nMTG:\nTOPO\t\tAlias\tlen\n" +
         rows;
}

TEST(MtgAliases, BeginCodes) {
  const Mtg mtg =
      importText(textWithAlias("/P1/A1\t\tmain\t3\n(main)/E1<E2+E8\n(main)/E1<E2<E3\n")).value;
  EXPECT_EQ(shapeOf(mtg), "P1 A1(P1) E1(A1) E2(A1)<E1 E8(A1)+E2 E3(A1)<E2");
  EXPECT_EQ(mtg.vertices[1].alias, "main");
  EXPECT_THAT(mtg.vertices[1].values, testing::ElementsAre("", "3"));
}

TEST(MtgAliases, SurviveWriting) {
  Mtg mtg = importText(textWithAlias("/P1/A1\t\tmain\t3\n^/E1\t\tfirst\n")).value;
  std::ostringstream out;
  writeMtg(out, mtg);
  EXPECT_EQ(importText(out.str()).value, mtg);
  mtg.features.erase(mtg.features.begin()); // of a plant whose file declared none
  mtg.vertices[1].values = {"3"};
  std::ostringstream again;
  writeMtg(again, mtg);
  EXPECT_EQ(importText(again.str()).value, mtgAsWritten(mtg));
  EXPECT_EQ(importText(again.str()).value.vertices[1].alias, "main");
}

TEST(MtgAliases, GivenTwiceAreNoted) {
  const auto mtg = importText(textWithAlias("/P1\t\tx\n/P2\t\tx\n(x)/A1\n"));
  EXPECT_EQ(shapeOf(mtg.value), "P1 P2 A1(P2)");
  EXPECT_THAT(eachInEnglish(mtg.notes),
              testing::ElementsAre(testing::HasSubstr("line 13, column 3: the alias")));
}

TEST(MtgDates, SayMoreOfTheLastVertexOfTheirColumn) {
  const Mtg mtg =
      readMtgRows("/P1/A1\t\t\t1\n*\t\t\t2\t7\n^*\t\t\t\t8\n^/E1\n\t+E2\t\t5\n\t*\t\t6\n"
                  "^<E3\n")
          .value;
  EXPECT_EQ(shapeOf(mtg), "P1 A1(P1) E1(A1) E2(A1)+E1 E3(A1)<E1");
  EXPECT_THAT(mtg.vertices[1].values, testing::ElementsAre("1"));
  EXPECT_THAT(mtg.vertices[1].later,
              testing::ElementsAre(testing::ElementsAre("2", "7"), testing::ElementsAre("", "8")));
  EXPECT_THAT(mtg.vertices[3].later, testing::ElementsAre(testing::ElementsAre("6")));
  std::ostringstream out;
  writeMtg(out, mtg);
  EXPECT_EQ(importText(out.str()).value, mtg);
}

// E1 would have three successors if E4, E5 and E6 were attached to the column before.
const std::string continuedRows = "/P1/A1/E1\n\t+E3\n\t<E4\n\t<E5\n^<E6\n";
const std::string continuedShape = "P1 A1(P1) E1(A1) E3(A1)+E1 E4(A1)<E3 E5(A1)<E4 E6(A1)<E1";

TEST(MtgDialects, TakeTheOneThatMakesAPlant) {
  EXPECT_EQ(shapeOfRows(continuedRows), continuedShape);
  EXPECT_THAT(notesOf(continuedRows),
              testing::ElementsAre("plant.mtg: 2 codes with < but no ^ stand below others of their "
                                   "column, the first in line 23: they follow the vertex above "
                                   "them, as OpenAlea reads"));
}

// A successor written after what branches off, as the manual of AMAPmod does.
const std::string shiftedRows = "/P1/A1/E1\n\t+E3\n\t<E4\n";

TEST(MtgDialects, FollowTheSpecificationWhereThatMakesAPlant) {
  EXPECT_EQ(shapeOfRows(shiftedRows), "P1 A1(P1) E1(A1) E3(A1)+E1 E4(A1)<E1");
  EXPECT_THAT(notesOf(shiftedRows),
              testing::ElementsAre(
                  testing::HasSubstr("1 code with < but no ^ stands below another of its column, "
                                     "in line 23: it follows the column before")));
}

TEST(MtgDialects, CanBeAskedFor) {
  EXPECT_EQ(shapeOf(importText(mtgText(shiftedRows), {.dialect = MtgDialect::continuation}).value),
            "P1 A1(P1) E1(A1) E3(A1)+E1 E4(A1)<E3");
  EXPECT_EQ(
      shapeOf(importText(mtgText(continuedRows), {.dialect = MtgDialect::previousColumn}).value),
      "P1 A1(P1) E1(A1) E3(A1)+E1 E4(A1)<E1 E5(A1)<E1 E6(A1)<E1");
}

TEST(MtgDialects, CanBeNamedByTheFile) {
  EXPECT_EQ(shapeOf(importText("# dialect: previous column\n" + mtgText(continuedRows)).value),
            "P1 A1(P1) E1(A1) E3(A1)+E1 E4(A1)<E1 E5(A1)<E1 E6(A1)<E1");
}

TEST(MtgDialects, AreNotNotedWhereTheyAgree) {
  EXPECT_THAT(notesOf("/P1/A1/E1\n\t+E3\n\t^<E4\n\t+E8\n\t\t<E9\n^<E6\n"), testing::IsEmpty());
}

TEST(MtgDialects, AgreeInTheFirstColumn) {
  EXPECT_EQ(shapeOfRows("/P1/A1\n/E1\n<E2\n\t+E3\n<E4\n"),
            "P1 A1(P1) E1(A1) E2(A1)<E1 E3(A1)+E2 E4(A1)<E2");
}

TEST(MtgColumns, NeedNotBeAdjacent) {
  const Mtg mtg = importText("CODE: FORM-A\nCLASSES:\nA\t1\nFEATURES:\nx\tINT\ny\tINT\nMTG:\n"
                             "TOPO\t\ty\t\t\tx\n/A1\t\t2\t\t\t1\n")
                      .value;
  EXPECT_THAT(mtg.features, testing::ElementsAre(MtgFeature{"y", "INT"}, MtgFeature{"x", "INT"}));
  EXPECT_THAT(mtg.vertices[0].values, testing::ElementsAre("2", "1"));
}

TEST(MtgColumns, PartedByBlanksAreRefusedWithAdvice) {
  EXPECT_THAT(refusalOf("CODE: FORM-A\nCLASSES:\nA\t1\nMTG:\nTOPO  x y\n/A1\n"),
              testing::HasSubstr("put tabs between them"));
}

TEST(MtgColumns, LeaveOutValuesAmongTheCodes) {
  EXPECT_THAT(notesOf("/P1\t4\t\t1\n"),
              testing::ElementsAre(testing::HasSubstr("line 21, column 2: '4' stands left")));
}

TEST(MtgSections, MayBeEmptyOrMissing) {
  const auto mtg =
      importText("CODE :  \tFORM-A\nCLASSES\nSYMBOL\tSCALE\nA 1 FREE\n\nDESCRIPTION:\n\n"
                 "FEATURES:\nMTG:\n\n\nENTITY-CODE\n/A1\n");
  EXPECT_EQ(shapeOf(mtg.value), "A1");
  EXPECT_EQ(mtg.value.classes[0].indexation, "FREE");
  EXPECT_THAT(mtg.notes, testing::IsEmpty());
  EXPECT_EQ(importText("CODE: FORM-A\nCLASSES:\nA\t1\nMTG:\nTOPO\tx\n/A1\t5\n").value.features,
            std::vector<MtgFeature>({{"x", "ALPHA"}}));
}

TEST(MtgSections, KeepFilesAndUnknownTypesOfFeatures) {
  const Mtg mtg = importText("CODE: FORM-A\nCLASSES:\nA\t1\nFEATURES:\ngeom\tGEOMETRY\tgeom1.geom\n"
                             "alive\tBOOLEAN\nMTG:\nTOPO\tgeom\talive\n/A1\tbox\ttrue\n")
                      .value;
  EXPECT_EQ(mtg.features[0], (MtgFeature{"geom", "GEOMETRY", "geom1.geom"}));
  std::ostringstream out;
  writeMtg(out, mtg);
  EXPECT_EQ(importText(out.str()).value, mtg);
}

// Read as another code, it could give a wrong plant.
TEST(MtgSections, OfTheOldFormBAreRefused) {
  EXPECT_THAT(refusalOf("CODE: FORM-B\nCLASSES:\nA\t1\nMTG:\nTOPO\n/A1\n"),
              testing::HasSubstr("line 1: the code FORM-B is older than the syntax of MTG files"));
  EXPECT_THAT(refusalOf("CODE: FORM-C\n"), testing::HasSubstr("only MTG files of code FORM-A"));
}

TEST(MtgSections, RefuseAbsurdScalesAndSymbols) {
  EXPECT_THAT(refusalOf("CODE: FORM-A\nCLASSES:\nA\t101\n"), testing::HasSubstr("line 3"));
  EXPECT_THAT(refusalOf("CODE: FORM-A\nCLASSES:\n" + std::string(200, 'A') + "\t1\n"),
              testing::HasSubstr("too long"));
}

TEST(MtgRepairs, DeclareClassesByWhatTheyFollow) {
  const auto mtg = readMtgRows("/P1/A1/E1\n^<F2\n\t+G1/H1\n/Q1\n");
  EXPECT_EQ(shapeOf(mtg.value), "P1 A1(P1) E1(A1) F2(A1)<E1 G1(A1)+F2 H1(G1) Q1(F2)");
  EXPECT_EQ(mtg.value.classes.size(), 8U);
  EXPECT_EQ(mtg.value.classes[6], (MtgClass{.symbol = "H", .scale = 4}));
}

TEST(MtgRepairs, TakeAnEdgeToNothingForTheFirstPart) {
  EXPECT_EQ(shapeOfRows("/P1+A1\n"), "P1 A1(P1)");
  EXPECT_THAT(notesOf("/P1+A1\n"),
              testing::ElementsAre(testing::HasSubstr("no vertex of its scale")));
}

TEST(MtgRepairs, AreErrorsForAStrictReader) {
  EXPECT_THAT(refusalOf(mtgText("/P1+A1\n"), {.isStrict = true}), testing::HasSubstr("line 20"))
      << "the first of them is that radius has no type";
}

TEST(MtgRepairs, AreCountedBeyondTheFirstTwenty) {
  std::string ranges = "/P1/A1/E9\n";
  for (int i = 0; i < 30; ++i)
    ranges += "^<<E1\n";
  const auto counted = importText(mtgText(ranges)).notes;
  EXPECT_EQ(counted.size(), 21U);
  EXPECT_THAT(inEnglish(counted.back()), testing::HasSubstr("11 more places were repaired"));
}

TEST(MtgScene, IsAVertexWhereTheFileNamesIt) {
  const Mtg mtg = readMtgRows("/Scene0\n^/P1\n/P2\n").value;
  EXPECT_EQ(shapeOf(mtg), "Scene0 P1(Scene0) P2(Scene0)");
  EXPECT_EQ(mtg.vertices[0].scale, 0);
}

TEST(MtgLabels, WithoutAnIndexAsJuliaWritesThem) {
  EXPECT_EQ(shapeOfRows("/P-9999\n"), "P");
}

TEST(MtgLabels, MayHoldDigitsInTheirSymbol) {
  const Mtg mtg = importText("CODE: FORM-A\nCLASSES:\nA1x\t1\nA\t2\nMTG:\nTOPO\n/A1x12/A3\n").value;
  EXPECT_EQ(shapeOf(mtg), "A1x12 A3(A1x12)");
}

TEST(MtgComments, EndAtTheNextTab) {
  EXPECT_THAT(valuesOf(readMtgRows("/P1 # one\t\t\t7#x\t\n").value), testing::ElementsAre("7"));
}

TEST(MtgComments, TakeTheWholeLineThatTheyBegin) {
  EXPECT_EQ(shapeOfRows("/P1\n# no\t+A9\n"), "P1");
  EXPECT_THAT(notesOf("/P1\n# no\t+A9\n"),
              testing::ElementsAre(testing::HasSubstr("1 line begins")));
}

TEST(MtgComments, MaySpanLines) {
  EXPECT_EQ(shapeOfRows("/P1(# a\nb\tc\n/P8 #)\n/P2\n"), "P1 P2");
}

TEST(MtgComments, ThatAreNeverClosedEndWithTheirField) {
  EXPECT_EQ(shapeOfRows("/P1 (# a\n/P2 (# b\n"), "P1 P2");
  EXPECT_THAT(notesOf("/P1 (# a\n"), testing::ElementsAre(testing::HasSubstr("is not closed")));
}

TEST(MtgComments, OfJuliaBeginWithASemicolon) {
  EXPECT_EQ(shapeOfRows("; a remark\n/P1 ; one\n"), "P1");
  const Mtg mtg = readMtgRows("/P1\t\t\t1\t2\t3\ta;b\n").value;
  EXPECT_EQ(mtg.vertices[0].values[3], "a;b") << "within a word it is none";
}

TEST(MtgEncoding, MayHaveLineEndsOfWindowsOrOfOldMacs) {
  const std::string text = mtgText("/P1/A1\t\t\t1\n^/E1\n");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text)
      other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(importText(other).value, importText(text).value);
  }
}

TEST(MtgEncoding, TakesOtherBytesForLatin1) {
  const auto mtg = importText(mtgText("/P1\t\t\t1\t2\t3\tch\xEAne\n"));
  EXPECT_EQ(mtg.value.vertices[0].values[3], "ch\xC3\xAAne");
  EXPECT_THAT(eachInEnglish(mtg.notes),
              testing::Contains("plant.mtg: is no UTF-8 and is read as Latin-1"));
  EXPECT_EQ(importText(mtgText("/P1\t\t\t1\t2\t3\tch\xC3\xAAne\n")).value, mtg.value);
}

/// Reads what takes hours where the cost of reading is not linear.
void expectAnAnswerTo(const std::string& text) {
  EXPECT_NO_THROW((void)refusalOf(text));
}

TEST(MtgHostile, HugeFilesAreReadOrRefused) {
  const std::string head = "CODE: FORM-A\nCLASSES:\nA\t1\n";
  expectAnAnswerTo(head + "MTG:\nTOPO\n/A" + std::string(1'000'000, '1') + "\n");
  std::string features = head + "FEATURES:\n"; // many features, of which lines use the last
  for (int i = 0; i < 20000; ++i)
    features += "f" + std::to_string(i) + "\tREAL\n";
  features += "MTG:\nTOPO\tf19999\n";
  for (int i = 0; i < 50000; ++i)
    features += "/A\t1\n";
  expectAnAnswerTo(features);
  std::string deep = head + "MTG:\nTOPO\n/A1";
  for (int i = 0; i < 300'000; ++i)
    deep += "<A";
  expectAnAnswerTo(deep + '\n');
  std::string open = head + "MTG:\nTOPO\n";
  for (int i = 0; i < 200'000; ++i)
    open += "(# ";
  expectAnAnswerTo(open);
}

} // namespace
} // namespace espalier
