#pragma once

#include <QObject>

namespace espalier {

class ActionSet;

/// Lets the row of digits of a keyboard do what actions with a digit do, where digits need Shift,
/// as on a French one: the key of 1 types & there.
class DigitKeys : public QObject {
  Q_OBJECT

public:
  explicit DigitKeys(const ActionSet& actions, QObject* parent = nullptr);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  const ActionSet& actions_;
};

} // namespace espalier
