#include "ui/dialogs/column_table.h"

#include "ui/dialogs/column_header.h"

#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// Why these columns are no points, whatever their values; empty: they are.
QString problemOf(const std::vector<PointField>& fields) {
  using enum PointField;
  const auto count = [&](PointField field) { return std::ranges::count(fields, field); };
  for (const PointField field : {x, y, z})
    if (count(field) == 0)
      return ColumnTable::tr("No column holds %1: choose it above one of them.").arg(textOf(field));
  for (const PointField field : {x, y, z, intensity, red, green, blue, station})
    if (count(field) > 1)
      return ColumnTable::tr("Two columns hold %1: choose something else above one of them.")
          .arg(textOf(field));
  const auto colors = count(red) + count(green) + count(blue);
  if (colors > 0 && colors < 3)
    return ColumnTable::tr("A color is red, green and blue: choose all three, or none of them.");
  return {};
}

} // namespace

ColumnTable::ColumnTable(FirstLines text, const std::vector<PointField>& chosen, QWidget* parent)
    : QTableWidget(parent), text_(std::move(text)), header_(new ColumnHeader(chosen, this)) {
  setObjectName("columns");
  setAccessibleName(tr("The first lines of the file"));
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setTabKeyNavigation(false);
  setWordWrap(false);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setColumnCount(static_cast<int>(chosen.size()));
  setHorizontalHeader(header_);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  fill();
  mark();
  for (QComboBox* list : header_->lists())
    list->installEventFilter(this);
  connect(header_, &ColumnHeader::fieldsChanged, this, [this] {
    mark();
    emit fieldsChanged();
  });
}

std::vector<PointField> ColumnTable::fields() const {
  return header_->fields();
}

const std::vector<QComboBox*>& ColumnTable::lists() const {
  return header_->lists();
}

void ColumnTable::fill() {
  setRowCount(static_cast<int>(text_.lines.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const TextLine& line = text_.lines[static_cast<std::size_t>(row)];
    const bool isWhole = line.kind == TextLine::Kind::comment || line.kind == TextLine::Kind::count;
    for (int column = 0; column < columnCount(); ++column) {
      const auto at = static_cast<std::size_t>(column);
      auto* item = new QTableWidgetItem(
          at < line.fields.size() ? QString::fromStdString(line.fields[at]) : QString());
      if (line.kind == TextLine::Kind::points)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFlags(Qt::ItemIsEnabled);
      setItem(row, column, item);
    }
    if (isWhole) setSpan(row, 0, 1, columnCount());
  }
}

bool ColumnTable::isWrong(const TextLine& line) const {
  return line.kind == TextLine::Kind::points && !isPoint(line, fields(), text_.hasDecimalComma);
}

/// The mark is a cross before the number of the line, and struck out text: not color alone.
void ColumnTable::mark() {
  for (int row = 0; row < rowCount(); ++row) {
    const TextLine& line = text_.lines[static_cast<std::size_t>(row)];
    const bool wrong = isWrong(line);
    const bool isRead =
        line.kind == TextLine::Kind::points ||
        (line.kind == TextLine::Kind::title && isPoint(line, fields(), text_.hasDecimalComma));
    const QString number = QString::number(line.number);
    auto* head = new QTableWidgetItem(wrong ? QStringLiteral("✗ ") + number : number);
    if (wrong) head->setToolTip(problemOfLine(line));
    setVerticalHeaderItem(row, head);
    for (int column = 0; column < columnCount(); ++column) {
      QTableWidgetItem* cell = item(row, column);
      QFont font = this->font();
      font.setStrikeOut(wrong);
      font.setItalic(!isRead && !wrong);
      cell->setFont(font);
      const bool isTaken = fields()[static_cast<std::size_t>(column)] != PointField::none;
      cell->setForeground(
          palette().brush(isTaken && isRead ? QPalette::Text : QPalette::PlaceholderText));
      cell->setToolTip(wrong ? problemOfLine(line) : QString());
    }
  }
}

QString ColumnTable::problemOfLine(const TextLine& line) const {
  const std::vector<PointField> chosen = fields();
  for (std::size_t column = 0; column < chosen.size(); ++column) {
    if (chosen[column] == PointField::none) continue;
    if (column >= line.fields.size())
      return tr("Line %1 has %2 values, too few for these columns: choose others, or mend the "
                "file.")
          .arg(line.number)
          .arg(line.fields.size());
    const TextLine one{line.number, line.kind, {line.fields[column]}};
    if (!isPoint(one, {PointField::x}, text_.hasDecimalComma))
      return tr("Line %1 has “%2” for %3, which is no number: choose other columns, or mend the "
                "file.")
          .arg(line.number)
          .arg(QString::fromStdString(line.fields[column]), textOf(chosen[column]));
  }
  return {};
}

QString ColumnTable::problem() const {
  if (const QString problem = problemOf(fields()); !problem.isEmpty()) return problem;
  const auto wrong =
      std::ranges::find_if(text_.lines, [this](const TextLine& line) { return isWrong(line); });
  return wrong == text_.lines.end() ? QString() : problemOfLine(*wrong);
}

bool ColumnTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn && rowCount() > 0)
    for (int column = 0; column < columnCount(); ++column)
      if (lists()[static_cast<std::size_t>(column)] == watched)
        scrollTo(model()->index(std::max(0, rowAt(0)), column));
  return QTableWidget::eventFilter(watched, event);
}

void ColumnTable::scrollContentsBy(int dx, int dy) {
  QTableWidget::scrollContentsBy(dx, dy);
  if (dx != 0) emit header_->geometriesChanged();
}

} // namespace espalier
