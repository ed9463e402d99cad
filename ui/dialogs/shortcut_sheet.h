#pragma once

#include <QDialog>

class QAction;
class QScrollArea;

namespace espalier {

class KeyBindings;

/// All commands that have keys, and what the mouse does, on one sheet. A click on keys changes
/// them.
class ShortcutSheet : public QDialog {
  Q_OBJECT

public:
  /// @param bindings must outlive it
  explicit ShortcutSheet(KeyBindings& bindings, QWidget* parent = nullptr);

private:
  void fill();
  [[nodiscard]] QSize roomForRows() const;
  void change(const QAction* action); // null: none chosen yet

  KeyBindings& bindings_;
  QScrollArea* scroll_; // around the rows
};

} // namespace espalier
