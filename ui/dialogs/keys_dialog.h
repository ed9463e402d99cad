#pragma once

#include <QDialog>

class QAction;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace espalier {

class KeyBindings;
class KeyEdit;

/// Where keys are changed: choose a command, press its new keys. Keys of another command are named,
/// and moved if one says so.
class KeysDialog : public QDialog {
  Q_OBJECT

public:
  /// @param bindings must outlive it
  /// @param chosen   the command to begin with; null: the first
  KeysDialog(KeyBindings& bindings, const QAction* chosen, QWidget* parent);

private:
  void keyPressEvent(QKeyEvent* event) override;
  void makeList();
  QWidget* makeEditor();
  void choose(const QAction* action);
  void filter(const QString& text);
  void refresh();
  void refreshEditor();
  void take();
  [[nodiscard]] QAction* current() const; // null: a section

  KeyBindings& bindings_;
  QLineEdit* filter_;
  QTreeWidget* list_;
  QLabel* name_;
  KeyEdit* keys_;
  QLabel* note_; // who has these keys
  QPushButton* set_;
  QPushButton* clear_;
  QPushButton* reset_;
  QPushButton* resetAll_;
};

} // namespace espalier
