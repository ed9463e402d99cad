#include "ui/dialogs/commit_marks_dialog.h"

#include "ui/document/length_unit.h"
#include "ui/document/manual_place.h"
#include "ui/document/plant_document.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace espalier {
namespace {

/// The classes of a scale: "U, I".
std::map<int, QStringList> classesByScale(const Skeleton& skeleton) {
  std::map<int, QStringList> classes;
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities) {
      QStringList& known = classes[entity.scale];
      const QString symbol = QString::fromStdString(entity.symbol);
      if (!known.contains(symbol)) known.append(symbol);
    }
  if (classes.empty()) classes = {{1, {"P"}}, {2, {"N"}}};
  return classes;
}

} // namespace

CommitMarksDialog::CommitMarksDialog(PlantDocument& document, QWidget* parent)
    : QDialog(parent), document_(document), symbol_(new QLineEdit(this)),
      place_(new QComboBox(this)), outcome_(new QLabel(this)) {
  setObjectName("commit_marks");
  setManualPlace(*this, QStringLiteral("correct.md#scales-by-hand"));
  setWindowTitle(tr("Commit Marks to a Scale"));
  symbol_->setObjectName("unit_class");
  symbol_->setPlaceholderText(tr("such as S or GU"));
  place_->setObjectName("unit_place");
  outcome_->setObjectName("unit_outcome");
  outcome_->setWordWrap(true);
  outcome_->setProperty("role", "quiet");
  addPlaces();
  auto* form = new QFormLayout;
  form->addRow(tr("Class of the units"), symbol_);
  form->addRow(tr("Made of"), place_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  commit_ = buttons->addButton(tr("Commit"), QDialogButtonBox::AcceptRole);
  commit_->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(outcome_);
  column->addWidget(buttons);
  connect(symbol_, &QLineEdit::textChanged, this, &CommitMarksDialog::refresh);
  connect(place_, &QComboBox::currentIndexChanged, this, &CommitMarksDialog::refresh);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    emit commitRequested({symbol_->text().toStdString(), place_->currentData().toInt()});
  });
  refresh();
}

QWidget* CommitMarksDialog::symbolField() const {
  return symbol_;
}

void CommitMarksDialog::addPlaces() {
  const std::map<int, QStringList> classes = classesByScale(document_.skeleton());
  std::vector<int> scales = scalesOf(document_.skeleton());
  std::ranges::reverse(scales); // directly above the nodes is what one mostly wants
  for (const int scale : scales) {
    const auto found = classes.find(scale);
    const QString symbols = found == classes.end() ? QString() : found->second.join(", ");
    place_->addItem(tr("%1 (scale %2)").arg(symbols).arg(scale), scale);
  }
}

void CommitMarksDialog::refresh() {
  const Skeleton& skeleton = document_.skeleton();
  const int finer = place_->currentData().toInt();
  const std::size_t units = startsOfNewUnits(skeleton, finer).size();
  const std::size_t marks = markedNodes(skeleton).size();
  const QString made = units == 1 ? tr("1 unit") : tr("%1 units").arg(formatCount(units));
  const QString from = marks == 1 ? tr("1 mark") : tr("%1 marks").arg(formatCount(marks));
  outcome_->setText(tr("Makes %1 of scale %2 from %3: one begins at each mark, at each root, and "
                       "wherever a coarser unit begins. Finer scales move down by one.")
                        .arg(made)
                        .arg(finer)
                        .arg(from));
  commit_->setEnabled(!symbol_->text().trimmed().isEmpty() && marks > 0);
}

} // namespace espalier
