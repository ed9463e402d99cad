#include "app/report/pdf_table.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr double gap = 18; // between columns
constexpr double padding = 3;
constexpr double barHeight = 3;
constexpr double leastBar = 48;

const QColor quietText(0x5b, 0x63, 0x5f);
const QColor line(0xc4, 0xca, 0xc7);

PdfText headLook() {
  return {.size = 10.5, .isBold = true, .color = quietText};
}
PdfText captionLook() {
  return {.size = 11.5, .isBold = true};
}

bool isHash(const QString& text) {
  const auto isHex = [](QChar letter) {
    return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
  };
  return text.size() == 64 && std::ranges::all_of(text, isHex);
}

PdfText lookOf(const ReportCell& cell) {
  return {.size = isHash(cell.text) ? 8.5 : 10.5, .isCode = isHash(cell.text)};
}

/// Widths of columns, heights of rows.
struct Layout {
  std::vector<double> widths;
  std::vector<double> rows;
  double caption = 0;
  double head = 0;

  [[nodiscard]] double whole() const {
    return caption + head + std::accumulate(rows.begin(), rows.end(), 0.0);
  }
};

/// How wide columns may be for all to fit in `room`; those below that keep their width.
double widestFitting(std::vector<double> widths, double room) {
  std::ranges::sort(widths);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double level = room / static_cast<double>(widths.size() - i);
    if (widths[i] > level) return level;
    room -= widths[i];
  }
  return std::numeric_limits<double>::infinity();
}

/// Nothing in it can be wrapped.
bool isWhole(const ReportTable& table, std::size_t column) {
  return table.columns[column].isNumber ||
         std::ranges::any_of(table.rows, [&](const auto& row) { return isHash(row[column].text); });
}

Layout layoutOf(const PdfPages& pages, const ReportTable& table) {
  Layout layout;
  layout.widths = columnWidths(pages, table);
  if (!table.caption.isEmpty())
    layout.caption = pages.heightOf(table.caption, pages.width(), captionLook()) + 2 * padding;
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    layout.head = std::max(layout.head, pages.heightOf(table.columns[column].title,
                                                       layout.widths[column], headLook()) +
                                            2 * padding);
  for (const auto& row : table.rows) {
    double height = 0;
    for (std::size_t column = 0; column < row.size(); ++column)
      height = std::max(
          height, pages.heightOf(row[column].text, layout.widths[column] + 1, lookOf(row[column])) +
                      (row[column].bar ? barHeight + 1 : 0));
    layout.rows.push_back(height + 2 * padding);
  }
  return layout;
}

Qt::Alignment alignmentOf(const ReportTable::Column& column) {
  return (column.isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop;
}

void drawRule(PdfPages& pages, const Layout& layout, double thickness) {
  const double gaps = gap * static_cast<double>(layout.widths.size() - 1);
  const double width = std::accumulate(layout.widths.begin(), layout.widths.end(), gaps);
  pages.painter().fillRect(QRectF(0, pages.y() - thickness, width, thickness), line);
}

void addHead(PdfPages& pages, const ReportTable& table, const Layout& layout) {
  double x = 0;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    pages.draw(QRectF(x, pages.y() + padding, layout.widths[column] + 1, layout.head),
               table.columns[column].title, headLook(), alignmentOf(table.columns[column]));
    x += layout.widths[column] + gap;
  }
  pages.advance(layout.head);
  drawRule(pages, layout, 1.2);
}

void drawBar(PdfPages& pages, const QRectF& box, double share) {
  pages.painter().fillRect(box, QColor(0xcf, 0xe3, 0xd8));
  pages.painter().fillRect(QRectF(box.topLeft(), QSizeF(box.width() * share, box.height())),
                           QColor(0x2f, 0x8f, 0x5b));
}

void addRow(PdfPages& pages, const ReportTable& table, const Layout& layout, std::size_t index) {
  double x = 0;
  const double height = layout.rows[index];
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const ReportCell& cell = table.rows[index][column];
    const double width = layout.widths[column];
    pages.draw(QRectF(x, pages.y() + padding, width + 1, height), cell.text, lookOf(cell),
               alignmentOf(table.columns[column]));
    if (cell.bar)
      drawBar(pages, QRectF(x, pages.y() + height - padding - barHeight, width, barHeight),
              *cell.bar);
    x += width + gap;
  }
  pages.advance(height);
  drawRule(pages, layout, 0.5);
}

} // namespace

std::vector<double> columnWidths(const PdfPages& pages, const ReportTable& table) {
  std::vector<double> widths;
  std::vector<double> words;
  double room = pages.width() - gap * static_cast<double>(table.columns.size() - 1);
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    double width = pages.widthOf(table.columns[column].title, headLook());
    for (const auto& row : table.rows) {
      width = std::max(width, pages.widthOf(row[column].text, lookOf(row[column])));
      if (row[column].bar) width = std::max(width, leastBar);
    }
    widths.push_back(width);
    if (isWhole(table, column))
      room -= width;
    else
      words.push_back(width);
  }
  const double widest = widestFitting(std::move(words), room);
  for (std::size_t column = 0; column < widths.size(); ++column)
    if (!isWhole(table, column)) widths[column] = std::min(widths[column], widest);
  return widths;
}

double heightOf(const PdfPages& pages, const ReportTable& table) {
  return std::min(layoutOf(pages, table).whole(), pages.height());
}

void addTable(PdfPages& pages, const ReportTable& table) {
  const Layout layout = layoutOf(pages, table);
  pages.need(std::min(layout.whole(), pages.height()));
  if (!table.caption.isEmpty()) {
    pages.draw(QRectF(0, pages.y(), pages.width(), layout.caption), table.caption, captionLook());
    pages.advance(layout.caption);
  }
  addHead(pages, table, layout);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (pages.y() + layout.rows[row] > pages.height()) {
      pages.need(layout.rows[row]);
      addHead(pages, table, layout);
    }
    addRow(pages, table, layout, row);
  }
}

} // namespace espalier
