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
  /// Work to go on with, in words, and the files it is in.
  void setSessions(const QStringList& texts, const QStringList& paths);

signals:
  void openRequested();
  void sampleRequested(); // a plant to try the program on
  void fileChosen(const QString& path);

private:
  void fill(QWidget& box, QVBoxLayout& list, const QString& title, const QStringList& texts,
            const QStringList& paths);

  QLabel* icon_;
  QWidget* recent_;
  QVBoxLayout* files_;
  QWidget* work_;
  QVBoxLayout* sessions_;
};

} // namespace espalier
