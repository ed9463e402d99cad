#pragma once

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace espalier {

/// Shows a text in Markdown, its headings beside it. Not modal: one reads and works.
class ManualWindow : public QDialog {
  Q_OBJECT

public:
  /// @param file  Markdown; pictures are looked for beside it. A line "{methods contract}" stands
  /// for the rows of a table of the methods of that step
  ManualWindow(const QString& file, QWidget* parent);

private:
  void fitPictures();
  void listHeadings();
  void goTo(int heading);

  QListWidget* headings_;
  QTextBrowser* text_;
};

} // namespace espalier
