#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace espalier {

/// What is shown while there is no plant: what to do, the button for it, and the recent files.
class StartPage : public QWidget {
  Q_OBJECT

public:
  explicit StartPage(QWidget* parent = nullptr);

  void setIcon(const QIcon& icon);
  void setRecentFiles(const QStringList& paths);

signals:
  void openRequested();
  void fileChosen(const QString& path);

private:
  QLabel* icon_;
  QWidget* recent_;
  QVBoxLayout* files_;
};

} // namespace espalier
