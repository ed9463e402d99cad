#include "core/base/error.h"
#include "core/mtg/mtg_reader.h"
#include "tests/core/mtg/mtg_text.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::mtgText;
using test::readMtgRows;

VertexId vertex(std::uint32_t number) {
  return VertexId{number};
}

std::string messageOf(const std::string& text) {
  std::istringstream in(text);
  try {
    (void)readMtg(in, "plant.mtg");
  } catch (const Error& error) {
    return error.what();
  }
  return "read without an error";
}

TEST(ReadMtg, KeepsClassesRulesAndFeatures) {
  const Mtg mtg = readMtgRows("/P1\n").value;
  ASSERT_EQ(mtg.classes.size(), 4U);
  EXPECT_EQ(mtg.classes[1], (MtgClass{.symbol = "P", .scale = 1}));
  EXPECT_EQ(mtg.classes[0].definition, "IMPLICIT");
  ASSERT_EQ(mtg.rules.size(), 1U);
  EXPECT_EQ(mtg.rules[0], (MtgRule{"E", "E,A", "+", "?"}));
  ASSERT_EQ(mtg.features.size(), 4U);
  EXPECT_EQ(mtg.features[0], (MtgFeature{"XX", "REAL"}));
  EXPECT_EQ(mtg.features[3], (MtgFeature{"radius", "ALPHA"})) << "it is not declared";
}

TEST(ReadMtg, AttachesCodesByColumnAndCaret) {
  const Mtg mtg = readMtgRows("/P1/A1\n^/E1\n^<E2\n\t+E3\n\t^<E4\n^<E5\n").value;
  ASSERT_EQ(mtg.vertices.size(), 7U);
  EXPECT_EQ(mtg.vertices[1].complex, vertex(0));
  EXPECT_EQ(mtg.vertices[2].complex, vertex(1)) << "E1 is a part of A1";
  EXPECT_EQ(mtg.vertices[2].parent, std::nullopt);
  EXPECT_EQ(mtg.vertices[4].parent, vertex(3)) << "E3 branches from E2";
  EXPECT_EQ(mtg.vertices[4].edge, EdgeType::branching);
  EXPECT_EQ(mtg.vertices[5].parent, vertex(4)) << "E4 follows E3";
  EXPECT_EQ(mtg.vertices[5].edge, EdgeType::successor);
  EXPECT_EQ(mtg.vertices[6].parent, vertex(3)) << "E5 follows E2";
  EXPECT_EQ(mtg.vertices[6].complex, vertex(1));
  EXPECT_EQ(mtg.vertices[6].index, 5);
}

TEST(ReadMtg, AttachesTheFirstPartWhereItsWholeBranches) {
  const Mtg mtg = readMtgRows("/P1/A1/E1<E2+A2/E3\n").value;
  ASSERT_EQ(mtg.vertices.size(), 6U);
  EXPECT_EQ(mtg.vertices[4].parent, vertex(1)) << "A2 branches from A1";
  EXPECT_EQ(mtg.vertices[4].edge, EdgeType::branching);
  EXPECT_EQ(mtg.vertices[5].complex, vertex(4));
  EXPECT_EQ(mtg.vertices[5].parent, vertex(3)) << "E3 branches from E2";
  EXPECT_EQ(mtg.vertices[5].edge, EdgeType::branching);
}

TEST(ReadMtg, GivesValuesToTheLastVertexOfALine) {
  const Mtg mtg = readMtgRows("/P1/A1\t\t\t1.5\t\t-2\n").value;
  EXPECT_TRUE(mtg.vertices[0].values.empty());
  EXPECT_THAT(mtg.vertices[1].values, testing::ElementsAre("1.5", "", "-2"));
}

TEST(ReadMtg, PassesOverCommentsAndEmptyLines) {
  const Mtg mtg = readMtgRows("\n# a remark\n/P1 # one\t\t\t7\n\t\t\n").value;
  ASSERT_EQ(mtg.vertices.size(), 1U);
  EXPECT_THAT(mtg.vertices[0].values, testing::ElementsAre("7"));
}

TEST(ReadMtg, NotesValuesWithoutAColumn) {
  const Imported<Mtg> mtg = readMtgRows("/P1\t\t\t1\t2\t3\t4\t5\n");
  EXPECT_THAT(eachInEnglish(mtg.notes),
              testing::Contains("plant.mtg: 1 value stands in a column without a name and is left "
                                "out"));
  EXPECT_THAT(eachInEnglish(readMtgRows("/P1\t\t\t1\t2\t3\t4\t5\t6\n").notes),
              testing::Contains("plant.mtg: 2 values stand in columns without a name and are left "
                                "out"));
}

TEST(ReadMtg, NamesTheCellThatIsWrong) {
  const auto refusalOf = [](const std::string& rows) { return messageOf(mtgText(rows)); };
  EXPECT_EQ(refusalOf("/P1\n^<?1\n"),
            "plant.mtg, line 22, column 1: '?1' begins with no symbol of the section CLASSES "
            "('$, P, A, E'): type one of these, and behind it its index, as in U1 or S16.1");
  EXPECT_EQ(refusalOf("/P1\t\t\t1\t2\tx\n"),
            "plant.mtg, line 21, column 6: ZZ is 'x', expected a number");
  EXPECT_THAT(refusalOf("/P1\t\t\t1,5\n"), testing::HasSubstr("a decimal point, not a comma"));
  EXPECT_THAT(refusalOf("/P1\n\t\t+A1\n"), testing::StartsWith("plant.mtg, line 22, column 3: "));
  EXPECT_THAT(refusalOf("/P1\n^N\n"), testing::StartsWith("plant.mtg, line 22, column 1: "));
  EXPECT_THAT(refusalOf("/P1\n^\n"), testing::StartsWith("plant.mtg, line 22, column 1: "));
  EXPECT_THAT(refusalOf("/P1\n^/\n"), testing::StartsWith("plant.mtg, line 22, column 1: "));
  EXPECT_THAT(refusalOf("/P1^/A1\n"), testing::HasSubstr("'^' may stand only at the beginning"));
  EXPECT_THAT(refusalOf("+E1\n"), testing::StartsWith("plant.mtg, line 21, column 1: "));
  EXPECT_THAT(refusalOf("/P1\t/A1\n"), testing::HasSubstr("line 21, column 2: two codes"));
  EXPECT_THAT(refusalOf("\t\t\t1\n"), testing::HasSubstr("line 21, column 4: values"));
  EXPECT_THAT(refusalOf("*\t\t\t1\n"), testing::StartsWith("plant.mtg, line 21, column 1: "));
  EXPECT_THAT(refusalOf("/P99999999999\n"), testing::HasSubstr("too large"));
  EXPECT_THAT(refusalOf("/P1\n(X)/A1\n"), testing::HasSubstr("no vertex before is named 'X'"));
  EXPECT_THAT(refusalOf("/P1\n(X/A1\n"), testing::HasSubstr("not closed with )"));
}

TEST(ReadMtg, RefusesWhatIsNoMtg) {
  EXPECT_EQ(messageOf(""), "plant.mtg: is empty");
  EXPECT_THAT(messageOf("1 2 3\n"), testing::StartsWith("plant.mtg, line 1: expected 'CODE"));
  EXPECT_THAT(messageOf("CODE: FORM-C\n"), testing::HasSubstr("'FORM-C'"));
  EXPECT_THAT(messageOf("CODE: FORM-A\n"), testing::HasSubstr("no section 'MTG:'"));
  EXPECT_THAT(messageOf("CODE: FORM-A\nMTG:\n"), testing::HasSubstr("no CLASSES"));
  EXPECT_THAT(messageOf(mtgText("")), testing::HasSubstr("holds no vertices"));
}

} // namespace
} // namespace espalier
