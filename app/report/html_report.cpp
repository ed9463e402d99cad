#include "app/report/html_report.h"

#include "app/report/html_style.h"
#include "app/report/plot_svg.h"
#include "ui/view/picture.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {
namespace {

QString escaped(const QString& text) {
  return text.toHtmlEscaped();
}

bool isHash(const ReportCell& cell) {
  return cell.text.size() == 64; // nothing else is a word of that length
}

/// Letters that stand beside each other in a line of it at least: words break between, numbers not.
qsizetype widthOf(const ReportTable& table) {
  qsizetype width = 0;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    qsizetype widest = 0;
    const auto take = [&](const QString& text, bool breaks) {
      for (const QString& word : text.split(breaks ? ' ' : '\n'))
        widest = std::max(widest, word.size());
    };
    take(table.columns[column].title, true);
    for (const auto& row : table.rows)
      take(row[column].text, !table.columns[column].isNumber);
    width += widest + 1;
  }
  return width;
}

/// Texts are escaped by those who add them.
class HtmlWriter {
public:
  void add(const QString& html) { page_ += html; }

  void operator()(const ReportParagraph& paragraph);
  void operator()(const ReportWarnings& warnings);
  void operator()(const ReportKeyNumbers& numbers);
  void operator()(const ReportLegend& legend);
  void operator()(const ReportTable& table);
  void operator()(const ReportFigures& figures);
  void operator()(const ReportPlot& plot);
  void operator()(const ReportTerms& terms);

  [[nodiscard]] QByteArray page() const { return page_.toUtf8(); }

private:
  void addRow(const ReportTable& table, const std::vector<ReportCell>& row, bool isNamed);

  QString page_;
};

void HtmlWriter::operator()(const ReportParagraph& paragraph) {
  const QString look = paragraph.look == ReportParagraph::Look::note   ? " class=\"note\""
                       : paragraph.look == ReportParagraph::Look::code ? " class=\"code\""
                                                                       : "";
  add(QStringLiteral("<p%1>%2</p>\n").arg(look, escaped(paragraph.text)));
}

void HtmlWriter::operator()(const ReportWarnings& warnings) {
  add(QStringLiteral("<div class=\"warnings\"><b>%1</b><ul>\n")
          .arg(escaped(QCoreApplication::translate("Report", "To know before reading on"))));
  for (const QString& line : warnings.lines)
    add(QStringLiteral("<li>%1</li>\n").arg(escaped(line)));
  add(QStringLiteral("</ul></div>\n"));
}

void HtmlWriter::operator()(const ReportKeyNumbers& numbers) {
  add(QStringLiteral("<div class=\"numbers\">\n"));
  for (const auto& number : numbers.numbers)
    add(QStringLiteral("<div><b>%1</b><span>%2</span><small>%3</small></div>\n")
            .arg(escaped(number.value), escaped(number.name), escaped(number.help)));
  add(QStringLiteral("</div>\n"));
}

void HtmlWriter::operator()(const ReportLegend& legend) {
  add(QStringLiteral("<ul class=\"legend\">\n"));
  for (const auto& entry : legend.entries)
    add(QStringLiteral("<li><i style=\"background:%1\"></i>%2 <span>%3</span></li>\n")
            .arg(entry.color.name(), escaped(entry.name), escaped(entry.text)));
  add(QStringLiteral("</ul>\n"));
}

/// @param isNamed whether each cell states the title of its column, too
void HtmlWriter::addRow(const ReportTable& table, const std::vector<ReportCell>& row,
                        bool isNamed) {
  add(QStringLiteral("<tr>"));
  for (std::size_t column = 0; column < row.size(); ++column) {
    const ReportCell& cell = row[column];
    add(QStringLiteral("<td class=\"%1\"")
            .arg(table.columns[column].isNumber ? "number"
                 : isHash(cell)                 ? "code"
                                                : "word"));
    if (isNamed) add(QStringLiteral(" data-name=\"%1\"").arg(escaped(table.columns[column].title)));
    add('>' + escaped(cell.text));
    if (cell.bar)
      add(QStringLiteral("<span class=\"bar\"><i style=\"width:%1%\"></i></span>")
              .arg(100 * *cell.bar, 0, 'f', 1));
    add(QStringLiteral("</td>"));
  }
  add(QStringLiteral("</tr>\n"));
}

void HtmlWriter::operator()(const ReportTable& table) {
  constexpr qsizetype widthOfPhone = 46;   // letters
  constexpr std::size_t mostTogether = 10; // rows that a page of A4 is not to part
  const bool isCards = widthOf(table) > widthOfPhone;
  QStringList looks;
  if (isCards) looks.append(QStringLiteral("cards"));
  if (table.rows.size() > mostTogether) looks.append(QStringLiteral("long"));
  add(QStringLiteral("<div class=\"wide\"><table%1>")
          .arg(looks.isEmpty() ? QString() : QStringLiteral(" class=\"%1\"").arg(looks.join(' '))));
  if (!table.caption.isEmpty())
    add(QStringLiteral("<caption>%1</caption>").arg(escaped(table.caption)));
  add(QStringLiteral("\n<thead><tr>"));
  for (const auto& column : table.columns)
    add(QStringLiteral("<th class=\"%1\" scope=\"col\">%2</th>")
            .arg(column.isNumber ? "number" : "word", escaped(column.title)));
  add(QStringLiteral("</tr></thead>\n<tbody>\n"));
  for (const auto& row : table.rows)
    addRow(table, row, isCards);
  add(QStringLiteral("</tbody></table></div>\n"));
}

void HtmlWriter::operator()(const ReportFigures& figures) {
  add(QStringLiteral("<div class=\"figures%1\">\n")
          .arg(figures.across > 2 ? QStringLiteral(" three") : QString()));
  for (const auto& figure : figures.figures) {
    add(QStringLiteral("<figure><img width=\"%1\" height=\"%2\" alt=\"%3\" "
                       "src=\"data:image/png;base64,%4\"/>")
            .arg(QString::number(figure.image.width()), QString::number(figure.image.height()),
                 escaped(figure.text.isEmpty() ? figure.title : figure.title + ": " + figure.text),
                 QString::fromLatin1(pngOf(figure.image).toBase64())));
    add(QStringLiteral("<figcaption><b>%1</b> %2</figcaption></figure>\n")
            .arg(escaped(figure.title), escaped(figure.text)));
  }
  add(QStringLiteral("</div>\n"));
}

void HtmlWriter::operator()(const ReportPlot& plot) {
  add(QStringLiteral("<figure class=\"plot\" style=\"max-width:%1px\">")
          .arg(1.3 * plot.size.width()));
  add(svgOf(plot));
  add(QStringLiteral("<figcaption>%1</figcaption></figure>\n").arg(escaped(plot.text)));
}

void HtmlWriter::operator()(const ReportTerms& terms) {
  add(QStringLiteral("<dl>\n"));
  for (const auto& term : terms.terms) {
    add(QStringLiteral("<dt>%1</dt><dd>%2").arg(escaped(term.name), escaped(term.text)));
    if (!term.source.isEmpty()) add(QStringLiteral(" <cite>%1</cite>").arg(escaped(term.source)));
    add(QStringLiteral("</dd>\n"));
  }
  add(QStringLiteral("</dl>\n"));
}

} // namespace

QByteArray htmlOf(const Report& report) {
  HtmlWriter writer;
  writer.add(
      QStringLiteral("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                     "<meta name=\"viewport\" content=\"width=device-width, "
                     "initial-scale=1\"/>\n<title>%1</title>\n<style>%2</style>\n</head>\n"
                     "<body>\n<main>\n<header><h1>%1</h1>\n<p class=\"facts\">%3</p></header>\n")
          .arg(escaped(report.title), htmlStyle(),
               escaped(report.facts.join(QStringLiteral(" · ")))));
  for (const ReportSection& section : report.sections) {
    writer.add(QStringLiteral("<section>\n<h2>%1</h2>\n").arg(escaped(section.title)));
    for (const ReportBlock& block : section.blocks)
      std::visit(writer, block);
    writer.add(QStringLiteral("</section>\n"));
  }
  writer.add(QStringLiteral("</main>\n</body>\n</html>\n"));
  return writer.page();
}

} // namespace espalier
