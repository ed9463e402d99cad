#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLineEdit;
class QListWidget;

namespace espalier {

/// Finds and runs any command by a few letters of its name.
class CommandPalette : public QDialog {
  Q_OBJECT

public:
  explicit CommandPalette(const QList<QAction*>& actions, QWidget* parent = nullptr);

  /// How well `text` matches what was typed: each word of it must begin a word of the text or, less
  /// well, stand anywhere in it, if need be without the s of a plural; best, they stand there as
  /// they were typed. 0: not at all.
  [[nodiscard]] static int match(const QString& text, const QString& typed);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; // arrows move the choice

private:
  void refill();
  void runChosen();

  QList<QAction*> actions_;
  QLineEdit* typed_;
  QListWidget* list_;
};

} // namespace espalier
