#include "app/report/html_report.h"
#include "app/report/pdf_report.h"
#include "app/report/pdf_table.h"
#include "app/report/write_report.h"
#include "core/base/error.h"
#include "tests/app/report/reported_plants.h"
#include "tests/support/shared_data.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::HasSubstr;

Report sample(const ReportAbout& about = test::aboutPlants()) {
  ReportPictures pictures;
  pictures.front = pictures.side = pictures.result = pictures.reference =
      QImage(60, 80, QImage::Format_RGB32);
  for (QImage* image : {&pictures.front, &pictures.side, &pictures.result, &pictures.reference})
    image->fill(Qt::white);
  pictures.errors.push_back(pictures.front);
  return comparisonReport(test::reported(test::stick(21, 0.1), test::branched(), 0.02), pictures,
                          about);
}

/// The names of elements and attributes, and all texts; fails where it is not well-formed.
struct Parsed {
  QStringList elements;
  QStringList sources; // values of src and href
  QString text;
};
Parsed parse(const QByteArray& html) {
  Parsed parsed;
  QXmlStreamReader reader(html);
  while (!reader.atEnd()) {
    reader.readNext();
    if (reader.isStartElement()) {
      parsed.elements << reader.name().toString();
      for (const auto& attribute : reader.attributes())
        if (attribute.name() == QLatin1String("src") || attribute.name() == QLatin1String("href"))
          parsed.sources << attribute.value().toString();
    }
    if (reader.isCharacters()) parsed.text += reader.text();
  }
  EXPECT_FALSE(reader.hasError()) << qPrintable(reader.errorString()) << ", line "
                                  << reader.lineNumber();
  return parsed;
}

TEST(HtmlReport, IsWellFormedAndFetchesNothing) {
  const QByteArray html = htmlOf(sample());
  const Parsed parsed = parse(html);
  EXPECT_EQ(parsed.elements.count("img"), 5);
  EXPECT_EQ(parsed.elements.count("svg"), 1);
  for (const char* fetching : {"script", "link", "iframe", "object", "a"})
    EXPECT_EQ(parsed.elements.count(fetching), 0) << fetching;
  for (const QString& source : parsed.sources)
    EXPECT_TRUE(source.startsWith("data:image/png;base64,") || source.startsWith('#'))
        << qPrintable(source.left(60));
  for (const char* address : {"http:", "https:", "url(", "@import", "file:"})
    EXPECT_FALSE(html.contains(address)) << address;
}

TEST(HtmlReport, HoldsWhatTheModelSays) {
  const Report report = sample();
  const Parsed parsed = parse(htmlOf(report));
  EXPECT_TRUE(parsed.text.contains(report.title));
  for (const ReportSection& section : report.sections) {
    EXPECT_TRUE(parsed.text.contains(section.title)) << qPrintable(section.title);
    for (const ReportBlock& block : section.blocks) {
      const auto* table = std::get_if<ReportTable>(&block);
      if (table == nullptr) continue;
      for (const auto& row : table->rows)
        for (const ReportCell& cell : row)
          EXPECT_TRUE(parsed.text.contains(cell.text)) << qPrintable(cell.text);
    }
  }
}

TEST(HtmlReport, IsTheSameButForTheDate) {
  const QByteArray first = htmlOf(sample());
  EXPECT_EQ(first, htmlOf(sample()));
  ReportAbout later = test::aboutPlants();
  later.date = "2027-03-04";
  EXPECT_EQ(QByteArray(first).replace("2026-01-02", "2027-03-04"), htmlOf(sample(later)));
}

TEST(HtmlReport, TakesNamesOfFilesForText) {
  ReportAbout about = test::aboutPlants();
  about.result.name = "<b>&\"%1'.mtg";
  const QByteArray html = htmlOf(sample(about));
  EXPECT_TRUE(parse(html).text.contains(about.result.name));
  EXPECT_FALSE(html.contains("<b>&"));
}

TEST(HtmlReport, IsWholeWithoutPictures) {
  ReportPictures none;
  none.problem = "OpenGL: no context to draw in";
  const Report report = comparisonReport(
      test::reported(test::stick(21, 0.1), test::branched(), 0.02), none, test::aboutPlants());
  const Parsed parsed = parse(htmlOf(report));
  EXPECT_EQ(parsed.elements.count("img"), 0);
  EXPECT_TRUE(parsed.text.contains("there are no pictures"));
  EXPECT_TRUE(parsed.text.contains("Methods"));
}

/// A table of one row with as many columns of numbers.
Report tableOf(int columns) {
  ReportTable table;
  table.rows.emplace_back();
  for (int i = 0; i < columns; ++i) {
    table.columns.push_back({"share"});
    table.rows.front().push_back({"0.12345"});
  }
  return {"Table", {}, {{"Table", {std::move(table)}}}};
}

TEST(HtmlReport, WritesATableThatIsTooWideForAPhoneRowBelowRow) {
  const QByteArray narrow = htmlOf(tableOf(5)); // 5 x 8 letters
  EXPECT_FALSE(narrow.contains("<table class=\"cards\">"));
  EXPECT_FALSE(narrow.contains("data-name="));
  const QByteArray wide = htmlOf(tableOf(6)); // 6 x 8
  EXPECT_TRUE(wide.contains("<table class=\"cards\">"));
  EXPECT_EQ(wide.count("data-name=\"share\""), 6) << "each cell says what it is";
  static_cast<void>(parse(wide));
}

TEST(HtmlReport, DescribesPicturesToThoseWhoDoNotSeeThem) {
  Report report = sample();
  QImage image(2, 2, QImage::Format_RGB32);
  image.fill(Qt::white);
  report.sections = {
      {"Pictures", {ReportFigures{.figures = {{image, "0.2 m", ""}, {image, "A", "the plant"}}}}}};
  const QByteArray html = htmlOf(report);
  EXPECT_TRUE(html.contains("alt=\"0.2 m\""));
  EXPECT_TRUE(html.contains("alt=\"A: the plant\""));
}

TEST(PdfReport, HasSeveralPagesOfA4) {
  const QByteArray pdf = pdfOf(sample());
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  const QString text = QString::fromLatin1(pdf);
  EXPECT_GT(text.count(QRegularExpression("/Type\\s*/Page\\b(?!s)")), 3);
  EXPECT_TRUE(text.contains(QRegularExpression("/MediaBox \\[0 0 59[45][.0-9]* 84[12][.0-9]*\\]")));
}

/// A table of which each row states its number.
Report longTable(int rows) {
  ReportTable table;
  table.columns = {{"row", false}, {"share"}};
  for (int i = 0; i < rows; ++i)
    table.rows.push_back({{QString::number(i)}, {"0.5", 0.5}});
  return {"Long", {}, {{"Table", {std::move(table)}}}};
}

TEST(PdfReport, CutsNoHash) {
  const QString hash(64, 'b');
  ReportTable inputs;
  inputs.columns = {{"rôle", false}, {"fichier", false}, {"SHA-256", false}};
  const QString file = "arbre.espalier (empreinte calculée sur la liste des nœuds du projet)";
  inputs.rows = {{{"structure"}, {file}, {hash}}};
  const PdfPages pages("Certificat");
  const std::vector<double> widths = columnWidths(pages, inputs);
  EXPECT_GE(widths[2], pages.widthOf(hash, {.size = 8.5, .isCode = true}));
  EXPECT_LT(widths[1], pages.widthOf(file, {.size = 10.5})) << "words are wrapped";
  EXPECT_LE(widths[0] + widths[1] + widths[2], pages.width());
}

TEST(PdfReport, GoesOnWithALongTableOnTheNextPage) {
  EXPECT_EQ(test::pagesOf(pdfOf(longTable(10))), 1);
  EXPECT_GE(test::pagesOf(pdfOf(longTable(200))), 4);
  EXPECT_LE(test::pagesOf(pdfOf(longTable(200))), 8);
}

TEST(WriteReport, WritesAsTheNameSays) {
  const auto folder = test::freshFolder();
  writeReport(folder / "a.html", sample());
  writeReport(folder / "a.PDF", sample());
  const auto begin = [&](const char* name) {
    QFile file(QString::fromStdString((folder / name).string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.read(9);
  };
  EXPECT_EQ(begin("a.html"), "<!DOCTYPE");
  EXPECT_TRUE(begin("a.PDF").startsWith("%PDF"));
}

TEST(WriteReport, RefusesOtherNamesAndFoldersThatAreMissing) {
  for (const char* name : {"a.doc", "a", ".html.gz", "html"})
    EXPECT_THROW(requireReportName(name), Error) << name;
  EXPECT_THROW(writeReport(test::freshFolder() / "nowhere" / "a.html", sample()), Error);
  try {
    requireReportName("thesis.docx");
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("thesis.docx: a report is written as HTML or PDF"));
  }
}

} // namespace
} // namespace espalier
