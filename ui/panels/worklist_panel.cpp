#include "ui/panels/worklist_panel.h"

#include "ui/document/length_unit.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr int pictureSize = 40; // [pixels] on the screen

/// How many plants are in each state, those that none is in left out.
QString countsOf(const std::vector<ListedPlant>& plants) {
  const auto count = [&](const auto& holds) {
    return static_cast<std::size_t>(std::ranges::count_if(plants, holds));
  };
  const auto inStage = [&](WorkStage stage) {
    return count([stage](const ListedPlant& plant) {
      return plant.row.isRead && !plant.row.problem && plant.row.stage() == stage;
    });
  };
  QStringList parts;
  const auto add = [&](std::size_t number, const QString& text) {
    if (number > 0) parts.append(text.arg(formatCount(number)));
  };
  add(inStage(WorkStage::toDo), WorklistPanel::tr("%1 to do"));
  add(inStage(WorkStage::automatic), WorklistPanel::tr("%1 automatic"));
  add(inStage(WorkStage::inReview), WorklistPanel::tr("%1 in review"));
  add(inStage(WorkStage::finished), WorklistPanel::tr("%1 signed"));
  add(count([](const ListedPlant& plant) { return plant.row.problem.has_value(); }),
      WorklistPanel::tr("%1 with a problem"));
  add(count([](const ListedPlant& plant) { return !plant.row.isRead; }),
      WorklistPanel::tr("%1 being read"));
  const QString all = plants.size() == 1
                          ? WorklistPanel::tr("1 plant")
                          : WorklistPanel::tr("%1 plants").arg(formatCount(plants.size()));
  return all + (parts.isEmpty() ? QString() : ": " + parts.join(", "));
}

} // namespace

WorklistPanel::WorklistPanel(const Actions& actions, QWidget* parent)
    : QWidget(parent), model_(new WorklistModel(this)), shown_(new QSortFilterProxyModel(this)),
      title_(new ElidedLabel), note_(makeLabel("worklist_note", "quiet")), filter_(new QComboBox),
      next_(panelButton(*actions.next, tr("Next ▸"))), list_(new QTableView) {
  setObjectName("worklist_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(12, 8, 12, 8);
  page->setSpacing(8);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  title_->setObjectName("worklist_title");
  setRole(*title_, "quiet");
  filter_->setObjectName("worklist_filter");
  filter_->setAccessibleName(tr("State of the plants that are shown"));
  filter_->addItem(tr("All states"), QString());
  filter_->addItem(tr("Not signed"), QStringLiteral("[^s]"));
  filter_->addItem(tr("To do"), QStringLiteral("t"));
  filter_->addItem(tr("Automatic"), QStringLiteral("a"));
  filter_->addItem(tr("In review"), QStringLiteral("r"));
  filter_->addItem(tr("Signed"), QStringLiteral("s"));
  filter_->addItem(tr("With a problem"), QStringLiteral("p"));
  opensOnEnter(*filter_);
  row->addWidget(title_, 1);
  row->addWidget(filter_);
  row->addWidget(panelButton(*actions.folder, tr("Folder…")));
  row->addWidget(panelButton(*actions.table, tr("Table…")));
  row->addWidget(next_);
  page->addLayout(row);
  note_->setWordWrap(true);
  note_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  page->addWidget(note_);
  makeList();
  page->addWidget(list_, 1);
  connect(filter_, &QComboBox::currentIndexChanged, this, [this] {
    shown_->setFilterRegularExpression(QRegularExpression(filter_->currentData().toString()));
    refreshTexts();
  });
  refreshTexts();
}

void WorklistPanel::makeList() {
  shown_->setSourceModel(model_);
  shown_->setSortRole(WorklistModel::sortRole);
  shown_->setSortCaseSensitivity(Qt::CaseInsensitive);
  shown_->setSortLocaleAware(true);
  shown_->setFilterRole(WorklistModel::stageRole);
  shown_->setFilterKeyColumn(WorklistModel::plantColumn);
  list_->setObjectName("worklist");
  list_->setAccessibleName(tr("Worklist"));
  list_->setModel(shown_);
  list_->setShowGrid(false);
  list_->setWordWrap(false);
  list_->setSelectionBehavior(QTableView::SelectRows);
  list_->setSelectionMode(QTableView::SingleSelection);
  list_->setEditTriggers(QTableView::NoEditTriggers);
  list_->setTabKeyNavigation(false);
  list_->setIconSize(QSize(pictureSize, pictureSize));
  list_->setMinimumHeight(60);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  list_->verticalHeader()->setDefaultSectionSize(pictureSize + 4);
  QHeaderView* header = list_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultSectionSize(90);
  header->resizeSection(WorklistModel::plantColumn, 260);
  header->setSectionResizeMode(WorklistModel::stateColumn, QHeaderView::Stretch);
  header->setMinimumSectionSize(60);
  for (const int number : {WorklistModel::findingsColumn, WorklistModel::minutesColumn})
    header->resizeSection(number, 76);
  for (const int name : {WorklistModel::annotatorColumn, WorklistModel::secondColumn})
    header->resizeSection(name, 130);
  header->setSortIndicator(WorklistModel::plantColumn, Qt::AscendingOrder);
  header->setSortIndicatorClearable(true); // a third click leads back to the order of a table
  list_->setSortingEnabled(true);
  onEnter(*list_, [this] { choose(); });
  goesThroughRows(*list_);
  connect(list_, &QTableView::doubleClicked, this, &WorklistPanel::choose);
}

void WorklistPanel::show(const QString& place, const QString& problem,
                         std::vector<ListedPlant> plants, const QStringList& others,
                         bool areInOrder) {
  const QVariant current = list_->currentIndex().siblingAtColumn(0).data();
  if (std::exchange(areInOrder_, areInOrder) != areInOrder)
    list_->sortByColumn(areInOrder ? -1 : int{WorklistModel::plantColumn}, Qt::AscendingOrder);
  place_ = place;
  problem_ = problem;
  model_->show(std::move(plants), others);
  if (!list_->currentIndex().isValid() && current.isValid())
    for (int row = 0; row < shown_->rowCount(); ++row)
      if (shown_->index(row, 0).data() == current) list_->setCurrentIndex(shown_->index(row, 0));
  showOpen();
  refreshTexts();
}

void WorklistPanel::setOpen(const QString& file) {
  if (file == open_) return;
  open_ = file;
  isOpenShown_ = file.isEmpty();
  model_->setOpen(file);
  showOpen();
}

void WorklistPanel::showOpen() {
  for (int row = 0; row < shown_->rowCount() && !isOpenShown_; ++row) {
    const int at = shown_->mapToSource(shown_->index(row, 0)).row();
    if (model_->plants()[static_cast<std::size_t>(at)].file() != open_) continue;
    isOpenShown_ = true;
    list_->setCurrentIndex(shown_->index(row, 0));
    list_->scrollTo(shown_->index(row, 0));
  }
}

std::vector<WorklistRow> WorklistPanel::following(const QString& file) const {
  std::vector<const ListedPlant*> plants; // as they are shown
  for (int row = 0; row < shown_->rowCount(); ++row) {
    const int at = shown_->mapToSource(shown_->index(row, 0)).row();
    plants.push_back(&model_->plants()[static_cast<std::size_t>(at)]);
  }
  const auto isIt = [&](const ListedPlant* plant) { return plant->file() == file; };
  const auto open = std::ranges::find_if(plants, isIt);
  if (open != plants.end()) {
    std::rotate(plants.begin(), open + 1, plants.end());
    plants.pop_back(); // itself
  }
  std::vector<WorklistRow> rows;
  for (const ListedPlant* plant : plants) {
    const bool isToSign = plant->row.isRead && !plant->row.problem && !plant->isFinished() &&
                          !plant->file().isEmpty();
    if (isToSign) rows.push_back(plant->row);
  }
  return rows;
}

bool WorklistPanel::isReading() const {
  return std::ranges::any_of(model_->plants(), [](const ListedPlant& plant) {
    return !plant.row.isRead && !plant.row.problem;
  });
}

void WorklistPanel::choose() {
  const QModelIndex current = list_->currentIndex();
  if (!current.isValid()) return;
  const int row = shown_->mapToSource(current).row();
  emit chosen(model_->plants()[static_cast<std::size_t>(row)].file());
}

void WorklistPanel::refreshTexts() {
  const std::vector<ListedPlant>& plants = model_->plants();
  const bool isRead = !plants.empty() || !problem_.isEmpty();
  title_->setText(place_.isEmpty() || !isRead ? place_
                                              : tr("%1 · %2").arg(place_, countsOf(plants)));
  title_->setToolTip(title_->text());
  QString note = problem_;
  if (place_.isEmpty())
    note = tr("Choose a folder of scans and projects, or a table that names them: they are listed "
              "here, and opened one after another.");
  else if (!isRead)
    note = tr("The worklist is being read.");
  else if (note.isEmpty() && shown_->rowCount() == 0)
    note = tr("No plant of the worklist is in this state.");
  setRole(*note_, problem_.isEmpty() ? "quiet" : "warning");
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  list_->setVisible(shown_->rowCount() > 0);
  filter_->setVisible(!plants.empty());
  next_->setVisible(!plants.empty());
}

} // namespace espalier
