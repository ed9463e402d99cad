#pragma once

#include <QDialog>

#include <vector>

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QTextBrowser;
class QTreeWidget;
class QUrl;

namespace espalier {

/// Shows the manual: its chapters and what is found in them at the left, the text at the right. Not
/// modal: one reads and works.
class ManualWindow : public QDialog {
  Q_OBJECT

public:
  explicit ManualWindow(QWidget* parent);

  /// Shows a chapter, from a heading on: "files.md", "files.md#projects". pre: it is shown
  void goTo(const QString& place);

private:
  QWidget* makeSide();
  QWidget* makePage();
  void listChapters();
  void follow(const QUrl& link);
  void takeChapter(const QUrl& place); // it was opened, or the place in it is another
  void fitPictures();
  void fitTables();
  void scrollTo(const QString& anchor);
  void choose(const QString& place); // in the list of chapters
  void find(const QString& text);
  void markFound();

  QLineEdit* search_;
  QStackedWidget* lists_;
  QTreeWidget* chapters_;
  QListWidget* found_;
  QTextBrowser* text_;
  QString file_; // of the chapter that is shown
};

} // namespace espalier
