#include "ui/dialogs/sign_dialog.h"

#include "ui/document/hand_work_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

SignDialog::SignDialog(const Seal& draft, LengthUnit unit, const QString& signer, QWidget* parent)
    : QDialog(parent), signer_(new QLineEdit(signer, this)) {
  setObjectName("sign");
  setWindowTitle(tr("Sign Structure"));
  signer_->setObjectName("signer");
  auto* statement = new QLabel(
      tr("I have looked at all of this structure, and to my knowledge it is right."), this);
  statement->setWordWrap(true);
  statement->setProperty("role", "title");
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(8);
  const auto addRow = [&](const QString& label, const QString& value) {
    auto* text = new QLabel(value, this);
    text->setWordWrap(true);
    form->addRow(label, text);
  };
  addRow(tr("Structure"),
         tr("%1 nodes, %2").arg(formatCount(draft.nodes), formatLength(draft.length, unit)));
  addRow(tr("At work"), tr("%1, pauses over %2 min left out")
                            .arg(formatWorkTime(draft.work.time))
                            .arg(longestPause / 60'000));
  addRow(tr("Corrections"), describe(draft.work.corrections));
  form->addRow(tr("Name"), signer_);
  auto* later = new QLabel(tr("A later edit breaks the seal, and undoing it mends it."), this);
  later->setWordWrap(true);
  later->setProperty("role", "quiet");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* sign = buttons->addButton(tr("Sign"), QDialogButtonBox::AcceptRole);
  sign->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(statement);
  column->addLayout(form);
  column->addWidget(later);
  column->addWidget(buttons);
  setMinimumWidth(420);
  const auto refresh = [this, sign] { sign->setEnabled(!this->signer().isEmpty()); };
  connect(signer_, &QLineEdit::textChanged, this, refresh);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  refresh();
}

QString SignDialog::signer() const {
  return signer_->text().trimmed();
}

} // namespace espalier
