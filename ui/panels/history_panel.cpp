#include "ui/panels/history_panel.h"

#include "ui/panels/focus_keys.h"
#include "ui/panels/history_model.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace espalier {

HistoryPanel::HistoryPanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), model_(new HistoryModel(document, this)), list_(new QTableView) {
  setObjectName("history_panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->addWidget(list_);
  list_->setObjectName("history_list");
  list_->setAccessibleName(tr("History"));
  list_->setModel(model_);
  list_->setShowGrid(false);
  list_->setSelectionBehavior(QTableView::SelectRows);
  list_->setSelectionMode(QTableView::SingleSelection);
  list_->setEditTriggers(QTableView::NoEditTriggers);
  list_->setTabKeyNavigation(false);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setDefaultSectionSize(24);
  QHeaderView* header = list_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(20);
  header->setSectionResizeMode(QHeaderView::Interactive);
  header->resizeSection(HistoryModel::markColumn, 20);
  header->setSectionResizeMode(HistoryModel::textColumn, QHeaderView::Stretch);
  header->resizeSection(HistoryModel::timeColumn, 140);
  header->resizeSection(HistoryModel::authorColumn, 140);
  goesThroughRows(*list_);
  onEnter(*list_, [this] {
    if (list_->currentIndex().isValid()) choose(list_->currentIndex().row());
  });
  connect(list_, &QTableView::clicked, this,
          [this](const QModelIndex& index) { choose(index.row()); });
  connect(model_, &HistoryModel::dataChanged, this, &HistoryPanel::showPresent);
  showPresent();
}

void HistoryPanel::showPresent() {
  const QModelIndex present = model_->index(model_->currentRow(), HistoryModel::textColumn);
  list_->setCurrentIndex(present);
  list_->scrollTo(present);
}

void HistoryPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showPresent(); // it has its size only now
}

void HistoryPanel::choose(int row) {
  const int position = model_->positionOf(row);
  if (position >= 0) emit chosen(position);
}

} // namespace espalier
