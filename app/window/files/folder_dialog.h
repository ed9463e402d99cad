#pragma once

#include <QFileDialog>

namespace espalier {

/// Asks for a folder to write to. The name of a folder that does not exist yet is taken, too: who
/// writes makes it.
class FolderDialog : public QFileDialog {
  Q_OBJECT

public:
  FolderDialog(QWidget* parent, const QString& title, const QString& beginning);

  [[nodiscard]] QString folder() const { return selectedFiles().value(0); }
  void accept() override;
};

} // namespace espalier
