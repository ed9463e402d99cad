#pragma once

#include <QObject>

namespace espalier {

/// Keys belong to a menu that is open: no command acts on the plant behind it.
class MenuKeys : public QObject {
  Q_OBJECT

public:
  explicit MenuKeys(QObject* parent = nullptr);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace espalier
