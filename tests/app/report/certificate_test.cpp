#include "app/report/certificate.h"
#include "app/report/pdf_report.h"
#include "tests/app/report/reported_plants.h"
#include "tests/app/report/whole_seal.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::aboutSeal;
using test::cellOf;
using test::textOf;
using test::wholeSeal;

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
  EXPECT_EQ(test::pagesOf(pdfOf(test::crowdedCertificate())), 1);
}

TEST(Certificate, ListsEachCommentOnce) {
  Skeleton plant = test::branched();
  plant.setReview(NodeId{3}, {.comment = "thin"});
  plant.setReview(NodeId{4}, {.comment = "broken", .reviewer = "Ben"});
  plant.setReview(NodeId{5}, {.comment = "broken", .reviewer = "Ben"});
  const std::vector<SealedComment> expected = {{"broken", "Ben", 2, NodeId{4}},
                                               {"thin", {}, 1, NodeId{3}}};
  EXPECT_EQ(commentsOf(plant), expected);
  CertificateAbout about = aboutSeal();
  about.comments = expected;
  QStringList places;
  const Report report = certificate(wholeSeal(), {}, about);
  for (const auto& block : report.sections.front().blocks)
    if (const auto* table = std::get_if<ReportTable>(&block))
      if (table->columns.back().title == "at node")
        for (const auto& row : table->rows)
          places.append(row.back().text);
  EXPECT_EQ(places, (QStringList{"4 and 1 more", "3"}));
}

} // namespace
} // namespace espalier
