#include "ui/panels/review_panel.h"

#include "ui/document/plant_document.h"
#include "ui/document/review_look.h"
#include "ui/panels/axis_review_model.h"
#include "ui/panels/coverage_bar.h"
#include "ui/panels/coverage_text.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/panel_button.h"

#include <QAction>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr std::array shownStates = {ReviewState::reviewed, ReviewState::doubtful,
                                    ReviewState::toDo};

QGridLayout* makeGrid(QVBoxLayout& column) {
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  column.addLayout(grid);
  return grid;
}

} // namespace

ReviewPanel::ReviewPanel(PlantDocument& document, const Actions& actions, QWidget* parent)
    : QScrollArea(parent), document_(document), model_(new AxisReviewModel(this)),
      bar_(new CoverageBar), share_(new QLabel), place_(new QLabel), why_(new QLabel),
      state_(new QLabel), comment_(new QLineEdit), axes_(new QTableView), reviewer_(new QLineEdit),
      seal_(new QLabel) {
  setObjectName("review_panel");
  setAccessibleName(tr("Review"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget;
  page->setObjectName("review_page");
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 12, 8, 12);
  column->setSpacing(8);
  addCoverage(*column);
  addChosen(*column, actions);
  addAxes(*column);
  addSeal(*column, actions);
  setWidget(page);

  timer_.setSingleShot(true);
  timer_.setInterval(50); // [ms]
  connect(&timer_, &QTimer::timeout, this, &ReviewPanel::refresh);
  connect(&document_, &PlantDocument::skeletonEdited, this, &ReviewPanel::later);
  connect(&document_, &PlantDocument::skeletonReplaced, this, &ReviewPanel::later);
  connect(&document_, &PlantDocument::unitChanged, this, &ReviewPanel::later);
  connect(&document_.selection(), &Selection::changed, this, &ReviewPanel::refreshChosen);
  connect(&document_, &PlantDocument::skeletonEdited, this, &ReviewPanel::refreshChosen);
  refreshChosen();
}

void ReviewPanel::showPlace(const QString& text, const QString& why) {
  place_->setText(text);
  why_->setText(why);
  why_->setVisible(!why.isEmpty());
  fitTexts();
}

void ReviewPanel::showSeal(const QString& text) {
  seal_->setText(text);
  fitTexts();
}

void ReviewPanel::setReviewer(const QString& name) {
  reviewer_->setText(name);
}

void ReviewPanel::focusComment() {
  comment_->setFocus(Qt::ShortcutFocusReason);
  comment_->selectAll();
}

void ReviewPanel::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  refresh(); // nothing was computed while nobody looked
}

void ReviewPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fitTexts();
}

/// A page in a scroll area does not ask how high wrapped text gets, and would cut it.
void ReviewPanel::fitTexts() {
  const QMargins margins = widget()->layout()->contentsMargins();
  const int width = viewport()->width() - margins.left() - margins.right();
  const QRect room(0, 0, width, QWIDGETSIZE_MAX);
  for (QLabel* label : {place_, why_, seal_})
    label->setMinimumHeight(
        label->fontMetrics().boundingRect(room, Qt::TextWordWrap, label->text()).height());
}

void ReviewPanel::addCoverage(QVBoxLayout& column) {
  share_->setObjectName("review_share");
  share_->setProperty("role", "title");
  column.addWidget(share_);
  column.addWidget(bar_);
  QGridLayout* grid = makeGrid(column);
  grid->setColumnStretch(2, 1);
  for (const ReviewState state : shownStates) {
    const auto at = static_cast<std::size_t>(state);
    samples_[at] = new QLabel;
    samples_[at]->setObjectName(QStringLiteral("review_sample_%1").arg(at));
    lengths_[at] = new QLabel;
    lengths_[at]->setObjectName(QStringLiteral("review_length_%1").arg(at));
    lengths_[at]->setAlignment(Qt::AlignRight);
    const int row = grid->rowCount();
    grid->addWidget(samples_[at], row, 0);
    grid->addWidget(new QLabel(titleOf(state)), row, 1);
    grid->addWidget(lengths_[at], row, 2);
  }
  connect(bar_, &CoverageBar::colorsChanged, this, &ReviewPanel::showSamples);
}

void ReviewPanel::addChosen(QVBoxLayout& column, const Actions& actions) {
  QGridLayout* grid = makeGrid(column);
  grid->addWidget(sharingButton(*actions.previous, tr("◂ Previous")), 0, 0);
  grid->addWidget(sharingButton(*actions.next, tr("Next ▸")), 0, 1);
  auto* kinds = new QHBoxLayout;
  kinds->setSpacing(4);
  for (QToolButton* button : {sharingButton(*actions.openEnd, tr("Open End")),
                              sharingButton(*actions.branching, tr("Branching"))})
    kinds->addWidget(button, button->sizeHint().width()); // each as its text needs
  grid->addLayout(kinds, 1, 0, 1, 2);
  grid->addWidget(sharingButton(*actions.riskiestFirst, tr("Riskiest First")), 2, 0, 1, 2);
  column.addWidget(sharingButton(*actions.reviewed, tr("Reviewed, Go On")));
  grid = makeGrid(column);
  grid->addWidget(sharingButton(*actions.doubtful, tr("Doubtful")), 0, 0);
  grid->addWidget(sharingButton(*actions.toDo, tr("To Do")), 0, 1);
  place_->setObjectName("review_place");
  place_->setWordWrap(true);
  why_->setObjectName("review_why");
  why_->setWordWrap(true);
  state_->setObjectName("review_state");
  state_->setProperty("role", "quiet");
  for (QLabel* label : {place_, why_, state_}) { // below the buttons, which so stay where they are
    label->setMinimumWidth(72);                  // must not widen the panel
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column.addWidget(label);
  }
  comment_->setObjectName("review_comment");
  comment_->setAccessibleName(tr("Comment"));
  comment_->setPlaceholderText(tr("Comment"));
  comment_->setToolTip(tr("A remark on the selected nodes (K)"));
  comment_->setMinimumWidth(72);
  column.addWidget(comment_);
  connect(comment_, &QLineEdit::editingFinished, this, [this] {
    if (comment_->isModified()) emit commentTyped(comment_->text());
  });
  connect(comment_, &QLineEdit::returnPressed, this, &ReviewPanel::leaveRequested);
  onEscape(*comment_, [this] {
    refreshChosen(); // without what was typed
    emit leaveRequested();
  });
}

void ReviewPanel::addAxes(QVBoxLayout& column) {
  axes_->setObjectName("review_axes");
  axes_->setTabKeyNavigation(false); // Tab leaves it
  axes_->setModel(model_);
  goesThroughRows(*axes_);
  axes_->setAccessibleName(tr("Axes"));
  axes_->setSelectionBehavior(QAbstractItemView::SelectRows);
  axes_->setSelectionMode(QAbstractItemView::SingleSelection);
  axes_->setShowGrid(false);
  axes_->setMinimumHeight(52); // a row: what signs stays in sight
  axes_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  axes_->verticalHeader()->hide();
  axes_->verticalHeader()->setDefaultSectionSize(22);
  axes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // takes what is left
  axes_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Fixed);
  axes_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  axes_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Fixed);
  constexpr int margins = 10;
  axes_->horizontalHeader()->resizeSection(2, margins +
                                                  axes_->fontMetrics().horizontalAdvance("? 99 %"));
  axes_->horizontalHeader()->setHighlightSections(false);
  column.addWidget(axes_, 1);
  const auto choose = [this](const QModelIndex& index) {
    if (index.isValid() && !timer_.isActive()) emit axisChosen(model_->axis(index.row()));
  };
  connect(axes_, &QTableView::clicked, this, choose);
  connect(axes_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this, choose](const QModelIndex& index) {
            if (axes_->hasFocus() && !QGuiApplication::mouseButtons()) choose(index); // by the keys
          });
}

void ReviewPanel::addSeal(QVBoxLayout& column, const Actions& actions) {
  reviewer_->setObjectName("reviewer");
  reviewer_->setAccessibleName(tr("Reviewer"));
  reviewer_->setPlaceholderText(tr("Your name"));
  reviewer_->setToolTip(tr("Kept with what you review and sign"));
  reviewer_->setMinimumWidth(72);
  seal_->setObjectName("seal");
  seal_->setWordWrap(true);
  seal_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Reviewer")));
  row->addWidget(reviewer_, 1);
  column.addLayout(row);
  column.addWidget(seal_);
  column.addWidget(sharingButton(*actions.sign, tr("Sign Structure…")));
  connect(reviewer_, &QLineEdit::editingFinished, this,
          [this] { emit reviewerTyped(reviewer_->text().trimmed()); });
  connect(reviewer_, &QLineEdit::returnPressed, this, &ReviewPanel::leaveRequested);
}

void ReviewPanel::later() {
  if (isVisible()) timer_.start();
}

void ReviewPanel::refresh() {
  timer_.stop();
  const ReviewCoverage seen = coverage(document_.skeleton());
  bar_->setCoverage(seen);
  showSamples();
  for (const ReviewState state : shownStates) {
    const auto at = static_cast<std::size_t>(state);
    lengths_[at]->setText(amountText(seen, state, document_.unit()));
    lengths_[at]->setToolTip(nodesText(seen.nodes[at]));
  }
  share_->setText(tr("%1 % reviewed").arg(percentText(seen, ReviewState::reviewed, 1)));
  model_->show(document_.skeleton(), document_.unit());
  constexpr int margins = 8;
  QHeaderView& header = *axes_->horizontalHeader();
  header.resizeSection(
      0, std::max(margins + axes_->fontMetrics().horizontalAdvance(model_->longestName()),
                  header.sectionSizeHint(0)));
  fitTexts();
}

/// In the colors of the theme, as the bar.
void ReviewPanel::showSamples() {
  for (const ReviewState state : shownStates)
    samples_[static_cast<std::size_t>(state)]->setPixmap(bar_->sample(state));
}

void ReviewPanel::refreshChosen() {
  std::vector<NodeId> nodes = document_.selection().nodes();
  const Skeleton& skeleton = document_.skeleton();
  std::erase_if(nodes, [&](NodeId id) { return !skeleton.contains(id); }); // they leave it next
  state_->hide();
  comment_->setText({});
  comment_->setPlaceholderText(tr("Comment"));
  if (nodes.empty()) return;
  const ReviewMark& first = skeleton[nodes.front()].review;
  const auto all = [&](auto member) {
    return std::ranges::all_of(
        nodes, [&](NodeId id) { return skeleton[id].review.*member == first.*member; });
  };
  const bool isToDo = all(&ReviewMark::state) && first.state == ReviewState::toDo;
  state_->setVisible(!isToDo);
  QString state = titleOf(coverage(skeleton, nodes).state());
  if (!all(&ReviewMark::state)) state += tr(", in part");
  if (all(&ReviewMark::reviewer) && !first.reviewer.empty())
    state += QStringLiteral(" · ") + QString::fromStdString(first.reviewer);
  state_->setText(state);
  if (all(&ReviewMark::comment)) {
    comment_->setText(QString::fromStdString(first.comment));
    comment_->setCursorPosition(0); // a long one shows its beginning
  } else
    comment_->setPlaceholderText(tr("Several comments"));
}

} // namespace espalier
