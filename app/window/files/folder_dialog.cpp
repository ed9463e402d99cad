#include "app/window/files/folder_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>

namespace espalier {

FolderDialog::FolderDialog(QWidget* parent, const QString& title, const QString& beginning)
    : QFileDialog(parent, title, beginning) {
  setFileMode(QFileDialog::Directory);
  setOption(QFileDialog::ShowDirsOnly);
  setOption(QFileDialog::DontUseNativeDialog); // those take no name of what is not there
  setLabelText(QFileDialog::FileName, tr("Folder, also a new one:"));
  auto* name = findChild<QLineEdit*>("fileNameEdit");
  auto* buttons = findChild<QDialogButtonBox*>("buttonBox");
  if (name == nullptr || buttons == nullptr) return;
  // Qt turns the button off where there is no such folder.
  connect(name, &QLineEdit::textChanged, this, [buttons](const QString& text) {
    if (QPushButton* choose = buttons->button(QDialogButtonBox::Open))
      choose->setEnabled(!text.trimmed().isEmpty());
  });
}

void FolderDialog::accept() {
  if (!folder().isEmpty() && !QFileInfo::exists(folder()))
    done(QDialog::Accepted); // accept() of files would refuse it
  else
    QFileDialog::accept();
}

} // namespace espalier
