#include "app/report/pdf_report.h"

#include "app/report/pdf_pages.h"
#include "app/report/pdf_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double apart = 12;         // between blocks
constexpr double leastFigure = 0.42; // of the height of a page, if it would be higher there

const QColor quiet(0x5b, 0x63, 0x5f);
const QColor accent(0x2f, 0x8f, 0x5b);

PdfText noteLook() {
  return {.size = 10, .color = quiet};
}
PdfText titleLook() {
  return {.size = 16, .isBold = true};
}

class PdfReport {
public:
  explicit PdfReport(const Report& report);

  [[nodiscard]] QByteArray bytes() { return pages_.bytes(); }
  [[nodiscard]] int pages() const { return pages_.page(); }

  void operator()(const ReportParagraph& paragraph);
  void operator()(const ReportWarnings& warnings);
  void operator()(const ReportKeyNumbers& numbers);
  void operator()(const ReportLegend& legend);
  void operator()(const ReportTable& table);
  void operator()(const ReportFigures& figures);
  void operator()(const ReportPlot& plot);
  void operator()(const ReportTerms& terms);

private:
  void add(const ReportSection& section);
  void addText(const QString& text, const PdfText& look, double indent = 0);
  void addFigure(const ReportFigures::Figure& figure, const QRectF& box);
  [[nodiscard]] QSizeF sizeOf(const ReportFigures& figures, double room) const;
  /// Of what a title must not be parted from.
  [[nodiscard]] double headHeight(const ReportSection& section) const;
  /// Of what must stand on one page of a block.
  [[nodiscard]] double leastHeight(const ReportBlock& block) const;

  PdfPages pages_;
};

PdfReport::PdfReport(const Report& report) : pages_(report.title) {
  addText(report.title, {.size = 20, .isBold = true});
  pages_.advance(2);
  addText(report.facts.join(QStringLiteral(" · ")), {.size = 10.5, .color = quiet});
  pages_.advance(6);
  pages_.painter().fillRect(QRectF(0, pages_.y(), pages_.width(), 2.5), accent);
  pages_.advance(8);
  for (const ReportSection& section : report.sections)
    add(section);
}

void PdfReport::add(const ReportSection& section) {
  pages_.advance(pages_.y() > 0 ? apart : 0);
  const double title = pages_.heightOf(section.title, pages_.width(), titleLook()) + 8;
  pages_.need(std::min(title + headHeight(section), pages_.height()));
  addText(section.title, titleLook());
  pages_.advance(8);
  for (const ReportBlock& block : section.blocks) {
    std::visit(*this, block);
    pages_.advance(apart);
  }
}

double PdfReport::headHeight(const ReportSection& section) const {
  double height = 0;
  for (const ReportBlock& block : section.blocks) {
    height += leastHeight(block) + apart;
    const bool isLead = std::holds_alternative<ReportParagraph>(block) ||
                        std::holds_alternative<ReportLegend>(block);
    if (!isLead) break;
  }
  return height;
}

double PdfReport::leastHeight(const ReportBlock& block) const {
  constexpr double someLines = 60;
  if (const auto* table = std::get_if<ReportTable>(&block)) return heightOf(pages_, *table);
  if (const auto* plot = std::get_if<ReportPlot>(&block)) return 30 + plot->size.height();
  if (std::holds_alternative<ReportKeyNumbers>(block)) return 2 * someLines;
  if (const auto* figures = std::get_if<ReportFigures>(&block))
    return std::min(sizeOf(*figures, pages_.height()).height(), leastFigure * pages_.height());
  return someLines;
}

void PdfReport::addText(const QString& text, const PdfText& look, double indent) {
  const double width = pages_.width() - indent;
  const double height = pages_.heightOf(text, width, look);
  pages_.need(height);
  pages_.draw(QRectF(indent, pages_.y(), width, height + 2), text, look);
  pages_.advance(height);
}

void PdfReport::operator()(const ReportParagraph& paragraph) {
  switch (paragraph.look) {
  case ReportParagraph::Look::plain:
    return addText(paragraph.text, {.size = 11.5});
  case ReportParagraph::Look::note:
    return addText(paragraph.text, noteLook());
  case ReportParagraph::Look::code:
    return addText(paragraph.text, {.size = 9.5, .isCode = true});
  }
}

void PdfReport::operator()(const ReportWarnings& warnings) {
  const PdfText look{.size = 10.5};
  const QString head = QCoreApplication::translate("Report", "To know before reading on");
  const double width = pages_.width() - 24;
  double height = pages_.heightOf(head, width, look) + 16;
  for (const QString& line : warnings.lines)
    height += pages_.heightOf(line, width, look) + 3;
  pages_.need(height);
  pages_.painter().fillRect(QRectF(0, pages_.y(), pages_.width(), height),
                            QColor(0xff, 0xf4, 0xdc));
  pages_.painter().fillRect(QRectF(0, pages_.y(), 4, height), QColor(0xe6, 0xa8, 0x17));
  pages_.advance(8);
  addText(head, {.size = 10.5, .isBold = true}, 14);
  for (const QString& line : warnings.lines) {
    pages_.advance(3);
    addText(line, look, 14);
  }
  pages_.advance(8);
}

void PdfReport::operator()(const ReportKeyNumbers& numbers) {
  constexpr int across = 3;
  constexpr double height = 58;
  const double width = (pages_.width() - (across - 1) * apart) / across;
  for (std::size_t i = 0; i < numbers.numbers.size(); ++i) {
    const auto& number = numbers.numbers[i];
    const std::size_t column = i % across;
    if (column == 0) pages_.need(height);
    const QRectF box(static_cast<double>(column) * (width + apart), pages_.y(), width, height);
    pages_.painter().fillRect(box, QColor(0xf3, 0xf5, 0xf3));
    const QRectF inner = box.adjusted(10, 6, -10, -4);
    pages_.draw(inner, number.value, {.size = 19, .isBold = true});
    pages_.draw(inner.adjusted(0, 23, 0, 0), number.name, {.size = 10.5});
    pages_.draw(inner.adjusted(0, 36, 0, 4), number.help, {.size = 9, .color = quiet});
    if (column == across - 1 || i + 1 == numbers.numbers.size())
      pages_.advance(height + (i + 1 < numbers.numbers.size() ? 8 : 0));
  }
}

void PdfReport::operator()(const ReportLegend& legend) {
  for (const auto& entry : legend.entries) {
    const PdfText look{.size = 10.5};
    const double height = pages_.heightOf(entry.name, pages_.width(), look) + 3;
    pages_.need(height);
    pages_.painter().fillRect(QRectF(0, pages_.y() + height / 2 - 3, 22, 4), entry.color);
    pages_.draw(QRectF(32, pages_.y(), 130, height), entry.name, look);
    pages_.draw(QRectF(162, pages_.y(), pages_.width() - 162, height), entry.text,
                {.size = 10.5, .color = quiet});
    pages_.advance(height);
  }
}

void PdfReport::operator()(const ReportTable& table) {
  addTable(pages_, table);
}

/// Of each with its caption: as wide as the page allows, as high as `room` at most.
QSizeF PdfReport::sizeOf(const ReportFigures& figures, double room) const {
  double width = (pages_.width() - (figures.across - 1) * apart) / figures.across;
  double slope = 0; // height over width of the steepest
  for (const auto& figure : figures.figures)
    slope = std::max(slope, static_cast<double>(figure.image.height()) / figure.image.width());
  constexpr double captionRoom = 36;
  const double highest = std::min(0.55 * pages_.height(), room - captionRoom);
  if (slope * width > highest) width = highest / slope;
  double caption = 0;
  for (const auto& figure : figures.figures)
    caption = std::max(caption, pages_.heightOf(figure.title, width, noteLook()) +
                                    pages_.heightOf(figure.text, width, noteLook()));
  return {width, slope * width + caption + 8};
}

void PdfReport::addFigure(const ReportFigures::Figure& figure, const QRectF& box) {
  const double height = box.width() * figure.image.height() / figure.image.width();
  pages_.painter().drawImage(QRectF(box.topLeft(), QSizeF(box.width(), height)), figure.image);
  pages_.painter().setPen(QPen(QColor(0xd9, 0xde, 0xdb), 0.75));
  pages_.painter().setBrush(Qt::NoBrush);
  pages_.painter().drawRect(QRectF(box.topLeft(), QSizeF(box.width(), height)));
  const QRectF under = box.adjusted(0, height + 4, 0, 0);
  PdfText bold = noteLook();
  bold.isBold = true;
  bold.color = Qt::black;
  pages_.draw(under, figure.title, bold);
  pages_.draw(under.adjusted(0, pages_.heightOf(figure.title, box.width(), bold), 0, 0),
              figure.text, noteLook());
}

void PdfReport::operator()(const ReportFigures& figures) {
  // Smaller, rather than on the next page, if that leaves them large enough.
  const double left = pages_.height() - pages_.y();
  const bool fits = left >= leastFigure * pages_.height();
  const QSizeF size = sizeOf(figures, fits ? left : pages_.height());
  const auto across = static_cast<std::size_t>(figures.across);
  for (std::size_t i = 0; i < figures.figures.size(); ++i) {
    if (i % across == 0) pages_.need(size.height());
    const double x = static_cast<double>(i % across) * (size.width() + apart);
    addFigure(figures.figures[i], QRectF(QPointF(x, pages_.y()), size));
    if (i % across == across - 1 || i + 1 == figures.figures.size())
      pages_.advance(size.height() + (i + 1 < figures.figures.size() ? apart : 0));
  }
}

void PdfReport::operator()(const ReportPlot& plot) {
  pages_.need(plot.size.height() + 20);
  pages_.setLook({});
  plot.paint(pages_.painter(), QRectF(QPointF(0, pages_.y()), QSizeF(plot.size)),
             plotColors(false));
  pages_.advance(plot.size.height() + 4);
  addText(plot.text, noteLook());
}

void PdfReport::operator()(const ReportTerms& terms) {
  const PdfText bold{.size = 11, .isBold = true};
  const PdfText text{.size = 10.5};
  for (const auto& term : terms.terms) {
    pages_.need(pages_.heightOf(term.name, pages_.width(), bold) +
                pages_.heightOf(term.text, pages_.width(), text) +
                pages_.heightOf(term.source, pages_.width(), noteLook()));
    addText(term.name, bold);
    addText(term.text, text);
    if (!term.source.isEmpty()) addText(term.source, noteLook());
    pages_.advance(7);
  }
}

} // namespace

QByteArray pdfOf(const Report& report) {
  return PdfReport(report).bytes();
}

int pdfPagesOf(const Report& report) {
  return PdfReport(report).pages();
}

} // namespace espalier
