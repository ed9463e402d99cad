#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace espalier {

/// What the plant of a scan probably is, and the settings that go with it, for one click where they
/// are not set yet. Absent until there is something to say.
class KindLine : public QWidget {
  Q_OBJECT

public:
  /// @param take what the click does
  explicit KindLine(QAction& take, QWidget* parent = nullptr);

  void show(const QString& text, const QString& details);

private:
  QLabel* text_;
};

} // namespace espalier
