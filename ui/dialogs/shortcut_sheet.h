#pragma once

#include <QDialog>
#include <QList>

class QAction;

namespace espalier {

/// All commands that have keys, and what the mouse does, on one sheet.
class ShortcutSheet : public QDialog {
  Q_OBJECT

public:
  explicit ShortcutSheet(const QList<QAction*>& actions, QWidget* parent = nullptr);
};

} // namespace espalier
