#include "core/io/csv.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CsvTable importCsv(const std::string& text) {
  return readCsv(text, "plants.csv");
}

std::string refusalOfCsv(const std::string& text) {
  return test::errorOf([&] { return importCsv(text); });
}

TEST(Csv, ReadsNamesAndRowsWithTheirLines) {
  const CsvTable table = importCsv("name, scan\noak,oak.ply\r\n\n , \nelm, elm.ply ");
  EXPECT_THAT(table.names, ElementsAre("name", "scan"));
  ASSERT_EQ(table.rows.size(), 2U) << "lines of blanks do not count";
  EXPECT_THAT(table.rows[0].fields, ElementsAre("oak", "oak.ply"));
  EXPECT_THAT(table.rows[1].fields, ElementsAre("elm", "elm.ply"));
  EXPECT_EQ(table.rows[1].line, 5U);
}

TEST(Csv, TakesSemicolonsAndTabsThatTheFirstLineHas) {
  EXPECT_THAT(importCsv("a;b\n1,5;2\n").rows.at(0).fields, ElementsAre("1,5", "2"));
  EXPECT_THAT(importCsv("\xEF\xBB\xBF"
                        "a\tb\n1;5\t2\n")
                  .rows.at(0)
                  .fields,
              ElementsAre("1;5", "2"));
}

TEST(Csv, FindsAColumnWhateverTheCaseOfItsLetters) {
  const CsvTable table = importCsv("Name,SCAN\n");
  EXPECT_EQ(table.column("scan"), 1U);
  EXPECT_FALSE(table.column("root"));
}

TEST(Csv, FillsUpARowThatIsTooShort) {
  EXPECT_THAT(importCsv("a,b,c\n1\n").rows.at(0).fields, ElementsAre("1", "", ""));
}

TEST(Csv, ReadsBackWhatItWrites) {
  const std::vector<std::string> fields = {"oak",  "two, three", "said \"no\"", " blanks ",
                                           "a\nb", "",           "a;b"};
  const CsvTable table = importCsv(csvLine({"a", "b", "c", "d", "e", "f", "g"}) + csvLine(fields));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].fields, fields);
}

TEST(Csv, RefusesBrokenTablesWithTheLine) {
  EXPECT_THAT(refusalOfCsv(""), HasSubstr("plants.csv, line 1: there are no names"));
  EXPECT_THAT(refusalOfCsv("a,b,A\n"), HasSubstr("line 1: two columns are named 'A'"));
  EXPECT_THAT(refusalOfCsv("a,b\n1,2\n1,2,3\n"), HasSubstr("line 3: expected 2 fields, found 3"));
  EXPECT_THAT(refusalOfCsv("a\n\"1\n2\n"), HasSubstr("line 2: a quote is not closed"));
  EXPECT_THAT(refusalOfCsv("a,b\n\"1\"2,3\n"), HasSubstr("line 2: there is text behind"));
}

TEST(Csv, WritesFormulasOfSpreadsheetsAsText) {
  EXPECT_EQ(csvLine({"=1+1", "+cmd", "-x", "@a", "'=1", "-1.5", "+2", "-", "it's", "a=b"}),
            "'=1+1,'+cmd,'-x,'@a,''=1,-1.5,+2,-,it's,a=b\n");
}

TEST(Csv, ReadsFormulasBackAsTheyWere) {
  const std::vector<std::string> fields = {"=1+1", "'=1", "''=1", "=a,\"b\"", "@x", "-1", "'x"};
  const CsvTable table = importCsv(csvLine({"a", "b", "c", "d", "e", "f", "g"}) + csvLine(fields));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].fields, fields);
}

TEST(Csv, GuardsNoNumbers) {
  const std::vector<std::string> fields = {"-1.25", "-3e-4", "-1.25 0.5 -3e-4", "'-1 2 3"};
  const std::string line = csvLine(fields);
  EXPECT_EQ(line, "-1.25,-3e-4,-1.25 0.5 -3e-4,''-1 2 3\n");
  EXPECT_EQ(importCsv("a,b,c,d\n" + line).rows.at(0).fields, fields);
  EXPECT_EQ(csvLine({"-1 2+3", "-1 -x"}), "'-1 2+3,'-1 -x\n");
}

TEST(Csv, ReadsPositionsThatWereGuardedOnce) {
  EXPECT_THAT(importCsv("root\n'-1.25 0.5 2\n").rows.at(0).fields, ElementsAre("-1.25 0.5 2"));
}

TEST(Csv, ReadsNamesThatAreFormulasBackAsTheyWere) {
  const CsvTable table = importCsv(csvLine({"=1+1", "'@a", "-b"}));
  EXPECT_THAT(table.names, ElementsAre("=1+1", "'@a", "-b"));
  EXPECT_EQ(table.column("=1+1"), 0U);
}

TEST(Csv, RefusesMoreColumnsThanAnyTableHas) {
  std::string names;
  for (int i = 0; i < 2000; ++i)
    names += "c" + std::to_string(i) + ',';
  EXPECT_THAT(refusalOfCsv(names + "\n"), HasSubstr("line 1: there are 2001 columns, more than"));
}

TEST(Csv, NamesUtf16) {
  EXPECT_THAT(refusalOfCsv(std::string("\xFF\xFEs\0c\0", 6)),
              HasSubstr("plants.csv: is text of two bytes per character (UTF-16"));
}

} // namespace
} // namespace espalier
