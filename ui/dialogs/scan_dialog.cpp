#include "ui/dialogs/scan_dialog.h"

#include "ui/dialogs/column_table.h"
#include "ui/dialogs/count_box.h"
#include "ui/dialogs/part_form.h"
#include "ui/document/manual_place.h"
#include "ui/document/shown_message.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace espalier {
namespace {

QLabel* wrappedLabel(const char* name, const char* role = nullptr) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (role != nullptr) label->setProperty("role", role);
  return label;
}

/// A list with the reason of what is chosen at first beside it.
QHBoxLayout* withReason(QComboBox* list, QLabel* reason) {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(list);
  row->addWidget(reason, 1);
  return row;
}

} // namespace

ScanDialog::ScanDialog(ScanLook look, std::uint64_t mostAtOnce, QWidget* parent)
    : QDialog(parent), look_(std::move(look)), asked_(mostAtOnce),
      questions_(wrappedLabel("scan_questions", "warning")), points_(wrappedLabel("scan_points")),
      columns_(wrappedLabel("scan_columns")), bounds_(wrappedLabel("scan_bounds")),
      size_(wrappedLabel("scan_size")), unit_(new QComboBox),
      unitReason_(wrappedLabel("unit_reason", "quiet")), up_(new QComboBox),
      upReason_(wrappedLabel("up_reason", "quiet")), part_(new PartForm(look_.glance, mostAtOnce)),
      remembers_(new QCheckBox(tr("Read files that begin alike so, too"), this)),
      limit_(new CountBox), problem_(wrappedLabel("scan_problem", "warning")) {
  setObjectName("open_scan");
  setManualPlace(*this, QStringLiteral("files.md#what-is-in-a-scan"));
  setWindowTitle(tr("Open a Scan"));
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(24, 20, 24, 16);
  page->setSpacing(12);
  page->addLayout(makeHead());
  page->addLayout(makeForm());
  if (look_.text)
    makeTable(*page);
  else
    page->addStretch(1);
  makeEnd(*page);
  resize(760, sizeHint().height());
  orderTabs();
  showGlance();
  connect(part_, &PartForm::changed, this, &ScanDialog::refresh);
  connect(unit_, &QComboBox::activated, this, [this] { isUnitChosen_ = true; });
  connect(unit_, &QComboBox::currentIndexChanged, this, [this] {
    size_->setText(sizeText(look_.glance, unit()));
    showQuestions();
  });
  connect(up_, &QComboBox::activated, this, [this] { isUpChosen_ = true; });
  if (table_ != nullptr)
    connect(table_, &ColumnTable::fieldsChanged, this, &ScanDialog::refreshColumns);
  refresh();
  showChosen();
  showQuestions();
}

/// What was chosen before, and why that could not be read: another try may do.
void ScanDialog::showChosen() {
  if (const std::optional<ScanChoices>& chosen = look_.chosen) {
    unit_->setCurrentIndex(unit_->findData(symbol(chosen->unit)));
    up_->setCurrentIndex(static_cast<int>(chosen->up));
    isUnitChosen_ = true;
    isUpChosen_ = true;
    part_->show(chosen->reading);
  }
  unit_->setEnabled(!look_.unit);
  up_->setEnabled(!look_.up);
  if (look_.failure.isEmpty()) return;
  problem_->setText(look_.failure);
  problem_->show();
}

QVBoxLayout* ScanDialog::makeHead() {
  auto* head = new QVBoxLayout;
  head->setSpacing(4);
  auto* name = wrappedLabel("scan_name", "title");
  name->setText(QFileInfo(look_.path).fileName());
  name->setToolTip(look_.path);
  head->addWidget(name);
  auto* format = wrappedLabel("scan_format", "quiet");
  const QString version = shownText(look_.glance.version);
  const bool isNamed = version.contains(look_.format); // "COPC, LAS 1.4"
  QStringList words = isNamed ? QStringList() : QStringList(look_.format);
  if (!version.isEmpty()) words.append(version);
  format->setText(words.join(QStringLiteral(", ")));
  head->addWidget(format);
  head->addWidget(questions_);
  return head;
}

QFormLayout* ScanDialog::makeForm() {
  unit_->setObjectName("scan_unit");
  unit_->setAccessibleName(tr("Unit"));
  unit_->addItem(tr("not known"), QString());
  for (const LengthUnit unit : {LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::meter})
    unit_->addItem(symbol(unit), symbol(unit));
  unit_->setToolTip(tr("The unit of the coordinates. They are shown with it, never rescaled."));
  up_->setObjectName("scan_up");
  up_->setAccessibleName(tr("Up"));
  for (const char* axis : {"x", "y", "z"}) // in the order of UpAxis
    up_->addItem(QString::fromLatin1(axis));
  up_->setToolTip(tr("The axis of the file that points up, from the foot of the plant to its top"));
  up_->setMinimumWidth(unit_->sizeHint().width());
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(6);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  form->addRow(tr("Points"), points_);
  if (!look_.text) form->addRow(tr("Columns"), columns_);
  form->addRow(tr("Bounds"), bounds_);
  form->addRow(tr("Size"), size_);
  form->addRow(tr("Unit"), withReason(unit_, unitReason_));
  form->addRow(tr("Up"), withReason(up_, upReason_));
  form->addRow(tr("Read"), part_);
  return form;
}

void ScanDialog::makeTable(QVBoxLayout& page) {
  const std::vector<PointField>& named = look_.columns;
  table_ = new ColumnTable(
      *look_.text, named.size() == look_.text->columns.size() ? named : look_.text->columns);
  table_->setMinimumHeight(table_->horizontalHeader()->sizeHint().height() +
                           4 * table_->verticalHeader()->defaultSectionSize());
  auto* title = new QLabel(tr("What the columns hold, above the first lines of the file"));
  title->setProperty("role", "section");
  page.addWidget(title);
  page.addWidget(table_, 1);
  page.addWidget(remembers_);
}

void ScanDialog::makeEnd(QVBoxLayout& page) {
  page.addWidget(problem_);
  remembers_->setObjectName("remember_columns");
  remembers_->setToolTip(tr("Columns as they are named here are taken for such files without "
                            "asking, also after the program is closed"));
  remembers_->setChecked(true);
  remembers_->setVisible(!look_.alike.isEmpty());
  limit_->setObjectName("most_at_once");
  limit_->setCount(asked_);
  auto* label = new QLabel(tr("Points of a scan that are read without asking, at most"));
  label->setBuddy(limit_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(label);
  row->addWidget(limit_);
  row->addStretch(1);
  page.addLayout(row);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  cancel_ = buttons->button(QDialogButtonBox::Cancel);
  cancel_->setAutoDefault(false);
  open_ = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  open_->setObjectName("open_chosen");
  open_->setProperty("role", "primary");
  open_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  page.addWidget(buttons);
}

/// As the eye goes: down the form, along the columns, to the buttons.
void ScanDialog::orderTabs() {
  std::vector<QWidget*> order = {unit_, up_};
  for (const char* name : {"read_all", "read_some", "read_most", "read_box", "box_x_from",
                           "box_x_to", "box_y_from", "box_y_to", "box_z_from", "box_z_to"})
    order.push_back(part_->findChild<QWidget*>(QString::fromLatin1(name)));
  if (table_ != nullptr) {
    order.insert(order.end(), table_->lists().begin(), table_->lists().end());
    order.insert(order.end(), {table_, remembers_});
  }
  order.insert(order.end(), {limit_, open_, cancel_});
  for (std::size_t i = 1; i < order.size(); ++i)
    setTabOrder(order[i - 1], order[i]);
  const bool areColumnsAsked = !columnsQuestion(look_).isEmpty();
  (areColumnsAsked ? static_cast<QWidget*>(table_->lists().front()) : open_)->setFocus();
}

void ScanDialog::showGlance() {
  const PointGlance glance = glanceOf(look_);
  points_->setText(contentText(glance));
  columns_->setText(columnsText(glance));
  bounds_->setText(boundsText(glance));
  if (!isUnitChosen_)
    unit_->setCurrentIndex(unit_->findData(QString::fromStdString(glance.unit.value)));
  if (!isUpChosen_) up_->setCurrentText(QString::fromStdString(glance.up.value));
  size_->setText(sizeText(glance, unit()));
  unitReason_->setText(reasonText(glance.unit));
  upReason_->setText(reasonText(glance.up));
}

/// Those that are still open. Once there are none, their room stays: nothing moves under the hand.
void ScanDialog::showQuestions() {
  ScanLook now = look_;
  if (unit() != LengthUnit::unknown) now.unit = unit();
  if (areColumnsChosen_) now.columns = columns();
  const QStringList questions = questionsOf(now, asked_);
  questions_->setVisible(!questions.isEmpty());
  if (questions.isEmpty()) return;
  questions_->setText(questions.join('\n'));
  QSizePolicy policy = questions_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  questions_->setSizePolicy(policy);
}

void ScanDialog::setGlance(const PointGlance& glance) {
  look_.glance = glance;
  showGlance();
  part_->setGlance(glance);
}

void ScanDialog::showProblem(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  open_->setEnabled(problem.isEmpty());
}

void ScanDialog::refreshColumns() {
  refresh();
  if (!table_->problem().isEmpty()) return;
  areColumnsChosen_ = true;
  showQuestions();
  emit columnsChosen(table_->fields());
}

void ScanDialog::refresh() {
  const QString problem = table_ != nullptr ? table_->problem() : QString();
  showProblem(problem.isEmpty() ? part_->problem() : problem);
}

LengthUnit ScanDialog::unit() const {
  return unitOfSymbol(unit_->currentData().toString());
}

std::vector<PointField> ScanDialog::columns() const {
  return table_ != nullptr ? table_->fields() : std::vector<PointField>();
}

ScanChoices ScanDialog::choices() const {
  ScanChoices choices{.reading = {}, .unit = unit(), .up = UpAxis(up_->currentIndex())};
  part_->choose(choices.reading);
  if (look_.text && columns() != look_.text->columns) choices.reading.columns = columns();
  return choices;
}

bool ScanDialog::remembersColumns() const {
  return remembers_->isChecked();
}

std::uint64_t ScanDialog::mostAtOnce() const {
  return static_cast<std::uint64_t>(limit_->value());
}

} // namespace espalier
