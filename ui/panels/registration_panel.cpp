#include "ui/panels/registration_panel.h"

#include "ui/document/number_box.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"
#include "ui/panels/wide_enough.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
namespace {

constexpr int rowHeight = 24; // [px], of a pair
constexpr int fewestRows = 3;
constexpr int mostRows = 8; // that are seen at once

QLabel* makeSentence(const char* name, const char* role) {
  QLabel* label = makeLabel(name, role);
  label->setWordWrap(true);
  label->setMinimumWidth(72);
  return label;
}

QVBoxLayout* makeColumn(QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  return column;
}

/// A sentence, or nothing where there is none.
void showSentence(QLabel& label, const QString& text) {
  label.setText(text);
  label.setVisible(!text.isEmpty());
}

QTableWidget* makePairTable() {
  auto* table = new QTableWidget(0, 3);
  table->setObjectName("registration_pairs");
  table->setAccessibleName(RegistrationPanel::tr("Pairs of targets"));
  table->setHorizontalHeaderLabels(
      {RegistrationPanel::tr("Pair"), RegistrationPanel::tr("Apart by"), QString()});
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(rowHeight);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setFocusPolicy(Qt::NoFocus);
  table->setShowGrid(false);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return table;
}

} // namespace

RegistrationPanel::RegistrationPanel(const Actions& actions, QWidget* parent)
    : QWidget(parent), empty_(new QWidget), work_(new QWidget),
      next_(makeSentence("registration_next", "value")),
      spheres_(new QCheckBox(tr("Targets are spheres"))), radius_(new NumberBox),
      table_(makePairTable()), byPairs_(makeSentence("registration_by_pairs", "quiet")),
      byPoints_(makeSentence("registration_by_points", "quiet")),
      warning_(makeSentence("registration_warning", "warning")) {
  setObjectName("registration_panel");
  QFont prominent = next_->font();
  prominent.setBold(true);
  next_->setFont(prominent);
  constexpr int lines = 4; // of the longest: what is below stays where it is
  next_->setMinimumHeight(lines * QFontMetrics(prominent).lineSpacing());
  next_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* empty = makeColumn(empty_);
  QLabel* words = makeSentence("registration_words", "quiet");
  words->setText(tr("Lays another scan of this plant on the open one, by targets that both show "
                    "and by their points, and joins them."));
  empty->addWidget(words);
  empty->addWidget(panelButton(actions.begin));

  spheres_->setObjectName("registration_spheres");
  spheres_->setToolTip(tr("A click anywhere on a sphere is enough: its center is found"));
  radius_->setObjectName("registration_radius");
  radius_->setAccessibleName(tr("Radius of the spheres"));
  radius_->setToolTip(tr("Radius of the spheres; 0: it is found"));
  radius_->setSpecialValueText(tr("found"));
  radius_->setDecimals(4);
  radius_->setRange(0, 1e6);
  auto* radiusLabel = new QLabel(tr("Radius"));
  radiusLabel->setBuddy(radius_);
  auto* radiusRow = new QHBoxLayout;
  radiusRow->addWidget(radiusLabel);
  radiusRow->addWidget(radius_, 1);
  for (QWidget* part : {static_cast<QWidget*>(radiusLabel), static_cast<QWidget*>(radius_)}) {
    part->setEnabled(false);
    connect(spheres_, &QCheckBox::toggled, part, &QWidget::setEnabled);
  }

  auto* work = makeColumn(work_);
  work->addWidget(next_);
  work->addWidget(spheres_);
  work->addLayout(radiusRow);
  work->addWidget(table_);
  work->addWidget(byPairs_);
  work->addWidget(panelButton(actions.fit));
  work->addWidget(byPoints_);
  work->addWidget(warning_);
  work->addWidget(panelButton(actions.color));
  work->addWidget(panelButton(actions.join));
  work->addWidget(panelButton(actions.moveStructure));
  auto* ends = new QHBoxLayout;
  ends->addWidget(sharingButton(actions.reset, tr("Reset")));
  ends->addWidget(sharingButton(actions.leave, tr("Leave")));
  work->addLayout(ends);

  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 12, 8, 12);
  column->addWidget(empty_);
  column->addWidget(work_);
  column->addStretch(1);
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Registration"));
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  keepWideEnough(*area);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(area);
  show(std::nullopt);
}

void RegistrationPanel::show(const std::optional<Shown>& shown) {
  empty_->setVisible(!shown);
  work_->setVisible(shown.has_value());
  if (!shown) return;
  next_->setText(shown->next);
  fillTable(shown->pairs);
  showSentence(*byPairs_, shown->byPairs);
  showSentence(*byPoints_, shown->byPoints);
  showSentence(*warning_, shown->warning);
}

void RegistrationPanel::fillTable(const std::vector<Pair>& pairs) {
  const int rows = static_cast<int>(pairs.size());
  table_->setRowCount(0); // the buttons of before go
  table_->setRowCount(rows);
  for (int row = 0; row < rows; ++row) {
    const Pair& pair = pairs[static_cast<std::size_t>(row)];
    const QString residual = pair.isWorst ? tr("%1, worst").arg(pair.residual) : pair.residual;
    auto* number = new QTableWidgetItem(QString::number(row + 1));
    auto* apart = new QTableWidgetItem(residual);
    apart->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QTableWidgetItem* item : {number, apart}) {
      QFont font = item->font();
      font.setBold(pair.isWorst);
      item->setFont(font);
    }
    table_->setItem(row, 0, number);
    table_->setItem(row, 1, apart);
    auto* remove = new QToolButton;
    remove->setObjectName("registration_remove");
    remove->setText(QStringLiteral("✕"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Removes pair %1").arg(row + 1));
    remove->setAccessibleName(remove->toolTip());
    connect(
        remove, &QToolButton::clicked, this, [this, row] { emit removeRequested(row); },
        Qt::QueuedConnection); // the button goes with it
    table_->setCellWidget(row, 2, remove);
  }
  const int seen = std::clamp(rows, fewestRows, mostRows);
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() + seen * rowHeight + 4);
}

bool RegistrationPanel::areSpheres() const {
  return spheres_->isChecked();
}

std::optional<double> RegistrationPanel::sphereRadius() const {
  return radius_->value() > 0 ? std::optional(radius_->value()) : std::nullopt;
}

void RegistrationPanel::setUnit(const QString& unit) {
  radius_->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
}

} // namespace espalier
