#include "app/report/choice_record.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <variant>

namespace espalier {
namespace {

std::vector<ChoiceRecord> someRecords() {
  QImage picture(3, 2, QImage::Format_RGB32);
  picture.fill(QColor(10, 120, 60));
  ChoiceState a{.name = "A", .options = {}, .picture = picture, .numbers = {{"Nodes", "12"}}};
  ChoiceState preview{.name = "Preview",
                      .options = "Contract: radius 12 mm",
                      .picture = {},
                      .numbers = {{"Nodes", "14"}, {"Lost ends", "2"}},
                      .isTaken = true};
  return {{.title = "A and Preview",
           .time = "22.11.26 05:00",
           .seen = "Green: the points.",
           .meanings = {{"Nodes", "Nodes of the skeleton"}, {"Webbed", "Of no state"}},
           .states = {a, preview}}};
}

TEST(ChoiceRecord, ComesBackAsItWasWritten) {
  const std::vector<ChoiceRecord> back = readChoices(writeChoices(someRecords()));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].title, "A and Preview");
  EXPECT_EQ(back[0].time, "22.11.26 05:00");
  EXPECT_EQ(back[0].seen, "Green: the points.");
  EXPECT_EQ(back[0].meanings, someRecords()[0].meanings);
  ASSERT_EQ(back[0].states.size(), 2U);
  EXPECT_EQ(back[0].states[0].picture.size(), QSize(3, 2));
  EXPECT_EQ(back[0].states[0].picture.pixelColor(1, 1), QColor(10, 120, 60));
  EXPECT_TRUE(back[0].states[1].picture.isNull());
  EXPECT_EQ(back[0].states[1].numbers, someRecords()[0].states[1].numbers);
  EXPECT_TRUE(back[0].states[1].isTaken);
  EXPECT_TRUE(readChoices(writeChoices({})).empty());
}

TEST(ChoiceRecord, RefusesWhatIsNone) {
  EXPECT_THROW((void)readChoices("{"), Error);
  EXPECT_THROW((void)readChoices("{\"title\": 1}"), Error);
}

TEST(ChoiceRecord, IsTheTableAndThePicturesOfAReport) {
  const ReportSection section = choicesSection(someRecords());
  EXPECT_EQ(section.title, "How options were chosen");
  ASSERT_EQ(section.blocks.size(), 4U);
  EXPECT_EQ(std::get<ReportParagraph>(section.blocks[0]).text,
            "A and Preview, 22.11.26 05:00. Green: the points.");
  const auto& figures = std::get<ReportFigures>(section.blocks[1]);
  ASSERT_EQ(figures.figures.size(), 1U) << "one has no picture";
  EXPECT_EQ(figures.figures[0].title, "A");
  EXPECT_EQ(figures.figures[0].text, "") << "its name says it";
  const auto& table = std::get<ReportTable>(section.blocks[2]);
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[2].title, "Preview (in use then)");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][2].text, "14");
  EXPECT_EQ(table.rows[1][1].text, "–") << "A has no such number";
}

TEST(ChoiceRecord, DefinesEachNumberOfAReportOnce) {
  std::vector<ChoiceRecord> records = someRecords();
  records.push_back(records.front());
  const ReportSection section = choicesSection(records);
  const auto& terms = std::get<ReportTerms>(section.blocks.back()).terms;
  ASSERT_EQ(terms.size(), 1U) << "in one list for both, of what the tables have";
  EXPECT_EQ(terms[0].name, "Nodes");
  EXPECT_EQ(terms[0].text, "Nodes of the skeleton");
}

} // namespace
} // namespace espalier
