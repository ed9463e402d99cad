#include "ui/panels/plot_panel.h"

#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace espalier {
namespace {

constexpr int plotRowHeight = 24; // [px]

QString plotIntroduction() {
  return PlotPanel::tr("Finds the stems of a plot and gives each point to the plant that it is of. "
                       "Each plant becomes a project of its own, in a folder.");
}

QTableWidget* makePlantTable() {
  auto* table = new QTableWidget(0, 3);
  table->setObjectName("plot_plants");
  table->setAccessibleName(PlotPanel::tr("Plants found"));
  table->setHorizontalHeaderLabels(
      {PlotPanel::tr("Plant"), PlotPanel::tr("Points"), PlotPanel::tr("Height")});
  table->setToolTip(PlotPanel::tr("A click on a plant selects its points; without its check mark "
                                  "it is not written"));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(plotRowHeight);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->setShowGrid(false);
  return table;
}

QTableWidgetItem* numberItem(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

} // namespace

PlotPanel::PlotPanel(QWidget* parent)
    : QWidget(parent), words_(makeLabel("plot_words", "quiet")),
      cleans_(new QCheckBox(tr("Leave out ground, poles, wires"))),
      find_(new QPushButton(tr("Find Plants"))), table_(makePlantTable()),
      write_(new QPushButton(tr("Write Projects…"))), cancel_(new QPushButton(tr("Cancel"))) {
  setObjectName("plot_panel");
  words_->setWordWrap(true);
  words_->setMinimumWidth(72);
  cleans_->setObjectName("plot_cleans");
  cleans_->setChecked(true);
  cleans_->setToolTip(
      tr("By cloth, cylinders and hanging curves, where the pipeline chooses nothing "
         "else. Off: only what the pipeline leaves out. Where points were set aside, it "
         "is off at first: without ground, a cloth touches branches"));
  find_->setObjectName("plot_find");
  find_->setToolTip(tr("By the steps of the pipeline before Plant and the options of that step; "
                       "points that are set aside are of no plant"));
  write_->setObjectName("plot_write");
  write_->setProperty("role", "primary");
  write_->setToolTip(tr("Chooses a folder, and writes the scan and a project of each plant with a "
                        "check mark there"));
  cancel_->setObjectName("plot_cancel");
  connect(cleans_, &QCheckBox::toggled, this, &PlotPanel::cleansChanged);
  connect(find_, &QPushButton::clicked, this, &PlotPanel::findRequested);
  connect(write_, &QPushButton::clicked, this, &PlotPanel::writeRequested);
  connect(cancel_, &QPushButton::clicked, this, &PlotPanel::cancelRequested);
  connect(table_, &QTableWidget::itemChanged, this, &PlotPanel::refresh);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) emit pointedAt(static_cast<std::size_t>(row));
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 10, 12);
  column->setSpacing(8);
  column->addWidget(words_);
  column->addWidget(cleans_);
  column->addWidget(find_);
  column->addWidget(table_, 1);
  column->addWidget(write_);
  column->addWidget(cancel_);
  column->addStretch(); // where the table is absent
  showNone({});
}

void PlotPanel::showPlants(const std::vector<Plant>& plants, const QString& words) {
  isWorking_ = false;
  words_->setText(words);
  if (plants == shown_) return refresh(); // with their check marks
  shown_ = plants;
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(plants.size()));
  for (std::size_t i = 0; i < plants.size(); ++i) {
    auto* name = new QTableWidgetItem(QString::number(i + 1));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    name->setCheckState(Qt::Checked);
    const int row = static_cast<int>(i);
    table_->setItem(row, 0, name);
    table_->setItem(row, 1, numberItem(plants[i].points));
    table_->setItem(row, 2, numberItem(plants[i].height));
  }
  refresh();
}

void PlotPanel::showNone(const QString& words) {
  showPlants({}, words.isEmpty() ? plotIntroduction() : words);
}

void PlotPanel::showWorking(const QString& words) {
  isWorking_ = true;
  words_->setText(words);
  refresh();
}

void PlotPanel::setFindable(bool isFindable) {
  isFindable_ = isFindable;
  refresh();
}

void PlotPanel::setCleans(bool isOn) {
  const QSignalBlocker quiet(cleans_);
  cleans_->setChecked(isOn);
}

bool PlotPanel::cleans() const {
  return cleans_->isChecked();
}

std::vector<std::size_t> PlotPanel::chosen() const {
  std::vector<std::size_t> places;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QTableWidgetItem* name = table_->item(row, 0);
    if (name != nullptr && name->checkState() == Qt::Checked)
      places.push_back(static_cast<std::size_t>(row));
  }
  return places;
}

void PlotPanel::refresh() {
  const bool hasPlants = table_->rowCount() > 0;
  if (isWorking_) {
    cancel_->show();
    passFocus(*find_, *cancel_);
    passFocus(*write_, *cancel_);
  }
  cleans_->setEnabled(isFindable_ && !isWorking_);
  find_->setEnabled(isFindable_ && !isWorking_);
  table_->setVisible(hasPlants);
  table_->setEnabled(!isWorking_);
  write_->setVisible(hasPlants && !isWorking_);
  write_->setEnabled(!chosen().empty());
  if (isWorking_) return;
  passFocus(*cancel_, *find_);
  cancel_->hide();
}

} // namespace espalier
