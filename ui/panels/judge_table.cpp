#include "ui/panels/judge_table.h"

#include "ui/document/number_scale.h"
#include "ui/panels/focus_keys.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int differenceRole = Qt::UserRole; // to the first state, as it is written
constexpr int differenceSize = 11;           // of its font [px]
constexpr int margin = 6;                    // of a cell [px]

QFont smaller(QFont font) {
  font.setPixelSize(differenceSize);
  return font;
}

/// A number with its difference beside it.
class NumberDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyleOptionViewItem whole = option;
    initStyleOption(&whole, index);
    const QString difference = index.data(differenceRole).toString();
    const int beside = widthOf(difference, whole.font);
    QStyleOptionViewItem ground = whole;
    ground.text.clear();
    const QStyle* style = whole.widget != nullptr ? whole.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &ground, painter, whole.widget);
    painter->save();
    painter->setFont(whole.font);
    painter->setPen(whole.palette.color(QPalette::Text));
    const QRect cell = whole.rect.adjusted(margin, 0, -margin, 0);
    const auto side = index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight;
    painter->drawText(cell.adjusted(0, 0, -beside, 0), side | Qt::AlignVCenter, whole.text);
    painter->setFont(smaller(whole.font));
    painter->setPen(whole.palette.color(QPalette::PlaceholderText));
    painter->drawText(cell, Qt::AlignRight | Qt::AlignVCenter, difference);
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override {
    QStyleOptionViewItem whole = option;
    initStyleOption(&whole, index);
    const int number = QFontMetrics(whole.font).horizontalAdvance(whole.text);
    const int beside = widthOf(index.data(differenceRole).toString(), whole.font);
    return {number + beside + 2 * margin, 24};
  }

private:
  static int widthOf(const QString& difference, const QFont& font) {
    if (difference.isEmpty()) return 0;
    return QFontMetrics(smaller(font)).horizontalAdvance(difference) + margin;
  }
};

/// A number as it is written, so that differences are those one sees.
double written(double value, const JudgeRow& row) {
  const double unit = std::pow(10, -row.decimals);
  return std::round(value / unit) * unit;
}

/// "+0.25 ✓": how far from the first state; the mark says that it is better, a cross that it is
/// worse.
QString differenceText(const JudgeRow& row, double difference) {
  if (difference == 0) return QStringLiteral("=");
  const QString number = numberText(std::abs(difference), row.decimals);
  QString text = (difference > 0 ? QStringLiteral("+") : QStringLiteral("−")) + number;
  if (row.better == Better::neither) return text;
  const bool isBetter = (row.better == Better::more) == (difference > 0);
  return text + (isBetter ? QStringLiteral(" ✓") : QStringLiteral(" ✗"));
}

QString tipOf(const JudgeRow& row) {
  const QString better = row.better == Better::less   ? JudgeTable::tr("Less is better.")
                         : row.better == Better::more ? JudgeTable::tr("More is better.")
                                                      : QString();
  const QString stop = row.meaning.endsWith('.') ? QString() : QStringLiteral(".");
  return QStringLiteral("<qt>%1%2 %3</qt>").arg(row.meaning.toHtmlEscaped(), stop, better);
}

} // namespace

JudgeTable::JudgeTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName("judge_table");
  setAccessibleName(tr("Numbers to judge by"));
  setShowGrid(false);
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setTabKeyNavigation(false); // Tab leaves the table
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(24);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setItemDelegate(new NumberDelegate(this));
  onCopy(*this, [this] { QApplication::clipboard()->setText(table()); });
}

void JudgeTable::show(const QStringList& states, const std::vector<JudgeRow>& rows,
                      bool areOfSame) {
  areOfSame_ = areOfSame;
  states_ = states;
  rows_ = rows;
  setColumnCount(1 + static_cast<int>(states.size()));
  setRowCount(static_cast<int>(rows.size()));
  setHorizontalHeaderLabels(QStringList{tr("Number")} + states);
  horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (int column = 1; column < columnCount(); ++column)
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (int place = 0; place < rowCount(); ++place)
    fillRow(place, rows_[static_cast<std::size_t>(place)]);
}

void JudgeTable::fillRow(int place, const JudgeRow& row) {
  const QString tip = tipOf(row);
  auto* name = new QTableWidgetItem(
      row.unit.isEmpty() ? row.name : QStringLiteral("%1 [%2]").arg(row.name, row.unit));
  name->setToolTip(tip);
  setItem(place, 0, name);
  for (int column = 1; column < columnCount(); ++column) {
    const auto state = static_cast<std::size_t>(column - 1);
    const std::optional<double> value =
        state < row.values.size() ? row.values[state] : std::optional<double>();
    auto* cell =
        new QTableWidgetItem(value ? numberText(*value, row.decimals) : QStringLiteral("–"));
    cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    cell->setToolTip(tip);
    if (value && state > 0 && row.values.front() && areOfSame_) {
      const QString difference =
          differenceText(row, written(*value, row) - written(*row.values.front(), row));
      cell->setData(differenceRole, difference);
      cell->setData(Qt::AccessibleTextRole,
                    tr("%1, %2 against %3").arg(cell->text(), difference, states_.front()));
    }
    setItem(place, column, cell);
  }
}

int JudgeTable::heightForRows() const {
  return horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth();
}

QString JudgeTable::table() const {
  QStringList lines = {(QStringList{tr("Number"), tr("Unit")} + states_).join('\t')};
  for (const JudgeRow& row : rows_) {
    QStringList cells = {row.name, row.unit};
    for (std::size_t i = 0; i < static_cast<std::size_t>(states_.size()); ++i)
      cells.append(i < row.values.size() && row.values[i] ? QString::number(*row.values[i], 'g', 10)
                                                          : QString());
    lines.append(cells.join('\t'));
  }
  return lines.join('\n') + '\n';
}

} // namespace espalier
