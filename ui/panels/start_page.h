#pragma once

#include <QScrollArea>
#include <QStringList>

class QLabel;
class QVBoxLayout;

namespace espalier {

/// What is shown while there is no plant: what to do, the button for it, and the recent files. It
/// scrolls where there is not room for all.
class StartPage : public QScrollArea {
  Q_OBJECT

public:
  explicit StartPage(QWidget* parent = nullptr);

  void setIcon(const QIcon& icon);
  void setRecentFiles(const QStringList& paths);
  /// Work to go on with, in words, and the files it is in.
  void setSessions(const QStringList& texts, const QStringList& paths);

  /// How much of what is to be read here lies in a part of it: pixels, 0 while it is hidden.
  [[nodiscard]] int covered(const QRect& part) const;

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
