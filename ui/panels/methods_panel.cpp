#include "ui/panels/methods_panel.h"

#include "ui/panels/elided_label.h"
#include "ui/panels/focus_keys.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace espalier {
namespace {

constexpr int valueRole = Qt::UserRole;   // the number itself
constexpr int rowRole = Qt::UserRole + 1; // as it was given

const ScoreList& columnScores() {
  static const ScoreList scores = leadingFirst(scoresIn(inMethods));
  return scores;
}

/// Sorts by number; what has none comes after all others, up or down.
class Cell : public QTableWidgetItem {
public:
  using QTableWidgetItem::QTableWidgetItem;
  bool operator<(const QTableWidgetItem& other) const override {
    const QVariant value = data(valueRole);
    const QVariant otherValue = other.data(valueRole);
    const bool isUp = tableWidget()->horizontalHeader()->sortIndicatorOrder() == Qt::AscendingOrder;
    if (value.isValid() != otherValue.isValid()) return value.isValid() == isUp;
    return value.toDouble() < otherValue.toDouble();
  }
};

} // namespace

MethodsPanel::MethodsPanel(QWidget* parent)
    : QWidget(parent), note_(new ElidedLabel), add_(new QPushButton(tr("Add Structures…"))),
      remove_(new QPushButton(tr("Remove"))), copy_(new QPushButton(tr("Copy Table"))),
      table_(new QTableWidget) {
  setObjectName("methods_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(12, 8, 12, 8);
  page->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  note_->setObjectName("methods_note");
  note_->setProperty("role", "quiet");
  row->addWidget(note_, 1);
  add_->setObjectName("methods_add");
  remove_->setObjectName("methods_remove");
  remove_->setToolTip(tr("Takes the selected structures out of the table"));
  copy_->setObjectName("methods_copy");
  copy_->setToolTip(tr("Copies the table for a spreadsheet"));
  for (QPushButton* button : {add_, remove_, copy_})
    row->addWidget(button);
  page->addLayout(row);
  table_->setObjectName("methods_table");
  table_->setAccessibleName(tr("Structures compared with the reference"));
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QTableView::SelectRows);
  table_->setEditTriggers(QTableView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->setColumnCount(1 + static_cast<int>(columnScores().size()));
  table_->setHorizontalHeaderItem(0, new QTableWidgetItem(tr("Structure")));
  for (std::size_t k = 0; k < columnScores().size(); ++k) {
    const Score& score = *columnScores()[k];
    auto* head = new QTableWidgetItem(titled(symbolOf(score)));
    head->setToolTip(tipOf(score));
    table_->setHorizontalHeaderItem(static_cast<int>(k) + 1, head);
  }
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSortIndicator(1, Qt::DescendingOrder);
  table_->setSortingEnabled(true);
  onCopy(*table_, [this] { emit copyRequested(); });
  page->addWidget(table_, 1);
  connect(add_, &QPushButton::clicked, this, &MethodsPanel::addRequested);
  connect(copy_, &QPushButton::clicked, this, &MethodsPanel::copyRequested);
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeRequested(chosenRows()); });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!chosenRows().empty()); });
  show({}, {}, LengthUnit::unknown);
}

void MethodsPanel::show(const std::vector<MethodRow>& rows, const QString& reference,
                        LengthUnit unit, double tolerance) {
  table_->setSortingEnabled(false); // rows would move while they are filled
  table_->clearSelection();
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const MethodRow& row = rows[static_cast<std::size_t>(i)];
    auto* name = new QTableWidgetItem(row.error.isEmpty() ? row.name : "⚠ " + row.name);
    name->setToolTip(row.error);
    name->setData(rowRole, i);
    table_->setItem(i, 0, name);
    for (std::size_t k = 0; k < columnScores().size(); ++k) {
      const Score& score = *columnScores()[k];
      const std::optional<double> value =
          row.scores ? row.scores->at(score.key) : std::optional<double>();
      const bool isComing = row.error.isEmpty() && !row.scores;
      auto* cell = new Cell(isComing ? QStringLiteral("…") : textOf(value, score.unit, unit));
      if (value) cell->setData(valueRole, *value);
      cell->setToolTip(row.error);
      cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(i, static_cast<int>(k) + 1, cell);
    }
  }
  table_->setSortingEnabled(true);
  noteText_ =
      reference.isEmpty() ? tr("Load a reference first: each structure is compared with it")
      : rows.size() < 2
          ? tr("Add structures of other methods or experts to compare them with %1, too")
                .arg(reference)
      : tolerance > 0
          ? tr("Compared with %1 within %2").arg(reference, formatLength(tolerance, unit, 3))
          : tr("Compared with %1").arg(reference);
  note_->setText(noteText_);
  note_->setToolTip(noteText_); // which may have no room
  add_->setEnabled(!reference.isEmpty());
  remove_->setEnabled(false);
  copy_->setEnabled(!rows.empty());
}

void MethodsPanel::setBusy(bool isBusy) {
  note_->setText(isBusy ? tr("Comparing…") : noteText_);
}

QString MethodsPanel::table() const {
  QStringList lines;
  QStringList cells;
  for (int column = 0; column < table_->columnCount(); ++column)
    cells.append(table_->horizontalHeaderItem(column)->text());
  lines.append(cells.join('\t'));
  for (int row = 0; row < table_->rowCount(); ++row) {
    cells = {table_->item(row, 0)->text()};
    for (int column = 1; column < table_->columnCount(); ++column) {
      const QVariant value = table_->item(row, column)->data(valueRole);
      cells.append(value.isValid() ? QString::number(value.toDouble(), 'g', 10) : QString());
    }
    lines.append(cells.join('\t'));
  }
  return lines.join('\n') + '\n';
}

std::vector<int> MethodsPanel::chosenRows() const {
  std::vector<int> rows;
  for (int row = 0; row < table_->rowCount(); ++row)
    if (table_->item(row, 0) != nullptr && table_->item(row, 0)->isSelected())
      rows.push_back(table_->item(row, 0)->data(rowRole).toInt());
  return rows;
}

} // namespace espalier
