#include "app/report/certificate.h"
#include "app/report/pdf_report.h"
#include "core/skeleton/finding.h"
#include "tests/app/report/reported_plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::cellOf;
using test::textOf;

/// With all that a seal can state.
Seal wholeSeal() {
  return {.author = "Anna",
          .time = 1'763'733'909'123,
          .work = {{.edits = 12, .added = 40, .removed = 7, .moved = 19}, 3'600'000},
          .nodes = 3358,
          .length = 156.486,
          .review = ReviewRecord{.lookedAt = {3000, 140},
                                 .inBulk = {300, 16},
                                 .before = {58, 0.5},
                                 .doubted = {20, 1},
                                 .comments = 9},
          .state = SealedState{
              .findings = {{"sharp_turn", 2}, {"crossing", 1}},
              .ignored = 5,
              .points = 147'989,
              .unexplained = 1480,
              .ignoredPlaces = 3,
              .ignoredPoints = 444,
              .questions = SealedQuestions{.answered = 14, .open = 2},
              .automatic = SealedAgreement{"the reconstruction", 0.01, 0.91, 0.85, 0.879, 0.84},
              .other = SealedAgreement{"second.mtg", 0.01, 0.98, 0.97, 0.975, 0.93},
              .reason = "the two turns are real"}};
}

CertificateAbout aboutSeal() {
  return {.plant = {"pine.espalier", QString(64, 'a')},
          .scan = ReportedFile{"pine.ply", QString(64, 'b')},
          .version = "9.8.7",
          .unit = LengthUnit::meter,
          .comments = {}};
}

TEST(Certificate, StatesAllThatTheSealDoes) {
  const Report report = certificate(wholeSeal(), {}, aboutSeal());
  ASSERT_EQ(report.sections.size(), 1U);
  const ReportSection& page = report.sections.front();
  EXPECT_TRUE(page.title.startsWith("Signed by Anna on 21 Nov 2025, "));
  EXPECT_EQ(cellOf(page, "Looked at", 1),
            formatCount(3000) + " nodes, " + formatLength(140, LengthUnit::meter));
  EXPECT_TRUE(cellOf(page, "Findings", 1).startsWith("3 open ("));
  EXPECT_TRUE(cellOf(page, "Findings", 1).contains("sharp turns: 2"));
  EXPECT_TRUE(cellOf(page, "Findings", 1).endsWith("; 5 ignored"));
  EXPECT_EQ(cellOf(page, "Points without wood", 1),
            formatCount(1480) + " of " + formatCount(147'989) +
                " (1.0 %); at 3 places ignored as no wood: 444 (0.3 %)");
  EXPECT_EQ(cellOf(page, "Why they are left", 1), "the two turns are real");
  EXPECT_EQ(cellOf(page, "Questions", 1), "14 answered, 2 open");
  EXPECT_TRUE(cellOf(page, "Agreement with the reconstruction", 1).startsWith("F 0.879 within "));
  EXPECT_TRUE(cellOf(page, "Agreement with second.mtg", 1).endsWith("T 0.930"));
  EXPECT_TRUE(textOf(page).contains("marked as reviewed in bulk")) << qPrintable(textOf(page));
}

TEST(Certificate, StatesFewIgnoredPointsAsMoreThanNone) {
  Seal seal = wholeSeal();
  seal.state->ignoredPlaces = 1;
  seal.state->ignoredPoints = 12;
  const auto points = [&] {
    const ReportSection page = certificate(seal, {}, aboutSeal()).sections.front();
    return cellOf(page, "Points without wood", 1);
  };
  EXPECT_TRUE(points().endsWith("; at 1 place ignored as no wood: 12 (0.008 %)"));
  seal.state->ignoredPlaces = seal.state->ignoredPoints = 0;
  EXPECT_TRUE(points().endsWith(" (1.0 %)"));
}

TEST(Certificate, OfACleanSealWarnsOfNothing) {
  Seal seal = wholeSeal();
  seal.review->inBulk = seal.review->before = {};
  seal.state->findings.clear();
  seal.state->reason.clear();
  const ReportSection page = certificate(seal, {}, aboutSeal()).sections.front();
  for (const ReportBlock& block : page.blocks)
    EXPECT_FALSE(std::holds_alternative<ReportWarnings>(block));
  EXPECT_TRUE(cellOf(page, "Findings", 1).startsWith("none is open"));
  EXPECT_TRUE(cellOf(page, "Why they are left", 1).isEmpty());
}

TEST(Certificate, StatesThatAllWasLookedAtOnlyWhereItWas) {
  const auto statesIt = [](const Seal& seal) {
    const QString page = textOf(certificate(seal, {}, aboutSeal()).sections.front());
    return page.contains("has looked at all of this structure");
  };
  Seal seal = wholeSeal();
  EXPECT_FALSE(statesIt(seal));
  seal.review->inBulk = {};
  EXPECT_FALSE(statesIt(seal)) << "some came with the plant";
  seal.review->before = {};
  EXPECT_TRUE(statesIt(seal));
  seal.review.reset();
  EXPECT_FALSE(statesIt(seal)) << "nobody knows";
}

TEST(Certificate, OfASealOfAnOlderProgramSaysSo) {
  Seal seal = wholeSeal();
  seal.review.reset();
  seal.state.reset();
  EXPECT_TRUE(
      textOf(certificate(seal, {}, aboutSeal()).sections.front()).contains("older program"));
}

TEST(Certificate, IsOnePage) {
  ReportPictures pictures;
  for (QImage ReportPictures::*each :
       {&ReportPictures::front, &ReportPictures::side, &ReportPictures::scan}) {
    pictures.*each = QImage(900, 1200, QImage::Format_RGB32);
    (pictures.*each).fill(Qt::white);
  }
  CertificateAbout crowded = aboutSeal();
  for (std::size_t i = 0; i < 30; ++i)
    crowded.comments.push_back({QString("a twig that may be dead, ").repeated(8), "Anna", 30});
  Seal seal = wholeSeal();
  for (int kind = 0; kind < findingKinds; ++kind)
    seal.state->findings[nameOf(static_cast<Finding::Kind>(kind))] = 100;
  seal.state->reason = QString("as it stands in the scan, ").repeated(11).toStdString();
  const QByteArray pdf = pdfOf(certificate(seal, pictures, crowded));
  EXPECT_EQ(test::pagesOf(pdf), 1);
}

TEST(Certificate, ListsEachCommentOnce) {
  Skeleton plant = test::branched();
  plant.setReview(NodeId{3}, {.comment = "thin"});
  plant.setReview(NodeId{4}, {.comment = "broken", .reviewer = "Ben"});
  plant.setReview(NodeId{5}, {.comment = "broken", .reviewer = "Ben"});
  const std::vector<SealedComment> expected = {{"broken", "Ben", 2}, {"thin", {}, 1}};
  EXPECT_EQ(commentsOf(plant), expected);
}

} // namespace
} // namespace espalier
