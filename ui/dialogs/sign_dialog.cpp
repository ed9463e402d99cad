#include "ui/dialogs/sign_dialog.h"

#include "ui/document/manual_place.h"
#include "ui/document/seal_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

SignDialog::SignDialog(const Seal& draft, LengthUnit unit, const QString& signer, QWidget* parent)
    : QDialog(parent), signer_(new QLineEdit(signer, this)), reason_(new QLineEdit(this)) {
  setObjectName("sign");
  setManualPlace(*this, QStringLiteral("review.md#the-seal"));
  setWindowTitle(tr("Sign Structure"));
  signer_->setObjectName("signer");
  auto* statement = new QLabel(
      draft.isAllLookedAt()
          ? tr("I have looked at all of this structure, and to my knowledge it is right.")
          : tr("To my knowledge this structure is right, also where I did not look closely."),
      this);
  statement->setWordWrap(true);
  statement->setProperty("role", "title");
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(8);
  for (const SealRow& row : sealRows(draft, unit)) {
    auto* text = new QLabel(row.text, this);
    text->setWordWrap(true);
    form->addRow(row.name, text);
  }
  const bool isOpen = draft.state && draft.state->openFindings() > 0;
  reason_->setObjectName("reason");
  reason_->setVisible(isOpen);
  reason_->setMaxLength(300); // for the page of a certificate
  if (isOpen) form->addRow(tr("Why findings are left"), reason_);
  form->addRow(tr("Name"), signer_);
  auto* later = new QLabel(tr("A later edit breaks the seal, and undoing it mends it."), this);
  later->setWordWrap(true);
  later->setProperty("role", "quiet");
  auto* missing = new QLabel(this); // beside the button: why it is off
  missing->setObjectName("sign_missing");
  missing->setProperty("role", "quiet");
  missing->setAlignment(Qt::AlignRight);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* sign = buttons->addButton(tr("Sign"), QDialogButtonBox::AcceptRole);
  sign->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(statement);
  column->addLayout(form);
  column->addWidget(later);
  column->addWidget(missing);
  column->addWidget(buttons);
  setMinimumWidth(560);
  const auto refresh = [this, sign, missing, isOpen] {
    const bool lacksReason = isOpen && reason().isEmpty();
    missing->setText(lacksReason                ? tr("To sign, type why findings are left open")
                     : this->signer().isEmpty() ? tr("To sign, type your name")
                                                : QString());
    sign->setEnabled(missing->text().isEmpty());
  };
  for (QLineEdit* field : {signer_, reason_})
    connect(field, &QLineEdit::textChanged, this, refresh);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setTabOrder(reason_, signer_);
  (isOpen ? reason_ : signer_)->setFocus();
  refresh();
  const int wide = std::max(minimumWidth(), sizeHint().width());
  resize(wide, column->totalHeightForWidth(wide)); // the hint of lines that wrap is of other widths
}

QString SignDialog::signer() const {
  return signer_->text().trimmed();
}

QString SignDialog::reason() const {
  return reason_->text().trimmed();
}

} // namespace espalier
