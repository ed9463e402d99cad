#pragma once

#include <QDialog>
#include <QIcon>
#include <QList>
#include <QString>
#include <QStringList>

namespace espalier {

/// What the program is: its version, the libraries it works with, its license.
class AboutDialog : public QDialog {
  Q_OBJECT

public:
  struct About {
    QIcon icon;
    QString version;
    QList<QStringList> libraries; // name, version, license, use
    QString license;              // of the program, as text
  };
  explicit AboutDialog(const About& about, QWidget* parent = nullptr);

private:
  /// What a report of a problem begins with.
  static QString versionsText(const About& about);
};

} // namespace espalier
